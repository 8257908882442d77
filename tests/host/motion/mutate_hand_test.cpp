#include "host/motion/mutate_hand.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "host/error.h"
#include "host/motion/felt_surface.h"
#include "host/motion/motion.h"
#include "host/motion/mutate.h"
#include "host/to_double.h"
#include "shared/hash64.h"
#include "shared/trace.h"
#include "tests/support/field_image.h"

namespace isotouch::motion {
namespace {

using Eigen::Vector3d;
using Inputs = std::vector<Input>;

constexpr double kThickness = 8;  // voxels

/// A plate, 40 voxels wide: edges and corners, and a medial plane in its middle.
const FieldView& plate() {
  static const test::FieldImage image({80, 80, 40}, [](const test::Point& p) {
    const double q[3] = {std::abs(p[0] - 40.3) - 20, std::abs(p[1] - 39.8) - 20, std::abs(p[2] - 20.4) - kThickness / 2};
    double square = 0;
    for (const double d : q) square += d > 0 ? d * d : 0;
    return square > 0 ? std::sqrt(square) : std::max(q[0], std::max(q[1], q[2]));
  });
  return image.view();
}

/// A hand that presses, slides and taps.
const Inputs& harmless() {
  static const Inputs hand = [] {
    Inputs all;
    for (const char* kind : {"press", "slide"}) {
      make_motion(&plate(), {.kind = kind, .ticks = 12'000, .seed = 5}, [&](const Input& input) { all.push_back(input); });
    }
    return all;
  }();
  return hand;
}

Inputs mutated(const std::string& kind, std::uint64_t seed = 1, const Inputs& from = harmless()) {
  Inputs inputs;
  const std::uint64_t ticks = mutate_hand(from, plate(), {.kind = kind, .seed = seed}, [&](const Input& in) { inputs.push_back(in); });
  EXPECT_EQ(ticks, inputs.size());
  return inputs;
}

std::uint64_t hash_of(const Inputs& inputs) {
  std::uint64_t hash = 0;
  for (const Input& input : inputs) {
    const TraceRecordBytes bytes = encode(TraceRecord{input, {}, 0, 0});
    hash = hash64(bytes.data(), bytes.size(), hash);
  }
  return hash;
}

double fastest(const Inputs& inputs) {
  double worst = 0;
  for (std::size_t i = 1; i < inputs.size(); ++i) worst = std::max(worst, (to_double(inputs[i].hip) - to_double(inputs[i - 1].hip)).norm());
  return 1000 * worst;
}

/// In voxels of the plate's frame, from its middle.
Vector3d in_plate(const Input& input) {
  return (to_double(input.hip) - to_double(plate().origin)) / FeltSurface(plate()).voxel_mm() - Vector3d(40.3, 39.8, 20.4);
}

TEST(MutateHand, IsTheSameForASeedAndAnotherForAnother) {
  for (const Mutation& mutation : mutations()) {
    if (mutation.of != InputKind::kPosition) continue;
    const std::string kind(mutation.name);
    const std::uint64_t first = hash_of(mutated(kind, 3));
    EXPECT_EQ(first, hash_of(mutated(kind, 3))) << kind;
    EXPECT_NE(first, hash_of(harmless())) << kind;
    const bool draws = kind != "fast" && kind != "medial" && kind != "graze" && kind != "mirror";
    if (draws) {
      EXPECT_NE(first, hash_of(mutated(kind, 4))) << kind;
    }
  }
}

TEST(MutateHand, FastReachesOneMetreASecondAndGoesTheSameWay) {
  const Inputs slow(harmless().begin(), harmless().begin() + 3000);
  const Inputs hand = mutated("fast", 1, slow);
  EXPECT_GT(fastest(hand), 900);
  EXPECT_LT(fastest(hand), 1100);
  EXPECT_LT(hand.size(), slow.size() * 2 / 3);
  const FeltSurface surface(plate());
  double fastest_touch = 0;
  for (std::size_t i = 1; i < hand.size(); ++i) {
    const bool near = std::abs(surface.sample(to_double(hand[i].hip)).distance) < 2 * surface.voxel_mm();
    if (near) fastest_touch = std::max(fastest_touch, 1000 * (to_double(hand[i].hip) - to_double(hand[i - 1].hip)).norm());
  }
  EXPECT_GT(fastest_touch, 700);
  for (std::size_t i = 0; i < hand.size(); i += 50) {  // every place of it is one of the slow hand's way
    double off = 1e9;
    for (const Input& place : slow) off = std::min(off, (to_double(place.hip) - to_double(hand[i].hip)).norm());
    ASSERT_LT(off, 0.3) << i;
  }
  EXPECT_THROW(mutated("fast", 1, Inputs(100, position_input({}))), InputError);
}

TEST(MutateHand, MirroredTwiceIsTheHandAgain) {
  const Inputs once = mutated("mirror", 2);
  const Inputs twice = mutated("mirror", 2, once);
  ASSERT_EQ(twice.size(), harmless().size());
  double moved = 0;
  for (std::size_t i = 0; i < twice.size(); ++i) {
    ASSERT_LE((to_double(twice[i].hip) - to_double(harmless()[i].hip)).norm(), 3e-6) << i;
    moved = std::max(moved, (to_double(once[i].hip) - to_double(harmless()[i].hip)).norm());
  }
  EXPECT_GT(moved, 10);
}

TEST(MutateHand, JitterStaysWithinACountAndLosesSamples) {
  const Inputs hand = mutated("jitter");
  ASSERT_EQ(hand.size(), harmless().size());
  std::size_t lost = 0, apart = 0;
  for (std::size_t i = 0; i < hand.size(); ++i) {
    if (!hand[i].fresh) {
      ++lost;
      continue;
    }
    const Vector3d off = to_double(hand[i].hip) - to_double(harmless()[i].hip);
    ASSERT_LE(off.cwiseAbs().maxCoeff(), 0.0461);
    apart += off.cwiseAbs().maxCoeff() > 0.023 ? 1U : 0U;
  }
  EXPECT_GT(apart, hand.size() / 2);
  EXPECT_NEAR(static_cast<double>(lost) / static_cast<double>(hand.size()), 0.058, 0.015);  // 3 % begin one of 1 to 3 ticks
}

TEST(MutateHand, DwellsInsideAtEdgesAndFlickersByACount) {
  const Inputs hand = mutated("dwell");
  EXPECT_GT(hand.size(), harmless().size() + 5 * 200);
  const FeltSurface surface(plate());
  std::size_t flickers = 0, at_edges = 0;
  for (std::size_t i = 1; i < hand.size(); ++i) {
    const Vector3d step = to_double(hand[i].hip) - to_double(hand[i - 1].hip);
    const bool one_count = step.cwiseAbs().maxCoeff() > 0.0455 && step.cwiseAbs().maxCoeff() < 0.0465;
    if (!one_count || surface.sample(to_double(hand[i].hip)).distance > 0) continue;
    ++flickers;
    const Vector3d place = in_plate(hand[i]).cwiseAbs();
    at_edges += std::max(place.x(), place.y()) > 12 ? 1U : 0U;
  }
  EXPECT_GT(flickers, 800U);
  EXPECT_GT(at_edges, flickers / 2);
}

TEST(MutateHand, CrossesTheMiddleOfThinPlaces) {
  const auto crossings = [](const Inputs& hand) {
    std::size_t count = 0;
    for (std::size_t i = 1; i < hand.size(); ++i) {
      const Vector3d before = in_plate(hand[i - 1]), now = in_plate(hand[i]);
      if (std::max(std::abs(now.x()), std::abs(now.y())) < 18 && std::abs(now.z()) < 3) count += before.z() * now.z() < 0 ? 1U : 0U;
    }
    return count;
  };
  EXPECT_GT(crossings(mutated("medial")), crossings(harmless()) + 5 * 7);
}

TEST(MutateHand, GrazesWhereverItWasNear) {
  const FeltSurface surface(plate());
  std::size_t was_near = 0, grazes = 0;
  const Inputs hand = mutated("graze");
  ASSERT_EQ(hand.size(), harmless().size());
  for (std::size_t i = 0; i < hand.size(); ++i) {
    was_near += std::abs(surface.sample(to_double(harmless()[i].hip)).distance) < 2 * surface.voxel_mm() ? 1U : 0U;
    grazes += std::abs(surface.sample(to_double(hand[i].hip)).distance) < 0.11 * surface.voxel_mm() ? 1U : 0U;
  }
  EXPECT_GT(was_near, 5'000U);
  EXPECT_GT(grazes, was_near * 8 / 10);
  EXPECT_LT(fastest(hand), 1001);
}

TEST(MutateHand, LeavesTheGridAndWhatTheCoreReaches) {
  const Inputs hand = mutated("leave");
  const FeltSurface surface(plate());
  std::size_t outings = 0, beyond = 0;
  bool was_out = false;
  for (const Input& input : hand) {
    const bool out = (to_double(input.hip) - surface.centre()).norm() > 1.1 * surface.radius();
    outings += out && !was_out ? 1U : 0U;
    was_out = out;
    beyond += to_double(input.hip).cwiseAbs().maxCoeff() > 512 ? 1U : 0U;
  }
  EXPECT_GE(outings, 6U);
  EXPECT_GT(beyond, 20U);
}

TEST(MutateHand, LeavesThreeTimesBeyondWhatTheCoreReaches) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    int journeys = 0;
    bool was_beyond = false;
    for (const Input& input : mutated("leave", seed)) {
      const bool is_beyond = to_double(input.hip).cwiseAbs().maxCoeff() > 512;
      journeys += is_beyond && !was_beyond ? 1 : 0;
      was_beyond = is_beyond;
    }
    EXPECT_EQ(journeys, 3) << "seed " << seed;
  }
}

TEST(MutateHand, WhatDoesNotExistIsRefused) {
  EXPECT_THROW(mutated("wave"), InputError);
  const Inputs far_away(100, position_input({Mm::of(300), Mm{}, Mm{}}));
  for (const char* kind : {"dwell", "medial", "graze", "leave"}) EXPECT_THROW(mutated(kind, 1, far_away), InputError) << kind;
}

}  // namespace
}  // namespace isotouch::motion
