/// The object as the page draws it: its surface, the points it was built from, slices, and what is known of it.
#pragma once

#include <array>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "host/cloud/oriented_points.h"
#include "host/field_file/open_field.h"

namespace isotouch::server {

using Lines = std::vector<std::array<Eigen::Vector3d, 2>>;  ///< both ends of each; workspace, mm

/// What the build knows beside the field; all empty where a field was read from a file.
struct Scan {
  cloud::OrientedPoints points = {};  ///< workspace, mm
  Lines rim = {};                     ///< along which the points end in the open
  Lines turned = {};                  ///< at each point whose normal was turned, along the normal as it is now
};

class Scene {
 public:
  static constexpr std::size_t kMaxVertices = 90'000;  ///< of the surface, about
  static constexpr std::size_t kMaxPoints = 60'000;    ///< that are drawn, and lines of a kind
  static constexpr double kThin_voxels = 3;            ///< a wall that is thinner is marked

  /// name      for people
  Scene(std::string name, field_file::OpenField field, const Scan& scan = {});

  const FieldView& field() const { return field_.view; }
  /// That names the field: 16 hexadecimal digits.
  const std::string& hash() const { return hash_; }
  /// Figures of the field, with their units in their names. `invented_share` is null where the field has no marks: nothing was invented, or nobody knows, as of
  /// a controller's field.
  nlohmann::ordered_json summary() const;
  /// Whole numbers: vertices, faces. Per vertex 16 bytes: position as three floats (mm), normal as three signed bytes (127 = 1), a byte of marks: 1
  /// where the surface was invented, 2 where the wall behind it is thinner than kThin_voxels. Per face three whole numbers.
  const std::string& surface() const { return surface_; }
  /// A whole number: points. Per point as a vertex; the last byte is 0.
  const std::string& points() const { return points_; }
  /// A whole number: lines. Per line six floats: both ends (mm).
  const std::string& rim() const { return rim_; }
  /// In the same form.
  const std::string& turned() const { return turned_; }
  /// The field's image, as a controller has it in memory.
  std::string image() const;

  /// Distances in a plane across an axis: whole numbers columns and rows, floats for its first corner, its columns' end and its rows' end (mm), then a
  /// float for each sample (mm, negative inside).
  ///
  /// axis      'x', 'y' or 'z'
  /// at        mm on it
  /// samples   along the longer side, 2 to 512
  std::string slice(char axis, double at, int samples) const;

 private:
  std::string name_;
  field_file::OpenField field_;
  std::string hash_;  ///< kept: it takes time, and the thread of all sockets asks for it
  std::size_t all_points_ = 0;
  std::optional<double> invented_share_;
  double thin_share_ = 0;
  int step_ = 1;
  std::string surface_, points_, rim_, turned_;
};

}  // namespace isotouch::server
