/// A Falcon whose firmware runs: a command out, the newest reply in. It has no opinion on force, lights or homing.
#pragma once

#include <cstdint>

#include "firmware/falcon/falcon_link.h"
#include "firmware/falcon/falcon_stream.h"
#include "firmware/loop/clock.h"
#include "shared/falcon_packet.h"

namespace isotouch::falcon {

struct DeviceSettings {
  std::int64_t reply_ns = 5'000'000;  ///< how long a reply is waited for
  int lost_after = 20;                ///< exchanges in a row without a reply until the device counts as lost
};

struct DeviceCounts {
  std::uint64_t exchanges = 0;
  std::uint64_t timeouts = 0;  ///< exchanges without a reply
  std::uint64_t late = 0;      ///< replies found when none was awaited; none of them is taken for the answer to a newer packet
  std::uint64_t echoes = 0;    ///< packets that came back as they were sent: a boot loader, not firmware; they count as timeouts too
  std::uint64_t clamped = 0;   ///< exchanges with a command outside ±4095
  StreamCounts stream;
};

/// True when a reply is no more than the command itself: the boot loader of the device repeats what it hears.
bool is_echo(const FalconReply& reply, const FalconCommand& command);

/// What one exchange brought.
struct Exchange {
  FalconReply reply;    ///< the newest valid one; an old one when not fresh
  FalconPacket packet;  ///< the same as it came
  bool fresh = false;   ///< it came in this exchange
  bool rested = false;  ///< zeros were sent in place of the commands, because the exchange before brought no reply
  bool lost = false;    ///< unplugged, or silent for too long: bring it up again
};

class FalconDevice {
 public:
  /// link, clock   live longer
  FalconDevice(FalconLink& link, loop::Clock& clock, const DeviceSettings& settings = {});

  /// A device that has just come up: not lost; the counts go on.
  void begin();

  /// Sends the command and waits for the reply.
  ///
  /// command   commands outside ±4095 are cut there, as the vendor's own driver does
  /// fails     never; see `Exchange`
  /// real time waits up to `reply_ns`; allocates nothing itself, the link may
  Exchange exchange(const FalconCommand& command);

  /// Three packets without force, LEDs off. For every way out; harmless on a device that is lost.
  void rest();

  DeviceCounts counts() const;

 private:
  bool send(const FalconCommand& command);
  std::size_t hear(std::uint32_t timeout_ms);
  void drain();
  bool await_reply();

  FalconLink& link_;
  loop::Clock& clock_;
  DeviceSettings settings_;
  FalconStream stream_;
  DeviceCounts counts_;
  FalconReply last_;
  FalconPacket last_packet_{};
  int silent_ = 0;   ///< exchanges in a row
  int suspect_ = 0;  ///< exchanges for which a late reply may still come
  bool gone_ = false, empty_ = false;
};

}  // namespace isotouch::falcon
