#include "firmware/store/run_mark.h"

#include <gtest/gtest.h>

#include "tests/firmware/store/crashing_folder.h"

namespace isotouch::store {
namespace {

TEST(RunMark, OnlyARunWithoutAnOrderlyEndLeavesIt) {
  CrashingFolder folder;
  {
    RunMark first(folder);
    EXPECT_FALSE(first.was_left());
    ASSERT_TRUE(first.set());
    first.clear();
  }
  {
    RunMark second(folder);
    EXPECT_FALSE(second.was_left());
    ASSERT_TRUE(second.set());
  }
  RunMark third(folder);
  EXPECT_TRUE(third.was_left());
  ASSERT_TRUE(third.set());
  EXPECT_TRUE(third.was_left());  // until a person has resumed, and longer
  third.clear();
  EXPECT_FALSE(RunMark(folder).was_left());
}

TEST(RunMark, APowerCutInARunIsFoundAndOneAfterItIsNot) {
  CrashingFolder folder;
  RunMark mark(folder);
  ASSERT_TRUE(mark.set());
  ASSERT_EQ(folder.pending(), 0U);
  CrashingFolder cut = folder.after_power_cut(0, CrashingFolder::Content::kEmpty);
  EXPECT_TRUE(RunMark(cut).was_left());
  mark.clear();
  ASSERT_EQ(folder.pending(), 0U);
  CrashingFolder later = folder.after_power_cut(0, CrashingFolder::Content::kEmpty);
  EXPECT_FALSE(RunMark(later).was_left());
}

TEST(RunMark, ADiskThatFailsIsSaid) {
  CrashingFolder folder;
  folder.steps_left = 0;
  EXPECT_EQ(RunMark(folder).set().error(), StoreError::kFailed);
}

}  // namespace
}  // namespace isotouch::store
