/// A set of a brick's 64 samples as bits of one number: bit x + 4 y + 16 z.
#pragma once

#include <cstddef>
#include <cstdint>

namespace isotouch::field {

using BrickMask = std::uint64_t;

inline constexpr BrickMask kLowFace[3] = {0x1111111111111111, 0x000F000F000F000F, 0x000000000000FFFF};
inline constexpr int kAcross[3] = {3, 12, 48};  ///< from the low face to the high one
inline constexpr int kNext[3] = {1, 4, 16};

/// What lies on the face at the low (0) or high (1) end of an axis, at the places of the low face.
constexpr BrickMask face(BrickMask mask, std::size_t axis, int end) { return (end == 0 ? mask : mask >> kAcross[axis]) & kLowFace[axis]; }

/// The set and what lies face to face with it, within the brick.
constexpr BrickMask grown(BrickMask mask) {
  BrickMask all = mask;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const BrickMask low = kLowFace[axis], high = low << kAcross[axis];
    all |= (mask & ~high) << kNext[axis] | (mask & ~low) >> kNext[axis];
  }
  return all;
}

/// The part of `mask` that hangs together with its lowest bit; `mask` is not empty.
constexpr BrickMask first_piece(BrickMask mask) {
  BrickMask piece = mask & (~mask + 1);
  for (BrickMask more = grown(piece) & mask; more != piece; more = grown(piece) & mask) piece = more;
  return piece;
}

}  // namespace isotouch::field
