/// The supervisor's state as it stands in memory: a code that is far from every other, stored twice, once inverted. A damaged one reads as fault.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "firmware/core/supervisor_table.h"

namespace isotouch::core {

namespace guarded_state_detail {

/// Sums of rows of a Walsh matrix, a row for each bit of the state's number: any two differ in eight bits of sixteen.
inline constexpr std::uint16_t kOffset = 0x00FF;
constexpr std::uint16_t code_of(std::size_t number) {
  return static_cast<std::uint16_t>(kOffset ^ ((number & 1) != 0 ? 0x5555 : 0) ^ ((number & 2) != 0 ? 0x3333 : 0) ^
                                    ((number & 4) != 0 ? 0x0F0F : 0));
}
inline constexpr std::array<std::uint16_t, kStates> kCodes = {code_of(0), code_of(1), code_of(2), code_of(3),
                                                              code_of(4), code_of(5), code_of(6)};

/// The number whose code this is, if it is one: each row has a bit that no other one has.
constexpr std::size_t number_of_code(std::uint16_t code) {
  const auto rows = static_cast<unsigned>(code ^ kOffset);
  return (rows >> 6 & 1U) | (rows >> 5 & 1U) << 1 | (rows >> 11 & 1U) << 2;
}

constexpr int least_distance() {
  int least = 16;
  for (std::size_t i = 0; i < kStates; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const int distance = std::popcount(static_cast<std::uint16_t>(kCodes[i] ^ kCodes[j]));
      least = distance < least ? distance : least;
    }
  }
  return least;
}
static_assert(least_distance() == 8);  // stored twice: sixteen flipped bits lead from one state to another, and no fewer

}  // namespace guarded_state_detail

/// tick      yes
class GuardedState {
 public:
  /// A value that is no state is stored as kFault.
  constexpr GuardedState(SupervisorState state = SupervisorState::kBoot)  // NOLINT(google-explicit-constructor): it stands for the state
      : code_(guarded_state_detail::kCodes[number_of(state)]), inverse_(static_cast<std::uint16_t>(~code_)) {}

  /// The state; kFault where what is stored is damaged.
  constexpr operator SupervisorState() const {  // NOLINT(google-explicit-constructor): it stands for the state
    return is_whole() ? static_cast<SupervisorState>(guarded_state_detail::number_of_code(code_)) : SupervisorState::kFault;
  }

  /// Is this state stored, and not damaged?
  constexpr bool is(SupervisorState state) const {
    return code_ == guarded_state_detail::kCodes[number_of(state)] && (code_ ^ inverse_) == 0xFFFF;
  }

  /// Is what is stored a state?
  constexpr bool is_whole() const {
    const std::size_t number = guarded_state_detail::number_of_code(code_);
    return number < kStates && code_ == guarded_state_detail::kCodes[number] && (code_ ^ inverse_) == 0xFFFF;
  }

 private:
  static constexpr std::size_t number_of(SupervisorState state) {
    const auto number = static_cast<std::size_t>(state);
    return number < kStates ? number : static_cast<std::size_t>(SupervisorState::kFault);
  }

  std::uint16_t code_, inverse_;
};

}  // namespace isotouch::core
