/// Normals of a range image: from its grid, and estimated as if the grid were not known.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "host/cloud/model.h"
#include "host/cloud/scan_grid.h"
#include "host/field/orientation.h"
#include "tests/support/accuracy.h"
#include "tests/support/random.h"
#include "tests/support/range_image.h"

namespace isotouch::field {
namespace {

using Eigen::Vector3d;
using test::IsAccuracyOf;

struct Shares {
  double beyond_10_degrees = 0;  ///< percent of the normals
  double wrong_side = 0;
};

Shares shares(const std::vector<Vector3d>& normals, const std::vector<Vector3d>& truth) {
  Shares result;
  const double each = 100.0 / static_cast<double>(normals.size());
  for (std::size_t i = 0; i < normals.size(); ++i) {
    const double cosine = normals[i].dot(truth[i]);
    if (cosine < std::cos(10 * M_PI / 180)) result.beyond_10_degrees += each;
    if (cosine < 0) result.wrong_side += each;
  }
  return result;
}

/// Half a metre away a pixel is 1 mm wide; depth is counted in millimetres, or has a noise of half a millimetre.
TEST(RangeImage, NormalsOfTheGridAreMoreAccurateThanEstimatedOnes) {
  struct Case {
    bool noise;
    double grid, estimate;  ///< bounds on the share beyond 10 degrees
  };
  for (const Case& c : {Case{false, 0.8, 16}, {true, 0.02, 40}}) {
    const test::RangeImage image = test::ball_image(0.05, 0.5);
    test::Random random(1);
    cloud::Model model;
    cloud::ScanGrid grid{.columns = image.width};
    std::vector<Vector3d> truth;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
      double z = image.pixels[i].z;
      grid.cells.push_back(z == 0 ? cloud::ScanGrid::kNoReturn : static_cast<std::uint32_t>(truth.size()));
      if (z == 0) continue;
      z = c.noise ? z + 0.0005 * (random.uniform(-1, 1) + random.uniform(-1, 1) + random.uniform(-1, 1)) : std::round(z * 1000) / 1000;
      const auto [x, y, one] = image.ray(i);
      model.positions.emplace_back(x * z, y * z, z);
      model.lines.push_back(truth.size());
      truth.emplace_back(image.pixels[i].normal[0], image.pixels[i].normal[1], image.pixels[i].normal[2]);
    }
    ASSERT_TRUE(orient_by_grid(model, grid));
    std::vector<Vector3d> true_ones;
    for (const std::size_t point : model.lines) true_ones.push_back(truth[point]);
    std::vector<Vector3d> estimated = estimated_normals(model.positions);
    for (std::size_t i = 0; i < estimated.size(); ++i) {  // the viewpoint tells the side
      if (estimated[i].dot(model.positions[i]) > 0) estimated[i] = -estimated[i];
    }
    const Shares of_grid = shares(model.normals, true_ones), of_estimate = shares(estimated, true_ones);
    EXPECT_THAT(of_grid.beyond_10_degrees, IsAccuracyOf(c.grid)) << c.noise;
    EXPECT_THAT(of_estimate.beyond_10_degrees, IsAccuracyOf(c.estimate)) << c.noise;
    EXPECT_EQ(of_grid.wrong_side, 0);
  }
}

}  // namespace
}  // namespace isotouch::field
