#include "host/stream/inbox.h"

#include <utility>

namespace isotouch::stream {

bool Inbox::offer(Frame frame) {
  frame.at = Clock::now();
  {
    const std::lock_guard hold(lock_);
    if (closed_) return false;
    ++offered_;
    if (waiting_) ++thinned_;
    if (!waiting_ || !frame.is_empty) waiting_ = std::move(frame);
  }
  changed_.notify_all();
  return true;
}

bool Inbox::hand_over(Frame frame) {
  {
    std::unique_lock hold(lock_);
    changed_.wait(hold, [this] { return closed_ || !waiting_; });
    if (closed_) return false;
    ++offered_;
    frame.at.reset();
    waiting_ = std::move(frame);
  }
  changed_.notify_all();
  return true;
}

bool Inbox::has_room() const {
  const std::lock_guard hold(lock_);
  return !waiting_;
}

void Inbox::miss(std::uint64_t frames) {
  const std::lock_guard hold(lock_);
  offered_ += frames;
  thinned_ += frames;
}

void Inbox::hear(std::uint64_t lost) {
  const std::lock_guard hold(lock_);
  ++heard_;
  lost_ += lost;
}

void Inbox::lose(std::uint64_t ticks) {
  const std::lock_guard hold(lock_);
  lost_ += ticks;
}

bool Inbox::wait_until(Clock::time_point time) {
  std::unique_lock hold(lock_);
  return !changed_.wait_until(hold, time, [this] { return closed_; });
}

bool Inbox::is_closed() const {
  const std::lock_guard hold(lock_);
  return closed_;
}

void Inbox::finish(std::exception_ptr error) {
  {
    const std::lock_guard hold(lock_);
    finished_ = true;
    error_ = std::move(error);
  }
  changed_.notify_all();
}

std::optional<Frame> Inbox::take(std::chrono::milliseconds patience) {
  std::optional<Frame> taken;
  {
    std::unique_lock hold(lock_);
    changed_.wait_for(hold, patience, [this] { return waiting_ || finished_; });
    if (!waiting_) {
      if (error_) std::rethrow_exception(std::exchange(error_, nullptr));
      return std::nullopt;
    }
    taken = std::exchange(waiting_, std::nullopt);
  }
  changed_.notify_all();
  if (!taken->at) taken->at = Clock::now();
  return taken;
}

bool Inbox::is_finished() const {
  const std::lock_guard hold(lock_);
  return finished_ && !waiting_ && !error_;
}

std::uint64_t Inbox::offered() const {
  const std::lock_guard hold(lock_);
  return offered_;
}

std::uint64_t Inbox::thinned() const {
  const std::lock_guard hold(lock_);
  return thinned_;
}

std::uint64_t Inbox::heard() const {
  const std::lock_guard hold(lock_);
  return heard_;
}

std::uint64_t Inbox::lost() const {
  const std::lock_guard hold(lock_);
  return lost_;
}

void Inbox::close() {
  {
    const std::lock_guard hold(lock_);
    closed_ = true;
    if (waiting_) ++thinned_;
    waiting_.reset();
  }
  changed_.notify_all();
}

}  // namespace isotouch::stream
