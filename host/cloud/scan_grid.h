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
  static constexpr int kMaxRadius = 4;  ///< half the widest window of cells that a normal is taken from

  std::size_t columns = 0;
  std::vector<std::uint32_t> cells = {};             ///< row by row, whole rows: an index of a position, or kNoReturn
  Eigen::Vector3d sensor = Eigen::Vector3d::Zero();  ///< the camera's or scanner's place, in the positions' frame

  /// Who says so: a person, or the file in words of its format; the file, which may mean another frame; nobody, but it is so in most files of the format;
  /// nobody, but a camera's own frame has it in the origin.
  enum class Known { kSurely, kStated, kUsual, kAssumed };
  Known known = Known::kSurely;
};

/// Gives a model the normals of its grid.
///
/// joined    two neighbouring cells, unless the way from one to the other is within 10 degrees of the line of sight: that is a jump in depth; or unless
///           one lies behind the sensor as seen from the other
/// normal    of the plane of least squares through a square window of cells, as far as joined cells lead from its middle. The window is 3 to 9 cells
///           wide, the same for the whole scan: as wide as its noise needs for an error of 3 degrees
/// side      all normals have the winding of the grid; most of them face the sensor
///
/// model     without normals; all its other lists stay in step
/// returns   how many points were left out: beside a jump, with fewer than four joined cells around them, or in no cell. Nothing, and the model stays
///           as it was, when fewer than half of the returns would get a normal, or a fifth of the normals would face away from the sensor: then the grid
///           is not that of an image. Nor when the sensor cannot have stood in its place, as the cells with a normal show.
///           Stated or usual: the image is that of a camera in the origin, or it is mirrored as seen from the place, and its columns do not lie in planes
///           through it, nor, at least, much nearer to such planes than to those through the origin.
///           Assumed: 1 % of the normals are more than 75 degrees beside the middle of the image; or rows or columns are bent as rings round an axis
///           are; or the image is mirrored as seen from the place, and its rows and columns do not lie in planes through it
/// is_elsewhere   whether that is the reason
std::optional<std::size_t> orient_by_grid(Model& model, const ScanGrid& grid, bool* is_elsewhere = nullptr);

}  // namespace isotouch::cloud
