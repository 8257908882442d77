/// Joins the tick to a port without a thread and without time: each wait is one exchange and one period of the virtual clock. The input of
/// the tick is then a pure function of the replies of the port.
#pragma once

#include <atomic>
#include <cstdint>

#include "firmware/loop/device.h"
#include "firmware/loop/virtual_clock.h"
#include "firmware/loop/word_delay.h"

namespace isotouch::loop {

class DirectDevice final : public Device {
 public:
  /// port, clock, stop   live longer; `stop` ends a search for a device that is not there
  /// guard               sees every command and every reply; nullptr: nobody does. Lives longer
  DirectDevice(Port& port, VirtualClock& clock, std::int64_t period_ns, const std::atomic<bool>& stop, CommandGuard* guard = nullptr)
      : port_(port), clock_(clock), period_ns_(period_ns), stop_(stop), guard_(guard) {}

  /// One exchange with the command that was left. No tick passes while there is no device.
  Wake wait(std::int64_t until_ns) override;
  Sample newest() override { return sample_; }
  void leave(const Command& command) override { command_ = command; }

 private:
  Port& port_;
  VirtualClock& clock_;
  std::int64_t period_ns_;
  const std::atomic<bool>& stop_;
  CommandGuard* guard_;
  Sample sample_;
  Command command_;
  WordDelay word_delay_;
};

}  // namespace isotouch::loop
