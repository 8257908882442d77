#include "host/stream/stream.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <thread>
#include <utility>

#include "host/error.h"
#include "host/field_file/packed.h"
#include "host/link/link_error.h"
#include "host/link/status.h"
#include "host/live/face_sensor.h"

namespace isotouch::stream {

namespace {

using namespace std::chrono_literals;

double ms_since(Clock::time_point begin) { return std::chrono::duration<double, std::milli>(Clock::now() - begin).count(); }

/// The box of a scan whose first frame shows a part of it: the frame's own and half of its longest side more on each side.
///
/// positions at least one
Eigen::AlignedBox3d box_round_first(std::span<const Eigen::Vector3d> positions) {
  constexpr double kMargin = 0.5;
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& position : positions) box.extend(position);
  const double longest = box.sizes().maxCoeff();
  if (!std::isfinite(longest))
    throw InputError("the places of the first frame are farther apart than a number can say; correct them, or give --box");
  if (!(longest > 0)) throw InputError("the first frame shows a single place, which says nothing about the size of the object; give --box");
  const Eigen::Vector3d more = Eigen::Vector3d::Constant(kMargin * longest);
  return {box.min() - more, box.max() + more};
}

}  // namespace

Stream::Stream(StreamOptions options) : options_(std::move(options)) {}

void Stream::connect(Watch watch) {
  watch_ = std::move(watch);
  if (options_.to.empty()) return;
  controller_.emplace(options_.to, std::nullopt, [this] { return gives_up(); });
  status_ = controller_->status();
}

bool Stream::is_due() const { return Clock::now() - reported_ >= 1s; }

/// While the controller is waited for.
bool Stream::gives_up() {
  if (!status_) return watch_.is_over();  // it does not know of the stream yet
  constexpr auto kSoon = 100ms;
  if (is_due() && Clock::now() - asked_ >= kSoon) {
    second_.unanswered = true;
    report_second();
  }
  return is_too_late(asked_);
}

/// Is the stream over, and what the controller gets for what it was asked then, too?
bool Stream::is_too_late(Clock::time_point asked) {
  if (!watch_.is_over()) return false;
  const Clock::time_point now = Clock::now();
  if (!over_) over_ = now;
  has_given_up_ = now - std::max(*over_, asked) >= kGrace;
  return has_given_up_;
}

void Stream::report_second() {
  reported_ = Clock::now();
  watch_.second(second_);
  second_ = {};
}

void Stream::run(Inbox& inbox) {
  const Clock::time_point begin = Clock::now();
  reported_ = begin;
  const auto report = [&] {
    report_.offered = inbox.offered();
    report_.thinned = inbox.thinned();
    report_.heard = inbox.heard();
    report_.lost = inbox.lost();
    report_.seconds = ms_since(begin) / 1e3;
  };
  const auto finish_field = [&] {
    inbox.close();
    if (field_) count(field_->finish(Clock::now()));
    report();
  };
  constexpr auto kIdle = 50ms;
  auto patience = kIdle;
  const auto next = [&]() -> std::optional<Frame> {
    try {
      return inbox.take(patience);
    } catch (const InputError&) {
      if (!watch_.is_over()) throw;
      return {};  // what ends this program may end the ssh of a source, too
    }
  };
  try {
    while (!watch_.is_over() && !inbox.is_finished()) {
      if (const auto frame = next()) {
        work_on(*frame);
        patience = kIdle;
      } else {
        work_idly();
        patience = field_ && field_->has_waiting() ? 0ms : kIdle;
      }
      report();
      if (!is_due()) continue;
      ask_status();  // it shows, too, whether the controller is still there
      report_second();
    }
  } catch (...) {
    finish_field();
    finish_after_error();
    throw;
  }
  finish_field();
}

void Stream::work_on(const Frame& frame) {
  const Clock::time_point begin = Clock::now();
  cloud::Model model = frame.read();
  for (Tally* tally : {&report_.all, &second_}) {
    ++tally->frames;
    if (model.positions.empty()) {
      ++tally->empty;
    } else if (model.normals.empty()) {
      ++tally->unoriented;
    }
  }
  report_.had_stiffness = report_.had_stiffness || !model.stiffness.empty();
  live::face_sensor({options_.viewpoint, model.sensor.place, model.edges.has_value()}, model.positions, model.normals);
  report_.read_ms.add(ms_since(begin));
  if (!field_ && !this->begin(model)) return;
  const Clock::time_point grows = Clock::now();
  const PointCounts points = field_->take(model, *frame.at);
  count(points);
  report_.grow_ms.add(ms_since(grows));
  if (!controller_ || !field_->has_changed()) return;
  const bool is_patch = felt_.has_value();
  send();
  if (!is_patch) return;
  for (Tally* tally : {&report_.all, &second_}) tally->delay_ms.add(ms_since(*frame.at));
}

/// Takes in some of what waits for frames that may not come; a frame that comes meanwhile waits for no more than that.
void Stream::work_idly() {
  if (!field_) return;
  count(field_->take_waiting(Clock::now()));
  if (controller_ && field_->has_changed()) send();
}

void Stream::count(const PointCounts& points) {
  report_.all.points += points;
  second_.points += points;
}

/// Decides where the field lies. False where the frame does not show it.
bool Stream::begin(const cloud::Model& model) {
  if (model.normals.empty()) return false;
  space_ = live::space_for(options_.box ? *options_.box : box_round_first(model.positions), options_.space);
  field_.emplace(*space_, options_.space.band, options_.info, options_.keep, options_.enough);
  return true;
}

void Stream::send() {
  try {
    felt_ ? patch() : upload();
  } catch (const InputError&) {
    has_failed_ = true;
    throw;
  }
}

void Stream::upload() {
  const field_file::OpenField& field = field_->keep_whole();
  if (options_.on_first) options_.on_first(field.view);
  const std::vector<std::uint8_t> packed = field_file::pack(field.view);
  asked_ = Clock::now();
  const protocol::Accepted accepted =
      controller_->upload({packed.size(), field.view.image.size(), field_->kept_hash(), protocol::Text::of(options_.name)}, packed);
  if (accepted.image_hash != field_->kept_hash()) throw InputError(options_.to + ": another field was taken over meanwhile; stream again");
  felt_ = accepted.image_hash;
  report_.upload_bytes = packed.size();
}

void Stream::patch() {
  const Clock::time_point begin = Clock::now();
  const std::vector<std::uint8_t> patch = field_->keep_patch();
  if (patch.empty()) return;
  report_.patch_ms.add(ms_since(begin));
  const protocol::Accepted accepted = send_patch(patch);
  if (accepted.image_hash != field_->kept_hash()) {
    is_replaced_ = true;
    throw InputError(options_.to + ": another field was taken over meanwhile; stream again");
  }
  felt_ = accepted.image_hash;
  report_.controller_ms.add(ms_since(asked_));
  report_.patch_bytes.add(static_cast<double>(patch.size()));
  for (Tally* tally : {&report_.all, &second_}) {
    ++tally->patches;
    tally->patch_bytes += patch.size();
  }
}

/// Sends it again as long as it is refused and may still be taken over: whoever is in the way may go without another field.
///
/// fails     InputError: the last refusal; somebody replaced the field; LinkError
protocol::Accepted Stream::send_patch(std::span<const std::uint8_t> patch) {
  constexpr auto kTriesEvery = 50ms;
  for (const Clock::time_point begin = Clock::now();;) {
    const Clock::time_point tried = asked_ = Clock::now();
    try {
      return controller_->patch(patch);
    } catch (const link::LinkError&) {
      throw;
    } catch (const InputError& refusal) {
      if (!is_still_own() || tried - begin >= options_.patience || is_too_late(begin)) throw;
      second_.refusal = refusal.what();
    }
    std::this_thread::sleep_for(kTriesEvery);
    for (Tally* tally : {&report_.all, &second_}) tally->refused_s += ms_since(tried) / 1e3;
    if (is_due()) report_second();
  }
}

/// The field of somebody else is no error of this program, and is not replaced.
///
/// returns   false: the controller is gone
/// fails     InputError: there is such a field
bool Stream::is_still_own() {
  try {
    asked_ = Clock::now();
    status_ = controller_->status();
  } catch (const InputError&) {
    return false;
  }
  require_own_field();
  return true;
}

void Stream::ask_status() {
  if (!controller_) return;
  asked_ = Clock::now();
  status_ = controller_->status();
  fault_ = status_->faults != 0 ? link::sentence(*status_, controller_->device()) : "";
  require_own_field();
}

void Stream::require_own_field() {
  if (felt_ && status_->field_hash != *felt_) {
    is_replaced_ = true;
    throw InputError(options_.to + ": another field was loaded while this one grew, and it stays; stream again to replace it");
  }
}

bool Stream::is_felt() const {
  return !controller_ || !has_points() || (felt_ == field_->kept_hash() && !field_->has_changed() && !is_replaced_);
}

/// What the controller lacks was taken before the error, which counts whatever becomes of this.
void Stream::finish_after_error() {
  if (!has_points() || has_failed_ || is_replaced_) return;
  try {
    finish();
  } catch (const InputError&) {  // is_felt says so
  }
}

void Stream::finish() {
  if (controller_ && has_points()) send();
  ask_status();
}

}  // namespace isotouch::stream
