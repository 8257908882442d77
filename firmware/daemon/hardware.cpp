#include "firmware/daemon/hardware.h"

#include <cstdio>
#include <utility>

#include "firmware/falcon/falcon_list.h"
#include "firmware/falcon/falcon_usb.h"
#include "firmware/falcon/sim_link.h"
#include "firmware/loop/linux_clock.h"
#include "firmware/loop/lockstep_clock.h"
#include "firmware/loop/virtual_clock.h"
#include "firmware/settings/apply.h"

namespace isotouch::daemon {

namespace {

Refusal make_replay(const Options& options, Hardware& made) {
  files::TraceFile trace;
  if (Refusal refusal = files::read_trace(options.name, trace)) return refusal;
  if (!trace.damage().empty()) return trace.damage();
  if (!trace.cut_off().empty()) std::fprintf(stderr, "isotouchd: %s\n", trace.cut_off().c_str());
  if (trace.kind() != InputKind::kPacket) {
    return options.name + ": it holds positions of a hand, not the packets of a device; make some with 'isotouch trace to-packets'";
  }
  if (options.lockstep) made.clock = std::make_unique<loop::VirtualClock>();
  made.replay = std::make_unique<falcon::ReplayPort>(std::move(trace), *made.clock);
  return {};
}

}  // namespace

Refusal make_hardware(const Options& options, bool home_anew, const std::atomic<bool>& stop, Hardware& made) {
  const settings::Settings& settings = options.settings;
  if (options.lockstep) {
    made.clock = std::make_unique<loop::LockstepClock>();
  } else {
    made.clock = std::make_unique<loop::LinuxClock>();
  }
  if (options.device == Options::Device::kRecorded) return make_replay(options, made);
  const bool simulated = options.device == Options::Device::kSimulated;
  if (!settings.firmware.empty()) {
    if (Refusal refusal = falcon::read_image(settings.firmware, made.image)) return refusal;
  } else if (simulated) {
    const auto image = falcon::synthetic_image();
    made.image.assign(image.begin(), image.end());
  }
  if (simulated) {
    made.link = std::make_unique<falcon::SimLink>(options.name);
  } else {
    made.link = std::make_unique<falcon::FalconUsb>(*made.clock, options.name);
  }
  falcon::SessionSettings session = settings::session_settings(settings);
  session.boot.always_upload |= home_anew;  // a device whose firmware begins anew has no reference
  made.session = std::make_unique<falcon::FalconSession>(*made.link, *made.clock, made.image, session,
                                                         [&stop](const falcon::BootProgress&) { return !stop.load(); });
  made.falcon = std::make_unique<falcon::FalconPort>(*made.session, *made.link);
  return {};
}

std::string serial_of(const Options& options, const Hardware& hardware) {
  switch (options.device) {
    case Options::Device::kRecorded: return {};
    case Options::Device::kSimulated: {
      if (options.settings.state.empty() && options.settings.calibrations.empty()) return {};
      std::string serial = hardware.link->open() ? hardware.link->identity().serial : std::string();
      hardware.link->close();
      return serial;
    }
    case Options::Device::kUsb: break;
  }
  if (!options.name.empty()) return options.name;
  const falcon::UsbListing listing = falcon::list_falcons();
  return listing.falcons.size() == 1 ? listing.falcons[0].serial : std::string();
}

}  // namespace isotouch::daemon
