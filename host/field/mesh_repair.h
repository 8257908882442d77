/// What was put right in a mesh, and the words in which that is told.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <vector>

namespace isotouch::field {

/// What was found and what was done. Places and lengths in the mesh's unit.
struct MeshRepair {
  std::size_t repeated = 0;                           ///< faces that were written before, and dropped
  std::size_t holes = 0;                              ///< closed by fans
  double rim_length = 0;                              ///< of all of them
  Eigen::Vector3d rim = Eigen::Vector3d::Zero();      ///< the middle of the longest
  std::size_t branching = 0;                          ///< edges of more than two faces
  Eigen::Vector3d branch = Eigen::Vector3d::Zero();   ///< the middle of the first of them
  bool turned = false;                                ///< all faces were turned round
  std::size_t swallowed = 0;                          ///< closed pieces that lie in others and face outwards: they bound nothing
  Eigen::Vector3d swallow = Eigen::Vector3d::Zero();  ///< the middle of a face of the first of them
  double coarse = 0;                                  ///< not looked for by `closed_mesh`, see `MeshDistance::coarse_parts`
  std::size_t crossing = 0;  ///< faces that run through others; not looked for by `closed_mesh`, see `MeshDistance::crossings`
  Eigen::Vector3d cross = Eigen::Vector3d::Zero();  ///< the middle of the first of them

  /// One sentence for each of these.
  std::vector<std::string> warnings() const;
};

/// A length or a coordinate, as "0.25".
std::string length_text(double length);

/// As "(1, 0.5, 0)".
std::string place_text(const Eigen::Vector3d& place);

/// As "1 face" or "3 faces".
std::string count_text(std::size_t count, const char* one, const char* many);

/// The clause that tells of a mesh's rims.
std::string rims_text(const MeshRepair& repair);

}  // namespace isotouch::field
