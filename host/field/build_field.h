/// The default method: oriented points → signed distance in a band, analytic, continuous and two-sided.
#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "host/cloud/oriented_points.h"
#include "host/field/band_field.h"
#include "host/field/progress.h"
#include "host/field/unsupported_components.h"

namespace isotouch::field {

/// Voxels by which the surface may bulge beyond the box of its samples, or go on where a scan is cut open; there it is closed.
inline constexpr double kBulge = 3.0;
/// The margin round the points, voxels, that leaves room for that: what `make_grid` should be asked for.
constexpr double field_margin(double band) { return band + kBulge + 3.0; }

/// What was doubtful about the samples, and mended.
struct Repair {
  std::size_t isolated = 0;      ///< samples far from all others, left out
  std::size_t turned = 0;        ///< normals that nearly all neighbours contradicted
  double surprising = 0;         ///< share of the surface whose samples lie more than a voxel off where their neighbours expect it
  double unexplained = 0;        ///< share of the samples whose neighbours no local surface explains
  double twice_enclosed = 0;     ///< of the surface that was measured: another layer of the scan lies round it
  UnsupportedComponents debris;  ///< pieces and cavities that no sample stands for
  std::vector<std::string> warnings() const;
};

/// Where the points come from.
struct Origin {
  std::size_t measured = std::numeric_limits<
      std::size_t>::max();  ///< so many, the first, were measured; `Repair` is about these alone where it speaks of shares
  bool is_sheet = false;    ///< these show one side; the others are walls and a back
  double noise = 0.0;       ///< standard deviation of the measured points before they were smoothed, mm
};

/// points    workspace, mm; unit outward normals; at least 8
/// grid      covers the points with a margin of at least band + 3 voxels on every side; with less than `field_margin` bulges are cut short
/// band      half width, voxels, 1 to 7.99
/// returns   distances in voxels, exact near the surface to the method's accuracy; empty bricks are wholly outside or wholly inside. A stiffness of each
///           brick where the points have one
/// repair    where given, is told what was mended
/// fails     InputError when there are too few points, when the grid is too small, or when the points do not enclose a body
BandField build_field(const cloud::OrientedPoints& points, const Grid& grid, double band, Progress& progress, Repair* repair = nullptr,
                      const Origin& origin = {});

}  // namespace isotouch::field
