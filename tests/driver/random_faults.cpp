#include "tests/driver/random_faults.h"

#include <malloc.h>

#include <algorithm>
#include <cstdio>
#include <memory>

#include "firmware/core/tick.h"
#include "firmware/loop/realtime.h"
#include "shared/fault_names.h"
#include "shared/field_view.h"
#include "shared/trace.h"
#include "tests/driver/fault_bench.h"
#include "tests/support/random.h"

namespace isotouch::test {

namespace {

constexpr int kTicksOfARun = 20'000;
constexpr int kMaxTicks = 3;

/// An image where a view of it may look at it.
struct Field {
  explicit Field(const std::vector<std::uint8_t>& bytes) : words((bytes.size() + 7) / 8) {
    std::copy(bytes.begin(), bytes.end(), reinterpret_cast<std::uint8_t*>(words.data()));
    view = *FieldView::parse({reinterpret_cast<const std::uint8_t*>(words.data()), bytes.size()});
  }
  std::vector<std::uint64_t> words;
  FieldView view;
};

std::uint64_t below(Random& random, std::uint64_t most) { return random.bits() % most; }

/// Faults at random packets, most of them after homing.
std::string random_script(Random& random, std::uint64_t& count) {
  std::string script;
  std::uint64_t packet = 3000;
  while (packet < kTicksOfARun) {
    packet += 20 + below(random, 900);
    const std::string n = std::to_string(1 + below(random, 4));
    const std::string kinds[] = {
        "short",
        "merged",
        "late " + n,
        "corrupt " + std::to_string(below(random, 16)) + " " + std::to_string(1 + below(random, 255)),
        "repeated",
        "split " + std::to_string(below(random, 16)),
        "modem-only " + n,
        "stall " + n,
        "stall " + std::to_string(1 + below(random, 40)),
        "buttons " + std::to_string(below(random, 16)) + " " + std::to_string(1 + below(random, 200)),
        "encoder-jump " + std::to_string(below(random, 3)) + " " + std::to_string(static_cast<int>(below(random, 3000)) - 1500),
        "homing-lost",
        "unplug " + n,
        "firmware-lost"};
    const std::uint64_t which = below(random, 60);  // the last four seldom: they cost a second or more of homing
    script += "at " + std::to_string(packet) + " " +
              kinds[which < 50        ? which % 10
                    : which < 56      ? 10
                    : which - 45 > 13 ? 10
                                      : which - 45] +
              "\n";
    ++count;
  }
  return script;
}

/// One of [feel], up to what a person would set; each may also be off.
SettingChange random_setting(Random& random) {
  constexpr LiveRaw kMax = {Stiffness::of(2).raw(),   Damping::of(0.001).raw(), Newton::of(12).raw(),     Ratio::of(0.9).raw(),
                            Damping::of(0.002).raw(), Damping::of(0.004).raw(), Damping::of(0.012).raw(), Newton::of(1).raw()};
  const std::uint64_t which = below(random, kLiveSettings);
  const auto setting = static_cast<TickSetting>(which + 1);
  const bool may_be_off = setting != TickSetting::kStiffness && setting != TickSetting::kForceLimit;
  if (may_be_off && below(random, 4) == 0) return {setting, 0};
  const std::int32_t low = std::max(raw_range(*kTickSettingRows[which]).low, 1);
  return {setting, low + static_cast<std::int32_t>(below(random, static_cast<std::uint64_t>(kMax[which] - low)))};
}

/// What a run must keep in every tick.
class Judge {
 public:
  explicit Judge(const TraceHeader& header) : chain_(header) {}

  /// returns   what is broken, nullptr: nothing
  const char* look(const loop::TickRecord& now, const FalconCommand& left, std::uint64_t& shown) {
    const bool words = !is_zero(left.words);
    const bool active = now.out.state == static_cast<std::uint16_t>(SupervisorState::kActive);
    // By the input alone. A sample that is no packet is none.
    const auto reply = decode_reply(now.in.packet);
    const int gap = static_cast<int>(std::min(stale_, 15U)) + 1;
    stale_ = now.in.fresh && reply ? 0 : stale_ + 1 + now.in.late;
    bool jump = false;
    if (now.in.fresh && reply) {
      for (std::size_t i = 0; i < 3 && has_counts_; ++i) jump |= std::abs(reply->counts[i] - counts_[i]) > 400 * gap;
      counts_ = reply->counts;
      has_counts_ = true;
    }
    const bool bad = stale_ >= 3 || now.in.lines != 0 || (now.in.requests & kRequestStop) != 0 || now.in.late >= 3 || jump;
    in_a_row_ = bad ? in_a_row_ + 1 : 0;
    shown += bad ? 1 : 0;
    if (left.words != now.out.commands) return "other words were left than the tick said";
    if (guard_verdict(now.in.lines) != GuardVerdict::kNone) return name_of(guard_verdict(now.in.lines)).data();  // the guard agrees
    if (words && !active) return "words in a state that has none";
    if (words && in_a_row_ > kMaxTicks) return "words beyond the bound";
    if (words && bad) return "words in a tick that shows a fault";
    if (fault_ && now.out.state != kFaultState && (now.in.requests & kRequestResume) == 0 && now.out.buttons == 0)
      return "a fault ended without a person";
    fault_ = now.out.state == kFaultState;
    return nullptr;
  }

  Chain chain_;

 private:
  static constexpr auto kFaultState = static_cast<std::uint16_t>(SupervisorState::kFault);
  std::uint32_t stale_ = 0;
  int in_a_row_ = 0;
  bool fault_ = false, has_counts_ = false;
  std::array<std::int16_t, 3> counts_{};
};

/// What a person needs to look for the cause.
std::string describe(const loop::TickRecord& record) {
  const auto mm = [](Mm v) { return static_cast<double>(v.raw()) / (1 << Mm::kFractionBits); };
  const auto& commands = record.out.commands;
  const auto newton = [](Newton v) { return static_cast<double>(v.raw()) / (1 << Newton::kFractionBits); };
  char text[240];
  std::snprintf(text, sizeof text, "state %u, status %08x, late %d, HIP %.2f %.2f %.2f mm, force %.3f %.3f %.3f N, commands %d %d %d",
                record.out.state, record.out.status, record.in.late, mm(record.out.hip.x), mm(record.out.hip.y), mm(record.out.hip.z),
                newton(record.out.force.x), newton(record.out.force.y), newton(record.out.force.z), commands[0], commands[1], commands[2]);
  return text;
}

/// One run; the recorded inputs are replayed beside it, through the bytes of a trace.
void run_once(Random& random, RandomRun& run, const Field (&fields)[2]) {
  FaultBench::Options options;
  options.faults = random_script(random, run.faults);
  const auto bench = std::make_unique<FaultBench>(options);
  TraceHeader header;
  header.device = options.device;
  header.period_ns = FaultBench::kPeriod;
  Judge judge(header);
  const core::TickModel model = core::make_tick_model(options.device, {}, FaultBench::kPeriod);
  core::TickState replayed;
  std::vector<std::size_t> field_of = {0};  // by generation
  int until_line = 0;
  loop::TickRecord last;
  for (int t = 0; t < kTicksOfARun; ++t, ++run.ticks) {
    if (t == 100 || (t > 6000 && below(random, 4000) == 0)) {
      const std::size_t which = t == 100 ? 0U : static_cast<std::size_t>(below(random, 2));
      const auto image = fields[which].view.image;
      if (bench->load({image.begin(), image.end()})) field_of.push_back(which);
      run.faults += t == 100 ? 0U : 1U;
    }
    if (below(random, 700) == 0) bench->late_ns = static_cast<std::int64_t>(below(random, 8'000'000)), ++run.faults;
    if (below(random, 9000) == 0) bench->late_ns = static_cast<std::int64_t>(below(random, 3'000'000'000)), ++run.faults;
    if (below(random, 9000) == 0) bench->set_back_ns = static_cast<std::int64_t>(below(random, 3'000'000'000)), ++run.faults;
    if (below(random, 5000) == 0) bench->lines.pressed = true, until_line = t + 150, ++run.faults;
    if (below(random, 9000) == 0) bench->lines.stuck_off = true, until_line = t + 150, ++run.faults;
    if (below(random, 9000) == 0) bench->lines.stuck_on = true, until_line = t + 150, ++run.faults;
    if (t >= until_line) bench->lines.pressed = bench->lines.stuck_off = bench->lines.stuck_on = false;
    if (below(random, 6000) == 0) bench->commands.ask(kRequestStop), ++run.faults;
    if (below(random, 9000) == 0) bench->commands.ask(kRequestRestart);
    if (below(random, 200) == 0) bench->commands.ask(kRequestResume);
    if (below(random, 500) == 0) bench->commands.set(random_setting(random)), ++run.settings;

    const std::uint64_t before = loop::allocations_of_thread, by_driver = bench->allocations_of_driver;
    const loop::TickRecord& now = bench->tick();
    run.allocations += loop::allocations_of_thread - before - (bench->allocations_of_driver - by_driver);

    for (loop::TickRecord record; bench->trace.pop(record);) {
      TraceRecord written{record.in, record.out, judge.chain_.extend(record.in, record.out), 0};
      const auto read = decode_record(encode(written));
      const bool has_field = read && read->input.field_generation != 0;
      const FieldView* field = has_field ? &fields[field_of[read->input.field_generation]].view : nullptr;
      const Output again = read ? core::tick(read->input, field, model, replayed) : Output{};
      if (!(read && again == read->output) && run.broken.empty()) {
        loop::TickRecord other = record;
        other.out = again;
        run.broken = "tick " + std::to_string(run.ticks) + " does not replay: " + describe(record) + "; again " + describe(other);
      }
    }
    const char* broken = judge.look(now, bench->last_left(), run.shown);
    if (broken != nullptr && run.broken.empty())
      run.broken = "tick " + std::to_string(run.ticks) + ": " + broken + ", " + describe(now) + "; before " + describe(last);
    last = now;
    ++run.in_state[now.out.state];
    run.with_words += bench->has_words() ? 1U : 0U;
  }
  run.allocations_of_driver += bench->allocations_of_driver;
  run.chain = run.chain * 31 + judge.chain_.value();
}

std::int64_t heap_bytes() { return static_cast<std::int64_t>(mallinfo2().uordblks); }

}  // namespace

RandomRun random_faults(std::uint64_t ticks, std::uint64_t seed) {
  const Field fields[] = {Field(ball_image(25)), Field(ball_image(32))};
  Random random(static_cast<std::uint32_t>(seed));
  RandomRun run;
  std::int64_t begun = 0;
  while (run.ticks < ticks && run.broken.empty()) {
    run_once(random, run, fields);
    if (begun == 0) begun = heap_bytes();
  }
  run.leaked_bytes = heap_bytes() - begun;
  if (run.broken.empty() && run.allocations > 0) run.broken = "ticks allocated";
  if (run.broken.empty() && run.leaked_bytes > 64 * 1024) run.broken = "memory was not given back";
  return run;
}

std::string describe(const RandomRun& run) {
  constexpr const char* kNames[] = {"boot", "homing", "idle", "ready", "active", "hold", "fault"};
  const auto number = [](std::uint64_t n) { return std::to_string(n); };
  std::string text = number(run.ticks) + " ticks, " + number(run.faults) + " faults, " + number(run.settings) + " settings; ticks in";
  for (std::size_t i = 0; i < run.in_state.size(); ++i) text += std::string(" ") + kNames[i] + " " + number(run.in_state[i]);
  char chain[20];
  std::snprintf(chain, sizeof chain, "%016llx", static_cast<unsigned long long>(run.chain));
  text += "; with force " + number(run.with_words) + "; showing a fault " + number(run.shown) + "; allocations in ticks " +
          number(run.allocations) + ", in the driver " + number(run.allocations_of_driver) + "; heap grew by " +
          std::to_string(run.leaked_bytes) + " bytes; replayed, " + chain;
  return text + (run.broken.empty() ? "" : "; BROKEN: " + run.broken);
}

}  // namespace isotouch::test
