#include "firmware/control/field_worker.h"

#include <sys/eventfd.h>
#include <unistd.h>

#include <utility>

#include "firmware/loop/realtime.h"

namespace isotouch::control {

FieldWorker::FieldWorker(store::FieldIntake& intake, Calibration* calibration)
    : intake_(intake), calibration_(calibration), bell_(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)), thread_([this] { run(); }) {}

FieldWorker::~FieldWorker() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stop_ = true;
  }
  changed_.notify_one();
  thread_.join();
  ::close(bell_);
}

void FieldWorker::begin(const FieldWork& work) {
  under_way_ = work.kind;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    wanted_ = work;
  }
  changed_.notify_one();
}

std::optional<FieldDone> FieldWorker::take() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!done_) return std::nullopt;
  std::uint64_t rings = 0;
  (void)!::read(bell_, &rings, sizeof rings);
  under_way_.reset();
  return std::exchange(done_, std::nullopt);
}

void FieldWorker::run() {
  loop::keep_crash_stack();
  std::unique_lock<std::mutex> lock(mutex_);
  for (;;) {
    changed_.wait(lock, [this] { return stop_ || wanted_; });
    if (stop_) return;
    const FieldWork wanted = *std::exchange(wanted_, std::nullopt);
    lock.unlock();
    FieldDone done = work(wanted);
    lock.lock();
    done_ = std::move(done);
    const std::uint64_t ring = 1;
    (void)!::write(bell_, &ring, sizeof ring);
  }
}

FieldDone FieldWorker::work(const FieldWork& wanted) {
  FieldDone done{wanted.kind, wanted.user, {}, {}};
  switch (wanted.kind) {
    case FieldWork::Kind::kAccept: done.outcome = intake_.accept(wanted.field, author_of(wanted.user)); break;
    case FieldWork::Kind::kPatch: done.outcome = intake_.patch(wanted.field.packed_bytes, author_of(wanted.user)); break;
    case FieldWork::Kind::kSelect: done.outcome = intake_.select(wanted.field.image_hash, author_of(wanted.user)); break;
    case FieldWork::Kind::kList: done.stored = intake_.stored(); break;
    case FieldWork::Kind::kCopy: done.outcome = intake_.copy(); break;
    case FieldWork::Kind::kCalibrate: done.outcome.refusal = calibration_->keep(wanted.measured); break;
  }
  return done;
}

}  // namespace isotouch::control
