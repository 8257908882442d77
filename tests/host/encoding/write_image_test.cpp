#include "host/encoding/write_image.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "host/error.h"
#include "shared/field_view.h"
#include "tests/host/encoding/field_bodies.h"

namespace isotouch::encoding {
namespace {

using ::testing::HasSubstr;

/// Every sample of the grid, stored or not, has the sign of the distance, and far ones are ±band.
void expect_signs(const test::Distance3& distance, const Eigen::Vector3d& half) {
  const Eigen::Vector3d shift(0.31, -0.17, 0.44);
  const field::BandField field = test::field_of(distance, half, 3.0, shift);
  const field_file::Image image = write_image(field, {});
  const auto parsed = FieldView::parse(image.bytes());
  ASSERT_TRUE(parsed.has_value());
  const FieldView& view = *parsed;
  std::size_t inside = 0;
  for (int k = 0; k < view.size[2]; ++k) {
    for (int j = 0; j < view.size[1]; ++j) {
      for (int i = 0; i < view.size[0]; ++i) {
        const double truth = distance(field.grid.position({i, j, k}) - shift);
        const int stored = view.coefficient(i, j, k);
        if (std::abs(truth) > 0.6) {
          ASSERT_EQ(stored < 0, truth < 0) << i << ' ' << j << ' ' << k;
        }
        if (std::abs(truth) > 3.0) {
          ASSERT_EQ(std::abs(stored), view.band.raw()) << i << ' ' << j << ' ' << k;
        }
        inside += truth < 0 ? 1U : 0U;
      }
    }
  }
  EXPECT_GT(inside, 5000U);
}

TEST(WriteImage, EverySampleHasTheRightSignInABall) { expect_signs(test::ball(25), Eigen::Vector3d::Constant(25)); }

TEST(WriteImage, EverySampleHasTheRightSignAroundACavity) { expect_signs(test::hollow_ball(34, 19), Eigen::Vector3d::Constant(34)); }

TEST(WriteImage, EverySampleHasTheRightSignAroundAThinPlate) { expect_signs(test::box({40, 30, 2}), {40, 30, 2}); }

TEST(WriteImage, TheHeaderSaysWhatItWasTold) {
  field::BandField field = test::field_of(test::ball(9), {9, 9, 9});
  field.grid.edge = 0.375;
  field.grid.origin = {-1.5, 2.25, 17.0};
  FieldInfo info;
  info.stiffness_n_per_mm = 1.25;
  info.source_hash = 0x0123456789abcdefULL;
  info.method = Method::kPublished;
  info.point_count = 77;
  info.placement = {2.5, {1.0, -2.0, 3.5}};
  const field_file::Image image = write_image(field, info);
  const auto view = FieldView::parse(image.bytes());
  ASSERT_TRUE(view.has_value());
  EXPECT_EQ(view->edge, MmPerVoxel::of(0.375));
  EXPECT_EQ(view->inverse_edge, VoxelPerMm::of(1 / 0.375));
  EXPECT_EQ(view->origin, (Vec3<Mm>{Mm::of(-1.5), Mm::of(2.25), Mm::of(17.0)}));
  EXPECT_EQ(view->band, Distance::of(4.0));
  EXPECT_EQ(view->stiffness, Stiffness::of(1.25));
  for (std::size_t axis = 0; axis < 3; ++axis) EXPECT_EQ(view->size[axis], field.grid.size[static_cast<int>(axis)]);
  const FieldInfo read = info_of(*view);
  EXPECT_EQ(read.stiffness_n_per_mm, info.stiffness_n_per_mm);
  EXPECT_EQ(read.source_hash, info.source_hash);
  EXPECT_EQ(read.method, info.method);
  EXPECT_EQ(read.point_count, info.point_count);
  EXPECT_EQ(read.placement.scale, info.placement.scale);
  EXPECT_EQ(read.placement.offset, info.placement.offset);
}

TEST(WriteImage, ATrilinearFieldHoldsTheDistancesThemselves) {
  const Eigen::Vector3d shift(0.31, -0.17, 0.44);
  const field::BandField field = test::field_of(test::ball(25), Eigen::Vector3d::Constant(25), 3.0, shift);
  FieldInfo info;
  info.interpolation = Interpolation::kTrilinear;
  const field_file::Image image = write_image(field, info);
  const FieldView view = FieldView::parse(image.bytes()).value();
  EXPECT_EQ(view.interpolation, Interpolation::kTrilinear);
  EXPECT_EQ(info_of(view).interpolation, Interpolation::kTrilinear);
  const field_file::Image spline = write_image(field, {});
  EXPECT_EQ(FieldView::parse(spline.bytes()).value().interpolation, Interpolation::kSpline);
  int asked = 0;
  for (int n = 4; n < view.size[0] - 4; ++n) {
    const double truth = (field.grid.position({n, n, n}) - shift).norm() - 25;
    if (std::abs(truth) > 2.9) continue;
    EXPECT_NEAR(view.coefficient(n, n, n) / 4096.0, truth, 0.6 / 4096);
    ++asked;
  }
  EXPECT_GT(asked, 5);
}

TEST(WriteImage, AListedBrickOfOneConstantIsNotStored) {
  const field::BandField field = test::field_of(test::ball(25), Eigen::Vector3d::Constant(25));
  field::BandField more = field;
  ASSERT_NE(more.bricks.front().cell, Eigen::Vector3i::Zero());
  field::Brick far{Eigen::Vector3i::Zero(), {}};
  far.distance.fill(50.0F);
  more.bricks.insert(more.bricks.begin(), far);
  const field_file::Image a = write_image(field, {});
  const field_file::Image b = write_image(more, {});
  EXPECT_TRUE(std::equal(a.bytes().begin(), a.bytes().end(), b.bytes().begin(), b.bytes().end()));
}

TEST(WriteImage, AnyBandInTheFormatIsAccepted) {
  for (const double band : {1.0, 1.7001, 2.50012207, 4.00012207, 7.99}) {
    const field_file::Image image = write_image(test::field_of(test::ball(14), Eigen::Vector3d::Constant(14), band), {});
    EXPECT_TRUE(FieldView::parse(image.bytes()).has_value()) << band;
  }
}

TEST(WriteImage, AStiffnessOfEachBrickBecomesATableOfPartsOfTheLargest) {
  field::BandField field = test::field_of(test::ball(14), Eigen::Vector3d::Constant(14));
  const field_file::Image without = write_image(field, {});
  for (const field::Brick& brick : field.bricks) field.stiffness.push_back(brick.cell.x() < 6 ? 0.001 : brick.cell.x() < 7 ? 0.6 : 1.2);
  FieldInfo info;
  info.stiffness_n_per_mm = 1.2;
  const field_file::Image image = write_image(field, info);
  const auto view = FieldView::parse(image.bytes());
  ASSERT_TRUE(view.has_value());
  ASSERT_NE(view->stiffness_parts, nullptr);
  EXPECT_EQ(image.size(), without.size() + view->brick_count);
  EXPECT_EQ(FieldView::parse(without.bytes())->stiffness_parts, nullptr);
  int soft = 0, middle = 0, hard = 0;
  for (const field::Brick& brick : field.bricks) {
    const Eigen::Vector3i at = 4 * brick.cell;
    if ((at.array() >= field.grid.size.array()).any()) continue;
    const std::uint32_t number = view->brick_number(at.x(), at.y(), at.z());
    if (number < 2) continue;
    const int part = view->stiffness_parts[number];
    const int x = brick.cell.x();
    ASSERT_EQ(part, x < 6 ? 1 : x < 7 ? 128 : 255) << "rounded, and 1 at least";
    (x < 6 ? soft : x < 7 ? middle : hard) += 1;
  }
  EXPECT_GT(std::min({soft, middle, hard}), 20);
}

TEST(WriteImage, TellsWhatWasTooSmallForTheGrid) {
  const auto with_beads = [](double radius) {
    return [=](const Eigen::Vector3d& p) {
      const double beads = std::min((p - Eigen::Vector3d(14, 3, 2)).norm(), (p - Eigen::Vector3d(-13, 1, 0)).norm()) - radius;
      return std::min(p.norm() - 7, beads);
    };
  };
  for (const auto& [radius, pieces] : {std::pair{1.0, std::size_t{2}}, {2.0, std::size_t{0}}}) {
    SmallComponents dropped{9, 9};
    write_field(test::field_of(with_beads(radius), Eigen::Vector3d::Constant(16)), {}, &dropped);
    EXPECT_EQ(dropped.pieces, pieces) << radius;
    EXPECT_EQ(dropped.cavities, 0U) << radius;
  }
}

std::string refusal(const field::BandField& field, const FieldInfo& info = {}) {
  try {
    write_image(field, info);
  } catch (const InputError& e) {
    return e.what();
  }
  return "accepted";
}

TEST(WriteImage, WhatDoesNotFitTheFormatIsRefusedWithItsName) {
  const field::BandField good = test::field_of(test::ball(9), {9, 9, 9});
  field::BandField bad = good;
  bad.grid.edge = 0.01;
  EXPECT_THAT(refusal(bad), HasSubstr("voxel edge"));
  bad = good;
  bad.grid.origin.y() = 512.1;
  EXPECT_THAT(refusal(bad), HasSubstr("corner"));
  bad = good;
  bad.band = 8.0;
  EXPECT_THAT(refusal(bad), HasSubstr("band"));
  bad = good;
  bad.grid.size.z() = 5000;
  EXPECT_THAT(refusal(bad), HasSubstr("5000 samples"));
  FieldInfo info;
  info.stiffness_n_per_mm = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(refusal(good, info), HasSubstr("stiffness"));
  EXPECT_EQ(refusal(good), "accepted");
}

TEST(WriteImage, ABodyThatReachesTheBorderIsRefused) {
  const field::Grid grid = field::make_grid({-9, -9, -9}, {9, 9, 9}, 1.0, 2.0);
  EXPECT_THAT(refusal(field::sample_distance(test::ball(9), grid, 4.0)), HasSubstr("border"));
}

}  // namespace
}  // namespace isotouch::encoding
