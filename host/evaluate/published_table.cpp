#include "host/evaluate/published_table.h"

#include <utility>

#include "host/cloud/shapes.h"
#include "host/field/make_grid.h"
#include "host/field/progress.h"
#include "host/published/build.h"

namespace isotouch::evaluate {

std::vector<PublishedRow> published_table() {
  std::vector<PublishedRow> rows;
  for (const char* name : {"hydrant", "owl", "boy", "bomberman", "jaguar"}) {
    const cloud::Shape shape = cloud::shape(name);
    const cloud::OrientedPoints points = cloud::sample_shape(shape, shape.default_points);
    Eigen::Vector3d low = points.positions.front();
    Eigen::Vector3d high = low;
    for (const Eigen::Vector3d& position : points.positions) {
      low = low.cwiseMin(position);
      high = high.cwiseMax(position);
    }
    const field::Grid grid = field::make_grid(low, high, 1.0, published::kMargin);  // a shape's unit is a voxel
    field::Progress progress;
    const published::Built built = published::build(points, grid, progress);
    progress.end();
    PublishedRow row{name, points.size(), built.inside_nodes, 0, (high - low).array().round().matrix().cast<int>()};
    for (const auto& [stage, seconds] : progress.seconds()) row.seconds += seconds;
    rows.push_back(row);
  }
  return rows;
}

}  // namespace isotouch::evaluate
