#include "host/evaluate/published_table.h"

#include <utility>

#include "host/cloud/shapes.h"
#include "host/field/make_grid.h"
#include "host/field/progress.h"
#include "host/published/build.h"

namespace isotouch::evaluate {

const std::vector<PaperRow>& paper_table() {
  static const std::vector<PaperRow> rows = {{"hydrant", 3756, 586'222, 30.86, {0, 0, 0}},
                                             {"owl", 3725, 824'436, 38.09, {186, 173, 87}},
                                             {"boy", 5153, 304'072, 26.26, {126, 187, 72}},
                                             {"bomberman", 3751, 1'129'209, 110.82, {0, 0, 0}},
                                             {"jaguar", 4433, 134'987, 11.67, {0, 0, 0}}};
  return rows;
}

PublishedRow published_row(const PaperRow& paper) {
  const cloud::Shape shape = cloud::shape(paper.name);
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
  PublishedRow row{paper, paper.name, points.size(), built.inside_nodes, 0, (high - low).array().round().matrix().cast<int>()};
  for (const auto& [stage, seconds] : progress.seconds()) row.seconds += seconds;
  return row;
}

std::vector<PublishedRow> published_table() {
  std::vector<PublishedRow> rows;
  for (const PaperRow& paper : paper_table()) rows.push_back(published_row(paper));
  return rows;
}

}  // namespace isotouch::evaluate
