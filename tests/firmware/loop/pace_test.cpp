#include "firmware/loop/pace.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "tests/support/random.h"

namespace isotouch::loop {
namespace {

constexpr std::int64_t kPeriod = 1'000'000;

/// Ticks of a device whose replies come at these times, each as the loop would begin it without delays of its own.
struct Course {
  std::vector<std::int64_t> starts;
  std::vector<std::int64_t> waits;  ///< from the reply to its tick; -1: no reply
};

Course course_of(const std::vector<std::int64_t>& arrivals) {
  Pace pace(kPeriod, 0);
  Course course;
  std::int64_t now = 0;
  for (std::size_t next = 0; next < arrivals.size();) {
    const bool replied = std::max(arrivals[next], now) <= std::max(pace.due_ns(), now);
    const std::int64_t start = replied ? pace.start_ns(arrivals[next]) : pace.due_ns();
    now = std::max(now, start);
    EXPECT_EQ(pace.begin(replied ? arrivals[next] : Pace::kNoReply, now), 0U);
    course.starts.push_back(now);
    course.waits.push_back(replied ? now - arrivals[next] : -1);
    while (replied && next < arrivals.size() && arrivals[next] <= now) ++next;
  }
  return course;
}

TEST(Pace, ADeviceThatKeepsTimeStartsEveryTickWhateverItsPhaseAndDrift) {
  test::Random random(3);
  for (const double drift : {-1e-3, -1e-5, 0.0, 1e-6, 1e-3}) {
    for (int phase = 0; phase < 20; ++phase) {
      std::vector<std::int64_t> arrivals;
      for (int k = 1; k <= 4000; ++k) {
        const double jitter = double(random.bits() % 10'000);
        arrivals.push_back(phase * kPeriod / 20 + std::int64_t(k * double(kPeriod) * (1 + drift) + jitter));
      }
      const Course result = course_of(arrivals);
      const std::size_t settled = 600;
      ASSERT_GE(result.starts.size(), 3900U);
      for (std::size_t i = settled; i < result.starts.size(); ++i) {
        ASSERT_GE(result.waits[i], 0) << "stale at " << i << " phase " << phase << " drift " << drift;
        ASSERT_LE(result.waits[i], 16'000) << i << " phase " << phase << " drift " << drift;
      }
    }
  }
}

TEST(Pace, OneLateReplyCostsNoPhaseForLong) {
  std::vector<std::int64_t> arrivals;
  for (int k = 1; k <= 200; ++k) arrivals.push_back(k * kPeriod + (k == 100 ? 240'000 : 0));
  const Course result = course_of(arrivals);
  ASSERT_EQ(result.starts.size(), 200U);
  EXPECT_EQ(result.waits[98], 0);
  EXPECT_EQ(result.waits[99], 0);
  for (std::size_t i = 102; i < 200; ++i) EXPECT_EQ(result.waits[i], 0) << i;
}

TEST(Pace, ADeviceFasterThanTheTickLeavesItToItsOwnClock) {
  Pace pace(kPeriod, 0);
  std::int64_t now = 0;
  for (int i = 1; i <= 1000; ++i) {
    const std::int64_t arrival = now + 300'000;
    const std::int64_t start = pace.start_ns(arrival);
    EXPECT_EQ(start, i * kPeriod + (i - 1) * (kPeriod / 512));
    EXPECT_EQ(pace.begin(arrival, start), 0U);
    now = start;
  }
}

TEST(Pace, ADeviceAlmostAsFastAsTheTickHurriesItByASixtyFourthAtMost) {
  Pace pace(kPeriod, 0);
  std::int64_t now = 0;
  for (int i = 1; i <= 1000; ++i) {
    const std::int64_t start = pace.start_ns(now + 700'000);
    pace.begin(now + 700'000, start);
    EXPECT_GE(start - now, kPeriod - kPeriod / 64);
    EXPECT_LE(start - now, kPeriod);
    now = start;
  }
}

TEST(Pace, WithoutRepliesTicksStayOnTheirGrid) {
  Pace pace(kPeriod, 500);
  for (int i = 1; i <= 1000; ++i) {
    EXPECT_EQ(pace.due_ns(), 500 + i * kPeriod + kPeriod / 4);
    EXPECT_EQ(pace.begin(Pace::kNoReply, pace.due_ns() + 600'000), 0U);
  }
}

TEST(Pace, ATickThatIsLateByWholePeriodsLeavesThemOut) {
  Pace pace(kPeriod, 0);
  EXPECT_EQ(pace.begin(Pace::kNoReply, 7 * kPeriod + 100), 6U);
  EXPECT_EQ(pace.due_ns(), 8 * kPeriod + kPeriod / 4);
  EXPECT_EQ(pace.begin(8 * kPeriod, 8 * kPeriod + 999'999), 0U);
  EXPECT_EQ(pace.begin(9 * kPeriod, 10 * kPeriod), 1U);
}

TEST(Pace, AClockThatWasSetBackDelaysNoTick) {
  Pace pace(1'000'000, 500'000'000);
  pace.stay_near(499'000'000);
  EXPECT_EQ(pace.due_ns(), 501'250'000) << "within two periods nothing changes";
  pace.stay_near(100'000'000);
  EXPECT_EQ(pace.due_ns(), 101'250'000);
  EXPECT_EQ(pace.begin(101'000'000, 101'000'000), 0U);
  EXPECT_EQ(pace.due_ns(), 102'250'000);
}

}  // namespace
}  // namespace isotouch::loop
