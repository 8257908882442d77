/// A scan that was seen as an image: neighbouring cells of its grid are neighbours on the surface, unless a jump in depth lies between them.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace isotouch::cloud {

struct Model;

struct ScanGrid {
  static constexpr std::uint32_t kNoReturn = 0xffffffff;

  std::size_t columns = 0;
  std::vector<std::uint32_t> cells = {};             ///< row by row, whole rows: an index of a position, or kNoReturn
  Eigen::Vector3d sensor = Eigen::Vector3d::Zero();  ///< the camera's or scanner's place, in the positions' frame
  bool is_assumed = false;                           ///< nobody states that place: a camera's own frame has it in the origin
};

/// Gives a model the normals of its grid.
///
/// joined    two neighbouring cells, unless the way from one to the other is within 10 degrees of the line of sight: that is a jump in depth
/// normal    of the plane of least squares through a square window of cells, as far as joined cells lead from its middle. The window is 3 to 9 cells
///           wide, the same for the whole scan: as wide as its noise needs for an error of 3 degrees
/// side      all normals have the winding of the grid; most of them face the sensor
///
/// model     without normals; all its other lists stay in step
/// returns   how many points were left out: beside a jump, with fewer than four joined cells around them, or in no cell. Nothing, and the model stays
///           as it was, when fewer than half of the returns would get a normal, or a fifth of the normals would face away from the sensor: then the grid
///           is not that of an image. Nor where the sensor's place is assumed, the image would be mirrored as seen from there, and its columns do not
///           lie in planes through that place: then the sensor stood on the other side
std::optional<std::size_t> orient_by_grid(Model& model, const ScanGrid& grid);

}  // namespace isotouch::cloud
