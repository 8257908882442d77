#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "hil/falcon_model/paths.h"

namespace isotouch::falcon_model {
namespace {

TEST(ScriptedPath, EveryMotionIsSlowerThanAHandAndStaysInReach) {
  for (const std::string& name : motion_names()) {
    const Path path = scripted_path(name);
    double fastest = 0, farthest = 0;
    Vector last = path(0);
    for (int ms = 1; ms < 70000; ++ms) {
      const Vector next = path(ms);
      fastest = std::max(fastest, length(next - last));
      farthest = std::max(farthest, length(next));
      last = next;
    }
    EXPECT_LT(fastest, 1.01) << name;  // mm in a ms
    EXPECT_LT(farthest, 46) << name;
    EXPECT_EQ(fastest > 0, name != "rest");
  }
  EXPECT_THROW(scripted_path("tur"), std::invalid_argument);
}

TEST(ScriptedPath, TheTourClosesAfterAMinute) {
  const Path tour = scripted_path("tour");
  for (const double ms : {0.0, 1234.0, 31000.0}) EXPECT_LT(length(tour(ms) - tour(ms + 60000)), 1e-9);
}

}  // namespace
}  // namespace isotouch::falcon_model
