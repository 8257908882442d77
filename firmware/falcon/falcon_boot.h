/// Brings a Falcon from "plugged in" to "answers packets" over any link, and loads its firmware where there is none.
///
///   greet       purge, fastest latency, run-time rate
///   probe       a packet without force: who answers already runs
///   handshake   9600 baud, DTR up: LF C CR is answered by LF D , CR
///   autobaud    DTR down, 142,857 baud: A is answered by A
///   upload      the image in pieces of 62 bytes, each echoed
///   start       run-time rate, and the probe again
///
/// Answers are collected over as many transfers as they take and searched for what is expected, because the switch of rate and lines leaves stray bytes
/// and the chip sends empty packets on its own.
///
/// source    the order of libnifalcon's driver over libusb; TI SPRU095 for what its second half means
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>

#include "firmware/falcon/falcon_link.h"
#include "firmware/falcon/firmware_image.h"
#include "firmware/loop/clock.h"

namespace isotouch::falcon {

struct BootSettings {
  int attempts = 10;           ///< whole uploads; the link is opened anew after every third
  int handshake_tries = 10;    ///< within an attempt
  int probe_tries = 10;        ///< packets until a device counts as silent
  bool ignore_echo = false;    ///< go on though an echo differs: on some machines the upload works all the same
  bool always_upload = false;  ///< also when the firmware runs already
};

enum class BootStage : std::uint8_t { kProbe, kHandshake, kAutobaud, kUpload, kStart };

struct BootProgress {
  BootStage stage = BootStage::kProbe;
  int attempt = 0;       ///< 1 is the first; 0 before any
  std::size_t sent = 0;  ///< bytes of the image
  std::size_t total = 0;
};

enum class BootOutcome : std::uint8_t {
  kAlreadyRunning,  ///< firmware answered, nothing was loaded
  kLoaded,          ///< firmware was loaded and answers
  kNoImage,         ///< no firmware answers and no image was given
  kBadImage,        ///< the image is no image; nothing was sent
  kNoHandshake,     ///< the last attempts end here: USB works, nobody answers behind it
  kNoAutobaud,
  kEchoDiffers,
  kSilent,      ///< loaded, but it does not answer
  kLinkFailed,  ///< `error` tells how
  kStopped,     ///< by the watcher
};

struct BootReport {
  BootOutcome outcome = BootOutcome::kNoImage;
  LinkError error = LinkError::kGone;  ///< of kLinkFailed
  ImageReport image;                   ///< of kBadImage
  int attempts = 0;                    ///< uploads begun
  std::size_t stray_bytes = 0;         ///< heard around what was expected
  std::size_t bad_echoes = 0;          ///< pieces whose echo differed or did not come

  bool running() const { return outcome == BootOutcome::kAlreadyRunning || outcome == BootOutcome::kLoaded; }
};

/// Sees each step before it is done; false stops. May be empty.
using BootWatch = std::function<bool(const BootProgress&)>;

/// link      open; opened anew in between, and left open unless that fails
/// image     firmware, or empty to probe only
/// returns   where it came to; takes up to about 15 s with nobody answering
/// real time no: waits, and allocates at its start
BootReport boot(FalconLink& link, loop::Clock& clock, std::span<const std::uint8_t> image, const BootSettings& settings,
                const BootWatch& watch = {});

/// One sentence, with what to do when it did not work.
std::string explain(const BootReport& report);

const char* name(BootStage stage);

}  // namespace isotouch::falcon
