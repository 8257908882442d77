#include "host/commands/progress_bar.h"

#include <gtest/gtest.h>

namespace isotouch::commands {
namespace {

TEST(ProgressBar, GoesOnWithTimeAndReachesTheEndOfAStageWithTheStageOnly) {
  ProgressBar bar({{"read", 1}, {"model", 5}, {"walk", 3}, {"write", 1}}, ProgressBar::Drawn::kNever);
  EXPECT_EQ(bar.done(0), 0);
  bar.begin("read");
  double before = -1;
  for (const double time : {0.0, 0.3, 0.6, 0.9, 2.0, 10.0, 1e3, 1e9}) {
    const double done = bar.done(time);
    EXPECT_GT(done, before) << time;
    EXPECT_LE(done, 0.1) << time;
    before = done;
  }
  EXPECT_NEAR(bar.done(0.5), 0.05, 0.01) << "half of a stage that takes as long as planned";
  bar.begin("walk");  // "model" was left out
  EXPECT_GE(bar.done(0), 0.6);
  EXPECT_LT(bar.done(1e9), 0.9001);
}

TEST(ProgressBar, AStageThatSaysHowFarItIsIsBelieved) {
  ProgressBar bar({{"read", 1}, {"model", 3}}, ProgressBar::Drawn::kNever);
  field::Progress progress(bar.show());
  progress.begin("model");
  progress.report(0.5);
  EXPECT_NEAR(bar.done(0), 0.25 + 0.75 * 0.5, 1e-9);
  EXPECT_NEAR(bar.done(1e9), 0.25 + 0.75 * 0.5, 1e-9);
}

TEST(ProgressBar, NeverGoesBackWhenThePlanChanges) {
  ProgressBar bar({{"read", 1}, {"model", 1}}, ProgressBar::Drawn::kNever);
  bar.begin("read");
  bar.begin("model");
  const double before = bar.done(0);
  EXPECT_NEAR(before, 0.5, 0.01);
  bar.plan({{"read", 1}, {"model", 1}, {"walk", 98}});
  EXPECT_GE(bar.done(0), before);
  bar.begin("walk");
  EXPECT_GE(bar.done(0), before);
}

}  // namespace
}  // namespace isotouch::commands
