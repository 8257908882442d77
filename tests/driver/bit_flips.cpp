#include "tests/driver/bit_flips.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <memory>
#include <numbers>

#include "firmware/core/tick.h"
#include "firmware/guard/arm_geometry.h"
#include "shared/falcon_packet.h"
#include "tests/driver/fault_bench.h"
#include "tests/driver/fault_cases.h"
#include "tests/driver/flip_places.h"
#include "tests/support/field_image.h"
#include "tests/support/random.h"

namespace isotouch::test {

namespace {

using guard::operator-;
using loop::TickRecord;
using S = SupervisorState;

constexpr int kBegun = 6000;          // ticks: homed, and in its rhythm
constexpr int kMoments = 2000;        // ticks in which something may flip: a period of the hand
constexpr int kFollowed = 1200;       // ticks that a run is followed
constexpr int kFieldFollowed = 2300;  // where a field is checked in two seconds
constexpr int kSetAt = 300;           // ticks after the flip: a setting changes
constexpr int kAfter = 30;            // ticks that a run is followed after the force has ended
constexpr unsigned kHangs = 10;       // s; a run takes milliseconds

/// Presses 2 mm into a ball of 25 mm and slides to and fro, lets go, and comes back: a round of two seconds.
falcon_model::Path stroking_hand() {
  return [](double ms) {
    const auto smooth = [](double part) {
      const double t = std::clamp(part, 0.0, 1.0);
      return t * t * (3 - 2 * t);
    };
    const double round = std::fmod(ms, 2000.0), angle = 0.35 * std::sin(2 * std::numbers::pi * ms / 1300);
    const double away = smooth((round - 1300) / 150) - smooth((round - 1850) / 150);
    const double first = smooth(ms / 1000), radius = (1 - first) * 45 + first * (20 + 12 * away);
    return falcon_model::Vector{radius * std::sin(angle), 0, radius * std::cos(angle)};
  };
}

std::vector<std::uint8_t> ball_with_a_table() {
  return FieldImage({106, 106, 106},
                    [](const Point& p) {
                      return (length(p * 0.7 - Point{37.1, 37.1, 37.1}) - 25) / 0.7;
                    },
                    {.edge_mm = 0.7,
                     .origin_mm = {-37.1, -37.1, -37.1},
                     .stiffness_part = [](const Point& p) { return 200 + static_cast<int>(p.x) % 50; }})
      .bytes();
}

FaultBench::Options options() {
  FaultBench::Options options;
  options.path = stroking_hand();
  options.tick.friction = Ratio::of(0.2);
  options.tick.hand_damping = Damping::of(0.0005);
  options.tick.passivity = Damping::of(0.002);
  options.tick.device_damping = Damping::of(0.003);
  return options;
}

constexpr SettingChange kSet{TickSetting::kForceLimit, Newton::of(7).raw()};

/// What an undamaged controller says of the same packets.
class Twin {
 public:
  explicit Twin(const std::vector<std::uint8_t>& image)
      : words_((image.size() + 7) / 8),
        device_(options().device),
        arms_(device_),
        model_(core::make_tick_model(device_, options().tick, FaultBench::kPeriod)) {
    std::copy(image.begin(), image.end(), reinterpret_cast<std::uint8_t*>(words_.data()));
    field_ = *FieldView::parse({reinterpret_cast<const std::uint8_t*>(words_.data()), image.size()});
  }

  /// asked, change   what was asked of this tick
  void tick(const loop::Sample& sample, const TickRecord& record, std::uint32_t generation, std::uint8_t asked,
            const SettingChange& change) {
    Input in;
    in.packet = sample.packet;
    in.fresh = sample.number != seen_;
    age_ = in.fresh ? 0 : std::min<std::uint32_t>(age_ + 1 + record.in.late, 0xFFFF);
    seen_ = sample.number;
    in.age = static_cast<std::uint16_t>(age_);
    in.late = record.in.late;
    in.requests = asked;
    in.change = change;
    in.field_generation = generation;
    before_ = out_;
    out_ = core::tick(in, generation == 0 ? nullptr : &field_, model_, state_);
    if (const auto reply = decode_reply(sample.packet)) static_cast<void>(arms_.find(reply->counts, grip_.at, grip_));
  }

  const Output& out() const { return out_; }

  /// N, see the header.
  double extra(const MotorCommands& told) const {
    const guard::Point force = arms_.force(told, grip_);
    const auto beyond = [&](const MotorCommands& right) {
      const guard::Point whole = arms_.force(right, grip_);
      const double square = guard::dot(whole, whole), part = square > 0 ? std::clamp(guard::dot(force, whole) / square, 0.0, 1.0) : 0.0;
      return guard::length(force - guard::Point{part * whole[0], part * whole[1], part * whole[2]});
    };
    return std::min(beyond(out_.commands), beyond(before_.commands));
  }

 private:
  std::vector<std::uint64_t> words_;
  FieldView field_;
  DeviceModel device_;
  guard::ArmGeometry arms_;
  core::TickModel model_;
  core::TickState state_;
  Output out_, before_;
  std::uint64_t seen_ = 0;
  std::uint32_t age_ = 0;
  guard::Grip grip_;
};

/// What the motors of the simulated device do.
MotorCommands felt_commands(FaultBench& bench) {
  const falcon_model::Commands now = bench.falcon().firmware().commands();
  return {static_cast<std::int16_t>(now[0]), static_cast<std::int16_t>(now[1]), static_cast<std::int16_t>(now[2])};
}

/// A bench and its twin.
struct Pair {
  std::vector<std::uint8_t> image = ball_with_a_table();
  FaultBench bench{options()};
  Twin twin{image};

  void tick(std::uint8_t asked = 0, const SettingChange& change = {}) {
    if (asked != 0) bench.commands.ask(asked);
    if (change.setting != TickSetting::kNone) bench.commands.set(change);
    const TickRecord& record = bench.tick();
    for (TickRecord popped; bench.trace.pop(popped);) {
    }
    if (generation == 0) generation = record.in.field_generation;
    twin.tick(bench.arrived(), record, generation, asked, change);
  }
  bool agree() { return twin.out() == bench.last.out && twin.extra(felt_commands(bench)) <= kMaxExtra; }
  std::uint32_t generation = 0;
};

struct Flip {
  FlipState state;
  int moment;  ///< tick after kBegun
  int wait;    ///< ticks that a hold or fault has lasted
  std::size_t place;
  std::uint64_t bit;
};

/// What a run writes down for the process that began it.
struct Seen {
  bool over, hung, differs;
  int by, after;  ///< -1: not noticed
  int longest;
  double newton;
};

enum By { kByCheck, kByGuard, kByCodes, kByOther, kByEnd };

/// Who took the force away, as far as this tick shows it; -1: nobody.
int noticed_by(const FaultBench& bench, const Output& right) {
  const Output& out = bench.last.out;
  if (bench.line_state.verdict() != GuardVerdict::kNone) return kByGuard;
  if ((bench.last.in.lines & kLineMemory) != 0) return kByCheck;
  const auto more = static_cast<std::uint16_t>(out.faults & ~right.faults);
  if ((more & kFaultMemory) != 0) return kByCodes;
  const bool graver = out.state != right.state && is_zero(out.commands) && !is_zero(right.commands);
  return more != 0 || graver ? kByOther : -1;
}

/// In a process of its own.
void follow(Pair& pair, const Flip& flip_of, Seen& seen) {
  const bool hold = flip_of.state == FlipState::kHold, fault = flip_of.state == FlipState::kFault;
  const auto disturb = [&](int t) {
    if (hold && t < 80 && t % 12 == 0) pair.bench.late_ns = 5 * FaultBench::kPeriod;
  };
  int t = 0;
  if (fault) pair.tick(kRequestStop);
  for (; (hold || fault) && t < flip_of.wait; ++t) disturb(t), pair.tick();
  const auto places = flip_places(pair.bench);
  const FlipPlace& place = places[flip_of.place];
  flip(pair.bench, place, flip_of.bit);
  const int most = place.name.rfind("field", 0) == 0 ? kFieldFollowed : kFollowed;
  seen.by = seen.after = -1;
  int in_a_row = 0, quiet = 0;
  for (int n = 0; n < most && quiet < kAfter; ++n) {
    disturb(t + n);
    pair.tick(0, n == kSetAt ? kSet : SettingChange{});
    seen.differs |= !(pair.bench.last.out == pair.twin.out());
    const double extra = pair.twin.extra(felt_commands(pair.bench));
    seen.newton = std::max(seen.newton, extra);
    in_a_row = extra > kMaxExtra ? in_a_row + 1 : 0;
    seen.longest = std::max(seen.longest, in_a_row);
    if (const int by = noticed_by(pair.bench, pair.twin.out()); by >= 0 && seen.by < 0) seen.by = by, seen.after = n;
    const bool stays = pair.bench.state() == S::kFault && is_zero(felt_commands(pair.bench));
    quiet = seen.by >= 0 && seen.by != kByOther && stays ? quiet + 1 : 0;
  }
}

/// Runs one flip in a copy of this process.
Seen run_apart(Pair& pair, const Flip& flip_of, Seen& shared) {
  shared = {};
  const int file = guard_memory_file();
  guard::Memory memory;  // the copy shares it
  const bool kept = pread(file, &memory, sizeof memory, 0) == static_cast<ssize_t>(sizeof memory);
  std::fflush(stdout);
  const pid_t child = fork();
  if (child == 0) {
    if (const int nowhere = open("/dev/null", O_RDWR); nowhere >= 0) {  // the number of a file may flip, too
      for (const int file_of_ours : {0, 1, 2}) dup2(nowhere, file_of_ours);
    }
    for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) std::signal(signal, SIG_DFL);
    alarm(kHangs);
    follow(pair, flip_of, shared);
    shared.over = true;
    _exit(0);
  }
  if (child < 0) std::abort();  // no process, no trial
  int status = 0;
  waitpid(child, &status, 0);
  shared.hung = WIFSIGNALED(status) && WTERMSIG(status) == SIGALRM;
  if (!kept || pwrite(file, &memory, sizeof memory, 0) != static_cast<ssize_t>(sizeof memory)) std::abort();
  return shared;
}

FlipCell cell_of(const Seen& seen) {
  FlipCell cell;
  cell.flips = 1;
  const bool noticed = !seen.over || seen.by >= 0;
  cell.noticed = noticed ? 1 : 0;
  cell.unseen = !noticed && !seen.differs ? 1 : 0;
  cell.escaped = seen.longest > kMaxTicks ? 1 : 0;
  if (noticed) cell.by[static_cast<std::size_t>(seen.over ? seen.by : kByEnd)] = 1;
  cell.noticed_late = seen.over ? seen.after + 1 : 0;
  cell.longest = seen.longest;
  cell.newton = seen.newton;
  return cell;
}

constexpr const char* kStateNames[kFlipStates] = {"contact", "free", "hold", "fault"};

std::string text_of(const char* format, auto... arguments) {
  char text[300];
  std::snprintf(text, sizeof text, format, arguments...);
  return text;
}

/// The ticks after kBegun in which the hand touches, and those in which it does not.
struct Moments {
  std::vector<int> touching, free;
};

Moments look_for_moments(std::string& broken) {
  const auto pair = std::make_unique<Pair>();
  pair->bench.load(pair->image);
  Moments moments;
  for (int t = 0; t < kBegun + kMoments; ++t) {
    pair->tick();
    if (!pair->agree() && broken.empty()) broken = "tick " + std::to_string(t) + ": the undamaged controllers differ";
    if (t >= kBegun) ((pair->bench.last.out.status & kContact) != 0 ? moments.touching : moments.free).push_back(t - kBegun);
  }
  return moments;
}

}  // namespace

void FlipCell::add(const FlipCell& other) {
  flips += other.flips, unseen += other.unseen, noticed += other.noticed, escaped += other.escaped;
  noticed_late = std::max(noticed_late, other.noticed_late), longest = std::max(longest, other.longest);
  newton = std::max(newton, other.newton);
  for (std::size_t i = 0; i < by.size(); ++i) by[i] += other.by[i];
}

FlipRun bit_flips(int flips, std::uint64_t seed) {
  FlipRun run;
  const Moments moments = look_for_moments(run.broken);
  if (moments.touching.size() < kMoments / 4 || moments.free.size() < kMoments / 10) run.broken = "the hand does not touch and let go";
  if (!run.broken.empty()) return run;

  const auto pair = std::make_unique<Pair>();
  pair->bench.load(pair->image);
  for (int t = 0; t < kBegun; ++t) pair->tick();
  for (const FlipPlace& place : flip_places(pair->bench)) run.rows.push_back({place.name, {}});

  Random random(seed);
  std::vector<Flip> all;
  for (int i = 0; i < flips; ++i) {
    const auto state = static_cast<FlipState>(random.bits() % kFlipStates);
    const std::vector<int>& among = state == FlipState::kFree ? moments.free : moments.touching;
    const int moment = among[random.bits() % among.size()];
    all.push_back({state, moment, 5 + static_cast<int>(random.bits() % 60), random.bits() % run.rows.size(), random.bits()});
  }
  std::stable_sort(all.begin(), all.end(), [](const Flip& a, const Flip& b) { return a.moment < b.moment; });

  void* const pages = mmap(nullptr, sizeof(Seen), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (pages == MAP_FAILED) return run.broken = "the system gives no shared memory", run;
  int t = -1;
  for (const Flip& one : all) {
    for (; t < one.moment; ++t) pair->tick();
    const Seen seen = run_apart(*pair, one, *static_cast<Seen*>(pages));
    const FlipCell cell = cell_of(seen);
    FlipRow& row = run.rows[one.place];
    if (seen.hung)
      run.hung.push_back(text_of("%s, %s: hung, bit %llu, tick %d", row.place.c_str(), kStateNames[static_cast<std::size_t>(one.state)],
                                 static_cast<unsigned long long>(one.bit), one.moment));
    row.cells[static_cast<std::size_t>(one.state)].add(cell);
    run.all.add(cell);
    if (cell.escaped != 0) {
      run.worst.push_back(text_of("%s, %s: %.2f N, %d ticks, bit %llu, tick %d, %s", row.place.c_str(),
                                  kStateNames[static_cast<std::size_t>(one.state)], seen.newton, seen.longest,
                                  static_cast<unsigned long long>(one.bit), one.moment,
                                  !seen.over     ? "the program ended"
                                  : seen.by >= 0 ? text_of("noticed after %d", seen.after).c_str()
                                                 : "never noticed"));
    }
  }
  munmap(pages, sizeof(Seen));
  return run;
}

std::string describe(const FlipRun& run) {
  std::string text = text_of("%-24s %-8s %6s %7s %8s %7s | %6s %6s %6s %6s %6s | %6s %6s %6s\n", "place", "state", "flips", "unseen",
                             "noticed", "escaped", "memory", "guard", "codes", "other", "ended", "within", "N", "ticks");
  const auto line = [&text](const char* place, const char* state, const FlipCell& c) {
    text += text_of("%-24s %-8s %6d %7d %8d %7d | %6d %6d %6d %6d %6d | %6d %6.2f %6d\n", place, state, c.flips, c.unseen, c.noticed,
                    c.escaped, c.by[0], c.by[1], c.by[2], c.by[3], c.by[4], c.noticed_late, c.newton, c.longest);
  };
  std::array<FlipCell, kFlipStates> of_state;
  for (const FlipRow& row : run.rows) {
    for (std::size_t s = 0; s < kFlipStates; ++s) {
      if (row.cells[s].flips > 0) line(row.place.c_str(), kStateNames[s], row.cells[s]);
      of_state[s].add(row.cells[s]);
    }
  }
  for (std::size_t s = 0; s < kFlipStates; ++s) line("all places", kStateNames[s], of_state[s]);
  line("all places", "all", run.all);
  for (const std::string& flip : run.worst) text += "escaped: " + flip + "\n";
  for (const std::string& flip : run.hung) text += flip + "\n";
  text += text_of("%d flips, %d escaped: %.2f %%\n", run.all.flips, run.all.escaped, 100.0 * run.all.escaped / std::max(run.all.flips, 1));
  return text + (run.broken.empty() ? "" : "BROKEN: " + run.broken + "\n");
}

}  // namespace isotouch::test
