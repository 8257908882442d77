/// The ticks whose commands came latest, so that a client can ask for the cause. Used by the control server's thread alone.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "firmware/loop/tick_record.h"
#include "shared/protocol_messages.h"

namespace isotouch::control {

class WorstTicks {
 public:
  static constexpr std::size_t kMax = 10;

  /// Forgets all.
  void begin_anew() { seen_ = count_ = 0; }

  /// One tick. Of two that are equally late the earlier one counts.
  void take(const loop::TickRecord& tick);

  std::uint64_t seen() const { return seen_; }
  /// The latest commands first.
  std::span<const protocol::WorstTick> ticks() const { return std::span(ticks_).first(count_); }

 private:
  std::uint64_t seen_ = 0;
  std::size_t count_ = 0;
  std::array<protocol::WorstTick, kMax> ticks_;
};

}  // namespace isotouch::control
