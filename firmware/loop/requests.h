/// What other threads ask of the tick, kept until the next tick begins, and who asked. Any number of askers. Everything is kept twice, so that one
/// flipped bit asks for nothing but a stop.
#pragma once

#include <array>
#include <atomic>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "shared/tick_io.h"

namespace isotouch::loop {

struct Asked {
  std::uint8_t bits = 0;           ///< RequestBits
  std::uint32_t author = kNobody;  ///< of several, who asked last

  bool operator==(const Asked&) const = default;
};

struct AskedChange {
  SettingChange change;
  std::uint32_t author = kNobody;

  bool operator==(const AskedChange&) const = default;
};

class Requests {
 public:
  /// bits      RequestBits; added to what is asked already
  void ask(std::uint8_t bits, std::uint32_t author = kNobody) {
    if ((bits & kRequestResume) != 0) stopped_.store(false, std::memory_order_relaxed);
    if ((bits & kRequestStop) != 0) {
      stopped_.store(true, std::memory_order_relaxed);
      stops_.fetch_add(1, std::memory_order_relaxed);
    }
    std::uint64_t before = asked_.load(std::memory_order_relaxed);
    while (!asked_.compare_exchange_weak(
        before, pair(low_of(before) | static_cast<std::uint32_t>(bits << 8 | bits), author == kNobody ? author_in(before) : author),
        std::memory_order_acq_rel, std::memory_order_relaxed)) {
    }
  }

  /// How often a stop was ever asked for, and whether no resume was since. Any thread.
  std::uint32_t stops() const { return stops_.load(std::memory_order_relaxed); }
  bool is_stopped() const { return stopped_.load(std::memory_order_relaxed); }

  /// All that was asked since the last tick, and nothing is asked any more.
  ///
  /// tick      yes
  Asked take() {
    const std::uint64_t asked = asked_.load(std::memory_order_relaxed) == 0 ? 0 : asked_.exchange(0, std::memory_order_acq_rel);
    const std::uint32_t one = low_of(asked) & 0xFF, other = low_of(asked) >> 8 & 0xFF;
    const auto bits = static_cast<std::uint8_t>((one & other) | ((one | other) & kRequestStop));
    return {bits, bits == 0 ? kNobody : author_in(asked)};
  }

  /// change    of two for the same setting that no tick took in between, the later holds; one that is not valid is none: no reader takes its record
  void set(const SettingChange& change, std::uint32_t author = kNobody) {
    if (change.setting == TickSetting::kNone || !is_valid(change)) return;
    const auto number = static_cast<std::size_t>(change.setting) - 1;
    std::uint64_t now = pair(static_cast<std::uint32_t>(change.raw), author);
    values_[number].store(now, std::memory_order_release);
    do {  // of two that set the same, both end with the check of the value that stays
      now = values_[number].load(std::memory_order_acquire);
      checks_[number].store(check_of(now), std::memory_order_release);
    } while (values_[number].load(std::memory_order_acquire) != now);
    changed_.fetch_or(1U << number, std::memory_order_release);
    waiting_.fetch_or(1U << number, std::memory_order_release);
  }

  /// One change at most; the others follow in the next ticks.
  ///
  /// tick      yes
  AskedChange take_change() {
    const std::uint32_t waiting = waiting_.load(std::memory_order_acquire) & kEverySetting;  // another bit is no setting
    if (waiting == 0) return {};
    const auto number = static_cast<std::size_t>(std::countr_zero(waiting));
    waiting_.fetch_and(~(1U << number), std::memory_order_acq_rel);
    const std::uint64_t value = values_[number].load(std::memory_order_relaxed);
    return is_whole(number, value) ? AskedChange{{static_cast<TickSetting>(number + 1), raw_of(value)}, author_in(value)} : AskedChange{};
  }

  /// What was asked for last, taken over or not; `otherwise` where nothing ever was. Any thread.
  std::int32_t newest(TickSetting setting, std::int32_t otherwise) const {
    const auto number = static_cast<std::size_t>(setting) - 1;
    const bool changed = (changed_.load(std::memory_order_acquire) >> number & 1U) != 0;
    const std::uint64_t value = values_[number].load(std::memory_order_relaxed);
    return changed && is_whole(number, value) ? raw_of(value) : otherwise;
  }

  /// A tick forgets everything before it: all that was ever set is to be set again.
  ///
  /// tick      yes
  void repeat_changes() { waiting_.fetch_or(changed_.load(std::memory_order_relaxed), std::memory_order_acq_rel); }

 private:
  static constexpr std::uint32_t kEverySetting = (1U << kLiveSettings) - 1;

  // What is asked, or a value, and its author are one word, so that nobody sees the one with another's.
  static constexpr std::uint64_t pair(std::uint32_t low, std::uint32_t author) { return std::uint64_t{author} << 32 | low; }
  static constexpr std::uint32_t low_of(std::uint64_t word) { return static_cast<std::uint32_t>(word); }
  static constexpr std::uint32_t author_in(std::uint64_t word) { return static_cast<std::uint32_t>(word >> 32); }
  static constexpr std::int32_t raw_of(std::uint64_t word) { return static_cast<std::int32_t>(low_of(word)); }

  static constexpr std::uint32_t check_of(std::uint64_t word) { return ~(low_of(word) ^ author_in(word)); }
  bool is_whole(std::size_t number, std::uint64_t value) const {  // not one that nobody has set
    return checks_[number].load(std::memory_order_relaxed) == check_of(value);
  }

  std::atomic<std::uint64_t> asked_{0};  ///< RequestBits in the lowest byte, and again in the next
  std::atomic<std::uint32_t> stops_{0};
  std::atomic<bool> stopped_{false};
  std::array<std::atomic<std::uint64_t>, kLiveSettings> values_{};
  std::array<std::atomic<std::uint32_t>, kLiveSettings> checks_{};
  std::atomic<std::uint32_t> changed_{0}, waiting_{0};
};

}  // namespace isotouch::loop
