#include "firmware/control/worst_ticks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace isotouch::control {
namespace {

loop::TickRecord tick(std::uint64_t number, std::uint32_t wake_ns, std::uint32_t tick_ns) {
  loop::TickRecord record;
  record.number = number;
  record.start_ns = static_cast<std::int64_t>(number) * 1'000'000;
  record.wake_ns = wake_ns;
  record.tick_ns = tick_ns;
  return record;
}

std::vector<std::uint64_t> numbers(const WorstTicks& worst) {
  std::vector<std::uint64_t> numbers;
  for (const protocol::WorstTick& late : worst.ticks()) numbers.push_back(late.number);
  return numbers;
}

TEST(WorstTicks, AreTheTenWhoseWordsCameLatestInOrder) {
  std::mt19937 random(3);
  std::vector<loop::TickRecord> all;
  for (std::uint64_t number = 1; number <= 5000; ++number) {
    all.push_back(tick(number, static_cast<std::uint32_t>(random() % 100'000), static_cast<std::uint32_t>(random() % 100'000)));
  }
  WorstTicks worst;
  for (const loop::TickRecord& one : all) worst.take(one);
  std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.wake_ns + a.tick_ns > b.wake_ns + b.tick_ns; });
  std::vector<std::uint64_t> expected;
  for (std::size_t i = 0; i < WorstTicks::kMax; ++i) expected.push_back(all[i].number);
  EXPECT_EQ(numbers(worst), expected);
  EXPECT_EQ(worst.seen(), 5000U);
  EXPECT_EQ(worst.ticks()[0].start_ns, all[0].start_ns);
  EXPECT_EQ(worst.ticks()[0].wake_ns, all[0].wake_ns);
  EXPECT_EQ(worst.ticks()[0].tick_ns, all[0].tick_ns);
}

TEST(WorstTicks, AFewAreAllAndOfEqualOnesTheEarlierCount) {
  WorstTicks worst;
  for (std::uint64_t number = 1; number <= 12; ++number) worst.take(tick(number, 7, 3));
  EXPECT_THAT(numbers(worst), testing::ElementsAre(1, 2, 3, 4, 5, 6, 7, 8, 9, 10));
  worst.begin_anew();
  EXPECT_TRUE(worst.ticks().empty());
  EXPECT_EQ(worst.seen(), 0U);
  worst.take(tick(20, 1, 0));
  worst.take(tick(21, 2, 0));
  EXPECT_THAT(numbers(worst), testing::ElementsAre(21, 20));
}

TEST(WorstTicks, TwoLongOnesDoNotOverflow) {
  WorstTicks worst;
  worst.take(tick(1, UINT32_MAX, UINT32_MAX));
  worst.take(tick(2, UINT32_MAX, 0));
  worst.take(tick(3, 5, 5));
  EXPECT_THAT(numbers(worst), testing::ElementsAre(1, 2, 3));
}

}  // namespace
}  // namespace isotouch::control
