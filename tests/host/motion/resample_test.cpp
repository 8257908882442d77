#include "host/motion/resample.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "host/error.h"
#include "host/to_double.h"
#include "tests/support/scratch_folder.h"

namespace isotouch::motion {
namespace {

std::vector<Eigen::Vector3d> resampled(const std::vector<TimedPoint>& points, std::uint32_t period_ns = 1'000'000) {
  std::vector<Eigen::Vector3d> positions;
  const std::uint64_t ticks =
      resample(points, period_ns, [&](const Input& input, const auto&) { positions.push_back(to_double(input.hip)); });
  EXPECT_EQ(ticks, positions.size());
  return positions;
}

TEST(Resample, EverySampleOnATickIsKeptAndSoIsTheLast) {
  std::vector<TimedPoint> points;
  for (int i = 0; i <= 20; ++i) points.push_back({0.016 * i, {std::round(100 * std::sin(i)) / 8, i * 0.25, -i * 0.5}});
  const auto positions = resampled(points);
  ASSERT_EQ(positions.size(), 321U);
  for (std::size_t i = 0; i <= 20; ++i) EXPECT_LT((positions[16 * i] - points[i].position).norm(), 2e-6) << i;
}

TEST(Resample, UniformMotionStaysUniform) {
  std::vector<TimedPoint> points;
  for (const double time : {0.0, 0.01, 0.013, 0.05, 0.051}) points.push_back({time, {100 * time, -50 * time, 1}});
  const auto positions = resampled(points);
  for (std::size_t tick = 0; tick < positions.size(); ++tick) EXPECT_NEAR(positions[tick].x(), 0.1 * static_cast<double>(tick), 2e-6);
}

TEST(Resample, NothingOvershootsAStop) {
  const std::vector<TimedPoint> points = {{0, {0, 0, 0}}, {0.02, {5, 0, 0}}, {0.04, {5, 0, 0}}, {0.06, {0, 0, 0}}};
  double highest = 0;
  for (const auto& position : resampled(points)) highest = std::max(highest, position.x());
  EXPECT_EQ(highest, 5.0);
}

/// Ticks whose force is known.
std::vector<std::size_t> known(const std::vector<TimedPoint>& points) {
  std::vector<std::size_t> ticks;
  std::size_t tick = 0;
  resample(points, 1'000'000, [&](const Input&, const std::optional<Eigen::Vector3d>& force) {
    if (force) ticks.push_back(tick);
    ++tick;
  });
  return ticks;
}

TEST(Resample, BetweenSamplesThatAreFarApartNoForceIsKnown) {
  const Eigen::Vector3d at(0, 0, 0), force(0, 1, 0);
  EXPECT_EQ(known({{0, at, force}, {0.002, at, force}, {2, at, force}, {2.001, at, force}}),
            (std::vector<std::size_t>{0, 1, 2, 2000, 2001}));
  std::vector<TimedPoint> ten_hz;
  for (int i = 0; i <= 20; ++i) ten_hz.push_back({0.1 * i, at, force});
  EXPECT_EQ(known(ten_hz).size(), 2001U);
  EXPECT_EQ(known({{0, at, force}, {0.1001, at, force}}).size(), 1U);
}

TEST(Resample, ATimeSince1970LosesNoTick) {
  const ScratchFolder folder;
  std::string table = "t_s,x_mm,y_mm,z_mm\n";
  for (int ms = 1002; ms < 2000; ++ms) table += "1700000000." + std::to_string(ms).substr(1) + ",0,0,0\n";
  EXPECT_EQ(resampled(read_motion_csv(folder.write("a.csv", table), {})).size(), 998U);
}

TEST(Resample, WhatATraceCannotHoldIsRefused) {
  EXPECT_THROW(resampled({{0, {0, 0, 0}}, {1, {2048, 0, 0}}}), InputError);
  EXPECT_THROW(resampled({{0, {0, 0, 0}}, {1e6, {1, 0, 0}}}), InputError);
  EXPECT_THROW(resampled({{0, {0, 0, 0}}, {1e-310, {1, 0, 0}}, {1, {2, 0, 0}}}), InputError);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Eigen::Vector3d& place : {Eigen::Vector3d(nan, 0, 0), Eigen::Vector3d(0, nan, 0), Eigen::Vector3d(0, 0, nan)})
    EXPECT_THROW(resampled({{0, place}, {1, {1, 0, 0}}}), InputError);
}

}  // namespace
}  // namespace isotouch::motion
