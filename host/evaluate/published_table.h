/// The published method's own figures: the columns of its Table 1.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <vector>

namespace isotouch::evaluate {

struct PublishedRow {
  std::string name;
  std::size_t points = 0;
  std::size_t inside_nodes = 0;
  double seconds = 0;                              ///< radii, indicator and levels
  Eigen::Vector3i grid = Eigen::Vector3i::Zero();  ///< nodes along the cloud's box; the paper states it for two of its objects
};

/// Hydrant, owl, boy, bomberman, jaguar, at the paper's point counts and sizes in voxels.
std::vector<PublishedRow> published_table();

}  // namespace isotouch::evaluate
