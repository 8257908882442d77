#include "host/trace/rendering_difference.h"

#include <gtest/gtest.h>

#include "host/to_double.h"

namespace isotouch::trace {
namespace {

Output touch(double fx, double fy, double proxy_x) {
  Output out;
  out.status = kContact;
  out.force = to_fixed<Newton>(Eigen::Vector3d(fx, fy, 0));
  out.proxy = to_fixed<Mm>(Eigen::Vector3d(proxy_x, 0, 0));
  return out;
}

TEST(RenderingDifference, MeasuresTicksInWhichOneTouches) {
  RenderingDifference difference;
  difference.add(InputKind::kPosition, {}, {});
  difference.add(InputKind::kPosition, touch(2, 0, 1), touch(0, 2, 1.5));
  difference.add(InputKind::kPosition, touch(1, 0, 1), {});
  const RenderingFigures figures = difference.figures();
  EXPECT_EQ(figures.ticks, 3U);
  EXPECT_EQ(figures.touching, 2U);
  EXPECT_EQ(figures.contact_differs, 1U);
  EXPECT_EQ(figures.all.force_n.count, 2U);
  EXPECT_NEAR(figures.all.force_n.median, 1, 1e-6);
  EXPECT_NEAR(figures.all.force_n.max, 2.828427, 1e-5);
  EXPECT_EQ(figures.all.direction_deg.count, 1U) << "no force has no direction";
  EXPECT_NEAR(figures.all.direction_deg.max, 90, 1e-9);
  EXPECT_NEAR(figures.all.proxy_mm.median, 0.5, 1e-6);
  EXPECT_NEAR(figures.all.proxy_mm.max, 1, 1e-6);
}

TEST(RenderingDifference, AHandIsShallowIfItIsByOneOfTheTwo) {
  RenderingDifference difference;
  difference.add(InputKind::kPosition, touch(1, 0, 0.5), touch(1, 0, 30));
  difference.add(InputKind::kPosition, touch(1, 0, 30), touch(1, 0, 0.5));
  difference.add(InputKind::kPosition, touch(1, 0, 1.1), touch(1, 0, 30));
  const RenderingFigures figures = difference.figures();
  EXPECT_EQ(figures.all.proxy_mm.count, 3U);
  EXPECT_EQ(figures.shallow.proxy_mm.count, 2U);
  EXPECT_EQ(figures.shallow.force_n.count, 2U);
}

TEST(RenderingDifference, SmallForcesHaveNoDirection) {
  RenderingDifference difference;
  difference.add(InputKind::kPosition, touch(0.09, 0, 0), touch(0, 2, 0));
  difference.add(InputKind::kPosition, touch(0.11, 0, 0), touch(0, 0.09, 0));
  EXPECT_EQ(difference.figures().all.direction_deg.count, 0U);
  difference.add(InputKind::kPosition, touch(0.11, 0, 0), touch(0, 0.11, 0));
  EXPECT_EQ(difference.figures().all.direction_deg.count, 1U);
}

TEST(RenderingDifference, OfADeviceForcesCountOnlyWhereItGivesAllOfThem) {
  RenderingDifference difference;
  Output recorded = touch(1, 0, 0);
  difference.add(InputKind::kPacket, recorded, touch(2, 0, 0));
  recorded.state = static_cast<std::uint16_t>(SupervisorState::kActive);
  recorded.status |= kRamping;
  difference.add(InputKind::kPacket, recorded, touch(2, 0, 0));
  EXPECT_EQ(difference.figures().all.force_n.count, 0U);
  EXPECT_EQ(difference.figures().all.proxy_mm.count, 2U);
  recorded.status = kContact;
  difference.add(InputKind::kPacket, recorded, touch(2, 0, 0));
  EXPECT_EQ(difference.figures().all.force_n.count, 1U);
}

}  // namespace
}  // namespace isotouch::trace
