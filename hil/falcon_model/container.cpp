#include "hil/falcon_model/container.h"

namespace isotouch::falcon_model {

namespace {

constexpr std::uint16_t kKey = 0x08AA;
constexpr std::uint32_t kReservedWords = 8;
constexpr std::uint32_t kHeaderWords = 1 + kReservedWords + 2;
constexpr std::uint32_t kDestinationWords = 2;

}  // namespace

Container::State Container::push(std::uint8_t byte) {
  if (state_ != State::kReading) return state_;
  if (half_) push_word(static_cast<std::uint16_t>(low_ | byte << 8));
  low_ = byte;
  half_ = !half_;
  return state_;
}

void Container::push_word(std::uint16_t word) {
  if (words_ < kHeaderWords) {
    const bool right = words_ == 0 ? word == kKey : words_ > kReservedWords || word == 0;
    if (!right) state_ = State::kMalformed;
    if (words_ > kReservedWords) entry_point_ = entry_point_ << 16 | word;
    ++words_;
  } else if (!in_block_) {
    if (word == 0) state_ = State::kComplete;
    in_block_ = true;
    block_words_ = kDestinationWords + word;
  } else if (--block_words_ == 0) {
    in_block_ = false;
    ++blocks_;
  }
}

}  // namespace isotouch::falcon_model
