/// How far a live field can be relied on, counted sample by sample so that it is kept up to date with every batch.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace isotouch::live {

/// Which way the normals look as a whole, as sums of integers: positions in 1/64 voxel, normals in 1/512.
struct Facing {
  Eigen::Matrix<std::int64_t, 3, 1> places = Eigen::Matrix<std::int64_t, 3, 1>::Zero(), normals = Eigen::Matrix<std::int64_t, 3, 1>::Zero();
  std::int64_t across = 0;   ///< of normal · position
  std::int64_t squares = 0;  ///< of the positions

  void add(const Eigen::Vector3d& position, const Eigen::Vector3d& normal, bool present);
  /// Do the normals of a scan from all sides look towards its middle? A scan of one side may be hollow, so it is never said of one.
  bool inwards(std::size_t samples) const;
  bool operator==(const Facing&) const = default;
};

struct Verdict {
  std::size_t points = 0;   ///< present
  std::size_t samples = 0;  ///< buckets that hold points
  std::size_t lonely = 0;   ///< samples with too few neighbours within reach: they are not felt
  std::size_t unexplained =
      0;  ///< samples that no local surface explains with their neighbours: normals that contradict each other, strays

  Facing facing;

  double lonely_share() const { return samples > 0 ? static_cast<double>(lonely) / static_cast<double>(samples) : 0.0; }
  double unexplained_share() const { return samples > 0 ? static_cast<double>(unexplained) / static_cast<double>(samples) : 0.0; }

  /// Why the field may be wrong, and what to do; one sentence each; empty = plausible.
  std::vector<std::string> reasons() const;
  bool operator==(const Verdict&) const = default;
};

}  // namespace isotouch::live
