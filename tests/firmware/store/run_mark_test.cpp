#include "firmware/store/run_mark.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "shared/fault_names.h"
#include "tests/firmware/store/crashing_folder.h"

namespace isotouch::store {
namespace {

using testing::HasSubstr;

bool finds_a_crash(CrashingFolder& folder) { return RunMark(folder).crashed(); }
bool finds_a_calibration(CrashingFolder& folder) { return RunMark(folder).recalibrated(); }

/// Runs that nobody confirms: each finds what the one before found.
void asks_again_and_again(CrashingFolder& folder, bool (RunMark::*finds)() const, const char* words) {
  for (int times = 0; times < 2; ++times) {
    RunMark later(folder);
    EXPECT_TRUE((later.*finds)());
    EXPECT_THAT(later.begin().sentence(), HasSubstr(words));
    EXPECT_EQ(later.end().sentence(), "");
  }
}

/// A run from its begin, which must have nothing to say, to an orderly end.
void run(CrashingFolder& folder, const std::function<void(RunMark&)>& life = nullptr) {
  RunMark mark(folder);
  EXPECT_EQ(mark.begin().sentence(), "");
  if (life) life(mark);
  EXPECT_EQ(mark.end().sentence(), "");
}

TEST(RunMark, ACrashIsFoundByEveryStartUntilAPersonHasConfirmedIt) {
  CrashingFolder folder;
  run(folder);
  EXPECT_FALSE(finds_a_crash(folder));
  EXPECT_EQ(RunMark(folder).begin().sentence(), "");  // and has no end
  asks_again_and_again(folder, &RunMark::crashed, "the previous run crashed");
  RunMark confirming(folder);
  EXPECT_TRUE(confirming.begin());
  confirming.confirm();
  EXPECT_TRUE(confirming.crashed()) << "as it was at the start";
  EXPECT_TRUE(finds_a_crash(folder)) << "it may still crash itself";
  EXPECT_EQ(confirming.end().sentence(), "");
  EXPECT_FALSE(finds_a_crash(folder));
}

TEST(RunMark, ARunThatEndsInAFaultIsFoundUntilAPersonHasConfirmedIt) {
  CrashingFolder folder;
  RunMark first(folder);
  EXPECT_EQ(first.begin().sentence(), "");
  EXPECT_EQ(first.end(kFaultStopped).sentence(), "");
  EXPECT_TRUE(finds_a_crash(folder));
  RunMark second(folder);
  second.confirm();
  EXPECT_EQ(second.end(kFaultStopped).sentence(), "");
  EXPECT_TRUE(finds_a_crash(folder)) << "confirmed, and in a fault again";
  RunMark third(folder);
  third.confirm();
  EXPECT_EQ(third.end().sentence(), "");
  EXPECT_FALSE(finds_a_crash(folder));
}

TEST(RunMark, TheNamesOfFaultsStayUntilAPersonHasConfirmedThem) {
  CrashingFolder folder;
  {
    RunMark first(folder);
    EXPECT_EQ(first.begin().sentence(), "");
    EXPECT_EQ(first.faults(), 0);
    EXPECT_EQ(first.note(kFaultGuard).sentence(), "");
    EXPECT_EQ(first.note(0).sentence(), "");  // and it is killed
  }
  CrashingFolder cut = folder.after_power_cut(0, CrashingFolder::Content::kEmpty);
  EXPECT_EQ(RunMark(cut).faults(), kFaultGuard) << "it was on the disk at once";
  for (int times = 0; times < 2; ++times) {
    RunMark later(folder);
    EXPECT_EQ(later.faults(), kFaultGuard) << times;
    EXPECT_TRUE(later.begin());
    EXPECT_EQ(later.end().sentence(), "");
  }
  RunMark second(folder);
  EXPECT_TRUE(second.begin());
  EXPECT_EQ(second.end(kFaultStopped).sentence(), "");
  RunMark third(folder);
  EXPECT_EQ(third.faults(), kFaultGuard | kFaultStopped);
  third.confirm();
  EXPECT_EQ(RunMark(folder).faults(), 0) << "confirmed, although it may still crash itself";
  EXPECT_EQ(third.end().sentence(), "");
  EXPECT_FALSE(finds_a_crash(folder));
}

TEST(RunMark, ANameThatCannotBeKeptIsTold) {
  CrashingFolder folder;
  RunMark first(folder);
  EXPECT_EQ(first.begin().sentence(), "");
  folder.full = true;
  const char* nameless = "nobody will know the fault's name; check";
  const char* roleless = "nobody will know the fault's name, nor that the role service must resume; check";
  EXPECT_THAT(first.note(kFaultGuard).sentence(), testing::HasSubstr(roleless));
  EXPECT_EQ(first.note(kFaultGuard).sentence(), "") << "it was told";
  EXPECT_EQ(first.note(0).sentence(), "");
  EXPECT_THAT(first.note(kFaultStopped).sentence(), testing::HasSubstr(nameless)) << "whoever may operate may resume";
  EXPECT_EQ(first.end(kFaultGuard).sentence(), "") << "it was told";
  EXPECT_TRUE(finds_a_crash(folder)) << "a person must resume all the same";
  folder.full = false;
  EXPECT_EQ(first.note(kFaultGuard).sentence(), "") << "it is tried again";
  EXPECT_EQ(RunMark(folder).faults(), kFaultGuard);
}

TEST(RunMark, EveryFaultIsFoundByItsNameAlone) {
  for (const FaultName& fault : kFaultNames) {
    CrashingFolder folder;
    EXPECT_EQ(RunMark(folder).end(fault.fault).sentence(), "");
    EXPECT_EQ(RunMark(folder).faults(), fault.fault) << fault.name;
  }
}

TEST(RunMark, AChangedCalibrationStaysUntilItIsConfirmed) {
  CrashingFolder folder;
  run(folder, [](RunMark& mark) {
    EXPECT_EQ(mark.note_calibration().sentence(), "");
    mark.confirm();  // of what was before: nothing
  });
  asks_again_and_again(folder, &RunMark::recalibrated, "angles of the device's arms were changed");
  RunMark confirming(folder);
  confirming.confirm();
  EXPECT_TRUE(confirming.recalibrated()) << "as it was at the start";
  EXPECT_FALSE(finds_a_calibration(folder));
}

TEST(RunMark, ACrashAndACalibrationAreBothFound) {
  CrashingFolder folder;
  RunMark mark(folder);
  EXPECT_EQ(mark.begin().sentence(), "");
  EXPECT_EQ(mark.note_calibration().sentence(), "");
  CrashingFolder cut = folder.after_power_cut(0, CrashingFolder::Content::kEmpty);
  EXPECT_TRUE(finds_a_crash(cut));
  EXPECT_TRUE(finds_a_calibration(cut));
}

TEST(RunMark, WhatIsCalibratedAgainBeforeItIsConfirmedStays) {
  CrashingFolder folder;
  run(folder, [](RunMark& mark) { EXPECT_EQ(mark.note_calibration().sentence(), ""); });
  RunMark second(folder);
  EXPECT_EQ(second.note_calibration().sentence(), "");
  second.confirm();
  EXPECT_TRUE(finds_a_calibration(folder));
}

TEST(RunMark, APowerCutInARunIsFoundAndOneAfterItIsNot) {
  CrashingFolder folder;
  RunMark mark(folder);
  EXPECT_EQ(mark.begin().sentence(), "");
  ASSERT_EQ(folder.pending(), 0U);
  CrashingFolder cut = folder.after_power_cut(0, CrashingFolder::Content::kEmpty);
  EXPECT_TRUE(finds_a_crash(cut));
  EXPECT_EQ(mark.end().sentence(), "");
  ASSERT_EQ(folder.pending(), 0U);
  CrashingFolder later = folder.after_power_cut(0, CrashingFolder::Content::kEmpty);
  EXPECT_FALSE(finds_a_crash(later));
}

TEST(RunMark, ARunThatCannotBeMarkedNeedsAPerson) {
  CrashingFolder folder;
  folder.steps_left = 0;
  RunMark mark(folder);
  EXPECT_THAT(mark.begin().sentence(), HasSubstr("cannot be written"));
  EXPECT_THAT(mark.note_calibration().sentence(), HasSubstr("cannot be written"));
}

}  // namespace
}  // namespace isotouch::store
