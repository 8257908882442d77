/// The header of a PCD file (Point Cloud Library): what stands in the body, and where it begins.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace isotouch::cloud {

enum class PcdData { kAscii, kBinary, kCompressed };

struct PcdField {
  std::string name;
  char type = 'F';        ///< F, I or U
  std::size_t size = 4;   ///< bytes of one number
  std::size_t count = 1;  ///< numbers, at least one
};

struct PcdHeader {
  std::vector<PcdField> fields;  ///< with x, y and z, each one number
  bool has_normals = false;      ///< normal_x, normal_y and normal_z
  bool has_stiffness = false;
  std::size_t width = 0;
  std::size_t height = 1;                         ///< above 1: an image, row by row
  std::size_t points = 0;                         ///< width times height, as declared; nothing is promised about the body
  std::optional<Eigen::Vector3d> viewpoint = {};  ///< the sensor's place, unless the line VIEWPOINT is missing or says the origin
  bool is_turned = false;                         ///< VIEWPOINT also says that the sensor was turned: the points may be in its own frame
  PcdData data = PcdData::kAscii;
  std::size_t bytes = 0;  ///< the body begins here

  bool is_organised() const { return height > 1; }
};

/// fails     InputError naming the line: bad grammar, unknown keyword, type or data, lists of different length, no x y z, only a part of a normal,
///           counts that contradict each other, a second list of fields
PcdHeader read_pcd_header(const std::string& name, std::span<const std::uint8_t> bytes);

}  // namespace isotouch::cloud
