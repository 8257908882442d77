#include "firmware/falcon/falcon_boot.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <vector>

#include "firmware/falcon/falcon_device.h"
#include "firmware/falcon/falcon_stream.h"
#include "firmware/falcon/ft232.h"

namespace isotouch::falcon {

namespace {

constexpr std::int64_t kMs = 1'000'000;
constexpr std::uint32_t kWriteMs = 1000;
constexpr std::int64_t kSilence = 20 * kMs;         // longer than the slower latency timer
constexpr std::int64_t kDrainAtMost = 500 * kMs;    // a device that never falls silent is left talking
constexpr std::int64_t kHandshakeWait = 100 * kMs;  // question and answer take 8 ms
constexpr std::int64_t kAutobaudWait = 200 * kMs;
constexpr std::int64_t kEchoWait = 200 * kMs;  // 62 bytes take 5 ms
constexpr std::int64_t kProbeWait = 10 * kMs;
constexpr std::int64_t kSettle = 20 * kMs;  // firmware that has just begun
constexpr int kReopenEvery = 3;
constexpr std::size_t kPiece = 62;  // its echo is one full USB packet, which does not wait for the latency timer
constexpr std::size_t kBuffer = 8 * kUsbPacket;

constexpr std::array<std::uint8_t, 3> kQuestion = {0x0A, 'C', 0x0D};
constexpr std::array<std::uint8_t, 4> kAnswer = {0x0A, 'D', ',', 0x0D};
constexpr std::array<std::uint8_t, 1> kAutobaud = {'A'};

/// What came in the time given.
enum class Heard : std::uint8_t { kNothing, kOther, kExpected };

class Boot {
 public:
  Boot(FalconLink& link, loop::Clock& clock, std::span<const std::uint8_t> image, const BootSettings& settings, const BootWatch& watch)
      : link_(link), clock_(clock), image_(image), settings_(settings), watch_(watch) {
    heard_.reserve(2 * kBuffer);
  }

  BootReport run() {
    report_.image = check_image(image_);
    if (!image_.empty() && report_.image.defect != ImageDefect::kNone) return ended(BootOutcome::kBadImage);
    if (!greet()) return ended(BootOutcome::kLinkFailed);
    if ((image_.empty() || !settings_.always_upload) && probe(BootStage::kProbe)) return ended(BootOutcome::kAlreadyRunning);
    if (failed_ || image_.empty()) return ended(BootOutcome::kNoImage);
    for (report_.attempts = 1;; ++report_.attempts) {
      const BootOutcome outcome = attempt();
      const bool over = outcome == BootOutcome::kLoaded || stopped_ || (failed_ && report_.error == LinkError::kGone);
      if (over || report_.attempts >= settings_.attempts) return ended(outcome);
      if ((failed_ || report_.attempts % kReopenEvery == 0) && !reopen()) return ended(outcome);
    }
  }

 private:
  /// One upload from the first purge to the first reply.
  BootOutcome attempt() {
    if (!enter_firmware_mode() || !shake_hands()) return BootOutcome::kNoHandshake;
    if (!lock_rate()) return BootOutcome::kNoAutobaud;
    if (!upload()) return BootOutcome::kEchoDiffers;
    return start() ? BootOutcome::kLoaded : BootOutcome::kSilent;
  }

  bool greet() { return request({ft232::kPurge1, ft232::kPurge2}) && enter_normal_mode(); }

  bool enter_normal_mode() { return request({ft232::kLatency1, ft232::kBaudRun, ft232::kPurge1, ft232::kPurge2}); }

  bool enter_firmware_mode() {
    return request({ft232::kPurge1, ft232::kPurge2, ft232::kLatency16, ft232::kBaud9600, ft232::k8N1, ft232::kNoFlowControl, ft232::kRtsLow,
                    ft232::kDtrLow, ft232::kDtrHigh});
  }

  bool shake_hands() {
    for (int i = 0; i < settings_.handshake_tries && !failed_; ++i) {
      if (!told(BootStage::kHandshake) || !send(kQuestion)) return false;
      if (listen(kAnswer, kHandshakeWait) == Heard::kExpected) return true;
    }
    return false;
  }

  bool lock_rate() {
    return told(BootStage::kAutobaud) && drain() && request({ft232::kDtrLow, ft232::kBaudUpload}) && drain() && send(kAutobaud) &&
           listen(kAutobaud, kAutobaudWait) == Heard::kExpected;
  }

  bool upload() {
    for (std::size_t at = 0; at < image_.size(); at += kPiece) {
      const std::span<const std::uint8_t> piece = image_.subspan(at, std::min(kPiece, image_.size() - at));
      if (!told(BootStage::kUpload, at) || !send(piece)) return false;
      if (listen(piece, settings_.ignore_echo ? kSilence : kEchoWait) == Heard::kExpected) continue;
      ++report_.bad_echoes;
      if (failed_ || !settings_.ignore_echo) return false;
    }
    return true;
  }

  bool start() {
    if (!told(BootStage::kStart, image_.size()) || !enter_normal_mode()) return false;
    clock_.sleep_until_ns(clock_.now_ns() + kSettle);
    return request({ft232::kPurge1, ft232::kPurge2}) && probe(BootStage::kStart);
  }

  /// Asks for a reply to a packet without force, with the red LED of a device that is not homed. A boot loader that took an A of an earlier packet for its
  /// own repeats what it hears: what looks like the packet itself is no reply, and every other packet differs in one LED.
  bool probe(BootStage stage) {
    FalconStream stream;
    for (int i = 0; i < settings_.probe_tries; ++i) {
      const std::uint8_t flags = kFalconHoming | kFalconRed | (i % 2 == 0 ? 0 : kFalconGreen);
      if (!told(stage, stage == BootStage::kStart ? image_.size() : 0) || !send(encode(FalconCommand{{}, flags}))) return false;
      for (const std::int64_t until = clock_.now_ns() + kProbeWait; clock_.now_ns() < until && !failed_;) {
        if (stream.feed(read(until)) > 0 && !is_echo(stream.newest(), {{}, flags})) return true;
      }
    }
    return false;
  }

  bool reopen() {
    failed_ = false;
    link_.close();
    if (const LinkResult<void> opened = link_.open(); !opened) return fail(opened.error());
    return greet();
  }

  /// Collects data until it contains what is expected, or as many other bytes followed by silence, or until the time is over.
  Heard listen(std::span<const std::uint8_t> expected, std::int64_t for_ns) {
    heard_.clear();
    std::int64_t now = clock_.now_ns(), last = now;
    for (const std::int64_t until = now + for_ns; now < until && !failed_; now = clock_.now_ns()) {
      if (heard_.size() >= expected.size() && now - last >= kSilence) break;
      if (!hear(std::min(until, now + kSilence))) continue;
      last = clock_.now_ns();
      if (std::search(heard_.begin(), heard_.end(), expected.begin(), expected.end()) == heard_.end()) continue;
      report_.stray_bytes += heard_.size() - expected.size();
      return Heard::kExpected;
    }
    report_.stray_bytes += heard_.size();
    return heard_.empty() ? Heard::kNothing : Heard::kOther;
  }

  /// Waits until nothing has come for a while, so that a late answer is not taken for the next.
  bool drain() {
    std::int64_t now = clock_.now_ns(), last = now;
    for (const std::int64_t until = now + kDrainAtMost; now < until && now - last < kSilence && !failed_; now = clock_.now_ns()) {
      heard_.clear();
      if (hear(last + kSilence)) last = clock_.now_ns();
      report_.stray_bytes += heard_.size();
    }
    return !failed_;
  }

  /// One transfer more; true when it brought data.
  bool hear(std::int64_t until_ns) {
    const std::span<std::uint8_t> transfer = read(until_ns);
    const std::size_t size = ft232::strip_status(transfer, line_);
    if (heard_.size() + size > heard_.capacity()) heard_.erase(heard_.begin(), heard_.end() - static_cast<std::ptrdiff_t>(kPiece));
    heard_.insert(heard_.end(), transfer.begin(), transfer.begin() + static_cast<std::ptrdiff_t>(size));
    return size > 0;
  }

  std::span<std::uint8_t> read(std::int64_t until_ns) {
    const std::int64_t left_ms = (until_ns - clock_.now_ns() + kMs - 1) / kMs;
    const LinkResult<std::size_t> size = link_.read(buffer_, static_cast<std::uint32_t>(std::max<std::int64_t>(left_ms, 0)));
    if (size) return std::span(buffer_).first(*size);
    if (size.error() != LinkError::kTimedOut) fail(size.error());
    return {};
  }

  bool send(std::span<const std::uint8_t> data) {
    while (!data.empty()) {
      const LinkResult<std::size_t> taken = link_.write(data, kWriteMs);
      if (!taken) return fail(taken.error());
      if (*taken == 0) return fail(LinkError::kTimedOut);
      data = data.subspan(*taken);
    }
    return true;
  }

  bool request(std::initializer_list<UsbSetup> setups) {
    for (const UsbSetup& setup : setups) {
      if (const LinkResult<std::size_t> done = link_.control(setup, {}); !done) return fail(done.error());
    }
    return true;
  }

  bool told(BootStage stage, std::size_t sent = 0) {
    if (!watch_ || watch_({stage, report_.attempts, sent, image_.size()})) return true;
    stopped_ = failed_ = true;
    return false;
  }

  bool fail(LinkError error) {
    report_.error = error;
    failed_ = true;
    return false;
  }

  BootReport ended(BootOutcome outcome) {
    report_.outcome = stopped_ ? BootOutcome::kStopped : failed_ ? BootOutcome::kLinkFailed : outcome;
    return report_;
  }

  FalconLink& link_;
  loop::Clock& clock_;
  std::span<const std::uint8_t> image_;
  const BootSettings& settings_;
  const BootWatch& watch_;
  BootReport report_;
  bool failed_ = false, stopped_ = false;
  ft232::LineCounts line_;
  std::array<std::uint8_t, kBuffer> buffer_{};
  std::vector<std::uint8_t> heard_;
};

}  // namespace

BootReport boot(FalconLink& link, loop::Clock& clock, std::span<const std::uint8_t> image, const BootSettings& settings,
                const BootWatch& watch) {
  return Boot(link, clock, image, settings, watch).run();
}

std::string explain(const BootReport& report) {
  const std::string tries = " after " + std::to_string(report.attempts) + (report.attempts == 1 ? " attempt" : " attempts");
  switch (report.outcome) {
    case BootOutcome::kAlreadyRunning: return "the Falcon's firmware runs already";
    case BootOutcome::kLoaded: return "the Falcon's firmware runs" + tries;
    case BootOutcome::kNoImage:
      return "the Falcon has no firmware, and no firmware file was given: name one in [boot] firmware; it came with the device's software";
    case BootOutcome::kBadImage: return "the firmware file is not usable: " + explain(report.image) + "; take a fresh copy of it";
    case BootOutcome::kNoHandshake:
      return "no wall power? USB works, but the Falcon behind it does not answer" + tries +
             ": plug in the Falcon's own power supply and try again";
    case BootOutcome::kNoAutobaud:
      return "the Falcon answers, but its boot loader does not" + tries + ": take its wall power away for a few seconds and try again";
    case BootOutcome::kEchoDiffers:
      return "the Falcon echoes its firmware wrongly" + tries + ": try another port or cable, or set [boot] ignore_echo";
    case BootOutcome::kSilent:
      return "the firmware was loaded, but does not answer" + tries + ": check that the firmware file is one for this device";
    case BootOutcome::kLinkFailed: return std::string("the Falcon was lost on the way: ") + describe(report.error) + "; plug it in again";
    case BootOutcome::kStopped: return "stopped before the Falcon's firmware ran";
  }
  return "unknown outcome";
}

const char* name(BootStage stage) {
  switch (stage) {
    case BootStage::kProbe: return "looking for firmware";
    case BootStage::kHandshake: return "waking the boot loader";
    case BootStage::kAutobaud: return "agreeing on the rate";
    case BootStage::kUpload: return "loading firmware";
    case BootStage::kStart: return "starting firmware";
  }
  return "unknown stage";
}

}  // namespace isotouch::falcon
