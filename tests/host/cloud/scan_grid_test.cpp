#include "host/cloud/scan_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "host/cloud/model.h"
#include "tests/support/accuracy.h"
#include "tests/support/random.h"
#include "tests/support/range_image.h"

namespace isotouch::cloud {
namespace {

using Eigen::Vector3d;
using test::IsAccuracyOf;

/// A range image as a reader would hand it over; `lines` says which pixel a point is.
struct Scan {
  test::RangeImage image;
  Model model;
  ScanGrid grid;

  explicit Scan(test::RangeImage seen) : image(std::move(seen)), grid{.columns = image.width} {
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
      const double z = image.pixels[i].z;
      grid.cells.push_back(z == 0 ? ScanGrid::kNoReturn : static_cast<std::uint32_t>(model.positions.size()));
      if (z == 0) continue;
      const auto [x, y, one] = image.ray(i);
      model.positions.emplace_back(x * z, y * z, z);
      model.lines.push_back(i);
    }
  }

  Vector3d truth(std::size_t point) const {
    const auto& n = image.pixels[model.lines[point]].normal;
    return {n[0], n[1], n[2]};
  }
  /// Degrees between found and true normals: 95 % are smaller.
  double error() const {
    std::vector<double> errors;
    for (std::size_t i = 0; i < model.normals.size(); ++i)
      errors.push_back(std::acos(std::clamp(model.normals[i].dot(truth(i)), -1.0, 1.0)) * 180 / M_PI);
    std::sort(errors.begin(), errors.end());
    return errors[errors.size() * 95 / 100];
  }
  std::size_t facing() const {
    std::size_t count = 0;
    for (std::size_t i = 0; i < model.normals.size(); ++i) count += model.normals[i].dot(grid.sensor - model.positions[i]) > 0 ? 1U : 0U;
    return count;
  }
  void shake(double noise) {
    test::Random random(7);
    for (Vector3d& p : model.positions) p *= 1 + noise * (random.uniform(-1, 1) + random.uniform(-1, 1) + random.uniform(-1, 1)) / p.norm();
  }
};

TEST(ScanGrid, NormalsOfABallAndOfHillsAreTrueAndFaceTheCamera) {
  Scan ball(test::ball_image(0.05, 0.5)), hills(test::relief_image(0.003, 0.03, 0.5));
  for (Scan* scan : {&ball, &hills}) {
    const std::vector<Vector3d> before = scan->model.positions;
    const auto edges = orient_by_grid(scan->model, scan->grid);
    ASSERT_TRUE(edges);
    EXPECT_EQ(scan->model.normals.size(), before.size() - *edges);
    EXPECT_EQ(scan->facing(), scan->model.normals.size());
    for (std::size_t i = 0; i < scan->model.positions.size(); ++i) {  // no place was moved
      ASSERT_EQ(scan->model.positions[i], before[scan->grid.cells[scan->model.lines[i]]]);
      ASSERT_NEAR(scan->model.normals[i].norm(), 1, 1e-12);
    }
  }
  EXPECT_THAT(ball.error(), IsAccuracyOf(1.2));
  EXPECT_THAT(hills.error(), IsAccuracyOf(0.8));
}

TEST(ScanGrid, WiderWindowsKeepNormalsTrueInNoise) {
  for (const auto& [noise, error] : {std::pair{0.0002, 4.5}, {0.0005, 6.0}, {0.001, 7.5}}) {
    Scan ball(test::ball_image(0.05, 0.5));
    ball.shake(noise);
    ASSERT_TRUE(orient_by_grid(ball.model, ball.grid));
    EXPECT_THAT(ball.error(), IsAccuracyOf(error)) << noise;
    EXPECT_EQ(ball.facing(), ball.model.normals.size());
  }
}

/// From whichever corner rows and columns are counted.
TEST(ScanGrid, AMirroredGridFacesTheCameraToo) {
  Scan ball(test::ball_image(0.05, 0.5));
  for (auto row = ball.grid.cells.begin(); row != ball.grid.cells.end(); row += static_cast<std::ptrdiff_t>(ball.grid.columns))
    std::reverse(row, row + static_cast<std::ptrdiff_t>(ball.grid.columns));
  ASSERT_TRUE(orient_by_grid(ball.model, ball.grid));
  EXPECT_EQ(ball.facing(), ball.model.normals.size());
}

/// A relief that was moved into its own frame: the camera looked down from far above, and the origin lies below.
TEST(ScanGrid, AnAssumedSensorBehindTheImageIsNotBelieved) {
  Scan relief(test::RangeImage{});
  relief.model.positions.clear();
  relief.grid.columns = 60;
  relief.grid.cells.clear();
  for (int row = 0; row < 60; ++row) {
    for (int column = 0; column < 60; ++column) {
      const double x = column - 29.5, y = 29.5 - row;
      relief.grid.cells.push_back(static_cast<std::uint32_t>(relief.model.positions.size()));
      relief.model.positions.emplace_back(x, y, 8 + 6 * std::exp(-(x * x + y * y) / 300));
    }
  }
  relief.grid.known = ScanGrid::Known::kAssumed;
  ASSERT_FALSE(orient_by_grid(relief.model, relief.grid));
  relief.grid.sensor = Vector3d(0, 0, 500);
  ASSERT_TRUE(orient_by_grid(relief.model, relief.grid));
  EXPECT_EQ(relief.facing(), relief.model.normals.size());
}

/// Some cameras deliver mirrored images, and stand in the origin all the same.
TEST(ScanGrid, AnAssumedSensorThatTheColumnsLeadToIsBelieved) {
  for (const bool mirrored : {false, true}) {
    Scan ball(test::ball_image(0.05, 0.5));
    for (auto row = ball.grid.cells.begin(); mirrored && row != ball.grid.cells.end();
         row += static_cast<std::ptrdiff_t>(ball.grid.columns))
      std::reverse(row, row + static_cast<std::ptrdiff_t>(ball.grid.columns));
    for (Vector3d& p : ball.model.positions) p = 0.0001 * (10000 * p).array().round();  // tenths of a millimetre
    ball.grid.known = ScanGrid::Known::kAssumed;
    ASSERT_TRUE(orient_by_grid(ball.model, ball.grid)) << mirrored;
    EXPECT_EQ(ball.facing(), ball.model.normals.size()) << mirrored;
  }
}

/// A grid of rings round an axis through the origin, `around` half turns and `along` half heights of an ellipsoid wide. Some programs write the origin where
/// nothing returned: each block of 30 rows and columns begins with a square of `zeros` such cells.
struct Rings {
  Model model = {};
  ScanGrid grid{.columns = kSide, .cells = {}, .known = ScanGrid::Known::kAssumed};

  Rings(bool turned, bool rings_are_columns, double around, double along, int zeros) {
    for (int row = 0; row < kSide; ++row) {
      for (int column = 0; column < kSide; ++column) {
        const double step = (rings_are_columns ? row : column) / (kSide - 1.0),
                     height = (rings_are_columns ? column : row) / (kSide - 1.0) - 0.5;
        const double angle = (turned ? -1 : 1) * M_PI * around * step, down = 2 * along * height;
        grid.cells.push_back(static_cast<std::uint32_t>(model.positions.size()));
        model.positions.emplace_back(std::cos(down) * std::cos(angle), 0.6 * std::cos(down) * std::sin(angle), -0.8 * std::sin(down));
        if (row % 30 < zeros && column % 30 < zeros) model.positions.back().setZero();
      }
    }
  }

 private:
  static constexpr int kSide = 90;
};

/// As a turntable or a program lays them: the columns lie in planes through the origin, which is within the body.
TEST(ScanGrid, AGridRoundAnAxisThroughTheOriginIsNoImage) {
  for (const bool turned : {false, true}) {
    for (const bool rings_are_columns : {false, true}) {
      for (const auto& [around, along] : {std::pair{0.6, 0.5}, {0.3, 1.2}, {0.5, 1.2}, {1.0, 1.2}, {1.0, 0.5}, {2.0, 1.2}}) {
        for (const int zeros : {0, 5, 15, 20}) {
          Rings rings(turned, rings_are_columns, around, along, zeros);
          EXPECT_FALSE(orient_by_grid(rings.model, rings.grid))
              << turned << rings_are_columns << ' ' << around << ' ' << along << ' ' << zeros;
        }
      }
    }
  }
}

/// A lens bends rows and columns by a few per cent at the image's corner, and the depth is measured along each pixel's own ray.
TEST(ScanGrid, AnAssumedSensorBehindALensIsBelieved) {
  for (const double bend : {-0.05, 0.05}) {
    for (const double focus : {100.0, 150.0, 500.0}) {
      for (const double height : {0.02, 0.002}) {
        Model model;
        ScanGrid grid{.columns = 160, .cells = {}, .known = ScanGrid::Known::kAssumed};
        for (int row = 0; row < 120; ++row) {
          for (int column = 0; column < 160; ++column) {
            const double x = (column - 79.5) / focus, y = (row - 59.5) / focus, bent = 1 + bend * (x * x + y * y);
            const double k = 2 * M_PI * focus / 15, depth = 0.5 - 150 / focus * height * std::cos(k * x) * std::cos(k * y);
            grid.cells.push_back(static_cast<std::uint32_t>(model.positions.size()));
            model.positions.emplace_back(bent * x * depth, bent * y * depth, depth);
          }
        }
        ASSERT_TRUE(orient_by_grid(model, grid)) << bend << ' ' << focus << ' ' << height;
        for (std::size_t i = 0; i < model.positions.size(); ++i) ASSERT_LT(model.normals[i].dot(model.positions[i]), 0);
      }
    }
  }
}

/// Some programs write the origin where nothing returned.
TEST(ScanGrid, PlacesAtTheAssumedSensorAreLeftOut) {
  Scan relief(test::relief_image(0.003, 0.03, 0.5));
  relief.grid.known = ScanGrid::Known::kAssumed;
  const std::size_t all = relief.model.positions.size();
  for (std::size_t i = 0; i < all / 4; ++i) relief.model.positions[i].setZero();
  const auto left_out = orient_by_grid(relief.model, relief.grid);
  ASSERT_TRUE(left_out);
  EXPECT_GE(*left_out, all / 4);
  EXPECT_EQ(relief.facing(), relief.model.normals.size());
}

/// What stands where nothing returned has no normal, and says nothing of the camera.
TEST(ScanGrid, WrongPlacesDoNotRefuteAnAssumedSensor) {
  for (const Vector3d& constant : {Vector3d(0, 0, 4), Vector3d(0, 0, 1e-4), Vector3d(0.2, 0, -0.01), Vector3d(-1, -1, -1)}) {
    Scan ball(test::ball_image(0.05, 0.5));
    ball.grid.known = ScanGrid::Known::kAssumed;
    const std::size_t middle = ball.model.positions.size() / 2;
    for (std::size_t i = 0; i < 3; ++i) ball.model.positions[middle + i] = constant;
    ASSERT_TRUE(orient_by_grid(ball.model, ball.grid)) << constant.transpose();
    EXPECT_EQ(ball.facing(), ball.model.normals.size()) << constant.transpose();
  }
}

/// Reflections in the lens, say.
TEST(ScanGrid, AFewPlacesBehindAnAssumedSensorDoNotRefuteIt) {
  for (const bool few : {true, false}) {
    Scan relief(test::relief_image(0.003, 0.03, 0.5));
    relief.grid.known = ScanGrid::Known::kAssumed;
    const std::size_t side = few ? 10 : 30;
    for (std::size_t row = 0; row < side; ++row) {
      for (std::size_t column = 0; column < side; ++column) relief.model.positions[(20 + row) * relief.grid.columns + 20 + column] *= -0.1;
    }
    EXPECT_EQ(orient_by_grid(relief.model, relief.grid).has_value(), few);
  }
}

TEST(ScanGrid, NoNormalReachesOverAJump) {
  Scan scan(test::ball_image(0.05, 0.5, 0.6));
  std::size_t rim = 0, ball = 0;
  const auto is_ball = [&](std::size_t pixel) { return scan.image.pixels[pixel].z < 0.55; };
  std::vector<bool> beside(scan.image.pixels.size());
  for (std::size_t i = 0; i < scan.image.pixels.size(); ++i) {
    ball += is_ball(i) ? 1U : 0U;
    const std::size_t column = i % scan.image.width;
    const bool right = column + 1 < scan.image.width && is_ball(i) != is_ball(i + 1);
    const bool left = column > 0 && is_ball(i) != is_ball(i - 1);
    const bool up = i >= scan.image.width && is_ball(i) != is_ball(i - scan.image.width);
    const bool down = i + scan.image.width < scan.image.pixels.size() && is_ball(i) != is_ball(i + scan.image.width);
    beside[i] = right || left || up || down;
    rim += beside[i] ? 1U : 0U;
  }
  const auto edges = orient_by_grid(scan.model, scan.grid);
  ASSERT_TRUE(edges);
  EXPECT_GT(ball, 5000U);
  EXPECT_GE(*edges, rim);
  EXPECT_LT(*edges, rim + rim / 2);
  for (std::size_t i = 0; i < scan.model.positions.size(); ++i) {
    const std::size_t pixel = scan.model.lines[i];
    EXPECT_FALSE(beside[pixel]);
    if (is_ball(pixel)) continue;
    EXPECT_LT((scan.model.normals[i] - Vector3d(0, 0, -1)).norm(), 1e-6) << pixel;
  }
}

/// A pixel at the rim of something often hangs between it and what is behind.
TEST(ScanGrid, APixelBetweenTwoDepthsIsLeftOut) {
  test::RangeImage image = test::ball_image(0.01, 0.5, 0.6);
  std::size_t corner = 20 * image.width + 20;
  image.pixels[corner].z = 0.57;
  Scan scan(image);
  ASSERT_TRUE(orient_by_grid(scan.model, scan.grid));
  EXPECT_EQ(std::count(scan.model.lines.begin(), scan.model.lines.end(), corner), 0);
  EXPECT_EQ(std::count(scan.model.lines.begin(), scan.model.lines.end(), corner + 1), 0);
  EXPECT_EQ(std::count(scan.model.lines.begin(), scan.model.lines.end(), corner + 2), 1);
}

TEST(ScanGrid, HolesCostOnlyWhatHardlyHasNeighbours) {
  Scan scan(test::relief_image(0.003, 0.03, 0.5));
  const std::size_t hole = 50 * scan.grid.columns + 70;
  scan.grid.cells[hole] = ScanGrid::kNoReturn;
  const auto edges = orient_by_grid(scan.model, scan.grid);
  ASSERT_TRUE(edges);
  EXPECT_EQ(*edges, 5U);  // four corners of the image, and the hole itself
}

/// A sensor in the wrong place would leave the side to chance.
TEST(ScanGrid, ASensorAmongThePointsIsNotBelieved) {
  Scan scan(test::relief_image(0.003, 0.03, 0.5));
  scan.grid.sensor = {0, 0, 0.5};
  EXPECT_FALSE(orient_by_grid(scan.model, scan.grid));
}

TEST(ScanGrid, WhatIsNoImageStaysAsItIs) {
  Scan shuffled(test::ball_image(0.05, 0.5, 0.6));
  test::Random random(3);
  for (std::size_t i = shuffled.grid.cells.size() - 1; i > 0; --i)
    std::swap(shuffled.grid.cells[i], shuffled.grid.cells[random.bits() % (i + 1)]);
  Scan line(test::ball_image(0.05, 0.5, 0.6));
  line.grid.columns = line.grid.cells.size();
  Scan empty(test::ball_image(0.05, 0.5, 0.6));
  std::fill(empty.grid.cells.begin(), empty.grid.cells.end(), ScanGrid::kNoReturn);
  for (Scan* scan : {&shuffled, &line, &empty}) {
    EXPECT_FALSE(orient_by_grid(scan->model, scan->grid));
    EXPECT_EQ(scan->model.positions.size(), scan->image.pixels.size());
    EXPECT_TRUE(scan->model.normals.empty());
  }
}

}  // namespace
}  // namespace isotouch::cloud
