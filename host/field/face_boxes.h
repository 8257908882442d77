/// Sixteen boxes, or sixteen faces, as rows of numbers: a machine asks as many of them at once as its vectors have lanes.
///
/// Rounding to floats makes nothing seem farther away than it is by more than a margin that `FaceTree` knows. Places that are left over are farther
/// away than anything else.
#pragma once

#include <array>
#include <cstddef>

namespace isotouch::field {

inline constexpr std::size_t kTogether = 16;
using Row = std::array<float, kTogether>;
using Rows = std::array<Row, 3>;

/// Boxes with axes of their own.
struct alignas(64) FaceBoxes {
  Rows middle;
  std::array<Rows, 3> axes;  ///< unit
  Rows half;                 ///< of the sides, along these
};

/// Faces, each in a frame of its own, in which it lies flat.
struct alignas(64) FlatFaces {
  Rows middle;
  Rows across, along, normal;                ///< the frame's axes, unit
  std::array<std::array<Row, 2>, 3> corner;  ///< across and along, counter-clockwise
  Rows inverse;                              ///< 1 over the square of the length of the edge behind each corner; 0 where there is none
};

/// Those that lie within a squared distance of a point: a bit each, the first the lowest. The functions for faces say how far each is, too, squared.
struct FacesWithin {
  unsigned (*boxes)(const FaceBoxes&, const std::array<float, 3>& point, float square);
  unsigned (*faces)(const FlatFaces&, const std::array<float, 3>& point, float square, Row& squares);
};
extern const FacesWithin kWithinByFours, kWithinByEights, kWithinBySixteens;
/// The widest that this machine can.
const FacesWithin& widest_within();

}  // namespace isotouch::field
