/// Where a scan ends in the open: seen from its samples alone.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "host/field/scan.h"

namespace isotouch::field {

/// A sample on a rim.
struct RimPlace {
  std::uint32_t sample;
  double length;      ///< of the rim beside it: half of each link to the next ones, the scan's unit
  bool on_longest;    ///< on the longest rim
  std::uint32_t rim;  ///< the sample that stands for its rim
  double surrounded;  ///< length of its rim's mean normal: near 1 round a hole in a face, near 0 round the end of a tube
};

struct OpenRim {
  std::size_t samples = 0;                                ///< on rims
  double length = 0;                                      ///< of all rims together, the scan's unit; within a fifth or so
  Eigen::Vector3d place = Eigen::Vector3d::Zero();        ///< the middle of the longest rim's samples
  double longest = 0;                                     ///< length of the longest rim, the scan's unit
  double least_surrounded = 1;                            ///< of all rims, the least `surrounded`
  Eigen::Vector3d least_place = Eigen::Vector3d::Zero();  ///< the middle of that rim's samples
  std::size_t patches = 0;  ///< samples of all patches: parts, of a scan that has others, that end outward all round and hang on nothing
  std::vector<RimPlace> along = {};                        ///< all samples on rims
  std::vector<std::array<Eigen::Vector3d, 2>> links = {};  ///< from sample to sample along all rims, the scan's unit
};

/// A sample is on a rim when its neighbours, seen in its tangent plane, leave a wide sector empty and none of them shows that the surface turns
/// away there: that is an edge or a tip, not an end. On a thin wall, whose other face takes many of the neighbours, the
/// neighbours' neighbours must leave one, too. Rim samples that are neighbours hang together; the length is that of their shortest spanning tree,
/// closed to a ring. What hangs together in fewer than a dozen samples is chance. So is what does in a few dozens, on both sides of a wall, where the scan
/// has samples on the face in which the wall ends beside most of them.
OpenRim open_rim(const Scan& scan);

}  // namespace isotouch::field
