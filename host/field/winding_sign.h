/// What the scan as a whole says about a place: is it enclosed?
///
/// Every sample stands for the patch of surface nearest to it. The sum of the solid angles of all patches, seen from a place away from them, is the
/// generalised winding number: 1 in the body, 0 outside, and it changes gradually across a part that nobody scanned. A few stray samples hardly
/// change it, and a local model that goes astray does not enter.
///
/// source    G. Barill, N. Dickson, R. Schmidt, D. Levin, A. Jacobson, Fast winding numbers for soups and clouds, 2018
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstdint>
#include <vector>

#include "host/field/scan.h"

namespace isotouch::field {

/// The area that each sample stands for: its cell among its neighbours on its tangent plane, as far as the neighbours' spacing reaches.
std::vector<double> sample_areas(const Scan& scan);

/// How far from the samples the number counts, as a squared distance to the nearest.
struct Doubt {
  double share;  ///< of the nearest nine's spread
  double least;  ///< square of the scan's unit

  constexpr double beyond(double spread) const { return std::max(share * spread, least); }
};
/// At a share of 0.2 the rim of a thin plate loses its edge, at 0.3 the tips of toes stand out by two voxels: where few samples lie, the number is not
/// sharper than that.
inline constexpr Doubt kDoubt{0.25, 0.0};
/// In a scan of one side what is hidden counts for enclosed, right up to the surface beside it that was seen. In voxels.
inline constexpr Doubt kDoubtOfSheet{0.5, 3.0};

class WindingSign {
 public:
  /// scan      at least 1 sample; normals outward
  /// noise     standard deviation of the samples across the surface, the scan's unit
  explicit WindingSign(const Scan& scan, double noise = 0.0, const Doubt& doubt = kDoubt);

  /// The area that a sample stands for, square of the scan's unit.
  double area(std::size_t sample) const { return areas_[sample]; }
  /// By how much a patch of an area is smoothed, squared, in the same unit: sharper, the number would show each sample and its noise.
  double softening(double area) const { return 0.125 * area + 2.0 * noise_ * noise_; }

  /// The winding number, to a tenth at one spacing from the samples or more; nearer it is smoothed.
  double operator()(const Eigen::Vector3d& place) const;

  /// As they were given.
  double noise() const { return noise_; }
  const Doubt& doubt() const { return doubt_; }

  /// Is a place so far from the samples that the number counts? Squared distances to the nearest sample and to the ninth.
  bool in_doubt(double nearest, double ninth) const { return nearest > doubt_.beyond(ninth - nearest); }

 private:
  struct Dipole {
    Eigen::Vector3d centre, area;  ///< area along the normal
  };
  struct Node {
    Dipole whole;
    double far = 0.0;                    ///< squared distance from which on the whole stands for its samples
    std::uint32_t first = 0, count = 0;  ///< of `samples_`
    std::uint32_t next = 0;              ///< the node after this one's descendants
  };

  void add_node(std::uint32_t first, std::uint32_t count);

  double noise_;
  Doubt doubt_;
  std::vector<double> areas_;
  std::vector<Dipole> samples_;
  std::vector<double> softening_;  ///< of a sample, squared
  std::vector<Node> nodes_;        ///< parents before children
};

/// Holds a distance to what encloses its place. Next to the samples it stays as it is; the farther the nearest sample is, compared with how the nearest nine
/// are spread, the more does the winding number count: of a place that is clearly enclosed, or clearly not, it is the sign, whatever the models
/// say, and its distance from one half stands for the way to the surface.
///
/// nearest, ninth   squared distances to the nearest sample and to the ninth
double signed_by_winding(double distance, const Eigen::Vector3d& place, double nearest, double ninth, const WindingSign& enclosure);

}  // namespace isotouch::field
