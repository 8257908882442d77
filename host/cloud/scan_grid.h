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
};

/// Gives a model the normals of its grid. A cell is joined to those of its four neighbours that returned something and are not behind a jump: the way
/// there is at least 10 degrees off the line of sight. The normal of a cell is the sum of the cross products of joined neighbours that follow each
/// other, which for four neighbours is the product of the two central differences. All normals have the winding of the grid; their common side is
/// the one on which most of them face the sensor.
///
/// model     without normals; all its other lists stay in step
/// returns   points left out: beside a jump, with fewer than three joined neighbours in a row, or in no cell. Nothing, and the model stays as it
///           was, when fewer than half of the returns would get a normal: then the grid is not that of an image
std::optional<std::size_t> orient_by_grid(Model& model, const ScanGrid& grid);

}  // namespace isotouch::cloud
