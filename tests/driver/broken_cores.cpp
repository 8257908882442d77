#include "tests/driver/broken_cores.h"

#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>

#include "firmware/daemon/status_lines.h"
#include "shared/fault_names.h"

namespace isotouch::test {

namespace {

using falcon_model::Vector;
using loop::Command;

/// A core that is broken on purpose. The one in the bench is not: it says by its zero when there should be no force.
struct Broken {
  const char* name;
  GuardVerdict verdict;
  std::function<void(Command&, const Command& last, int t)> says;  ///< what it says instead; `last` is what it said before it broke
  std::function<void(FaultBench&)> cause = {};                     ///< what should end the force, beside the script
  std::string script = {};                                         ///< a fault of the device, in the packet in which the core breaks
  Way way = {};
  int wait = 50;  ///< ticks from the hand's move until the core breaks
  DeviceModel device = libnifalcon_model();
  int most = 3;  ///< packets with force after the sound core says zero
};

/// The force goes on as if nothing had happened, with a tremor of one unit.
void goes_on(Command& command, const Command& last, int t) {
  command.falcon = last.falcon;
  command.falcon.words[0] = static_cast<std::int16_t>(command.falcon.words[0] + t % 2);
}

/// The same, and it says that it has seen nothing since.
std::function<void(Command&, const Command&, int)> looks_at_none_from_now_on() {
  return [sample = std::uint64_t{0}](Command& command, const Command& last, int t) mutable {
    if (t == 1) sample = command.sample - 1;  // before the packet of the strike
    goes_on(command, last, t);
    command.sample = sample;
  };
}

/// A force of some 2 N, with the light that belongs to it.
void appears(Command& command, const Command& /*last*/, int t) {
  command.falcon.words = {static_cast<std::int16_t>(600 + t % 2), 600, 600};
  command.falcon.flags = kFalconHoming | kFalconGreen;
}

DeviceModel with(const std::function<void(DeviceModel&)>& change) {
  DeviceModel device = libnifalcon_model();
  change(device);
  return device;
}

bool says_force(const FaultBench& bench) { return !is_zero(bench.last_left().words); }

std::vector<Broken> list() {
  return {
      {"the emergency stop is ignored", GuardVerdict::kLine, goes_on, [](FaultBench& b) { b.lines.pressed = true; }},
      {"a stop is ignored", GuardVerdict::kStopped, goes_on, [](FaultBench& b) { b.commands.ask(kRequestStop); }},
      {"the light says idle", GuardVerdict::kLight,
       [](Command& c, const Command& last, int t) { goes_on(c, last, t), c.falcon.flags = kFalconHoming | kFalconBlue; }},
      {"the limit of the motors is ignored", GuardVerdict::kLimit, [](Command& c, const Command&, int) { c.falcon.words[1] = 4096; }},
      {"a silent device is ignored", GuardVerdict::kStale, goes_on, {}, "stall 40"},
      {"new packets are not looked at", GuardVerdict::kStale, looks_at_none_from_now_on(), {}, "encoder-jump 1 1200"},
      {"a lost reference is ignored", GuardVerdict::kReference, goes_on, {}, "homing-lost"},
      {"a jump of the encoders is ignored", GuardVerdict::kJump, goes_on, {}, "encoder-jump 1 1200"},
      {"a button that was let go is ignored", GuardVerdict::kReleased, goes_on, {}, "", {}, 50, with([](DeviceModel& d) {
         d.hold_to_run = 1;
       })},
      {"no contact", GuardVerdict::kFree, appears, {}, "", {{0, 0, 25}, 300}, 600},
      {"a hand that is too fast is ignored",
       GuardVerdict::kSpeed,
       goes_on,
       {},
       "",
       {{20, 0, 0}, 50},
       0,
       with([](DeviceModel& d) { d.speed_limit = MmPerS::of(200); }),
       10},  // the guard allows half as much again
      {"warm motors are ignored",
       GuardVerdict::kHeat,
       [](Command& c, const Command& last, int t) { goes_on(c, last, t), times(2, c); },
       {},
       "",
       {},
       50,
       with([](DeviceModel& d) {
         d.heat_word = 300;
         d.heat_ms = 1000;
       }),
       1000},
  };
}

FaultRow run(const Broken& which) {
  FaultRow row;
  row.fault = std::string("broken core: ") + which.name;
  FaultBench::Options options;
  const Move move{which.way};
  options.path = move;
  options.device = which.device;
  const std::string held = which.device.hold_to_run != 0 ? "at 1 buttons 4 " : "";
  if (!held.empty()) options.faults = held + "100000\n";
  const auto trial = std::make_unique<FaultBench>(options);  // the same up to the strike: it tells the packet
  if (!trial->begin()) {
    row.broken = "the hand never pressed";
    return row;
  }
  const std::string strike = std::to_string(trial->falcon().packets() + static_cast<std::uint64_t>(which.wait));
  options.faults = which.script.empty() ? "" : "at " + strike + " " + which.script;
  if (!held.empty()) options.faults = held + strike + "\n" + options.faults;

  const auto bench = std::make_unique<FaultBench>(options);
  if (!bench->begin()) row.broken = "the hand never pressed";
  move.go();
  for (int t = 0; t < which.wait; ++t) bench->tick();
  if (which.cause) which.cause(*bench);
  int t = 0, packets = 0;
  Command last;
  last.falcon = bench->last_left();
  bench->tamper = [&](Command& command) { which.says(command, last, ++t); };
  GuardVerdict verdict = GuardVerdict::kNone;
  bool told = false;
  for (int i = 0; i < 1500; ++i) {
    const std::uint64_t before = bench->packets_with_force;
    bench->tick();
    if (!bench->has_words()) packets += static_cast<int>(bench->packets_with_force - before);
    if (verdict == GuardVerdict::kNone) verdict = bench->line_state.verdict();
    if (verdict != GuardVerdict::kNone && has_force(*bench)) row.broken = "force after the verdict";
    told |= (bench->last.out.faults & kFaultGuard) != 0;
  }
  if (!says_force(*bench)) row.broken = "the core said no force, so nothing was stopped";
  if (!told) row.broken = "the core was not told";
  if (packets > which.most) row.broken = std::to_string(packets) + " packets with force";
  if (verdict != which.verdict) row.broken = "the verdict is: a command " + std::string(name_of(verdict));
  row.ticks = which.most > kMaxTicks ? -1 : packets;
  if (bench->state() != SupervisorState::kFault) row.broken = "the state is no fault";
  bench->tamper = {};
  bench->lines.pressed = false;
  for (int i = 0; i < 3000 && bench->state() == SupervisorState::kFault; ++i) {
    if (i % 100 == 99) bench->commands.ask(kRequestResume);
    bench->tick();
  }
  if (bench->state() == SupervisorState::kFault) row.broken = "nobody can resume";
  row.state = "fault";
  row.sentence = daemon::guard_line(verdict);
  row.recovery = "a person resumes";
  return row;
}

}  // namespace

void times(double factor, Command& command) {
  for (std::int16_t& word : command.falcon.words) word = static_cast<std::int16_t>(std::lround(word * factor));
}

bool has_force(const FaultBench& bench) { return !is_zero(bench.sent.words); }

std::vector<FaultRow> broken_cores() {
  std::vector<FaultRow> rows;
  for (const Broken& which : list()) rows.push_back(run(which));
  return rows;
}

}  // namespace isotouch::test
