/// What a file of points or faces holds, as it stands there: the readers' common result, not yet checked beyond the file's own grammar.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "host/cloud/scan_grid.h"

namespace isotouch::cloud {

/// What is known of the sensor's place.
struct Sensor {
  std::optional<Eigen::Vector3d> place = {};          ///< in the positions' frame
  bool is_assumed = false;                            ///< the file does not state it, but its grid is that of a camera there
  bool is_turned = false;                             ///< the file states, too, that the sensor was turned
  std::optional<Eigen::Vector3d> refuted_place = {};  ///< what the file states, if its grid was not seen from there
  bool looks_past = false;                            ///< a depth image's principal point lies outside it
  bool is_elsewhere = false;                          ///< the grid was seen neither from a place that the file states nor from the origin
};

struct Model {
  /// A polygon of more than three corners, as a fan among the faces.
  struct Polygon {
    std::size_t first, count;  ///< of `faces`
    std::size_t line, number;  ///< where it stands, from 1: the line of a text (else 0), and which of the faces it is
  };

  std::string format;                               ///< for people: "PLY, binary little-endian"
  std::vector<Eigen::Vector3d> positions;           ///< finite
  std::vector<Eigen::Vector3d> normals;             ///< finite; one for each position, or none at all
  std::vector<std::size_t> lines;                   ///< where each position stands in a text; empty for binary files
  std::vector<std::array<std::uint32_t, 3>> faces;  ///< indices of positions; larger polygons are fans until `cut_polygons`
  std::vector<Polygon> polygons = {};
  std::size_t unused_faces = 0;           ///< of the file, where its points were asked for
  std::vector<double> stiffness = {};     ///< N/mm; one for each position, or none at all
  std::optional<ScanGrid> grid = {};      ///< of an organised scan without normals
  std::optional<std::size_t> edges = {};  ///< the normals come from the grid; points at edges that were left out for that
  Sensor sensor = {};
  bool is_array = false;  ///< the caller's own: its points are counted from 0, as arrays count
  std::size_t incomplete =
      0;  ///< points left out because their coordinates or their normal are not finite, or because their normal is zero

  /// "line 12" or "point 12", counted from 1; "point 11 (counted from 0)" of an array.
  std::string place(std::size_t point) const {
    if (is_array) return "point " + std::to_string(point) + " (counted from 0)";
    return lines.empty() ? "point " + std::to_string(point + 1) : "line " + std::to_string(lines[point]);
  }
};

/// A normal of a file; zero where it is not finite: programs write NaN for one that they do not know, and `check` counts those of zero.
inline Eigen::Vector3d known_or_zero(const Eigen::Vector3d& normal) { return normal.allFinite() ? normal : Eigen::Vector3d(0, 0, 0); }

/// Leaves points out of a model without a grid.
///
/// stays     called with each point's index
/// returns   how many
template <class Stays>
std::size_t keep_points(Model& model, const Stays& stays) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < model.positions.size(); ++i) {
    if (!stays(i)) continue;
    model.positions[kept] = model.positions[i];
    if (!model.normals.empty()) model.normals[kept] = model.normals[i];
    if (!model.lines.empty()) model.lines[kept] = model.lines[i];
    if (!model.stiffness.empty()) model.stiffness[kept] = model.stiffness[i];
    ++kept;
  }
  const std::size_t left_out = model.positions.size() - kept;
  model.positions.resize(kept);
  if (!model.normals.empty()) model.normals.resize(kept);
  if (!model.lines.empty()) model.lines.resize(kept);
  if (!model.stiffness.empty()) model.stiffness.resize(kept);
  return left_out;
}

}  // namespace isotouch::cloud
