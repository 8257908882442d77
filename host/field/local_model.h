/// What the surface looks like round one sample: up to four smooth pieces, joined by "both" at convex edges and by "either" at creases.
///
/// No sample marks an edge, so the data decide: the neighbours are split into one to four pieces where their normals jump most, each piece
/// becomes a patch, every way to join the patches is tried, and the model that explains the neighbours best for its number of free
/// parameters wins. A flat face stays one piece, a box's edge becomes two planes with an exact edge between them, a thin plate two planes
/// back to back; a round bar stays round, because two planes explain its normals worse than one cylinder.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "host/field/patch_fit.h"
#include "host/field/scan.h"
#include "host/field/toroidal_patch.h"

namespace isotouch::field {

inline constexpr std::size_t kMaxPieces = 4;

struct LocalModel {
  std::array<ToroidalPatch, kMaxPieces> pieces{};  ///< in the order in which they are joined
  std::uint8_t count = 1;
  double trust = 1.0;        ///< weight in a blend: the inverse of the error with which it explains its neighbours
  std::uint8_t concave = 0;  ///< bit k: piece k is joined to those before it by union (min), else by intersection (max)

  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< the sample
  double reach = 0.0;                                ///< to the farthest neighbour that the model explains

  /// Signed distance, never larger than the true one to the joined pieces outside a convex edge and inside a concave one. Beyond `reach` the
  /// pieces know nothing: there the sign stays as it is at the reach along the line from the sample, and the value grows with the way.
  double distance(const Eigen::Vector3d& x) const {
    const Eigen::Vector3d way = x - centre;
    const double squared = way.squaredNorm();
    if (squared <= reach * reach || reach == 0.0) return joined(x);
    const double share = reach / std::sqrt(squared);
    return joined(centre + share * way) / share;
  }

 private:
  double joined(const Eigen::Vector3d& x) const {
    double value = pieces[0].distance(x);
    for (std::size_t k = 1; k < count; ++k) {
      const double next = pieces[k].distance(x);
      value = (concave >> k & 1) != 0 ? (next < value ? next : value) : (next > value ? next : value);
    }
    return value;
  }
};

/// Of a sample's list, those that its model may depend on, itself among them.
inline constexpr std::size_t kModelled = 14;

/// The model of one sample.
///
/// samples   the sample itself first, with weight 1, then its nearest neighbours by distance, at most 12, with weights 0 to 1 that fall with the
///           distance; at least 2
LocalModel fit_model(const std::vector<WeightedSample>& samples);

/// Did no surface explain the neighbours? The model is the tangent plane then, which is all that is known.
bool is_unexplained(const LocalModel& model);

/// One model a sample, by looking at its 12 nearest neighbours.
///
/// scan      at least 2 samples
/// models    where given, of what `known` says true of a sample number: it stays as it is
std::vector<LocalModel> local_models(const Scan& scan);
void fit_models(const Scan& scan, const std::vector<std::uint8_t>& known, std::vector<LocalModel>& models);

}  // namespace isotouch::field
