/// Nasty hands, derived from recorded or made ones: the motions that a replay ought to survive and that nobody makes by chance.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "host/evaluate/hand.h"
#include "shared/blob.h"
#include "shared/tick_io.h"

namespace isotouch::evaluate {

/// fast      time runs so that the fastest touch, or without one the fastest moment, has 1 m/s; nothing is faster
/// mirror    mirrored on the middle of the object's grid, along an axis that the seed draws
/// jitter    every sample moved by up to an encoder count along each axis, three in a hundred lost
/// dwell     where the touched surface is bent most, the hand presses into it, rests with flickering counts, and stirs
/// medial    where the touched object is thinnest, the hand goes in to its middle and crosses it to and fro, then along it
/// graze     where the hand is near the surface it follows the surface instead, within a tenth of a voxel in and out
/// leave     six times, out of a touch, it leaves the grid in a drawn direction, three times also ±512 mm, and comes back
const std::vector<std::string>& mined_hands();

struct MiningOptions {
  std::string kind;  ///< one of mined_hands()
  std::uint64_t seed = 1;
  std::uint32_t period_ns = 1'000'000;
};

/// The same ticks for the same hand, blob and seed on every machine.
///
/// hand      in the workspace of `field`
/// emit      takes the ticks in their order
/// returns   how many
/// fails     InputError: an unknown kind; a hand that never moves (fast), or never comes near the surface (dwell, medial, graze, leave)
std::uint64_t mine_hand(const std::vector<TickInput>& hand, const BlobView& field, const MiningOptions& options, Hand::Emit emit);

}  // namespace isotouch::evaluate
