#include "host/motion/motion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "host/error.h"
#include "host/motion/felt_surface.h"
#include "host/to_double.h"
#include "shared/hash64.h"
#include "shared/trace.h"
#include "tests/support/field_image.h"

namespace isotouch::motion {
namespace {

/// A plate of 4 voxels, 40 voxels wide: edges, corners and a thin wall. Exact by comparisons and square roots alone.
const FieldView& plate() {
  static const test::FieldImage image({80, 80, 40}, [](const test::Point& p) {
    const double q[3] = {std::abs(p[0] - 40.3) - 20, std::abs(p[1] - 39.8) - 20, std::abs(p[2] - 20.4) - 2};
    double square = 0;
    for (const double d : q) square += d > 0 ? d * d : 0;
    return square > 0 ? std::sqrt(square) : std::max(q[0], std::max(q[1], q[2]));
  });
  return image.view();
}

std::vector<Input> motion(const FieldView* field, const MotionOptions& options) {
  std::vector<Input> inputs;
  const std::uint64_t ticks = make_motion(field, options, [&](const Input& input) { inputs.push_back(input); });
  EXPECT_EQ(ticks, inputs.size());
  return inputs;
}

std::uint64_t hash_of(const std::vector<Input>& inputs) {
  std::uint64_t hash = 0;
  for (const Input& input : inputs) {
    const TraceRecordBytes bytes = encode(TraceRecord{input, {}, 0, 0});
    hash = hash64(bytes.data(), bytes.size(), hash);
  }
  return hash;
}

double fastest(const std::vector<Input>& inputs) {
  double worst = 0;
  for (std::size_t i = 1; i < inputs.size(); ++i) worst = std::max(worst, (to_double(inputs[i].hip) - to_double(inputs[i - 1].hip)).norm());
  return 1000 * worst;
}

TEST(Motion, IsTheSameOnEveryMachine) {
  EXPECT_EQ(hash_of(motion(nullptr, {.kind = "tour", .ticks = 20'000})), 0xff592388dbe150afU);
  EXPECT_EQ(hash_of(motion(&plate(), {.kind = "tour", .ticks = 20'000, .lost_share = 0.04 / 1.02})), 0xf5928ec7540cc735U);
}

TEST(Motion, HasExactlyTheTicksThatWereAskedFor) {
  for (const std::string& kind : motion_kinds()) {
    for (const std::uint64_t ticks : {1U, 777U, 30'000U}) {
      EXPECT_EQ(motion(&plate(), {.kind = kind, .ticks = ticks}).size(), ticks) << kind;
      EXPECT_EQ(motion(nullptr, {.kind = kind, .ticks = ticks}).size(), ticks) << kind;
    }
  }
}

TEST(Motion, AnotherSeedIsAnotherMotion) {
  EXPECT_NE(hash_of(motion(&plate(), {.kind = "press", .seed = 1})), hash_of(motion(&plate(), {.kind = "press", .seed = 2})));
}

TEST(Motion, WithoutAnObjectItComesNearEveryPlaceOfTheWorkspace) {
  const auto inputs = motion(nullptr, {.kind = "stab", .ticks = 600'000});
  for (double x = -40; x <= 40; x += 20) {
    for (double y = -40; y <= 40; y += 20) {
      for (double z = -40; z <= 40; z += 20) {
        const Eigen::Vector3d place(x, y, z);
        if (place.norm() > 48) continue;
        double nearest_mm = 1e9;
        for (std::size_t i = 0; i < inputs.size(); i += 4) nearest_mm = std::min(nearest_mm, (to_double(inputs[i].hip) - place).norm());
        EXPECT_LT(nearest_mm, 6) << place.transpose();
      }
    }
  }
  for (const Input& input : inputs) ASSERT_LT(to_double(input.hip).norm(), 50.001);
}

TEST(Motion, TheHandIsAsFastAsItsKindSays) {
  EXPECT_LT(fastest(motion(nullptr, {.kind = "stab", .ticks = 100'000})), 1001);
  EXPECT_LT(fastest(motion(&plate(), {.kind = "stab", .ticks = 100'000})), 1001);
  EXPECT_GT(fastest(motion(&plate(), {.kind = "stab", .ticks = 100'000})), 950);
  EXPECT_LT(fastest(motion(&plate(), {.kind = "leave", .ticks = 100'000})), 2501);
}

TEST(Motion, EveryKindTouchesTheObjectInItsWay) {
  const FeltSurface surface(plate());
  const double voxel = surface.voxel_mm();
  for (const std::string& kind : motion_kinds()) {
    std::size_t inside = 0;
    double beyond = 0;  // voxels from the middle of the plate, along its normal
    for (const Input& input : motion(&plate(), {.kind = kind})) {
      const Eigen::Vector3d hip = to_double(input.hip);
      inside += surface.sample(hip).distance < 0 ? 1U : 0U;
      beyond = std::max(beyond, (hip - surface.centre()).norm() / voxel);
    }
    EXPECT_GT(inside, 20U) << kind;
    EXPECT_GT(beyond, 20) << kind;
  }
}

TEST(Motion, LostSamplesRepeatTheLastOneAndSayHowOldItIs) {
  const auto inputs = motion(nullptr, {.kind = "tap", .ticks = 200'000, .lost_share = 0.1});
  std::size_t lost = 0;
  for (std::size_t i = 1; i < inputs.size(); ++i) {
    if (inputs[i].fresh) {
      EXPECT_EQ(inputs[i].age, 0);
      continue;
    }
    ++lost;
    EXPECT_EQ(inputs[i].hip, inputs[i - 1].hip);
    EXPECT_EQ(inputs[i].age, inputs[i - 1].age + 1);
  }
  EXPECT_NEAR(static_cast<double>(lost) / 200'000, 0.1, 0.005);
}

TEST(Motion, WhatDoesNotExistIsRefused) {
  EXPECT_THROW(motion(nullptr, {.kind = "wave"}), InputError);
  const test::FieldImage empty({32, 32, 32}, [](const test::Point&) { return 10.0; });
  EXPECT_THROW(motion(&empty.view(), {.kind = "press"}), InputError);
}

}  // namespace
}  // namespace isotouch::motion
