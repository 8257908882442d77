/// From a reply being there to the first command made of it being handed over. What passes after that, until the device answers again, is the device's.
///
/// real-time   yes
#pragma once

#include <cstdint>
#include <utility>

#include "firmware/loop/device.h"

namespace isotouch::loop {

class WordDelay {
 public:
  /// The newest sample's command was handed to a device that gave this answer; of several with the same sample the first counts.
  ///
  /// sent_ns   when
  void handed_over(const Command& command, std::int64_t sent_ns, Answer answer) {
    if (command.sample == sample_) return;
    sample_ = command.sample;
    delay_ns_ = answer == Answer::kAbsent || command.arrival_ns < 0 ? -1 : sent_ns - command.arrival_ns;
  }

  /// returns   ns, of the command that the newest reply answers; -1 = not known. A second call returns -1
  std::int64_t take() { return std::exchange(delay_ns_, -1); }

 private:
  std::uint64_t sample_ = 0;
  std::int64_t delay_ns_ = -1;
};

}  // namespace isotouch::loop
