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

class Scene {
 public:
  using Rim = std::vector<std::array<Eigen::Vector3d, 2>>;

  static constexpr std::size_t kVertices = 90'000;  ///< of the surface, about
  static constexpr std::size_t kPoints = 60'000;    ///< that are drawn

  /// name      for people
  /// points    workspace, mm; may be empty
  /// rim       lines along which the points end in the open, workspace, mm
  Scene(std::string name, field_file::OpenField field, const cloud::OrientedPoints& points = {}, const Rim& rim = {});

  const FieldView& field() const { return field_.view; }
  /// Figures of the field, with their units in their names.
  nlohmann::ordered_json summary() const;
  /// Whole numbers: vertices, faces. Per vertex 16 bytes: position as three floats (mm), normal as three signed bytes (127 = 1), a byte that is 1 where
  /// the surface was invented. Per face three whole numbers.
  const std::string& surface() const { return surface_; }
  /// A whole number: points. Per point as a vertex; the last byte is 0.
  const std::string& points() const { return points_; }
  /// A whole number: lines. Per line six floats: both ends (mm).
  const std::string& rim() const { return rim_; }
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
  std::size_t all_points_ = 0;
  double invented_share_ = 0;
  int step_ = 1;
  std::string surface_, points_, rim_;
};

}  // namespace isotouch::server
