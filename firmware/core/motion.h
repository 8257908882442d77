/// How the hand moves: the one memory of where the HIP was, its filtered velocity, and whether it leapt.
///
/// Two velocities are kept. That of the HIP judges its speed. The *quiet* one is that of a point which the HIP drags through a play of one encoder count: a
/// hand at rest whose counts flicker between two values has no quiet velocity at all, one that moves has its own. Damping uses it, because a velocity of
/// single counts would be felt as a buzz: one count of 40 µm in a millisecond is 40 mm/s.
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
  std::uint32_t ticks = 0;  ///< since `last`
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
/// A difference of fresh samples enters a velocity with a quarter: noise is halved, and a step takes eight samples to come through to nine tenths. A
/// repeated sample says nothing: the velocity stays, and the next difference is divided by the ticks that passed, eight at most.
///
/// hip           within ±512 mm
/// wants_quiet   whether anything damps; else the quiet memory is empty
/// tick          yes: constant cost, no division
Motion track_motion(const Vec3<Mm>& hip, bool fresh, bool wants_quiet, const MotionModel& model, MotionState& state);

/// Another field begins: the quiet memory does, too.
inline void forget_quiet(MotionState& state) { state.quiet = {}; }

/// returns   the force on the hand, against its velocity
/// tick      yes
inline Vec3<Newton> damping_force(const Vec3<MmPerS>& velocity, Damping damping) { return -mul<Newton>(velocity, damping); }

}  // namespace isotouch::core
