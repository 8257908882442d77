#include "firmware/loop/ring.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <thread>

namespace isotouch::loop {
namespace {

TEST(Ring, KeepsItsOrderAndRefusesWhatDoesNotFit) {
  Ring<int> ring(5);
  EXPECT_EQ(ring.size(), 8U);
  int out = -1;
  EXPECT_FALSE(ring.pop(out));
  for (int round = 0; round < 3; ++round) {
    for (int i = 0; i < 8; ++i) EXPECT_TRUE(ring.push(i));
    EXPECT_FALSE(ring.push(8));
    for (int i = 0; i < 8; ++i) {
      ASSERT_TRUE(ring.pop(out));
      EXPECT_EQ(out, i);
    }
    EXPECT_FALSE(ring.pop(out));
  }
  EXPECT_EQ(ring.lost(), 3U);
}

TEST(Ring, BetweenTwoThreadsWhatIsNotLostComesInOrder) {
  constexpr std::uint64_t kValues = 300'000;
  Ring<std::uint64_t> ring(64);
  std::uint64_t refused = 0;
  std::thread writer([&] {
    for (std::uint64_t i = 1; i <= kValues; ++i) refused += ring.push(i) ? 0U : 1U;
    while (!ring.push(kValues + 1)) ++refused;
  });
  std::uint64_t before = 0, got = 0, wrong = 0;
  while (before <= kValues) {
    std::uint64_t value = 0;
    if (!ring.pop(value)) continue;
    wrong += value <= before ? 1U : 0U;
    before = value;
    ++got;
  }
  writer.join();
  EXPECT_EQ(wrong, 0U);
  EXPECT_EQ(ring.lost(), refused);
  EXPECT_LE(got, kValues + 1);
  EXPECT_GE(got, 64U);
}

}  // namespace
}  // namespace isotouch::loop
