#include "firmware/core/lag.h"

#include <algorithm>

#include "shared/roots.h"

namespace isotouch::core {

namespace {

constexpr Newton kMostForce =
    Newton::of(4095);  // a component: 2^28, so that the sum of squares is below 2^58, and that of a difference below 2^60

constexpr Newton kStill = Newton::of(0.002);  // smaller steps of the target are those of a proxy that has settled

std::int64_t square_of(const Vec3<Newton>& v) { return dot_raw(v, v); }
std::int64_t square_of(Newton length) { return std::int64_t{length.raw()} * length.raw(); }

/// The part that `length` is of a vector that is no shorter.
Ratio part_in(Newton length, std::int64_t square) {
  const Reciprocal inverse = inverse_root_of_positive(static_cast<std::uint64_t>(square));
  return Ratio::from_raw(static_cast<std::int32_t>(share_of_root(length.raw(), inverse)));
}

Newton length_of(std::int64_t square) {
  if (square == 0) return {};
  return Newton::from_raw(static_cast<std::int32_t>(roots_of(static_cast<std::uint64_t>(square)).root));
}

Vec3<Newton> no_longer(const Vec3<Newton>& v, Newton most) {
  const std::int64_t square = square_of(v);
  return square <= square_of(most) ? v : part_of(v, part_in(most, square));
}

Vec3<Newton> shorter(const Vec3<Newton>& v, Newton by) {
  const std::int64_t square = square_of(v);
  return square <= square_of(by) ? Vec3<Newton>{} : v - part_of(v, part_in(by, square));
}

/// The unit vector; zero for zero.
Vec3<Ratio> direction_of(const Vec3<Newton>& v) {
  const Reciprocal inverse = inverse_root(static_cast<std::uint64_t>(square_of(v)));
  const auto part = [&](Newton q) { return Ratio::from_raw(static_cast<std::int32_t>(share_of_root(q.raw(), inverse))); };
  return {part(v.x), part(v.y), part(v.z)};
}

Newton along(const Vec3<Newton>& v, const Vec3<Ratio>& unit) {
  return Newton::from_raw(saturate32(dot_raw(v, unit) >> Ratio::kFractionBits));
}

Vec3<Newton> reaching(Newton length, const Vec3<Ratio>& unit) {
  return {part_of(length, unit.x), part_of(length, unit.y), part_of(length, unit.z)};
}

/// What is left of a force when the hand goes along with it; against it, all of it.
Vec3<Newton> used_up(const Vec3<Newton>& felt, const Vec3<Newton>& by_hand) {
  return shorter(felt, std::max(along(by_hand, direction_of(felt)), Newton{}));
}

/// The force without what it pulls the hand into the surface by.
Vec3<Newton> without_pull(const Vec3<Newton>& force, const Vec3<Ratio>& outwards) {
  return force - reaching(std::min(along(force, outwards), Newton{}), outwards);
}

/// Can the hand's change of speed alone do this to the damper's force? A part more is left to a surface that is curved.
bool is_by_hand(const Vec3<Newton>& change, const Vec3<Newton>& gain) {
  const std::int64_t most = square_of(gain);
  return square_of(change) <= most + (most >> 2);
}

/// Moves the damper's force on. What the dampers give more than the hand explains, is taken from the spring's.
///
/// jumps     the surface does
void follow_damper(const LagInput& in, bool jumps, Lag& lag, Vec3<Newton>& spring) {
  const Vec3<Newton> damper = within(in.damper, kMostForce), change = damper - lag.damper;
  const bool meets = in.touching != in.touched;
  if (!meets && change == Vec3<Newton>{}) return;
  const bool by_hand = meets ? !jumps : is_by_hand(change, within(in.gain, kMostForce));  // where the hand itself touches, dampers begin
  if (!by_hand && jumps && in.touching && !meets) return;                                 // they hold what they gave
  lag.damper = damper;
  if (by_hand) return;
  spring = within(spring - change, kMostForce);
  if (!meets) return;
  const Vec3<Newton> others = within(in.others, kMostForce);
  if (in.touching) {
    lag.withheld = length_of(square_of(others));
  } else {
    spring = within(spring + shorter(others, lag.withheld), kMostForce);
  }
}

}  // namespace

Vec3<Newton> let_through(const Vec3<Newton>& others, const Lag& lag) {
  return lag.withheld == Newton{} ? others : shorter(within(others, kMostForce), lag.withheld);
}

void surface_moved(const Vec3<Newton>& given, Lag& lag) {
  if (!lag.on) lag.felt = within(given, kMostForce);
  lag.on = lag.moved = true;
  lag.settling = kSettlingTicks;
}

Vec3<Newton> follow_target(const LagInput& in, Lag& lag) {
  const Vec3<Newton> target = within(in.target, kMostForce), step = within(in.step, kMostForce), by_hand = within(in.by_hand, kMostForce);
  const Newton longest = length_of(square_of(by_hand));  // of a step that the hand alone can make
  const bool leaps = square_of(step) > square_of(longest + kStill), moved_here = lag.moved && leaps;
  if (in.arriving || (in.touching && leaps)) lag.settling = kSettlingTicks;

  const bool jumps = lag.moved || leaps, lets_go = leaps && !in.touching;
  Vec3<Newton> before = moved_here || lets_go ? in.limited : lag.felt;
  follow_damper(in, jumps, lag, before);

  const bool goes_on = in.touching && !moved_here;
  const Vec3<Newton> led = goes_on ? before + (lag.settling > 0 ? no_longer(step, longest) : step) : used_up(before, by_hand);
  const Vec3<Newton> behind = target - within(led, kMostForce);
  Vec3<Newton> felt = target - shorter(behind, kFollow);
  const Vec3<Ratio> outwards = direction_of(target);
  if (along(before, outwards) >= Newton{}) felt = without_pull(felt, outwards);
  const std::int64_t larger = std::max(square_of(target), square_of(before));
  if (square_of(felt) > larger) felt = no_longer(felt, length_of(larger));

  if (!in.touching) lag.withheld = {};
  if (behind == Vec3<Newton>{}) lag.withheld = std::max(lag.withheld - kFollow, Newton{});  // the spring does not need it

  lag.felt = felt;
  lag.moved = false;
  if (lag.settling > 0) --lag.settling;
  lag.on = lag.settling > 0 || !(felt == target) || lag.withheld > Newton{};
  return felt;
}

}  // namespace isotouch::core
