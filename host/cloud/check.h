/// What a cloud must be before anything is built from it, and what is put right on the way.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "host/cloud/model.h"
#include "host/cloud/oriented_points.h"

namespace isotouch::cloud {

/// What was found in a file and what was done to it.
struct CloudReport {
  std::string format;             ///< "PLY, binary little-endian"
  std::uint64_t source_hash = 0;  ///< of the file's bytes, as an image stores it
  std::size_t points_read = 0;
  std::size_t points = 0;                 ///< after merging
  bool has_normals = true;                ///< if not, the points' normals are zero, and to be estimated
  std::size_t unused_faces = 0;           ///< of the file, which also has faces
  std::optional<std::size_t> edges = {};  ///< the normals come from the scan's grid; points at its edges that were left out
  Sensor sensor = {};
  std::size_t incomplete = 0;     ///< points whose coordinates or normal are not finite, or whose normal is zero, left out
  std::size_t renormalised = 0;   ///< normals whose length was more than 1 % off
  std::size_t merged = 0;         ///< points at a place that another one already had
  std::size_t contradictory = 0;  ///< points whose normals contradict each other at their place
  bool two_faced = false;         ///< so many that one of each place is kept, with a normal of unknown sign; few are left out
  Eigen::Vector3d low = Eigen::Vector3d::Zero();  ///< the points' box, cloud units
  Eigen::Vector3d high = Eigen::Vector3d::Zero();

  /// Why an image's grid was not used and what to do if that is wrong, as a clause; empty where it was used or is none.
  std::string sensor_doubt() const;
  /// One sentence for each thing that was put right or looks doubtful.
  std::vector<std::string> warnings(bool are_normals_used = true) const;
};

/// Checks and mends, in this order:
///
/// no normals   points whose normal is zero are left out, if these are at most half of them
/// normals      a length from 1/2 to 2 is brought to 1 (further off it is refused: it may not be a normal at all)
/// duplicates   points at exactly the same place become one, in the place of the first, with the mean of their normals and stiffnesses; when that mean is
///              shorter than 1/2 (two normals more than 120 degrees apart) all of them are left out,
///              unless that happens at a tenth of all places: then the first is kept
/// clumps       a scan that was saved several times, and moved a little, lies in clumps, each of which becomes one point in the same way; not where a tenth
///              of the clumps have opposite normals
///
/// name      of the file, for the sentences
/// fails     InputError: no points, most normals zero, all coded without a sign, one far from unit length (with its place), a coordinate beyond 1e12,
///           a stiffness outside (0, 100] N/mm (with its place), fewer than 8 points left
OrientedPoints check(const std::string& name, Model model, CloudReport& report);

/// The same of a frame of a scan that goes on, as far as it shows without the other frames. A normal whose length `check` refuses becomes zero: among
/// thousands of frames there is one, and it ends no stream.
///
/// fails     InputError: the normals are coded without a sign
void check_frame(const std::string& name, Model& model);

/// A place for people: "(0.1, 2, -3)".
std::string in_brackets(const Eigen::Vector3d& place);

/// From a point to its nearest neighbour, the median: of a large cloud, of 4,096 points and a few more, spread over the list.
///
/// positions  at least 2, no two at one place
double median_spacing(const std::vector<Eigen::Vector3d>& positions);

}  // namespace isotouch::cloud
