/// The motions of `isotouch trace make`: the same positions for the same field and seed on every machine.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "host/motion/hand.h"
#include "shared/field_view.h"

namespace isotouch::motion {

constexpr std::uint64_t kMaxTicks = 100'000'000;  ///< of a trace that is made or imported: 28 hours at the usual rate

struct MotionOptions {
  std::string kind = "tour";  ///< one of motion_kinds()
  std::uint64_t ticks = 0;    ///< exactly so many, the gestures again and again at other places; 0 = one round
  std::uint64_t seed = 1;
  std::uint32_t period_ns = 1'000'000;
  double lost_share = 0.0;  ///< samples that do not arrive, 0 to 0.5
};

/// press slide tap corner graze stab leave tour; the tour is all the others in this order.
const std::vector<std::string>& motion_kinds();

/// Moves around and on an object, or, without one, through the ball of 50 mm radius that a Falcon reaches: everywhere in it and of the kind
/// only the pace (a stab reaches 1 m/s, leaving goes to twice the radius).
///
/// field     nullptr = no object
/// emit      takes the ticks in their order
/// returns   how many
/// fails     InputError: an unknown kind; an object that cannot be reached from outside
std::uint64_t make_motion(const FieldView* field, const MotionOptions& options, Hand::Emit emit);

}  // namespace isotouch::motion
