#include "tests/driver/guard_cost.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>
#include <vector>

#include "firmware/core/tick.h"
#include "tests/driver/fault_bench.h"

namespace isotouch::test {

namespace {

using Clock = std::chrono::steady_clock;

double ns_since(Clock::time_point start) { return std::chrono::duration<double, std::nano>(Clock::now() - start).count(); }

double quantile(std::vector<double>& times, double share) {
  const auto at = times.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(times.size() - 1));
  std::nth_element(times.begin(), at, times.end());
  return *at;
}

/// Passes everything on to a guard and times it.
class TimedGuard final : public loop::CommandGuard {
 public:
  explicit TimedGuard(loop::CommandGuard& guard) : guard_(guard) {}

  MotorCommands pass(const loop::Command& command, std::int64_t now_ns) override {
    const auto start = Clock::now();
    const MotorCommands passed = guard_.pass(command, now_ns);
    spent_ns += ns_since(start);
    return passed;
  }
  void hear(const FalconPacket& packet, std::int64_t now_ns) override {
    const auto start = Clock::now();
    guard_.hear(packet, now_ns);
    spent_ns += ns_since(start);
  }
  double spent_ns = 0;  ///< since somebody took it

 private:
  loop::CommandGuard& guard_;
};

}  // namespace

GuardCost guard_cost(std::uint64_t ticks) {
  constexpr std::uint64_t kUntilForce = 30'000;  // ticks, homing included
  const FaultBench::Options options;
  const auto bench = std::make_unique<FaultBench>(options);
  TimedGuard timed(bench->guard);
  bench->judge = &timed;
  bench->load(ball_image(25));

  const core::TickModel model = core::make_tick_model(options.device, options.tick, FaultBench::kPeriod);
  core::TickState state;
  GuardCost cost;
  std::vector<double> guard, core;
  for (std::uint64_t n = 0; n < ticks + kUntilForce && guard.size() < ticks; ++n) {
    timed.spent_ns = 0;
    const loop::TickRecord record = bench->tick();
    for (loop::TickRecord seen; bench->trace.pop(seen);) {
    }
    const FieldView* field = record.in.field_generation == 0 ? nullptr : bench->fields.published().view;
    const auto start = Clock::now();
    const Output again = core::tick(record.in, field, model, state);
    const double core_ns = ns_since(start);
    if (again.commands != record.out.commands) return cost.broken = "the timed tick is another one than that of the loop", cost;
    if (!bench->has_words()) continue;
    guard.push_back(timed.spent_ns);
    core.push_back(core_ns);
  }
  cost.ticks = guard.size();
  if (cost.ticks < ticks) return cost.broken = "only " + std::to_string(cost.ticks) + " ticks had force", cost;
  cost.guard_median_ns = quantile(guard, 0.5), cost.guard_p999_ns = quantile(guard, 0.999);
  cost.tick_median_ns = quantile(core, 0.5), cost.tick_p999_ns = quantile(core, 0.999);
  return cost;
}

std::string describe(const GuardCost& cost) {
  if (!cost.broken.empty()) return "BROKEN: " + cost.broken;
  char text[300];
  std::snprintf(text, sizeof text,
                "guard   median %.0f ns, 99.9 %% %.0f ns a packet\n"
                "tick    median %.0f ns, 99.9 %% %.0f ns\n"
                "%llu ticks with force; the guard works on the thread that talks to the device",
                cost.guard_median_ns, cost.guard_p999_ns, cost.tick_median_ns, cost.tick_p999_ns,
                static_cast<unsigned long long>(cost.ticks));
  return text;
}

}  // namespace isotouch::test
