#include "firmware/core/motion.h"

#include <algorithm>
#include <array>

#include "firmware/core/longer.h"

namespace isotouch::core {

namespace {

constexpr std::uint8_t kMaxTicks = 8;
constexpr std::array<Ratio, kMaxTicks + 1> kParts = {Ratio::of(1),    Ratio::of(1),   Ratio::of(0.5),          Ratio::of(0.3333333333),
                                                     Ratio::of(0.25), Ratio::of(0.2), Ratio::of(0.1666666667), Ratio::of(0.1428571429),
                                                     Ratio::of(0.125)};

/// A fourth, rounded.
constexpr MmPerS quarter(MmPerS whole) { return MmPerS::from_raw((whole.raw() >> 2) + ((whole.raw() >> 1) & 1)); }

/// Moves a track on by one tick.
void follow(const Vec3<Mm>& point, bool fresh, PerSecond rate, Track& track) {
  if (track.ticks < kMaxTicks) ++track.ticks;
  if (!fresh) return;
  if (track.has_last) {
    const Vec3<MmPerS> now = mul<MmPerS>(part_of(point - track.last, kParts[track.ticks]), rate);
    const Vec3<MmPerS> change = now - track.velocity;
    track.velocity = track.velocity + Vec3<MmPerS>{quarter(change.x), quarter(change.y), quarter(change.z)};
  }
  track.last = point;
  track.ticks = 0;
  track.has_last = true;
}

/// Is the HIP further from its last fresh sample than a hand moves in the ticks since?
bool is_leap(const Vec3<Mm>& hip, bool fresh, Mm largest_move, const Track& track) {
  const int ticks = std::min(track.ticks + 1, int{kMaxTicks});
  const auto most = Mm::from_raw(largest_move.raw() * ticks);  // at most 800 mm
  return fresh && track.has_last && is_longer(hip - track.last, most);
}

/// The point dragged by the HIP, at most a play away on each axis.
Vec3<Mm> drag(const Vec3<Mm>& hip, const Vec3<Mm>& dragged, Mm play) {
  const auto axis = [play](Mm to, Mm from) { return to + within(from - to, play); };
  return {axis(hip.x, dragged.x), axis(hip.y, dragged.y), axis(hip.z, dragged.z)};
}

}  // namespace

MotionModel make_motion_model(const DeviceModel& device, std::uint32_t period_ns) {
  constexpr int kShift = Mm::kFractionBits - MmPerS::kFractionBits;
  const std::int64_t way =
      2 * std::int64_t{device.speed_limit.raw()} * period_ns * (1 << kShift) / 1'000'000'000;  // below 2^60 before it is divided
  MotionModel model;
  model.rate = PerSecond::from_raw(static_cast<std::int32_t>(1'000'000'000LL * (1 << PerSecond::kFractionBits) / period_ns));
  model.largest_move = Mm::from_raw(saturate32(std::clamp(way, std::int64_t{1}, std::int64_t{Mm::of(100).raw()})));
  model.play = device.play;
  return model;
}

Motion track_motion(const Vec3<Mm>& hip, bool fresh, bool wants_quiet, const MotionModel& model, MotionState& state) {
  Motion motion;
  motion.hip = hip;
  motion.fresh = fresh;
  motion.way = hip - state.now;
  motion.leapt = is_leap(hip, fresh, model.largest_move, state.hip);
  follow(hip, fresh, model.rate, state.hip);
  motion.velocity = state.hip.velocity;
  if (wants_quiet) {
    state.dragged = state.quiet.has_last ? drag(hip, state.dragged, model.play) : hip;
    follow(state.dragged, fresh, model.rate, state.quiet);
    motion.quiet = state.quiet.velocity;
  } else {
    forget_quiet(state);
  }
  state.now = hip;
  return motion;
}

}  // namespace isotouch::core
