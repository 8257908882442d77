/// Do the encoders still count? Each leg of the device moves by itself, so a count that stays is a place of the hand like any other. Two things no hand
/// does. A motor without power or with a torn cable shows the second one, too:
///
/// - One leg keeps its count to the unit, while another one moves by 400 counts, which are 14.6° or some 18 mm of the hand. The hand would have to follow
///   a curved surface to a fiftieth of a millimetre.
/// - All three legs keep their counts for 50 packets, although the force on the hand is another one by 1.5 N. A hand as stiff as 5 N/mm gives way by 0.3 mm,
///   which are six counts.
///
/// A leg at an end of its way rests against its stop, and proves nothing.
///
/// What this cannot notice: encoders that are stuck while the hand and the force rest, and a leg that is stuck where it never was further.
/// Measured with seven recorded hands in 400 postures each: a leg that rested by chance saw another one move by 203 counts at most. A straight line touches
/// such a surface for 5 mm, which are some 110 counts.
#pragma once

#include <array>
#include <cstdint>

#include "firmware/guard/arm_geometry.h"

namespace isotouch::guard {

inline constexpr int kStuckTravel = 400;            ///< counts of another leg
inline constexpr double kStuckForce = 1.5;          ///< N
inline constexpr std::uint32_t kStuckPackets = 50;  ///< valid ones

struct EncoderMemory {
  using Counts = std::array<std::int16_t, 3>;
  struct Span {
    Counts low{}, high{};
  };
  Counts counts{};              ///< of the newest packet
  Span ends;                    ///< of each leg since there is a reference
  std::array<Span, 3> at_rest;  ///< of all legs, since this one moved last
  bool begun = false;           ///< there is a reference

  std::uint32_t still = 0;  ///< valid packets since any leg moved
  bool has_force = false;
  Point force{};                 ///< on the hand when all legs came to rest
  std::uint32_t changed_at = 0;  ///< of `still`: since then the force is another one; 0: it is not
};

/// A valid packet came.
///
/// referenced   its counts have a reference, the same as those before
/// tick         yes: constant work, no allocation
void follow_counts(const std::array<std::int16_t, 3>& counts, bool referenced, EncoderMemory& memory);

/// A command was sent.
///
/// force     that it makes on the hand, device axes, N
/// tick      yes: constant work, no allocation
void follow_force(const Point& force, EncoderMemory& memory);

/// returns   true: one leg, or all three, cannot be following the hand
/// tick      yes: constant work, no allocation
bool is_stuck(const EncoderMemory& memory);

}  // namespace isotouch::guard
