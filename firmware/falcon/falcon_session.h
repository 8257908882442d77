/// Find, boot, run, and again after an unplug: the one thing that the USB thread calls.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "firmware/falcon/falcon_boot.h"
#include "firmware/falcon/falcon_device.h"
#include "firmware/falcon/falcon_link.h"
#include "firmware/loop/clock.h"

namespace isotouch::falcon {

enum class SessionState : std::uint8_t { kSearching, kBooting, kRunning };

struct SessionSettings {
  BootSettings boot = {.attempts = 3};  ///< then the device is opened anew and booted again, for as long as it takes
  DeviceSettings device;
  std::int64_t search_ns = 250'000'000;   ///< between two looks for the device
  std::int64_t retry_ns = 1'000'000'000;  ///< after a boot that failed
  std::int64_t nap_ns = 10'000'000;       ///< longest wait of one step while searching
};

class FalconSession {
 public:
  /// link, clock   live longer
  /// image         firmware, lives longer; empty: only devices whose firmware runs are taken
  /// watch         sees the boot's steps and may stop it
  FalconSession(FalconLink& link, loop::Clock& clock, std::span<const std::uint8_t> image, const SessionSettings& settings = {},
                BootWatch watch = {});
  /// As `stop`.
  ~FalconSession();
  FalconSession(const FalconSession&) = delete;
  FalconSession& operator=(const FalconSession&) = delete;

  /// Does the next piece of work: looks for the device, or boots it, or makes one exchange with this command.
  ///
  /// returns   what the exchange brought; without one, not fresh and lost
  /// real time in kRunning as `FalconDevice::exchange`; searching waits up to `nap_ns`, booting seconds
  Exchange step(const FalconCommand& command);

  /// Forces to zero, LEDs off, device given back.
  void stop();

  SessionState state() const { return state_; }
  /// Why the last search found nothing, or how the device was lost.
  std::optional<LinkError> trouble() const { return trouble_; }
  /// How the last boot ended.
  const BootReport& last_boot() const { return last_boot_; }
  DeviceCounts counts() const { return device_.counts(); }
  /// How often a running device was lost.
  std::uint64_t losses() const { return losses_; }

 private:
  void search();
  void bring_up();
  void search_again(std::int64_t after_ns);

  FalconLink& link_;
  loop::Clock& clock_;
  std::span<const std::uint8_t> image_;
  SessionSettings settings_;
  BootWatch watch_;
  FalconDevice device_;
  SessionState state_ = SessionState::kSearching;
  std::optional<LinkError> trouble_;
  BootReport last_boot_;
  std::int64_t look_at_ns_;
  std::uint64_t losses_ = 0;
};

}  // namespace isotouch::falcon
