#include "host/evaluate/touch_points.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "host/cloud/random.h"
#include "host/error.h"
#include "host/to_double.h"
#include "tests/support/chained.h"
#include "tests/support/scratch_folder.h"

namespace isotouch::evaluate {
namespace {

using Eigen::Vector3d;

constexpr double kStiffness = 0.5;
constexpr double kRadius = 20;

/// One tick 1 mm deep in a ball of kRadius, everywhere on it; with the status of contact.
TraceRecord touch(cloud::Random& random) {
  Vector3d way;
  do {
    for (double& coordinate : way) coordinate = random.uniform(-1, 1);
  } while (way.norm() > 1 || way.norm() < 0.1);
  way.normalize();
  TraceRecord record;
  record.input = position_input(to_fixed<Mm>(Vector3d((kRadius - 1) * way)));
  record.output.hip = record.input.hip;
  record.output.proxy = to_fixed<Mm>(Vector3d(kRadius * way));
  record.output.force = to_fixed<Newton>(Vector3d(kStiffness * way));
  record.output.status = kContact;
  return record;
}

class TouchPoints : public testing::Test {
 protected:
  /// A trace of ball touches, changed one by one.
  trace::Trace trace(std::size_t ticks, const std::function<void(std::size_t, TraceRecord&)>& change = {}) {
    cloud::Random random(2);
    trace::TraceWriter writer(folder_.path() / "a.trace", header_);
    Chain chain(header_);
    for (std::size_t tick = 0; tick < ticks; ++tick) {
      TraceRecord record = touch(random);
      if (change) change(tick, record);
      writer.append(header_.has_outputs ? test::chained(chain, record) : record);
    }
    writer.finish();
    return trace::read_trace(folder_.path() / "a.trace");
  }
  TouchPoints() {
    header_.has_outputs = true;
    header_.settings.stiffness = to_fixed<Stiffness>(kStiffness);
  }

  ScratchFolder folder_;
  TraceHeader header_;
  TouchReport report_;
};

TEST_F(TouchPoints, LieOnTheSurfaceWithItsNormalsEvenlySpread) {
  const auto points = touch_points(trace(20000), {.points = 500}, report_);
  ASSERT_EQ(points.size(), 500U);
  EXPECT_EQ(report_.touches, 20000U);
  EXPECT_LT(report_.places, 20000U);
  EXPECT_GT(report_.places, 2000U);
  const double expected_spacing = std::sqrt(4 * 3.14159265 * kRadius * kRadius / 500);
  EXPECT_NEAR(report_.spacing_mm, expected_spacing, 0.15 * expected_spacing);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_NEAR(points.positions[i].norm(), kRadius, 0.02);
    EXPECT_GT(points.normals[i].dot(points.positions[i].normalized()), 0.9999);
    EXPECT_NEAR(points.normals[i].norm(), 1, 1e-12);
    double nearest = std::numeric_limits<double>::max();
    for (std::size_t j = 0; j < points.size(); ++j) {
      if (i != j) nearest = std::min(nearest, (points.positions[i] - points.positions[j]).norm());
    }
    EXPECT_GT(nearest, 0.5 * expected_spacing);
  }
}

TEST_F(TouchPoints, WithoutAFreshSampleATickIsNeitherATouchNorFree) {
  const auto lose = [](std::size_t tick, TraceRecord& record) {
    if (tick % 4 == 0) record.output.status = kStale;
    if (tick % 4 == 1) record.output.status = 0, record.input.fresh = false, record.input.age = 1;
  };
  (void)touch_points(trace(1000, lose), {}, report_);
  EXPECT_EQ(report_.free, 0U);
  EXPECT_EQ(report_.unfit, 500U);
  EXPECT_EQ(report_.touches, 500U);
}

TEST_F(TouchPoints, TicksWhoseForceTellsNoDepthAreLeftOutAndCounted) {
  const std::uint32_t unfit[] = {kRamping, kForceLimited, kStale, kInputClamped, kFollowing, kHeldInside};
  const auto spoil = [&](std::size_t tick, TraceRecord& record) {
    if (tick % 10 >= 8) return;
    record.output.force = to_fixed<Newton>(Vector3d(3, 0, 0));
    record.output.proxy = to_fixed<Mm>(Vector3d(50, 0, 0));  // would lie far off
    if (tick % 10 < 6) record.output.status |= unfit[tick % 10];
    if (tick % 10 == 6) record.output.status = 0;
    if (tick % 10 == 7) record.output.force = to_fixed<Newton>(Vector3d(0.01, 0, 0));
  };
  const auto points = touch_points(trace(1000, spoil), {}, report_);
  EXPECT_EQ(report_.ticks, 1000U);
  EXPECT_EQ(report_.unfit, 600U);
  EXPECT_EQ(report_.free, 100U);
  EXPECT_EQ(report_.weak, 100U);
  EXPECT_EQ(report_.touches, 200U);
  for (const Vector3d& position : points.positions) EXPECT_NEAR(position.norm(), kRadius, 0.02);
}

TEST_F(TouchPoints, WhatIsTouchedManyTimesIsAveraged) {
  cloud::Random noise(5);
  const auto shake = [&](std::size_t, TraceRecord& record) {
    const Vector3d proxy = to_double(record.output.proxy);
    record.output.proxy = to_fixed<Mm>(Vector3d(proxy + noise.uniform(-0.2, 0.2) * proxy.normalized()));
  };
  const auto points = touch_points(trace(60000, shake), {.points = 300}, report_);
  double squares = 0;
  for (const Vector3d& position : points.positions) squares += (position.norm() - kRadius) * (position.norm() - kRadius);
  const double rms = std::sqrt(squares / static_cast<double>(points.size()));
  const double raw = 0.2 / std::sqrt(3.0);
  EXPECT_LT(rms, 0.5 * raw);
  EXPECT_GT(rms, 0.05 * raw);
}

TEST_F(TouchPoints, TheTwoSidesOfAFoilAreNotAveraged) {
  const auto on_foil = [](std::size_t tick, TraceRecord& record) {
    const double x = static_cast<double>(tick % 50) / 5, y = static_cast<double>(tick / 50 % 50) / 5;
    const double side = tick % 2 == 0 ? 1 : -1;
    record.output.hip = to_fixed<Mm>(Vector3d(x, y, side * (0.01 - 1)));
    record.output.proxy = to_fixed<Mm>(Vector3d(x, y, side * 0.01));
    record.output.force = to_fixed<Newton>(Vector3d(0, 0, side * kStiffness));
  };
  const auto points = touch_points(trace(5000, on_foil), {.points = 100}, report_);
  ASSERT_EQ(points.size(), 100U);
  for (std::size_t i = 0; i < points.size(); ++i) EXPECT_NEAR(points.positions[i].z(), 0.01 * points.normals[i].z(), 1e-4);
}

/// What the last ticks of a trace change, from the middle on.
std::function<void(std::size_t, TraceRecord&)> changed_to(TickSetting setting, double value) {
  return [=](std::size_t tick, TraceRecord& record) {
    if (tick == 25) record.input.change = {setting, kTickSettingRows[index_of(setting)]->raw(value)};
  };
}

TEST_F(TouchPoints, DampingsWeightAndASofterPlaceMoveNoPoint) {
  header_.settings.damping = Damping::of(0.1);
  header_.settings.hand_damping = Damping::of(0.02);
  header_.settings.passivity = Damping::of(0.012);
  header_.settings.weight = Newton::of(0.8);
  const auto points = touch_points(trace(20000,
                                         [](std::size_t, TraceRecord& record) {
                                           const Vector3d force = 0.3 * to_double(record.output.force) + Vector3d(0.3, 0.8, 0);
                                           record.output.force = to_fixed<Newton>(force);
                                         }),
                                   {.points = 500}, report_);
  ASSERT_EQ(points.size(), 500U);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_NEAR(points.positions[i].norm(), kRadius, 0.02);
    EXPECT_GT(points.normals[i].dot(points.positions[i].normalized()), 0.9999);
  }
}

Input fresh_packet() {
  Input packet;
  packet.fresh = true;
  return packet;
}

TEST_F(TouchPoints, TheHandlesWeightMakesNoTouchStronger) {
  header_.settings.weight = Newton::of(0.8);
  const auto of_a_device = [](std::size_t, TraceRecord& record) {
    record.input = fresh_packet();
    record.output.force = to_fixed<Newton>(Vector3d(0.02 * to_double(record.output.proxy).normalized() + Vector3d(0, 0.8, 0)));
  };
  EXPECT_THROW(touch_points(trace(50, of_a_device), {}, report_), InputError);
  EXPECT_EQ(report_.weak, 50U);
}

TEST_F(TouchPoints, WhereADeviceGivesNoForceItsWeightIsNone) {
  header_.settings.weight = Newton::of(0.8);
  const auto idle = [](std::size_t, TraceRecord& record) {
    record.input = fresh_packet();
    record.output.force = {};
  };
  EXPECT_THROW(touch_points(trace(50, idle), {}, report_), InputError);
  EXPECT_EQ(report_.weak, 50U);
}

TEST_F(TouchPoints, ForcesWithoutProxiesNeedTheWallsStiffness) {
  const auto forces_only = [](std::size_t, TraceRecord& record) { record.output.proxy = record.output.hip; };
  const auto points = touch_points(trace(20000, forces_only), {.stiffness_n_per_mm = kStiffness, .points = 500}, report_);
  ASSERT_EQ(points.size(), 500U);
  for (const Vector3d& position : points.positions) EXPECT_NEAR(position.norm(), kRadius, 0.02);
}

TEST_F(TouchPoints, ATraceThatCannotTellIsRefusedWithTheReason) {
  const auto refused = [&](const char* why, const TouchOptions& options = {},
                           const std::function<void(std::size_t, TraceRecord&)>& change = {}) {
    try {
      touch_points(trace(50, change), options, report_);
      ADD_FAILURE() << "accepted: " << why;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr(why));
    }
  };
  refused("not one of its 50 ticks", {.least_force_n = 2});
  refused("leave --stiffness out", {.stiffness_n_per_mm = kStiffness});
  refused("import it with --stiffness", {}, [](std::size_t, TraceRecord& record) { record.output.proxy = record.output.hip; });
  refused("friction is set", {}, changed_to(TickSetting::kFriction, 0.5));
  refused("friction_damping is set", {}, changed_to(TickSetting::kFrictionDamping, 0.01));
  EXPECT_NO_THROW(touch_points(trace(50, changed_to(TickSetting::kFriction, 0)), {}, report_));
  EXPECT_NO_THROW(touch_points(trace(50, changed_to(TickSetting::kStiffness, 0.1)), {}, report_));
  header_.settings.friction = Ratio::of(0.5);
  refused("friction is set");
  header_.settings.friction = {};
  header_.has_outputs = false;
  refused("holds no forces", {}, [](std::size_t, TraceRecord& record) { record.output = {}; });
}

}  // namespace
}  // namespace isotouch::evaluate
