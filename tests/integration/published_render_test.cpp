/// A field of the published method as the controller renders it, against the same method in floating point on the levels themselves.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "host/encoding/write_image.h"
#include "host/evaluate/descent_tick.h"
#include "host/evaluate/force_error.h"
#include "host/evaluate/shape_trial.h"
#include "host/field/make_grid.h"
#include "host/field/progress.h"
#include "host/field_file/open_field.h"
#include "host/published/build.h"
#include "host/to_double.h"

namespace isotouch {
namespace {

using Eigen::Vector3d;

TEST(PublishedRender, TheControllerFeelsWhatThePaperDescribes) {
  evaluate::ShapeTrial trial = evaluate::shape_trial("sphere");
  const double voxel = 4 * trial.grid.edge;
  trial.grid = field::make_grid(voxel / 4 * trial.shape.low, voxel / 4 * trial.shape.high, voxel, published::kMargin);
  field::Progress progress;
  const published::LevelField levels = published::build(trial.points, trial.grid, progress).levels;
  encoding::FieldInfo info;
  info.method = Method::kPublished;
  const field_file::OpenField field = field_file::open_field(encoding::write_image(published::to_band_field(levels), info), "sphere");
  const double stiffness = to_double(field.view.stiffness);

  evaluate::DescentTick floating(levels, static_cast<float>(stiffness));
  const evaluate::ForceTick core = evaluate::core_force(field.view);
  std::vector<double> differences;
  double strongest = 0;
  const auto both = [&](const Vector3d& hip) -> Vector3d {
    const Vector3d felt = core(hip), meant = floating.force(hip.cast<float>()).cast<double>();
    strongest = std::max(strongest, meant.norm());
    differences.push_back((felt - meant).norm());
    return felt;
  };
  evaluate::slide_on_sphere(evaluate::trial_slide(field.view, 300), both);

  ASSERT_GT(differences.size(), 1000U);
  EXPECT_GT(strongest, 0.5);
  std::sort(differences.begin(), differences.end());
  EXPECT_LT(differences.back(), 0.001);
}

}  // namespace
}  // namespace isotouch
