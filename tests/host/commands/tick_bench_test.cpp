#include "host/commands/tick_bench.h"

#include <gtest/gtest.h>

#include "host/encoding/write_image.h"
#include "host/error.h"
#include "host/field/make_grid.h"
#include "host/field/progress.h"
#include "host/field/sample_distance.h"
#include "host/field_file/open_field.h"
#include "host/published/levels.h"

namespace isotouch::commands {
namespace {

constexpr double kRadius = 10;  // mm and voxels

field::Grid grid() { return field::make_grid(Eigen::Vector3d::Constant(-kRadius), Eigen::Vector3d::Constant(kRadius), 1.0, 8.0); }

field_file::OpenField ball() {
  const auto distance = [](const Eigen::Vector3d& p) { return p.norm() - kRadius; };
  return field_file::open_field(encoding::write_image(field::sample_distance(distance, grid(), 4.0), {}), "ball");
}

/// Straight along z through the ball's upper half and out again.
Motion dip() {
  Motion motion;
  for (int n = 0; n < 400; ++n) motion.emplace_back(0.1, 0.2, 8.0 + std::abs(n - 200) * 0.03);
  return motion;
}

void expect_times(const TickTimes& times) {
  EXPECT_GT(times.median_ns, 0);
  EXPECT_LE(times.median_ns, times.p99_ns);
  EXPECT_LE(times.p99_ns, times.p999_ns);
  EXPECT_GT(times.ticks, 50U);
  EXPECT_LT(times.ticks, 250U);  // of 400: only those in contact
}

TEST(TickBench, TimesTheTicksInContactAndNoOthers) {
  expect_times(time_core(ball().view, dip()));
  expect_times(time_core(ball().view, dip(), every_feature()));
  expect_times(time_device(ball().view, dip()));
  expect_times(time_device(ball().view, dip(), every_feature()));

  published::Indicator inside(grid(), 0);
  for (int k = 0; k < inside.grid.size.z(); ++k) {
    for (int j = 0; j < inside.grid.size.y(); ++j) {
      for (int i = 0; i < inside.grid.size.x(); ++i) inside.at(i, j, k) = inside.grid.position({i, j, k}).norm() <= kRadius ? 1 : 0;
    }
  }
  field::Progress quiet;
  expect_times(time_published(published::peel(inside, quiet), 0.8, dip()));
}

TEST(TickBench, ColdCachesMakeTheSameTicksSlower) {
  const Motion all = dip();
  const Motion some(all.begin() + 130, all.begin() + 160);  // into contact; writing the caches full takes a while
  for (const auto time : {time_core, time_device}) {
    const TickTimes warm = time(ball().view, some, {}, Caches::kWarm), cold = time(ball().view, some, {}, Caches::kCold);
    EXPECT_EQ(cold.ticks, warm.ticks);
    EXPECT_GT(cold.median_ns, warm.median_ns);  // by ten times where nothing else slows both
  }
}

TEST(TickBench, AMotionThatNeverTouchesIsRefused) {
  const Motion away(100, Eigen::Vector3d(0, 0, 14));
  EXPECT_THROW(time_core(ball().view, away), InputError);
  EXPECT_THROW(time_core(ball().view, {}), InputError);
}

}  // namespace
}  // namespace isotouch::commands
