/// A scan put in order before anything is built from it: strays out, one outside, and a back where only one side was scanned.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "host/cloud/oriented_points.h"
#include "host/field/default_grid.h"
#include "host/field/open_rim.h"
#include "host/field/rounding.h"

namespace isotouch::field {

/// How the whole of a scan got its outside.
enum class Outside {
  kAsGiven,     ///< the normals' votes are clear, or nothing contradicts them
  kTurned,      ///< a closed surface whose normals clearly pointed inward: all turned
  kNeighbours,  ///< the normals contradicted each other, or there were none: by agreement of neighbours
  kViewpoint,   ///< towards the sensor
  kDoubtful,    ///< the votes are not clear; nothing was changed
};

/// Who says where the sensor stood. A depth image has its camera in the origin, and nobody can say otherwise.
enum class SensorFrom { kPerson, kFile, kAssumption, kDepthImage };

struct SoundScan {
  cloud::OrientedPoints points;       ///< the measured ones in their order, then the invented
  std::size_t measured = 0;           ///< how many of them were measured
  bool is_estimated = false;          ///< its normals are not the file's
  bool is_sheet = false;              ///< of one side: what was invented are walls and a back
  bool is_capped = false;             ///< the scan ends in a plane, and what was invented closes it there (cut_plane.h)
  bool is_on_table = false;           ///< the scan ends in a plane that looks back at it; a relief with a flat edge does, too
  std::size_t strays = 0;             ///< points left out: far from the others, or not confirmed by those beside them (outliers.h)
  std::size_t sparse = 0;             ///< points kept as a side that is much sparser than the other side of its wall (outliers.h)
  double unknown_side = 0;            ///< the surface of such a side over that of the rest, where it was left out: the file has no normals
  std::size_t strays_among = 0;       ///< of these those in the box round the points that stay, or just beside it
  std::vector<std::uint32_t> turned;  ///< of the measured points those whose normal points the other way than in the file
  std::size_t inside_out = 0;         ///< of these those of closed parts that hang on nothing (lone_parts.h)
  double contradicted = 0;            ///< of the clear pairs of neighbours: their normals contradict each other still
  double noise = 0;                   ///< standard deviation of the points across the surface, their unit
  bool smoothed = false;              ///< the noise was taken back as far as neighbours tell
  double tilt = 0;                    ///< sine of the angle between normals and what the positions say, the median
  double layered = 0;                 ///< where the file has no normals: `Roughness::layered`
  double spacing = 0;                 ///< median distance to the nearest point, their unit
  double rounding = 0;                ///< the step to which all coordinates were rounded (rounding.h), their unit
  AxisStep coarsest;                  ///< `coarsest_axis`, their unit
  double float_step = 0;              ///< between the 32-bit floats in which all coordinates are (rounding.h), their unit
  double hidden = 0;                  ///< `hidden_share` from the sensor's place, where that is known
  double in_lines = 0;                ///< where the file has no normals: `share_in_lines`
  double enclosed = 0;                ///< volume that the points enclose by the divergence theorem, their unit cubed
  double one_sided = 0;               ///< 0 for a closed surface, 1 for a flat sheet
  OpenRim rim;                        ///< where the measured points end; their unit, but for `least_place`, which stays as in the file
  Outside outside = Outside::kAsGiven;
  SensorFrom sensor_from = SensorFrom::kPerson;  ///< where that is the sensor's side

  /// To the workspace, mm.
  void place(const cloud::Placement& placement);
  /// Leaves the measured points alone.
  void drop_invented();

  /// The grid where nobody says how fine: as fine as the points support. Noise hides what a finer one would show.
  ///
  /// sides     of the box round the measured points, in the points' present unit
  /// returns   voxels along the longest side
  int usual_grid(const Eigen::Vector3d& sides) const { return !smoothed && spacing > 0 ? default_grid(sides, spacing) : kCoarseGrid; }

  /// One sentence for each thing that was put right or looks doubtful; in the workspace.
  std::vector<std::string> warnings() const;
};

struct ScanOptions {
  bool estimate = false;                          ///< take no normal from the file
  std::optional<Eigen::Vector3d> viewpoint = {};  ///< the sensor's place, in the points' frame
  SensorFrom from = SensorFrom::kPerson;          ///< who says so
  std::string sensor_doubt = {};                  ///< why nobody does, for a refusal: a clause, or empty
  std::string name = {};                          ///< of the file, for a refusal; empty: whoever catches it names it
};

/// points    any length unit; at least 8; unit normals, of any sign where `estimate`
/// fails     InputError when nothing is left, when all normals are equal on a body that is not flat, or when a sheet without normals has no viewpoint
SoundScan sound_scan(cloud::OrientedPoints points, const ScanOptions& options = {});

}  // namespace isotouch::field
