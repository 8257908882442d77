#include "host/stream/growing_field.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <vector>

#include "host/cloud/shapes.h"
#include "host/field_file/make_patch.h"
#include "shared/field_patch.h"

namespace isotouch::stream {
namespace {

using namespace std::chrono_literals;

constexpr double kBand = 3;

live::Space unit_space(int grid = 32) {
  const cloud::Shape sphere = cloud::shape("sphere");
  live::SpaceOptions options;
  options.grid = grid;
  return live::space_for({sphere.low, sphere.high}, options);
}

/// A part of a sphere's points, as a frame.
cloud::Model part(const cloud::OrientedPoints& points, std::size_t begin, std::size_t end) {
  cloud::Model model;
  for (std::size_t i = begin; i < end; ++i) {
    model.positions.push_back(points.positions[i]);
    model.normals.push_back(points.normals[i]);
  }
  return model;
}

std::vector<std::uint8_t> bytes_of(const field_file::OpenField& field) { return {field.view.image.begin(), field.view.image.end()}; }

/// The field of these points alone.
std::vector<std::uint8_t> built(const cloud::Model& model, int grid = 32) {
  GrowingField field(unit_space(grid), kBand, {}, {});
  field.take(model, {});
  return bytes_of(field.keep_whole());
}

TEST(GrowingField, PatchesLeadFromEachStateToTheNext) {
  const cloud::OrientedPoints points = cloud::scatter_on_shape(cloud::shape("sphere"), 2000, 1);
  GrowingField field(unit_space(), kBand, {}, {});
  EXPECT_EQ(field.take(part(points, 0, 500), {}).taken, 500U);
  std::vector<std::uint8_t> image = bytes_of(field.keep_whole());
  for (std::size_t at = 500; at < 2000; at += 500) {
    field.take(part(points, at, at + 500), {});
    EXPECT_TRUE(field.has_changed());
    const std::vector<std::uint8_t> bytes = field.keep_patch();
    EXPECT_FALSE(field.has_changed());
    const auto patch = FieldPatch::parse(bytes);
    ASSERT_TRUE(patch);
    field_file::Image before(image.size()), after(patch->image_bytes());
    std::copy(image.begin(), image.end(), before.data());
    const auto view = FieldView::parse(before.bytes());
    ASSERT_TRUE(view);
    const auto made = apply(*patch, *view, {after.data(), after.size()});
    ASSERT_TRUE(made);
    image.assign(made->begin(), made->end());
    EXPECT_EQ(image, bytes_of(field.kept()));
    EXPECT_EQ(patch->hash_after, field.kept_hash());
  }
  EXPECT_EQ(image, built(part(points, 0, 2000)));
  EXPECT_TRUE(field.keep_patch().empty());
}

TEST(GrowingField, APointCountsForAsLongAsIsWanted) {
  const cloud::OrientedPoints points = cloud::scatter_on_shape(cloud::shape("sphere"), 3000, 1);
  GrowingField field(unit_space(), kBand, {}, 2s);
  const Clock::time_point begin{};
  for (int second = 0; second < 3; ++second) {
    const auto at = static_cast<std::size_t>(second) * 1000;
    EXPECT_EQ(field.take(part(points, at, at + 1000), begin + second * 1s).expired, second == 2 ? 1000U : 0U);
  }
  EXPECT_EQ(bytes_of(field.keep_whole()), built(part(points, 1000, 3000)));
  EXPECT_EQ(field.take({}, begin + 2999ms).expired, 0U);
  EXPECT_EQ(field.take({}, begin + 3s).expired, 1000U);
  EXPECT_EQ(bytes_of(field.keep_whole()), built(part(points, 2000, 3000)));
  EXPECT_EQ(field.take({}, begin + 1h).expired, 1000U);
  EXPECT_EQ(bytes_of(field.keep_whole()), built({}));
}

TEST(GrowingField, APlaceThatHasEnoughTakesNoMoreUntilItsPointsExpire) {
  const cloud::OrientedPoints points = cloud::scatter_on_shape(cloud::shape("sphere"), 20'000, 1);
  GrowingField field(unit_space(), kBand, {}, 2s, 4);
  const Clock::time_point begin{};
  const PointCounts first = field.take(part(points, 0, 20'000), begin);
  EXPECT_EQ(first.taken + first.surplus, 20'000U);
  EXPECT_GT(first.surplus, 5000U);
  EXPECT_GT(first.taken, 1000U);
  const std::vector<std::uint8_t> image = bytes_of(field.keep_whole());
  EXPECT_LE(field.take(part(points, 0, 20'000), begin + 1s).taken, first.taken);  // places that had fewer
  const PointCounts again = field.take(part(points, 0, 20'000), begin + 5s);
  EXPECT_EQ(again.taken, first.taken);
  EXPECT_EQ(bytes_of(field.keep_whole()), image);

  cloud::Model one = part(points, 0, 1);
  GrowingField small(unit_space(), kBand, {}, {}, 3);
  std::size_t taken = 0;
  for (std::size_t n = 0; n < 20; ++n) taken += small.take(one, begin).taken;
  EXPECT_EQ(taken, 3U);
}

TEST(GrowingField, APlaceThatHasPointsTakesFurtherOnesWhenItHasItsTurn) {
  const cloud::OrientedPoints points = cloud::scatter_on_shape(cloud::shape("sphere"), 4000, 1);
  const cloud::Model one = part(points, 0, 1);
  const Clock::time_point begin{};
  GrowingField field(unit_space(), kBand, {}, {}, 16);
  std::vector<std::size_t> when;
  std::size_t sum = 0;
  for (std::size_t n = 1; n <= 40; ++n) {
    const PointCounts counts = field.take(one, begin);
    EXPECT_EQ(field.work().samples, counts.taken > 0 ? 1U : 0U) << n;
    if (counts.taken == 0) continue;
    sum += counts.taken;
    when.push_back(n);
  }
  ASSERT_GE(when.size(), 3U) << "at once, and at turns of its block";
  EXPECT_EQ(when[0], 1U);
  for (std::size_t n = 2; n < when.size(); ++n) EXPECT_EQ(when[n] - when[n - 1], GrowingField::kTurns);
  EXPECT_EQ(sum, 16U);
  EXPECT_EQ(field.take_waiting(begin).taken, 0U);
}

TEST(GrowingField, APlaceBesideOneThatHasPointsWaitsForItsTurn) {
  const live::Space space = unit_space();
  const double bucket = space.box.sizes().maxCoeff() / 16;
  const auto at = [bucket](double buckets, double facing) {
    cloud::Model model;
    model.positions.emplace_back(buckets * bucket, 0.0, 0.0);
    model.normals.emplace_back(0.0, 0.0, facing);
    return model;
  };
  std::size_t at_once = 0;
  for (std::size_t phase = 0; phase < GrowingField::kTurns; ++phase) {
    GrowingField field(space, kBand, {}, {}, 16);
    for (std::size_t n = 0; n < phase; ++n) field.take({}, {});
    EXPECT_EQ(field.take(at(0.2, 1), {}).taken, 1U);
    EXPECT_EQ(field.take(at(3.2, 1), {}).taken, 1U) << "no surface is beside it";
    EXPECT_EQ(field.take(at(1.2, -1), {}).taken, 1U) << "another side of a wall";
    std::size_t beside = field.take(at(1.2, 1), {}).taken;
    at_once += beside;
    for (std::size_t n = 1; n < GrowingField::kTurns; ++n) beside += field.take({}, {}).taken;
    EXPECT_EQ(beside, 1U);
  }
  EXPECT_EQ(at_once, 1U) << "where its turn was just then";
}

TEST(GrowingField, WhatWaitsIsTakenTurnByTurnOrAllAtTheEnd) {
  constexpr int kGrid = 96;  // more blocks than one
  const cloud::OrientedPoints points = cloud::scatter_on_shape(cloud::shape("sphere"), 4000, 1);
  for (const bool is_end : {false, true}) {
    GrowingField field(unit_space(kGrid), kBand, {}, {}, 1000);
    std::size_t taken = 0, waited = 0;
    for (std::size_t at = 0; at < 4000; at += 100) {
      taken += field.take(part(points, at, at + 100), {}).taken;
      if (taken < at + 100) ++waited;
    }
    EXPECT_GT(waited, 20U);
    EXPECT_LT(taken, 4000U);
    std::size_t turns = 0;
    for (; field.has_waiting(); ++turns) taken += is_end ? field.finish({}).taken : field.take_waiting({}).taken;
    EXPECT_EQ(taken, 4000U);
    if (is_end) {
      EXPECT_EQ(turns, 1U);
    } else {
      EXPECT_GT(turns, 2U);
      EXPECT_LE(turns, GrowingField::kTurns);
    }
    EXPECT_EQ(field.take_waiting({}).taken, 0U);
    EXPECT_EQ(field.finish({}).taken, 0U);
    EXPECT_EQ(bytes_of(field.keep_whole()), built(part(points, 0, 4000), kGrid));
  }
}

/// A camera that stands still, for hours.
TEST(GrowingField, HowManyPointsWaitDoesNotGrowWithThoseThatWereSeen) {
  const cloud::Model one = part(cloud::scatter_on_shape(cloud::shape("sphere"), 1, 1), 0, 1);
  GrowingField field(unit_space(), kBand, {}, {}, 1'000'000);
  std::size_t taken = 0, most = 0;
  for (std::size_t n = 1; n <= 1000; ++n) {
    taken += field.take(one, {}).taken;
    most = std::max(most, n - taken);
  }
  EXPECT_GE(most, GrowingField::kMaxWaiting / 2) << "places that grow are computed rarely";
  EXPECT_LT(most, GrowingField::kMaxWaiting + GrowingField::kTurns);
}

TEST(GrowingField, EveryPointIsTakenOrCountedAmongThoseLeftOutOnce) {
  const cloud::OrientedPoints points = cloud::scatter_on_shape(cloud::shape("sphere"), 4000, 1);
  for (const std::optional<Clock::duration> keep : {std::optional<Clock::duration>(), std::optional<Clock::duration>(2s)}) {
    GrowingField field(unit_space(), kBand, {}, keep, 4);
    Clock::time_point at{};
    PointCounts all;
    std::size_t given = 0;
    for (int frame = 0; frame < 44; ++frame) {
      at += frame % 10 == 9 ? 3s : 100ms;  // some wait until they are too old
      const auto first = static_cast<std::size_t>(frame % 4) * 1000;
      all += field.take(part(points, first, first + 1000), at);
      given += 1000;
      EXPECT_LE(all.taken + all.surplus, given);
    }
    all += field.take_waiting(at);
    all += field.finish(at);
    EXPECT_GT(all.surplus, 1000U);
    EXPECT_EQ(all.taken + all.surplus, given) << (keep ? "with keep" : "without");
    EXPECT_EQ(all.taken - all.expired, field.verdict().points);
  }
}

TEST(GrowingField, APointWaitsNoLongerThanItWouldCount) {
  const cloud::OrientedPoints points = cloud::scatter_on_shape(cloud::shape("sphere"), 3, 1);
  const cloud::Model one = part(points, 0, 1);
  const Clock::time_point begin{};
  GrowingField field(unit_space(), kBand, {}, 2s, 16);
  for (std::size_t n = 0; n < GrowingField::kTurns && field.verdict().points < 2; ++n) field.take(one, begin);  // until it has had its turn
  const std::size_t before = field.verdict().points;
  ASSERT_GT(before, 1U);
  EXPECT_EQ(field.take(one, begin + 1s).taken, 0U);
  const PointCounts gone = field.take({}, begin + 2s);
  EXPECT_EQ(gone.expired, before);
  EXPECT_EQ(gone.taken, 1U) << "the place is computed anew, so what waits counts at once";
  EXPECT_EQ(field.take(one, begin + 2100ms).taken, 0U);
  EXPECT_EQ(field.take_waiting(begin + 4100ms).taken, 0U);
  EXPECT_EQ(field.take({}, begin + 4100ms).expired, 1U);
  EXPECT_EQ(field.verdict().points, 0U);
}

/// A place that is seen again and again stays for as long after it was seen last as any other.
TEST(GrowingField, APlaceStaysThatIsSeenAlthoughItHasEnough) {
  const cloud::OrientedPoints points = cloud::scatter_on_shape(cloud::shape("sphere"), 4000, 1);
  const cloud::Model seen = part(points, 0, 2000), other = part(points, 2000, 2050);
  GrowingField field(unit_space(), kBand, {}, 2s, 4);
  const Clock::time_point begin{};
  const std::size_t taken = field.take(seen, begin).taken;
  const std::vector<std::uint8_t> image = bytes_of(field.keep_whole());
  const std::size_t places = field.verdict().samples;
  field.take(seen, begin + 900ms);
  EXPECT_EQ(field.take(other, begin + 2100ms).expired, taken);
  EXPECT_GE(field.verdict().points, taken);
  EXPECT_GE(field.verdict().samples, places);
  const std::size_t points_then = field.verdict().points;
  EXPECT_EQ(field.take({}, begin + 2899ms).expired, 0U);
  EXPECT_EQ(field.verdict().points, points_then);
  field.take({}, begin + 2900ms);
  EXPECT_LE(field.verdict().points, other.positions.size());
  field.take({}, begin + 1h);
  EXPECT_EQ(bytes_of(field.keep_whole()), built({}));

  field.take(seen, begin + 2h);
  EXPECT_EQ(bytes_of(field.keep_whole()), image) << "nothing is left of what waited";
  for (int n = 1; n < 30; ++n) {
    field.take(seen, begin + 2h + n * 100ms);
    EXPECT_GE(field.verdict().points, taken);
  }
  field.take(seen, begin + 4h);  // what waits is too old
  EXPECT_EQ(bytes_of(field.keep_whole()), image);
}

TEST(GrowingField, CountsWhatItCannotUse) {
  const live::Space space = unit_space();
  GrowingField field(space, kBand, {}, {});
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  const Eigen::Vector3d inside = space.box.center(), up(0, 0, 1);
  cloud::Model model;
  const auto add = [&](const Eigen::Vector3d& position, const Eigen::Vector3d& normal) {
    model.positions.push_back(position);
    model.normals.push_back(normal);
  };
  add(inside, up);
  add(inside, Eigen::Vector3d::Zero());
  add(inside, {nan, 0, 0});
  add(inside, {inf, 0, 0});
  add(space.box.max() + Eigen::Vector3d(1e-9, 0, 0), up);
  add({nan, 0, 0}, up);
  add({1e300, 0, 0}, up);
  const PointCounts counts = field.take(model, {});
  EXPECT_EQ(counts.taken, 1U);
  EXPECT_EQ(counts.useless, 3U);
  EXPECT_EQ(counts.outside, 3U);
  model.normals.clear();
  EXPECT_EQ(field.take(model, {}).useless, 4U);
}

}  // namespace
}  // namespace isotouch::stream
