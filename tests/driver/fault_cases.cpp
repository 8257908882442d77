#include "tests/driver/fault_cases.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <utility>

#include "firmware/daemon/status_lines.h"
#include "shared/falcon_packet.h"
#include "tests/driver/broken_cores.h"
#include "tests/driver/fault_bench.h"
#include "tests/driver/outside_faults.h"

namespace isotouch::test {

namespace {

using loop::TickRecord;
using S = SupervisorState;

constexpr int kStrike = 50;     // ticks after the hand has pressed for a while
constexpr int kAskFrom = 1500;  // from here on a person asks to resume, ten times a second
constexpr int kMax = 20'000;    // ticks until it must be well again

/// Does this tick's input show the fault? Judged from the input alone, not from what the core made of it.
using Shows = std::function<bool(const TickRecord& now, const TickRecord& before)>;

bool stale(const TickRecord& now, const TickRecord& /*before*/) { return !now.in.fresh && now.in.age >= 3; }
bool line(const TickRecord& now, const TickRecord& /*before*/) { return (now.in.lines & (kLineStop | kLineEnableWrong)) != 0; }
bool told(const TickRecord& now, const TickRecord& /*before*/) { return (now.in.requests & kRequestStop) != 0; }
bool late(const TickRecord& now, const TickRecord& before) { return now.in.late + before.in.late >= 3; }
bool another_field(const TickRecord& now, const TickRecord& before) { return now.in.field_generation != before.in.field_generation; }
bool too_deep(const TickRecord& now, const TickRecord& /*before*/) {  // 4 mm below a ball of 25 mm
  const double x = now.out.hip.x.raw() / 1048576.0, y = now.out.hip.y.raw() / 1048576.0, z = now.out.hip.z.raw() / 1048576.0;
  return x * x + y * y + z * z < 21.0 * 21.0;
}
bool jump(const TickRecord& now, const TickRecord& before) {
  const auto a = decode_reply(now.in.packet), b = decode_reply(before.in.packet);
  bool far = false;
  for (std::size_t i = 0; a && b && i < 3; ++i) far |= std::abs(a->counts[i] - b->counts[i]) > 400;
  return far;
}
bool leap(const TickRecord& now, const TickRecord& before) {
  const auto a = decode_reply(now.in.packet), b = decode_reply(before.in.packet);
  return a && b && std::abs(a->counts[1] - b->counts[1]) > 200;
}
/// The encoders of the newest packets: how many packets' counts were all the same, and by how much each leg moved since another one did not.
class Encoders {
 public:
  bool another_leg_travels(const TickRecord& now, const TickRecord& /*before*/) {
    take(now);
    bool travels = false;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) travels |= high_[i][j] - low_[i][j] > 400;
    }
    return travels;
  }
  bool rest_under_another_force(const TickRecord& now, const TickRecord& /*before*/) {
    take(now);
    const auto change = [&](Newton a, Newton b) { return std::abs(a.raw() - b.raw()) / 65536.0; };
    const Vec3<Newton>& f = now.out.force;
    const double most = std::max({change(f.x, force_.x), change(f.y, force_.y), change(f.z, force_.z)});
    changed_ = most > 1.5 ? changed_ + 1 : 0;
    return changed_ > 50;
  }

 private:
  using Counts = std::array<std::int16_t, 3>;
  void take(const TickRecord& now) {
    const auto reply = decode_reply(now.in.packet);
    if (!reply || !now.in.fresh) return;
    for (std::size_t i = 0; i < 3; ++i) {
      if (reply->counts[i] != counts_[i]) low_[i] = high_[i] = reply->counts;
      for (std::size_t j = 0; j < 3; ++j) {
        low_[i][j] = std::min(low_[i][j], reply->counts[j]);
        high_[i][j] = std::max(high_[i][j], reply->counts[j]);
      }
    }
    if (reply->counts != counts_) force_ = now.out.force, changed_ = 0;
    counts_ = reply->counts;
  }

  Counts counts_{};
  std::array<Counts, 3> low_{}, high_{};
  Vec3<Newton> force_;
  int changed_ = 0;
};

bool unhomed(const TickRecord& now, const TickRecord& /*before*/) {
  const auto reply = decode_reply(now.in.packet);
  return reply && reply->homed != 7;
}

/// What is done beside the script, before tick `t` after the hand has pressed for a while.
using Pull = std::function<void(FaultBench&, int t)>;

struct Case {
  const char* name;
  std::string script;  ///< packets counted from the strike on; "at # FAULT"
  Pull pull;
  Shows shows;  ///< empty: no input shows it, and nothing happens
  S state;      ///< the gravest that it leads to
  std::uint16_t faults;
  bool by_itself;  ///< comes back without a person
  FaultBench::Options options = {};
  GuardVerdict verdict = GuardVerdict::kNone;  ///< what the guard alone can see
};

Pull during(int from, int to, std::function<void(FaultBench&, bool)> pull) {
  return [from, to, pull](FaultBench& bench, int t) {
    if (t == from) pull(bench, true);
    if (t == to) pull(bench, false);
  };
}

Pull lateness(std::int64_t ns, int ticks) {
  return [ns, ticks](FaultBench& bench, int t) {
    if (t >= kStrike && t < kStrike + ticks) bench.late_ns = ns;
  };
}

/// Presses, and from 4 s on goes deeper, out, and presses again.
falcon_model::Path deeper_hand(double deeper_mm) {
  return [deeper_mm, press = pressing_hand()](double ms) {
    falcon_model::Vector at = press(ms);
    if (ms > 4000) at.z -= deeper_mm * std::min((ms - 4000) / 400, 1.0);
    return ms < 5000 ? at : ms < 6500 ? falcon_model::Vector{0, 0, 45} : press(ms - 6500);
  };
}

/// Presses, and from 3.6 s on slides to and fro in front of the ball.
falcon_model::Path sliding_hand() {
  return [press = pressing_hand()](double ms) {
    if (ms < 3600) return press(ms);
    const double angle = 0.9 * std::sin((ms - 3600) / 400) * std::min((ms - 3600) / 400, 1.0);
    return falcon_model::Vector{18 * std::sin(angle), 0, 18 * std::cos(angle)};
  };
}

std::vector<Case> cases() {
  FaultBench::Options shallow;
  shallow.device.penetration_limit = Mm::of(4);
  shallow.path = deeper_hand(20);
  FaultBench::Options deep;
  deep.path = deeper_hand(0);
  FaultBench::Options sliding;
  sliding.path = sliding_hand();
  const auto seen = [] { return std::make_shared<Encoders>(); };
  return {
      {"short packet", "at # short", {}, stale, S::kHold, 0, true},
      {"merged packets", "at # merged", {}, stale, S::kHold, 0, true},
      {"late packets", "at # late 2", {}, stale, S::kHold, 0, true},
      {"corrupt packet", "at # corrupt", {}, stale, S::kHold, 0, true},
      {"repeated packet", "at # repeated", {}, {}, S::kActive, 0, true},
      {"modem-only reads, 2", "at # modem-only 2", {}, {}, S::kActive, 0, true},
      {"modem-only reads, 5", "at # modem-only 5", {}, stale, S::kHold, 0, true},
      {"device stalls 5 ms", "at # stall 1", {}, stale, S::kHold, 0, true},
      {"device stalls 50 ms", "at # stall 10", {}, stale, S::kHold, 0, true},
      {"device stalls 500 ms", "at # stall 100", {}, stale, S::kFault, kFaultSilent, false},
      {"unplug", "at # unplug 3", {}, stale, S::kFault, kFaultSilent, false},
      {"firmware lost", "at # firmware-lost", {}, stale, S::kFault, kFaultSilent, false},
      {"homing lost", "at # homing-lost", {}, unhomed, S::kHoming, 0, true},
      {"encoder jump, 900 counts", "at # encoder-jump 1 900\nat #+400 homing-lost", {}, jump, S::kFault, kFaultEncoders, false},
      {"encoder leap, 300 counts", "at # encoder-jump 1 300\nat #+200 encoder-jump 1 -300", {}, leap, S::kHold, 0, true},
      {"one encoder stuck",
       "at # encoder-stuck 1 4000",
       {},
       [e = seen()](const TickRecord& now, const TickRecord& before) { return e->another_leg_travels(now, before); },
       S::kFault,
       kFaultGuard,
       false,
       sliding,
       GuardVerdict::kStuck},
      {"all encoders stuck, and the stiffness changes",
       "at # encoder-stuck 7 1200",
       [](FaultBench& b, int t) {
         if (t == kStrike + 100) b.commands.set({TickSetting::kStiffness, Stiffness::of(0.1).raw()});
       },
       [e = seen()](const TickRecord& now, const TickRecord& before) { return e->rest_under_another_force(now, before); },
       S::kFault,
       kFaultGuard,
       false,
       {},
       GuardVerdict::kStuck},
      {"clock jumps ahead 10 s", "", lateness(10'000'000'000, 1), late, S::kFault, kFaultLate, false},
      {"clock is set back 10 s",
       "",
       [](FaultBench& b, int t) { b.set_back_ns = t == kStrike ? 10'000'000'000 : 0; },
       {},
       S::kActive,
       0,
       true},
      {"tick 5 ms late", "", lateness(5'000'000, 1), late, S::kHold, 0, true},
      {"tick 50 ms late", "", lateness(50'000'000, 1), late, S::kHold, 0, true},
      {"tick 500 ms late", "", lateness(500'000'000, 1), late, S::kFault, kFaultLate, false},
      {"burst of 20 ticks, each 2 ms late", "", lateness(2'000'000, 20), late, S::kHold, 0, true},
      {"every tick 2 ms late for 0.5 s", "", lateness(2'000'000, 170), late, S::kFault, kFaultLate, false},
      {"emergency stop", "", during(kStrike, 400, [](FaultBench& b, bool on) { b.lines.pressed = on; }), line, S::kFault, kFaultEmergency,
       false},
      {"enable stuck off", "", during(kStrike, 400, [](FaultBench& b, bool on) { b.lines.stuck_off = on; }), line, S::kFault, kFaultEnable,
       false},
      {"emergency stop, enable stuck on", "", during(kStrike, 400, [](FaultBench& b, bool on) { b.lines.pressed = b.lines.stuck_on = on; }),
       line, S::kFault, kFaultEmergency | kFaultEnable, false},
      {"stop requested", "",
       [](FaultBench& b, int t) {
         if (t == kStrike) b.commands.ask(kRequestStop);
       },
       told, S::kFault, kFaultStopped, false},
      {"hand too deep", "", {}, too_deep, S::kFault, kFaultPenetration, false, shallow},
      {"field swapped for one that swallows the hand", "",
       [](FaultBench& b, int t) {
         if (t == kStrike) b.load(ball_image(32));
       },
       another_field, S::kActive, 0, true, deep},
  };
}

/// Every '#' is a packet's number; "#+N" one so many later.
std::string at_packet(std::string script, std::uint64_t packet) {
  for (std::size_t at = script.find('#'); at != std::string::npos; at = script.find('#')) {
    std::size_t size = 1;
    std::uint64_t number = packet;
    if (script.compare(at, 2, "#+") == 0) {
      std::size_t digits = 0;
      number += std::stoull(script.substr(at + 2), &digits);
      size = 2 + digits;
    }
    script.replace(at, size, std::to_string(number));
  }
  return script;
}

bool graver(S a, S b) { return static_cast<int>(a) > static_cast<int>(b); }

/// Follows one fault until all is well again.
class Follow {
 public:
  Follow(const Case& which, FaultBench& bench) : case_(which), bench_(bench) {}

  FaultRow run() {
    FaultRow row;
    row.fault = case_.name;
    const bool happens = static_cast<bool>(case_.shows);
    for (int t = 0; t < kMax && !(well_again_ >= 0 && t > well_again_ + 300) && !(!happens && t > 1000); ++t) {
      if (case_.pull) case_.pull(bench_, t);
      if (t >= kAskFrom && t % 100 == 0 && bench_.state() == S::kFault) {
        bench_.commands.ask(kRequestResume);
        asked_ = true;
      }
      const TickRecord before = bench_.last;
      look(t, bench_.tick(), before);
    }
    row.ticks = shown_ < 0 || zero_ < 0 ? -1 : zero_ - shown_;
    row.state = state_ == S::kHoming ? "homing" : state_ == S::kFault ? "fault" : state_ == S::kHold ? "hold" : "active";
    row.sentence = sentence();
    row.recovery = recovery();
    row.broken = broken();
    return row;
  }

 private:
  void look(int t, const TickRecord& now, const TickRecord& before) {
    const bool zero = !bench_.has_words();
    if (!zero && bench_.state() != S::kActive && broken_.empty()) broken_ = "words in a state that has none";
    const GuardVerdict verdict = guard_verdict(now.in.lines);
    if (verdict != GuardVerdict::kNone && verdict != case_.verdict && broken_.empty()) broken_ = "the guard stopped it";
    if (now.out.commands != bench_.last_left().words && broken_.empty()) broken_ = "words left that the tick did not say";
    if (shown_ < 0 && case_.shows && case_.shows(now, before)) shown_ = t;
    if (shown_ >= 0 && zero_ < 0 && zero) zero_ = t;
    if (!zero && case_.shows == nullptr) return;
    if (zero && !case_.shows && broken_.empty()) broken_ = "no force, though nothing shows a fault";
    if (graver(bench_.state(), S::kActive) ? graver(bench_.state(), state_) : bench_.state() == S::kHoming && state_ == S::kActive)
      state_ = bench_.state(), status_ = now.out.status;
    if (!asked_) faults_ = static_cast<std::uint16_t>(faults_ | now.out.faults);
    if (zero_ >= 0 && well_again_ < 0 && t > zero_ && !zero && (now.out.status & kRamping) == 0) well_again_ = t;
    if (zero_ >= 0 && well_again_ < 0 && !zero && bench_.state() == S::kActive && (before.out.state != now.out.state) &&
        (now.out.status & kRamping) == 0 && broken_.empty())
      broken_ = "forces return without a soft start";
  }

  std::string sentence() const {
    if (case_.shows && state_ == S::kActive) return "none: no force until the hand has left the object";
    return state_ == S::kActive ? "none" : daemon::supervisor_line({static_cast<std::uint16_t>(state_), faults_, status_, true});
  }

  std::string recovery() const {
    if (!case_.shows) return "nothing to recover from";
    if (well_again_ < 0) return "never";
    const std::string after = std::to_string(well_again_ - zero_) + " ticks later";
    return asked_ ? "a person resumes; soft start" : "by itself, full force " + after;
  }

  std::string broken() const {
    if (!broken_.empty()) return broken_;
    if (!case_.shows) return state_ != S::kActive || bench_.longest_gap_ns > 5 * FaultBench::kPeriod / 2 ? "something happened" : "";
    if (shown_ < 0) return "no input showed the fault";
    if (zero_ < 0) return "there was no zero";
    if (zero_ - shown_ > kMaxTicks) return "zero came too late";
    if (state_ != case_.state) return "another state was reached";
    if (faults_ != case_.faults) return "other faults were told";
    if (well_again_ < 0) return "forces did not return";
    if (asked_ == case_.by_itself) return asked_ ? "did not return by itself" : "returned without a person";
    return {};
  }

  const Case& case_;
  FaultBench& bench_;
  int shown_ = -1, zero_ = -1, well_again_ = -1;
  S state_ = S::kActive;
  std::uint16_t faults_ = 0;
  std::uint32_t status_ = 0;
  bool asked_ = false;
  std::string broken_;
};

FaultRow run(const Case& which) {
  FaultBench::Options options = which.options;
  FaultBench trial(options);  // the same up to the strike: it tells the packet
  if (!trial.begin()) return {which.name, -1, "", "", "", "the hand never pressed"};
  options.faults = at_packet(which.script, trial.falcon().packets() + kStrike);
  FaultBench bench(options);
  bench.begin();
  return Follow(which, bench).run();
}

}  // namespace

std::vector<FaultRow> fault_matrix() {
  std::vector<FaultRow> rows;
  for (const Case& which : cases()) rows.push_back(run(which));
  for (FaultRow& row : broken_cores()) rows.push_back(std::move(row));
  for (FaultRow& row : outside_faults()) rows.push_back(std::move(row));
  return rows;
}

}  // namespace isotouch::test
