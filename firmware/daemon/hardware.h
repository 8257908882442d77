/// What the loop feels through: a Falcon over a link, or a recording.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "firmware/daemon/options.h"
#include "firmware/falcon/falcon_port.h"
#include "firmware/falcon/replay_port.h"
#include "firmware/loop/clock.h"
#include "shared/files/refusal.h"

namespace isotouch::daemon {

/// Either `falcon`, with all that it stands on, or `replay`.
struct Hardware {
  std::vector<std::uint8_t> image;  ///< firmware for the device
  std::unique_ptr<loop::Clock> clock;
  std::unique_ptr<falcon::FalconLink> link;
  std::unique_ptr<falcon::FalconSession> session;
  std::unique_ptr<falcon::FalconPort> falcon;
  std::unique_ptr<falcon::ReplayPort> replay;

  loop::Port& port() const { return falcon ? static_cast<loop::Port&>(*falcon) : *replay; }
};

/// Makes what the command line asks for. Nothing is opened yet but a recording and the firmware's file.
///
/// home_anew the device must lose its reference, so that a person homes it; without its firmware's file it keeps it
/// stop      ends a boot of the device; lives as long as `made`
/// returns   none: `made` is complete
Refusal make_hardware(const Options& options, bool home_anew, const std::atomic<bool>& stop, Hardware& made);

/// The serial whose calibration holds: the one asked for, else that of the only device there; empty: not known yet.
std::string serial_of(const Options& options, const Hardware& hardware);

}  // namespace isotouch::daemon
