/// Connects the tick to a port by a thread: the code that talks to hardware may allocate and block, the tick may not. Values pass through `Latest`; two
/// doorbells signal that there is a new one.
///
/// After a reply the thread waits for the motor commands of the tick and sends them at once, so that device and tick have the same rate. A tick
/// that does not come in time does not stop the packets: the device is asked again with the newest commands, and without force when no tick has come for
/// longer. Where both share a processor the tick goes first: it is short, starts the moment the reply is handed over, and its commands are ready when
/// this thread needs them. The search for a device may take a tenth of a second.
#pragma once

#include <atomic>
#include <cstdint>

#include "firmware/loop/clock.h"
#include "firmware/loop/device.h"
#include "firmware/loop/doorbell.h"
#include "firmware/loop/latest.h"

namespace isotouch::loop {

class ExchangeThread final : public Device {
 public:
  /// port, clock   live longer; the clock is CLOCK_MONOTONIC
  /// refresh_ns    longest time between two commands while the tick is silent
  /// silent_ns     without a tick for so long, packets carry no force: the first one at this moment, or once the port has returned
  /// guard         sees every command and every reply; nullptr: nobody does. Lives longer
  ExchangeThread(Port& port, Clock& clock, std::int64_t refresh_ns, std::int64_t silent_ns, CommandGuard* guard = nullptr)
      : port_(port), clock_(clock), refresh_ns_(refresh_ns), silent_ns_(silent_ns), guard_(guard) {}

  // The tick's side.
  Wake wait(std::int64_t until_ns) override;
  Sample newest() override;
  void leave(const Command& command) override;

  /// The thread's whole life: exchanges until told to stop or until the port ends, and leaves the device without force.
  void serve(const std::atomic<bool>& stop);

 private:
  void await_words(const Sample& sample, std::int64_t silent_from);

  Port& port_;
  Clock& clock_;
  std::int64_t refresh_ns_, silent_ns_;
  CommandGuard* guard_;
  Latest<Sample> samples_;
  Latest<Command> commands_;
  Doorbell replies_, words_;
  std::atomic<bool> ended_{false};
  std::uint64_t taken_ = 0;  ///< number of the newest sample that the tick has had
};

}  // namespace isotouch::loop
