#include "host/live/live_field.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "host/error.h"
#include "host/field/parallel.h"
#include "shared/certificate.h"
#include "shared/field_view.h"
#include "tests/host/live/random_batches.h"

namespace isotouch::live {
namespace {

using Eigen::Vector3d;

bool same(const field_file::Image& a, const field_file::Image& b) { return std::ranges::equal(a.bytes(), b.bytes()); }

/// Short histories of every object; `live_plain` runs thousands.
void expect_whole(unsigned threads) {
  const field::ThreadLimit limit(threads);
  std::size_t bricks = 0;
  for (std::uint64_t history = 0; history < cloud::shape_names().size(); ++history) {
    test::RandomBatches batches(cloud::shape(cloud::shape_names()[history]), 32, history);
    LiveField field(batches.grid(), field::kBand, {});
    for (int n = 0; n < 4; ++n) {
      field.apply(batches.next());
      LiveField whole(batches.grid(), field::kBand, {});
      whole.apply(batches.whole());
      const field_file::Image image = field.image();
      ASSERT_TRUE(same(image, whole.image())) << cloud::shape_names()[history] << ", batch " << n;
      ASSERT_EQ(field.verdict(), whole.verdict());
      ASSERT_EQ(field.source_hash(), whole.source_hash());
      ASSERT_EQ(field.certificate_hash(), whole.certificate_hash()) << cloud::shape_names()[history] << ", batch " << n;
      const auto view = FieldView::parse(image.bytes());
      ASSERT_TRUE(view.has_value());
      bricks += view->brick_count - 2;
    }
  }
  EXPECT_GT(bricks, 1000U);
}

TEST(LiveField, IsTheFieldOfAllPresentPointsToTheByte) { expect_whole(1); }
TEST(LiveField, IsTheSameWithSevenThreads) { expect_whole(7); }

/// Also where 1 / reach², in floats, is more or less than it is.
TEST(LiveField, IsTheSameWithOtherBands) {
  for (const double band : {1.0, 1.14, 1.5, 2.54, 2.98, 3.16, 5.3, 7.99}) {
    test::RandomBatches batches(cloud::shape("owl"), 24, 3);
    LiveField field(batches.grid(), band, {});
    for (int n = 0; n < 3; ++n) {
      field.apply(batches.next());
      LiveField whole(batches.grid(), band, {});
      whole.apply(batches.whole());
      const field_file::Image image = field.image();
      ASSERT_TRUE(same(image, whole.image())) << band;
      const auto view = FieldView::parse(image.bytes());
      ASSERT_TRUE(view.has_value()) << band;
      EXPECT_GT(view->brick_count, 20U);
    }
  }
}

/// Points of a sphere in the middle of a grid of one voxel a millimetre.
struct Ball {
  field::Grid grid = field::make_grid(Vector3d::Constant(-20), Vector3d::Constant(20), 1.0, 16);
  double radius = 18;

  Batch points(std::size_t count, std::uint64_t seed = 1) const {
    Batch batch;
    cloud::Random random(seed);
    while (batch.added.size() < count) {
      const Vector3d at(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
      if (at.norm() > 1.0 || at.norm() < 0.1) continue;
      batch.added.push_back(*point_in(grid, radius * at.normalized(), at));
    }
    return batch;
  }
};

TEST(LiveField, LiesWhereItsPointsLie) {
  const Ball ball;
  LiveField field(ball.grid, field::kBand, {});
  field.apply(ball.points(3000));
  const field_file::Image image = field.image();
  const FieldView view = *FieldView::parse(image.bytes());
  std::size_t near = 0, behind = 0;
  double worst = 0.0;
  for (int k = 0; k < view.size[2]; ++k) {
    for (int j = 0; j < view.size[1]; ++j) {
      for (int i = 0; i < view.size[0]; ++i) {
        const double truth = ball.grid.position({i, j, k}).norm() - ball.radius;
        const double value = static_cast<double>(view.coefficient(i, j, k)) / 4096;
        if (std::abs(truth) < 2.9) worst = std::max(worst, std::abs(value - truth)), ++near;
        if (truth < -3.1 && truth > -3.6) {
          EXPECT_EQ(view.coefficient(i, j, k), -view.band.raw());
          ++behind;
        }
        if (truth > 3.1 || truth < -11) {  // there is nothing, or nothing is known
          EXPECT_EQ(view.coefficient(i, j, k), view.band.raw());
        }
      }
    }
  }
  EXPECT_GT(near, 10000U);
  EXPECT_GT(behind, 1000U);
  EXPECT_LT(worst, 0.12);
  EXPECT_GT(worst, 0.01);  // else tighten
  EXPECT_TRUE(check_certificate(view, assumed_loop(view), {}).accepted);
}

TEST(LiveField, EndsWhereItsPointsEnd) {
  const Ball ball;
  Batch half = ball.points(4000);
  std::erase_if(half.added, [&](const Point& p) { return p.position[2] < (ball.grid.size.z() - 1) << (kPositionBits - 1); });
  LiveField field(ball.grid, field::kBand, {});
  field.apply(half);
  const field_file::Image image = field.image();
  const FieldView view = *FieldView::parse(image.bytes());
  std::size_t inside = 0;
  for (int k = 0; k < view.size[2]; ++k) {
    for (int j = 0; j < view.size[1]; ++j) {
      for (int i = 0; i < view.size[0]; ++i) {
        if (view.coefficient(i, j, k) >= 0) continue;
        ++inside;
        const Vector3d at = ball.grid.position({i, j, k});
        EXPECT_LT(at.norm(), ball.radius + 1);
        EXPECT_GT(at.z(), -7.5) << at.transpose();  // of the unseen half: what lies behind the seen one, and a rim
      }
    }
  }
  EXPECT_GT(inside, 1000U);
}

TEST(LiveField, HasTheSameBytesOnEveryMachine) {
  const cloud::Shape shape = cloud::shape("owl");
  const cloud::OrientedPoints points = cloud::sample_shape(shape, 1000);
  const field::Grid grid = field::make_grid(shape.low, shape.high, (shape.high - shape.low).maxCoeff() / 48, margin(field::kBand));
  Batch batch;
  for (std::size_t i = 0; i < points.size(); ++i) batch.added.push_back(*point_in(grid, points.positions[i], points.normals[i]));
  LiveField field(grid, field::kBand, {});
  field.apply(batch);
  EXPECT_EQ(FieldView::parse(field.image().bytes())->hash(), 0xde274974e587534dULL);
}

TEST(LiveField, OfNothingIsEmptyAgain) {
  const Ball ball;
  LiveField field(ball.grid, field::kBand, {}), empty(ball.grid, field::kBand, {});
  Batch batch = ball.points(500);
  field.apply(batch);
  EXPECT_FALSE(same(field.image(), empty.image()));
  std::swap(batch.added, batch.removed);
  field.apply(batch);
  EXPECT_TRUE(same(field.image(), empty.image()));
  EXPECT_EQ(field.verdict(), Verdict{});
}

TEST(LiveField, WorkGrowsWithTheBatchAndNotWithTheField) {
  const Ball ball;
  Work small_field, large_field;
  for (Work* work : {&small_field, &large_field}) {
    LiveField field(ball.grid, field::kBand, {});
    Batch cap = ball.points(12000);
    if (work == &small_field) std::erase_if(cap.added, [&](const Point& p) { return p.position[2] < 40 << kPositionBits; });
    field.apply(cap);
    Batch one;
    one.added.push_back(*point_in(ball.grid, ball.radius * Vector3d::UnitZ(), Vector3d::UnitZ()));
    *work = field.apply(one);
  }
  EXPECT_EQ(small_field.models, large_field.models);
  EXPECT_EQ(small_field.bricks, large_field.bricks);
  EXPECT_GT(large_field.models, 1U);
  EXPECT_LT(large_field.models, 60U);
  EXPECT_LT(large_field.bricks, 200U);
}

TEST(LiveField, AStrayIsNoSurface) {
  const Ball ball;
  LiveField field(ball.grid, field::kBand, {});
  Batch stray;
  for (int n = 0; n < 50; ++n) stray.added.push_back(*point_in(ball.grid, {1, 2, 3}, {0, 0, 1}));
  field.apply(stray);
  EXPECT_EQ(field.verdict().samples, 1U);
  EXPECT_EQ(field.verdict().lonely, 1U);
  EXPECT_EQ(FieldView::parse(field.image().bytes())->brick_count, 2U);
  EXPECT_EQ(field.verdict().reasons().size(), 1U);
  EXPECT_NE(field.verdict().reasons()[0].find("larger --voxel"), std::string::npos);
  field.apply({{}, stray.added});
  ASSERT_EQ(field.verdict().reasons().size(), 1U);
  EXPECT_NE(field.verdict().reasons()[0].find("none of its points is left"), std::string::npos);
}

TEST(LiveField, SaysThatNormalsContradict) {
  const Ball ball;
  Batch batch = ball.points(3000);
  cloud::Random random(5);
  for (Point& point : batch.added) {
    for (std::int16_t& x : point.normal) x = static_cast<std::int16_t>(random.uniform(-16000, 16000));
  }
  LiveField field(ball.grid, field::kBand, {});
  field.apply(batch);
  EXPECT_GT(field.verdict().unexplained_share(), 0.3);
  EXPECT_FALSE(field.verdict().reasons().empty());
  LiveField right(ball.grid, field::kBand, {});
  right.apply(ball.points(3000));
  EXPECT_LT(right.verdict().unexplained_share(), 0.01);
  EXPECT_TRUE(right.verdict().reasons().empty());
}

TEST(LiveField, SaysThatABodyIsInsideOutAndNotThatAHollowIs) {
  const Ball ball;
  const auto reasons = [&](bool turned, bool half) {
    Batch batch;
    for (Point point : ball.points(3000).added) {
      if (half && point.normal[2] < 0) continue;
      if (turned) {
        for (std::int16_t& x : point.normal) x = static_cast<std::int16_t>(-x);
      }
      batch.added.push_back(point);
    }
    LiveField field(ball.grid, field::kBand, {});
    field.apply(batch);
    return field.verdict().reasons().size();
  };
  EXPECT_EQ(reasons(false, false), 0U);
  EXPECT_EQ(reasons(true, false), 1U);
  EXPECT_EQ(reasons(false, true), 0U);
  EXPECT_EQ(reasons(true, true), 0U) << "the inside of a bowl";
}

TEST(LiveField, RefusesToRemoveWhatIsNotThere) {
  const Ball ball;
  LiveField field(ball.grid, field::kBand, {});
  Batch batch = ball.points(10);
  batch.removed = ball.points(1, 7).added;
  EXPECT_THROW(field.apply(batch), InputError);
}

TEST(LivePoint, OutsideTheGridOrWithoutANormalIsNone) {
  const Ball ball;
  EXPECT_TRUE(point_in(ball.grid, {0, 0, 0}, {0, 0, 2}).has_value());
  EXPECT_FALSE(point_in(ball.grid, {0, 0, 100}, {0, 0, 1}).has_value());
  EXPECT_FALSE(point_in(ball.grid, {0, 0, 0}, {0, 0, 0}).has_value());
  EXPECT_FALSE(point_in(ball.grid, {std::numeric_limits<double>::quiet_NaN(), 0, 0}, {0, 0, 1}).has_value());
  EXPECT_FALSE(point_in(ball.grid, {0, 0, 0}, {0, std::numeric_limits<double>::infinity(), 1}).has_value());
}

TEST(LiveBucket, ForgetsWhatIsRemoved) {
  const Ball ball;
  const Batch batch = ball.points(2);
  Bucket both, one;
  both.add(batch.added[0]);
  both.add(batch.added[1]);
  both.remove(batch.added[0]);
  one.add(batch.added[1]);
  EXPECT_EQ(both.count(), 1U);
  EXPECT_EQ(both.mean(), one.mean());
}

}  // namespace
}  // namespace isotouch::live
