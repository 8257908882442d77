/// What the watchdog thread, the guard and the tick exchange: the state of the safety lines, the guard's verdict, and whether the supervisor allows forces.
#pragma once

#include <atomic>
#include <cstdint>

#include "shared/tick_io.h"

namespace isotouch::loop {

/// Without a watchdog thread the lines always count as good.
class LineState {
  static_assert(std::atomic<std::uint16_t>::is_always_lock_free);

 public:
  /// The watchdog's side. bits: LineBits
  void put(std::uint8_t bits) {
    bits_.store(bits, std::memory_order_release);
    words_.store(words_.load(std::memory_order_relaxed) + 1, std::memory_order_release);
  }
  /// The guard's side.
  void put(GuardVerdict verdict) { verdict_.store(line_bits(verdict), std::memory_order_release); }
  /// The memory check's side. damaged: what the tick relies on has changed
  void put_damaged(bool damaged) { memory_.store(damaged ? std::uint8_t{kLineMemory} : std::uint8_t{0}, std::memory_order_release); }
  /// What watchdog and memory check put last, without the guard's verdict. Any thread.
  std::uint8_t lines() const {
    return static_cast<std::uint8_t>(bits_.load(std::memory_order_acquire) | memory_.load(std::memory_order_acquire));
  }
  GuardVerdict verdict() const { return guard_verdict(verdict_.load(std::memory_order_acquire)); }
  SupervisorState told() const { return static_cast<SupervisorState>(state_.load(std::memory_order_acquire)); }

  /// The state of the lines. If the watchdog thread has been silent for longer than the patience, the stop counts as pressed, because a real one could
  /// not get through.
  ///
  /// tick      yes
  std::uint8_t get() {
    const std::uint32_t words = words_.load(std::memory_order_acquire);
    silent_ticks_ = words == heard_ ? silent_ticks_ + 1 : 0;
    heard_ = words;
    const unsigned bits = unsigned{lines()} | verdict_.load(std::memory_order_acquire);
    return static_cast<std::uint8_t>(patience_ != 0 && silent_ticks_ > patience_ ? bits | kLineStop : bits);
  }
  /// ticks     0, as at the beginning: for ever. Before the first tick
  void set_patience(std::uint32_t ticks) { patience_ = ticks; }
  /// tick      yes
  void tell(std::uint16_t state) { state_.store(state, std::memory_order_release); }

 private:
  std::atomic<std::uint8_t> bits_{0}, verdict_{0}, memory_{0};
  std::atomic<std::uint32_t> words_{0};
  std::atomic<std::uint16_t> state_{0};
  std::uint32_t patience_ = 0, heard_ = 0, silent_ticks_ = 0;  ///< the tick's own
};

}  // namespace isotouch::loop
