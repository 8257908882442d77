/// The published method's own figures: the columns of its Table 1, the paper's beside ours.
///
/// source    Sreeni K. G., Distance Field based Haptic Rendering of Scattered Oriented Points, 2013, Table 1: a Core 2 Quad at 2.66 GHz with 2 GB
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <vector>

namespace isotouch::evaluate {

/// As printed in the paper.
struct PaperRow {
  const char* name;
  std::size_t points;
  std::size_t inside_nodes;
  double seconds;
  Eigen::Vector3i grid;  ///< zero where the paper does not state it
};

struct PublishedRow {
  PaperRow paper;
  std::string name;
  std::size_t points = 0;
  std::size_t inside_nodes = 0;
  double seconds = 0;                              ///< radii, indicator and levels
  Eigen::Vector3i grid = Eigen::Vector3i::Zero();  ///< nodes along the cloud's box; the paper states it for two of its objects
};

/// Hydrant, owl, boy, bomberman, jaguar.
const std::vector<PaperRow>& paper_table();

/// Our object of this name: the paper's number of points, about the paper's size in voxels.
PublishedRow published_row(const PaperRow& paper);

/// All of them.
std::vector<PublishedRow> published_table();

}  // namespace isotouch::evaluate
