/// Where the arms of a device stand while a hand holds it still: the mean of the counts over some ticks, none of which had a force. Pure arithmetic on
/// ticks. Belongs to the control server's thread.
#pragma once

#include <array>
#include <cstdint>

#include "firmware/loop/tick_record.h"
#include "shared/files/refusal.h"

namespace isotouch::control {

class PostureMeter {
 public:
  /// Counts that a hand at rest may move within: about a quarter of a millimetre.
  static constexpr int kStill = 8;

  /// Begins anew.
  ///
  /// ticks     to be measured, at least 1
  /// after     number of the last tick that does not count
  void begin(std::uint32_t ticks, std::uint64_t after);

  /// One tick; without effect when the measurement has ended.
  void take(const loop::TickRecord& tick);

  bool has_ended() const { return left_ == 0; }
  /// When it has ended: why there is no result.
  const Refusal& refusal() const { return refusal_; }
  /// Mean counts of the legs, 8 fraction bits.
  std::array<std::int32_t, 3> counts() const;

 private:
  void end(const char* refusal);

  std::uint32_t left_ = 0;
  std::uint64_t after_ = 0;
  std::uint32_t fresh_ = 0;
  std::array<std::int64_t, 3> sum_{};
  std::array<std::int16_t, 3> least_{}, most_{};
  Refusal refusal_;
};

}  // namespace isotouch::control
