#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <memory>
#include <string>

#include "shared/fault_names.h"
#include "tests/driver/fault_bench.h"

namespace isotouch::test {
namespace {

using falcon_model::Vector;
using loop::Command;

/// Presses, and once it is told to, moves by so much within so many milliseconds.
struct Move {
  Vector by{};
  double ms_long = 1;
  std::shared_ptr<double> began = std::make_shared<double>(-1);  ///< ms; -1: not told, 0: told

  Vector operator()(double ms) const {
    if (*began == 0) *began = ms;
    Vector at = pressing_hand()(*began < 0 ? ms : std::max(ms, 2000.0));
    const double part = *began < 0 ? 0.0 : std::clamp((ms - *began) / ms_long, 0.0, 1.0);
    at.x += part * by.x, at.y += part * by.y, at.z += part * by.z;
    return at;
  }
  void go() const { *began = 0; }
};

/// A core that is broken on purpose. The one in the bench is not: it says by its zero when there should be no force.
struct Broken {
  const char* name;
  GuardVerdict verdict;
  std::function<void(Command&, const Command& last, int t)> says;  ///< what it says instead; `last` is what it said before it broke
  std::function<void(FaultBench&)> cause = {};                     ///< what should end the force, beside the script
  std::string script = {};                                         ///< a fault of the device, in the packet in which the core breaks
  Move move = {};
  int wait = 50;  ///< ticks from the hand's move until the core breaks
  DeviceModel device = libnifalcon_model();
  int most = 3;  ///< packets with force after the sound core says zero
};

/// The force goes on as if nothing had happened, with a tremor of one unit.
void goes_on(Command& command, const Command& last, int t) {
  command.falcon = last.falcon;
  command.falcon.words[0] = static_cast<std::int16_t>(command.falcon.words[0] + t % 2);
}

/// A force of some 2 N, with the light that belongs to it.
void appears(Command& command, const Command& /*last*/, int t) {
  command.falcon.words = {static_cast<std::int16_t>(600 + t % 2), 600, 600};
  command.falcon.flags = kFalconHoming | kFalconGreen;
}

std::function<void(Command&, const Command&, int)> times(double factor) {
  return [factor](Command& command, const Command&, int) {
    for (std::int16_t& word : command.falcon.words) word = static_cast<std::int16_t>(std::lround(word * factor));
  };
}

DeviceModel with(const std::function<void(DeviceModel&)>& change) {
  DeviceModel device = libnifalcon_model();
  change(device);
  return device;
}

bool says_force(const FaultBench& bench) { return bench.last_left().words != std::array<std::int16_t, 3>{}; }
bool has_force(const FaultBench& bench) { return bench.sent.words != std::array<std::int16_t, 3>{}; }

/// Until the force stops for good.
struct Caught {
  int packets = 0;  ///< with force, from the tick on in which the sound core says zero
  GuardVerdict verdict = GuardVerdict::kNone;
  bool told = false;  ///< the core was told of it
};

Caught caught(const Broken& broken) {
  FaultBench::Options options;
  options.path = broken.move;
  options.device = broken.device;
  const std::string held = broken.device.hold_to_run != 0 ? "at 1 buttons 4 " : "";
  if (!held.empty()) options.faults = held + "100000\n";
  const auto trial = std::make_unique<FaultBench>(options);
  EXPECT_TRUE(trial->begin());
  const std::string strike = std::to_string(trial->falcon().packets() + static_cast<std::uint64_t>(broken.wait));
  options.faults = broken.script.empty() ? "" : "at " + strike + " " + broken.script;
  if (!held.empty()) options.faults = held + strike;

  const auto bench = std::make_unique<FaultBench>(options);
  EXPECT_TRUE(bench->begin());
  broken.move.go();
  for (int t = 0; t < broken.wait; ++t) bench->tick();
  if (broken.cause) broken.cause(*bench);
  int t = 0;
  Command last;
  last.falcon = bench->last_left();
  bench->tamper = [&](Command& command) { broken.says(command, last, ++t); };
  Caught found;
  for (int i = 0; i < 1500; ++i) {
    const std::uint64_t before = bench->packets_with_force;
    bench->tick();
    if (!bench->has_words()) found.packets += static_cast<int>(bench->packets_with_force - before);
    if (found.verdict == GuardVerdict::kNone) found.verdict = bench->line_state.verdict();
    EXPECT_FALSE(found.verdict != GuardVerdict::kNone && has_force(*bench)) << broken.name;
    found.told |= (bench->last.out.faults & kFaultGuard) != 0;
  }
  EXPECT_TRUE(says_force(*bench)) << broken.name << ": else nothing is stopped";
  return found;
}

TEST(Guard, StopsWhatABrokenCoreSaysWithinThreeTicks) {
  const std::vector<Broken> list = {
      {"the emergency stop is ignored", GuardVerdict::kLine, goes_on, [](FaultBench& b) { b.lines.pressed = true; }},
      {"a stop is ignored", GuardVerdict::kStopped, goes_on, [](FaultBench& b) { b.commands.ask(kRequestStop); }},
      {"the light says idle", GuardVerdict::kLight,
       [](Command& c, const Command& last, int t) { goes_on(c, last, t), c.falcon.flags = kFalconHoming | kFalconBlue; }},
      {"the limit of the motors is ignored", GuardVerdict::kLimit, [](Command& c, const Command&, int) { c.falcon.words[1] = 4096; }},
      {"a silent device is ignored", GuardVerdict::kStale, goes_on, {}, "stall 40"},
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
       [](Command& c, const Command& last, int t) { goes_on(c, last, t), times(2)(c, c, 0); },
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
  for (const Broken& broken : list) {
    const Caught found = caught(broken);
    EXPECT_EQ(found.verdict, broken.verdict) << broken.name << ": " << name_of(found.verdict);
    EXPECT_LE(found.packets, broken.most) << broken.name;
    EXPECT_TRUE(found.told) << broken.name;
  }
}

/// What was let through of a core that is wrong by degrees, from the first touch on.
struct Passed {
  double newton = 0;  ///< the largest force that should not have been
  GuardVerdict verdict = GuardVerdict::kNone;
};

/// wrong     what there is too much, N, of the force that the sound core asks for
Passed passed(const std::function<void(Command&)>& says, const std::function<double(const Vec3<Newton>&)>& wrong, int ticks_in_contact,
              const Move& move = {}) {
  FaultBench::Options options;
  options.path = move;
  const auto bench = std::make_unique<FaultBench>(options);
  bench->load(ball_image(25));
  int touched = 0;
  for (; !bench->has_words() || ++touched < ticks_in_contact;) bench->tick();
  bench->tamper = says;
  if (move.by != Vector{}) move.go();
  Passed through;
  for (int t = 0; t < 1500; ++t) {
    bench->tick();
    if (through.verdict == GuardVerdict::kNone) through.verdict = bench->line_state.verdict();
    if (has_force(*bench)) through.newton = std::max(through.newton, wrong(bench->last.out.force));
    EXPECT_FALSE(through.verdict != GuardVerdict::kNone && has_force(*bench));
  }
  return through;
}

double newton(const Vec3<Newton>& force) {
  return std::hypot(std::ldexp(force.x.raw(), -16), std::ldexp(force.y.raw(), -16), std::ldexp(force.z.raw(), -16));
}

TEST(Guard, StopsAForceThatIsTooStrong) {
  const Passed through = passed([](Command& c) { times(8)(c, c, 0); }, [](const Vec3<Newton>& f) { return 8 * newton(f); }, 0);
  EXPECT_EQ(through.verdict, GuardVerdict::kStrong) << name_of(through.verdict);
  EXPECT_LT(through.newton, 2.5) << "of 8";
  EXPECT_GT(through.newton, 0.5) << "else it was stopped for another reason";
}

TEST(Guard, StopsAForceIntoTheObject) {
  const Passed through = passed([](Command& c) { times(-1)(c, c, 0); }, newton, 0);
  EXPECT_EQ(through.verdict, GuardVerdict::kPull) << name_of(through.verdict);
  EXPECT_LT(through.newton, 2.2);
}

TEST(Guard, StopsCommandsThatRepeat) {
  Command frozen;
  const auto says = [&frozen](Command& c) {
    if (frozen.tick == 0) frozen = c;
    c.falcon = frozen.falcon;
  };
  const Passed through = passed(says, [](const Vec3<Newton>&) { return 0.0; }, 1500, {{15, 0, 8}, 300});
  EXPECT_EQ(through.verdict, GuardVerdict::kRepeat) << name_of(through.verdict);
}

TEST(Guard, BelievesASoundCoreAfterAPersonHasResumed) {
  const auto bench = std::make_unique<FaultBench>(FaultBench::Options{});
  ASSERT_TRUE(bench->begin());
  bench->tamper = [](Command& c) { c.falcon.words[1] = 4096; };
  bench->tick();
  bench->tamper = {};
  for (int t = 0; t < 200; ++t) bench->tick();
  EXPECT_EQ(bench->line_state.verdict(), GuardVerdict::kNone) << "it was silent for 100 ms";
  EXPECT_EQ(bench->state(), SupervisorState::kFault);
  EXPECT_EQ(bench->last.out.faults, kFaultGuard);
  bench->commands.ask(kRequestResume);
  for (int t = 0; t < 600; ++t) bench->tick();
  EXPECT_TRUE(has_force(*bench));
}

}  // namespace
}  // namespace isotouch::test
