#include "firmware/core/handle_weight.h"

#include <gtest/gtest.h>

namespace isotouch::core {
namespace {

TEST(HandleWeight, IsHeldUpAlongY) {
  const Vec3<Newton> force = with_handle_held_up({Newton::of(1), Newton::of(-2), Newton::of(3)}, Newton::of(0.75));
  EXPECT_EQ(force, (Vec3<Newton>{Newton::of(1), Newton::of(-1.25), Newton::of(3)}));
  EXPECT_EQ(with_handle_held_up({}, {}), Vec3<Newton>{});
}

}  // namespace
}  // namespace isotouch::core
