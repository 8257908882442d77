#include "firmware/store/run_mark.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/firmware/store/crashing_folder.h"

namespace isotouch::store {
namespace {

using testing::HasSubstr;
using Left = RunMark::Left;

TEST(RunMark, OnlyARunWithoutAnOrderlyEndLeavesIt) {
  CrashingFolder folder;
  {
    RunMark first(folder);
    EXPECT_EQ(first.left(), Left::kNothing);
    EXPECT_EQ(first.begin().sentence(), "");
    first.end();
  }
  {
    RunMark second(folder);
    EXPECT_EQ(second.left(), Left::kNothing);
    EXPECT_EQ(second.begin().sentence(), "");
  }
  RunMark third(folder);
  EXPECT_EQ(third.left(), Left::kRun);
  EXPECT_THAT(third.begin().sentence(), HasSubstr("the previous run crashed"));
  EXPECT_EQ(third.left(), Left::kRun);  // until a person has resumed, and longer
  third.end();
  EXPECT_EQ(RunMark(folder).left(), Left::kNothing);
}

TEST(RunMark, AChangedCalibrationIsFoundByTheNextRunAlone) {
  CrashingFolder folder;
  RunMark first(folder);
  EXPECT_EQ(first.begin().sentence(), "");
  first.note_calibration();
  first.end();
  RunMark second(folder);
  EXPECT_EQ(second.left(), Left::kCalibration) << "whatever the end";
  EXPECT_THAT(second.begin().sentence(), HasSubstr("angles of the device's arms were changed"));
  second.end();
  EXPECT_EQ(RunMark(folder).left(), Left::kNothing);
}

TEST(RunMark, APowerCutInARunIsFoundAndOneAfterItIsNot) {
  CrashingFolder folder;
  RunMark mark(folder);
  EXPECT_EQ(mark.begin().sentence(), "");
  ASSERT_EQ(folder.pending(), 0U);
  CrashingFolder cut = folder.after_power_cut(0, CrashingFolder::Content::kEmpty);
  EXPECT_EQ(RunMark(cut).left(), Left::kRun);
  mark.end();
  ASSERT_EQ(folder.pending(), 0U);
  CrashingFolder later = folder.after_power_cut(0, CrashingFolder::Content::kEmpty);
  EXPECT_EQ(RunMark(later).left(), Left::kNothing);
}

TEST(RunMark, ARunThatCannotBeMarkedNeedsAPerson) {
  CrashingFolder folder;
  folder.steps_left = 0;
  EXPECT_THAT(RunMark(folder).begin().sentence(), HasSubstr("cannot be written"));
}

}  // namespace
}  // namespace isotouch::store
