#include "firmware/loop/latest.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <thread>

namespace isotouch::loop {
namespace {

TEST(Latest, GivesTheNewestValueAndTheSameOneAgain) {
  Latest<int> latest;
  EXPECT_EQ(latest.get(), 0);
  latest.put(1);
  EXPECT_EQ(latest.get(), 1);
  EXPECT_EQ(latest.get(), 1);
  latest.put(2);
  latest.put(3);
  EXPECT_EQ(latest.get(), 3);
  const int& held = latest.get();
  latest.put(4);
  latest.put(5);
  latest.put(6);
  EXPECT_EQ(held, 3) << "what was read stays until the next get";
  EXPECT_EQ(latest.get(), 6);
}

TEST(Latest, IsNeverTornAndNeverGoesBackBetweenTwoThreads) {
  using Value = std::array<std::uint64_t, 16>;
  constexpr std::uint64_t kValues = 200'000;
  Latest<Value> latest;
  std::thread writer([&] {
    Value value{};
    for (std::uint64_t i = 1; i <= kValues; ++i) {
      value.fill(i);
      latest.put(value);
    }
  });
  std::uint64_t before = 0, torn = 0, back = 0;
  while (before < kValues) {
    const Value& value = latest.get();
    for (const std::uint64_t part : value) torn += part != value[0] ? 1U : 0U;
    back += value[0] < before ? 1U : 0U;
    before = value[0];
  }
  writer.join();
  EXPECT_EQ(torn, 0U);
  EXPECT_EQ(back, 0U);
}

}  // namespace
}  // namespace isotouch::loop
