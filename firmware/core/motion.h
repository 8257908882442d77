/// How the hand moves: the only memory of where the HIP was, its filtered velocity, and whether it jumped.
///
/// Two velocities are kept. The velocity of the HIP is compared with the speed limit. The *quiet* velocity is that of a point which the HIP drags along
/// with a play of one encoder count: it is zero for a hand at rest whose counts flicker between two values, and the hand's own velocity otherwise.
/// Damping uses the quiet one. With the other a person would feel every count as a buzz: one count of 40 µm in a millisecond is 40 mm/s.
///
/// source    first-order low-pass on quantised differences, and damping by it: Colgate and Brown 1994, Factors affecting the Z-width of a haptic display;
///           play against quantisation: DESIGN.md, "Feel"
#pragma once

#include <cstdint>

#include "shared/device_model.h"
#include "shared/units.h"
#include "shared/vec3.h"

namespace isotouch::core {

/// What does not change between ticks, see `make_motion_model`.
struct MotionModel {
  PerSecond rate;   ///< ticks a second
  Mm largest_move;  ///< of a hand in one tick: at twice the speed limit, at most 100 mm
  Mm play;
};

/// period_ns    100,000 to 4,000,000
/// tick         no: divides
MotionModel make_motion_model(const DeviceModel& device, std::uint32_t period_ns);

/// A point that is differenced from fresh sample to fresh sample.
struct Track {
  Vec3<Mm> last;  ///< at the last fresh sample
  Vec3<MmPerS> velocity;
  std::uint8_t ticks = 0;  ///< since `last`
  bool has_last = false;
};

struct MotionState {
  Track hip;
  Track quiet;  ///< begins when damping is asked for
  Vec3<Mm> dragged;
  Vec3<Mm> now;  ///< the HIP of the last tick
};

/// The hand in this tick.
struct Motion {
  Vec3<Mm> hip;  ///< workspace frame
  bool fresh = false;
  Vec3<Mm> way;           ///< since the last tick that was tracked
  Vec3<MmPerS> velocity;  ///< of the HIP, within ±524 m/s
  Vec3<MmPerS> quiet;     ///< of the dragged point; zero where no damping is asked for
  bool leapt = false;     ///< no hand moves so far between two samples; true in that tick alone
};

/// Takes in where the HIP is.
///
/// The filter weighs a new difference with a quarter: noise is halved, and nine tenths of a step pass within eight samples. A repeated sample carries no
/// news: the velocity stays, and the next difference is divided by the ticks since the last fresh sample, at most eight.
///
/// hip           within ±512 mm
/// wants_quiet   whether anything damps; else the quiet memory is empty
/// tick          yes: constant cost, no division
Motion track_motion(const Vec3<Mm>& hip, bool fresh, bool wants_quiet, const MotionModel& model, MotionState& state);

/// For another field: forgets the quiet velocity.
inline void forget_quiet(MotionState& state) { state.quiet = {}; }

/// returns   the force on the hand, against its velocity
/// tick      yes
inline Vec3<Newton> damping_force(const Vec3<MmPerS>& velocity, Damping damping) { return -mul<Newton>(velocity, damping); }

}  // namespace isotouch::core
