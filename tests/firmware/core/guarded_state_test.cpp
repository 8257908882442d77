#include "firmware/core/guarded_state.h"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>

namespace isotouch::core {
namespace {

GuardedState damaged(GuardedState state, std::uint32_t bits) {
  return std::bit_cast<GuardedState>(std::bit_cast<std::uint32_t>(state) ^ bits);
}

TEST(GuardedState, HoldsEveryState) {
  for (std::size_t i = 0; i < kStates; ++i) {
    const auto state = static_cast<SupervisorState>(i);
    EXPECT_EQ(GuardedState(state), state);
    EXPECT_TRUE(GuardedState(state).is_whole());
    for (std::size_t j = 0; j < kStates; ++j) EXPECT_EQ(GuardedState(state).is(static_cast<SupervisorState>(j)), i == j);
  }
  EXPECT_EQ(GuardedState(), SupervisorState::kBoot);
  EXPECT_EQ(GuardedState(static_cast<SupervisorState>(kStates)), SupervisorState::kFault);
}

TEST(GuardedState, FourFlippedBitsAreNoticedWhereverTheyAre) {
  int tried = 0, missed = 0;
  for (std::size_t i = 0; i < kStates; ++i) {
    const GuardedState state = static_cast<SupervisorState>(i);
    for (std::uint32_t a = 0; a < 32; ++a) {
      for (std::uint32_t b = 0; b <= a; ++b) {
        for (std::uint32_t c = 0; c <= b; ++c) {
          for (std::uint32_t d = 0; d <= c; ++d) {
            const std::uint32_t bits = 1U << a | 1U << b | 1U << c | 1U << d;  // the same one twice: fewer
            const GuardedState after = damaged(state, bits);
            missed += after.is_whole() || after != SupervisorState::kFault || after.is(state) ? 1 : 0;
            ++tried;
          }
        }
      }
    }
  }
  EXPECT_EQ(missed, 0);
  EXPECT_EQ(tried, 7 * 52'360);
}

TEST(GuardedState, MemoryOfOneValueIsNoState) {
  for (const std::uint32_t fill : {0U, 0xFFFFFFFFU, 0xAAAAAAAAU, 0x55555555U}) {
    EXPECT_FALSE(std::bit_cast<GuardedState>(fill).is_whole()) << fill;
  }
}

}  // namespace
}  // namespace isotouch::core
