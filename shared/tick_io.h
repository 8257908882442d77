/// What enters one tick and what leaves it: the argument list of the pure function, and so the content of a trace record.
#pragma once

#include <array>
#include <cstdint>

#include "shared/units.h"
#include "shared/vec3.h"

namespace isotouch {

/// One sample of the device, as the tick sees it. Arrival times stay outside: they are not the same twice.
struct TickInput {
  Vec3<Mm> hip;              ///< where the hand is, workspace frame
  std::uint8_t buttons = 0;  ///< bit 0 to 3
  bool fresh = true;         ///< false: the same sample as in an earlier tick
  std::uint16_t age = 0;     ///< whole ticks since the sample was fresh
};

/// Conditions of one tick; "limited" bits are not faults.
enum StatusBits : std::uint32_t {
  kContact = 1U << 0,       ///< the proxy is held by the surface, the force is that of contact
  kFollowing = 1U << 1,     ///< the proxy is on its way to the HIP in free space and has not arrived: no force
  kOutsideGrid = 1U << 2,   ///< the HIP is outside the sampled box
  kHeldInside = 1U << 3,    ///< the HIP began inside the object: no force until it has left
  kRamping = 1U << 4,       ///< the force is below its full value because contact did not begin at rest
  kForceLimited = 1U << 5,  ///< the force was shortened to the limit, its direction kept
  kStale = 1U << 6,         ///< the input was not fresh
  kInputClamped = 1U << 7,  ///< the HIP was outside ±512 mm and was moved to the border
  // Only in the tick of a device.
  kBadReply = 1U << 8,        ///< the packet was malformed and counts as none
  kCountJump = 1U << 9,       ///< the counts took another reference: the pose is sought anew
  kPoseUncertain = 1U << 10,  ///< the HIP is not known: no force
  kNearSingular = 1U << 11,   ///< the mechanism is nearly singular: torques are smaller than asked for
  kTooFast = 1U << 12,        ///< the HIP is faster than the model's limit
  kWordsLimited = 1U << 13,   ///< the motor words were shortened to the limit, their direction kept
  kSlewLimited = 1U << 14,    ///< the change of the motor words was shortened, its direction kept
  kHeatLimited = 1U << 20,    ///< the limit of the motor words is lowered, because the motors are warm
  kLate = 1U << 21,           ///< periods were left out before this tick
  // Of how it feels.
  kDamped = 1U << 24,  ///< the passivity controller adds damping
};

struct TickOutput {
  Vec3<Mm> proxy;                       ///< workspace frame
  Vec3<Newton> force;                   ///< on the hand, device axes
  std::array<std::int16_t, 3> words{};  ///< motor words
  std::uint16_t state = 0;              ///< supervisor state
  std::uint32_t status = 0;             ///< StatusBits

  bool operator==(const TickOutput&) const = default;
};

inline constexpr Ratio kMostFriction = Ratio::of(1.5);
inline constexpr Damping kMostDamping = Damping::of(0.1);
inline constexpr Newton kMostWeight = Newton::of(5);
inline constexpr std::uint32_t kMostDelay = 7;

/// What a person may set; part of the trace's header and of the chain.
struct TickSettings {
  Stiffness stiffness;                   ///< the largest of the surface; 0 = the blob's
  Damping damping;                       ///< between proxy and HIP; 0 = pure spring
  Newton force_limit = Newton::of(8.0);  ///< the Falcon gives about 9 N
  std::uint32_t ramp_ticks = 50;         ///< from no force to full force where contact did not begin at rest
  // What the published method has none of; all off where it is 0.
  Ratio friction{};               ///< Coulomb's μ between proxy and surface, 0 to 1.5
  Damping friction_damping{};     ///< viscous friction of the sliding proxy
  Damping hand_damping{};         ///< of the hand's filtered speed, in contact
  Damping passivity{};            ///< the most that the passivity controller may add to it
  Damping device_damping{};       ///< of the device itself, which the controller counts on
  Newton weight{};                ///< of the handle, held up along +y; ±5 N
  std::uint32_t delay_ticks = 0;  ///< from a sample to its force being felt, 0 to 7; the controller's ledger needs it

  bool operator==(const TickSettings&) const = default;
};

}  // namespace isotouch
