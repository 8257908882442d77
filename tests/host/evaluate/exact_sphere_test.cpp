#include "host/evaluate/exact_sphere.h"

#include <gtest/gtest.h>

namespace isotouch::evaluate {
namespace {

TEST(ExactSphere, IsASpringUpToTheLimitForAHandThatMayFeelIt) {
  Output out;
  out.hip = {Mm::of(0), Mm::of(33), Mm::of(0)};
  EXPECT_NEAR(exact_sphere_force(InputKind::kPosition, out, 35, 0.8, 8), 1.6, 1e-9);
  EXPECT_EQ(exact_sphere_force(InputKind::kPosition, out, 35, 0.8, 1), 1);
  EXPECT_EQ(exact_sphere_force(InputKind::kPosition, out, 32, 0.8, 8), 0);
  EXPECT_EQ(exact_sphere_force(InputKind::kPacket, out, 35, 0.8, 8), 0) << "the device is not active";
  out.state = static_cast<std::uint16_t>(SupervisorState::kActive);
  EXPECT_NEAR(exact_sphere_force(InputKind::kPacket, out, 35, 0.8, 8), 1.6, 1e-9);
  out.status = kHeldInside;
  EXPECT_EQ(exact_sphere_force(InputKind::kPosition, out, 35, 0.8, 8), 0);
}

}  // namespace
}  // namespace isotouch::evaluate
