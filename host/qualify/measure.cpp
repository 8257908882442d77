#include "host/qualify/measure.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <iterator>
#include <map>
#include <optional>
#include <thread>
#include <utility>

#include "host/error.h"
#include "host/link/board_shell.h"
#include "host/link/controller.h"
#include "host/qualify/board_files.h"
#include "host/qualify/board_questions.h"
#include "host/qualify/practice_questions.h"
#include "host/qualify/verdict.h"
#include "host/trace/hash_text.h"
#include "shared/files/version_text.h"
#include "shared/tick_io.h"

namespace isotouch::qualify {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double kPatience = 20;       // seconds, with a small command on a busy board
constexpr double kFirstPatience = 60;  // somebody may have to type a password
constexpr int kUsualPriority = 80;     // of isotouchd's tick, unless its settings say otherwise
constexpr double kTimerSlice = 10;     // seconds of cyclictest at a time: it outlives a connection that is cut, but no longer than this

/// Between two questions whether there is a force: a hand that explores lifts off often.
constexpr std::chrono::milliseconds kForcePause(200);

double seconds_since(Clock::time_point then) { return std::chrono::duration<double>(Clock::now() - then).count(); }

/// What the controller has counted until now.
struct Counts {
  protocol::StatusReport status;
  std::array<link::Histogram, protocol::kMeasures> measures;
};

Counts counts(link::Controller& controller) {
  Counts now;
  now.status = controller.status();
  for (std::size_t i = 0; i < protocol::kMeasures; ++i) now.measures[i] = controller.histogram(static_cast<protocol::Measure>(i));
  return now;
}

/// Causes of the worst ticks, asked for while the tracer still has them.
class Causes {
 public:
  Causes(link::BoardShell& shell, bool wanted) : shell_(shell) {
    if (!wanted) {
      why_ = "the kernel's tracer was not used";
      return;
    }
    shell_.at_end(end_tracing_command());
    tracing_ = shell_.run(begin_tracing_command(), kPatience).status == 0;
    if (!tracing_) {
      why_ = "this user may not use the kernel's tracer there (root usually may), so the causes of the worst ticks are unknown";
    }
  }
  ~Causes() {
    try {
      if (tracing_) (void)shell_.run(end_tracing_command(), kPatience);
    } catch (const std::exception&) {  // the board is gone, and its tracer with it
    }
  }
  Causes(const Causes&) = delete;
  Causes& operator=(const Causes&) = delete;

  void look(const std::vector<protocol::WorstTick>& worst) {
    if (!why_.empty()) return;
    std::vector<protocol::WorstTick> fresh;
    std::copy_if(worst.begin(), worst.end(), std::back_inserter(fresh), [&](const auto& tick) { return known_.count(tick.number) == 0; });
    if (fresh.empty()) return;
    std::optional<link::BoardShell::Answer> answer;
    try {
      answer = shell_.run(trace_command(fresh), kPatience);
    } catch (const InputError&) {  // the ticks are measured all the same
    }
    if (!answer || answer->status != 0) {
      why_ = "the kernel's tracer could not be read in time, so the causes of some of the worst ticks are unknown";
      return;
    }
    const std::vector<std::string> causes = read_causes(answer->text, fresh.size());
    for (std::size_t i = 0; i < fresh.size(); ++i) known_[fresh[i].number] = causes[i].empty() ? "no longer in the tracer" : causes[i];
  }
  std::string of(std::uint64_t tick) const {
    const auto found = known_.find(tick);
    return found == known_.end() ? std::string() : found->second;
  }
  const std::string& why() const { return why_; }

 private:
  link::BoardShell& shell_;
  std::map<std::uint64_t, std::string> known_;
  std::string why_;
  bool tracing_ = false;
};

Subject subject_of(const link::Controller& controller, link::BoardShell& shell) {
  const protocol::Welcome& welcome = controller.welcome();
  Subject subject;
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  char date[32] = {};
  if (gmtime_r(&now, &utc) != nullptr) (void)std::strftime(date, sizeof date, "%Y-%m-%dT%H:%M:%SZ", &utc);
  subject.date = date;
  subject.host = shown(shell.run("uname -n", kFirstPatience).text);
  subject.tool = files::short_version_text("isotouch");
  subject.controller = welcome.program.view();
  subject.protocol = std::to_string(welcome.major) + "." + std::to_string(welcome.minor);
  return subject;
}

bool gives_force(const protocol::StatusReport& status) {
  return status.state == static_cast<std::uint16_t>(SupervisorState::kActive) && (status.status & kContact) != 0;
}

constexpr const char* kInterrupted = ": the measurement was interrupted";
constexpr const char* kColdCut = "cold ticks are unknown: the measurement ended before";
constexpr const char* kTimerCut = "cyclictest was not run to its end: the measurement ended before";
constexpr const char* kNoSensors = "the temperature could not be read at each check: ";
constexpr const char* kNoPractice = "the settings that affect timing could not be read: ";

/// Looks at the controller and its board in the course of a measurement.
class Looks {
 public:
  Looks(link::Controller& controller, link::BoardShell& shell, const protocol::StatusReport& before, const std::function<bool()>& is_over)
      : controller_(controller), shell_(shell), before_(before), is_over_(is_over) {}

  double seconds() const { return seconds_since(begun_); }

  void look(Figures& figures) {
    Moment moment = ask();
    try {
      const Sensors sensors = read_sensors(shell_.run(sensors_command(), kPatience).text, moment);
      // A sensor that never gives a number, as that of a radio that is off, counts only where there is no other.
      if (sensors.read < sensors_ || (sensors.read == 0 && sensors.silent > 0)) note_no_sensors(figures, "a sensor of the board gave none");
      sensors_ = std::max(sensors_, sensors.read);
    } catch (const InputError& e) {  // the ticks are measured all the same
      note_no_sensors(figures, e.what());
    }
    figures.moments.push_back(moment);
  }

  /// Waits until that second, and notes whether a force is given meanwhile.
  void wait(double second, Moment& since) {
    const auto until = begun_ + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(second));
    while (Clock::now() < until && !is_over_()) {
      if (!since.force) since.force = gives_force(controller_.status());
      std::this_thread::sleep_until(since.force ? until : std::min(until, Clock::now() + kForcePause));
    }
  }

  /// After the undisturbed ticks, whose figures stay whatever becomes of the controller.
  void look_later(Figures& figures) {
    try {
      figures.later.push_back(ask());
    } catch (const InputError& e) {
      if (figures.end_unknown.empty()) figures.end_unknown = e.what();  // later ones only follow from it
    }
  }

 private:
  Moment ask() {
    Moment moment;
    moment.second = seconds();
    const protocol::StatusReport status = controller_.status();
    moment.late = status.late - before_.late;
    moment.page_faults = status.page_faults - before_.page_faults;
    moment.allocations = status.allocations - before_.allocations;
    moment.state = status.state;
    moment.force = gives_force(status);
    return moment;
  }
  void note_no_sensors(Figures& figures, const std::string& why) const {
    if (figures.sensors_unknown.empty() && !is_over_()) figures.sensors_unknown = kNoSensors + why;
  }

  link::Controller& controller_;
  link::BoardShell& shell_;
  Clock::time_point begun_ = Clock::now();
  protocol::StatusReport before_;
  const std::function<bool()>& is_over_;
  std::size_t sensors_ = 0;  ///< most temperature sensors that one look has read
};

/// What was read of the ticks that nothing disturbed.
struct Undisturbed {
  Counts after;
  double seconds = 0;
  std::vector<protocol::WorstTick> worst;
};

/// The counts are read once a second, so that most of them are there whatever ends the measurement.
///
/// fails     InputError: nothing could be read
Undisturbed measure_undisturbed(link::Controller& controller, Looks& looks, Causes& causes, const Wish& wish, Figures& figures) {
  Undisturbed read;
  try {
    while (looks.seconds() < wish.seconds && !wish.is_over()) {
      looks.look(figures);
      causes.look(read.worst = controller.worst_ticks(false));
      looks.wait(std::min(std::floor(looks.seconds()) + 1, wish.seconds), figures.moments.back());
      read.after = counts(controller);
      read.seconds = looks.seconds();
    }
    causes.look(read.worst = controller.worst_ticks(false));
    looks.look(figures);
  } catch (const InputError& e) {
    if (read.seconds == 0) throw;
    figures.end_unknown = e.what();
  }
  if (read.seconds == 0) throw InputError(figures.address + kInterrupted + " before anything was measured");
  return read;
}

/// What the board does for ticks in time, or why it is not known.
void look_at_practice(link::BoardShell& shell, const BoardFiles& before, const Wish& wish, Figures& figures) {
  const double wakeup_us = wish.wakeup_us > 0 ? wish.wakeup_us : tenth_of_period_us(figures.period_ns);
  try {
    figures.practice = judge_practice(before, read_practice(shell.run(practice_command(), kPatience).text), wakeup_us);
  } catch (const InputError& e) {
    figures.practice_unknown = kNoPractice + (wish.is_over() ? "the measurement ended before" : std::string(e.what()));
  }
}

/// Ticks as they are while other programs use the caches.
void measure_cold(link::Controller& controller, link::BoardShell& shell, const Wish& wish, Figures& figures) {
  const double seconds = std::min(wish.cold_seconds, wish.seconds);
  if (seconds == 0) {
    figures.cold_unknown = "cold ticks were not asked for";
    return;
  }
  try {
    const std::uint64_t late_before = controller.status().late;
    const link::Histogram before = controller.histogram(protocol::Measure::kTick);
    const auto begun = Clock::now();
    try {
      (void)shell.run(eviction_command(seconds), seconds + 3 * kPatience);
    } catch (const InputError& e) {
      figures.cold_unknown = wish.is_over() ? kColdCut : e.what();
    }
    const double written = seconds_since(begun);
    figures.cold_late = controller.status().late - late_before;  // they count whatever became of the shell
    if (!figures.cold_unknown.empty()) return;
    if (written < 0.9 * seconds) {  // a program that ended at once has written nothing
      figures.cold_unknown = "cold ticks are unknown: 'dd' and 'timeout' could not write 64 MiB of memory there";
      return;
    }
    figures.cold = between(before, controller.histogram(protocol::Measure::kTick));
    figures.cold_seconds = written;
    if (figures.cold.count == 0) figures.cold_unknown = "cold ticks are unknown: no tick came while memory was written";
  } catch (const InputError& e) {  // the ticks are measured, and stay so
    figures.cold_unknown = wish.is_over() ? kColdCut : "cold ticks are unknown: the controller could not be asked about them";
    figures.end_unknown = e.what();
  }
}

/// A piece of cyclictest, or `figures.timer_unknown` says why there is none.
std::optional<link::Histogram> timer_slice(link::BoardShell& shell, double seconds, const Wish& wish, Figures& figures) {
  try {
    const link::BoardShell::Answer answer =
        shell.run(timer_command(figures.timer_priority, figures.period_ns / 1000, seconds), seconds + 3 * kPatience);
    return read_timer(answer.status, answer.text, figures.timer_unknown);
  } catch (const InputError& e) {  // the ticks are measured, and stay so
    figures.timer_unknown = wish.is_over() ? kTimerCut : e.what();
    return std::nullopt;
  }
}

void measure_timer(Looks& looks, link::BoardShell& shell, const Wish& wish, Figures& figures) {
  if (figures.timer_priority == 0) {
    figures.timer_unknown = "cyclictest was not asked for";
    return;
  }
  for (double left = wish.seconds; left > 0 && figures.timer_unknown.empty(); left -= kTimerSlice) {
    if (const auto timer = timer_slice(shell, std::min(left, kTimerSlice), wish, figures)) figures.timer = sum(figures.timer, *timer);
    looks.look_later(figures);  // also where cyclictest failed: perhaps because the controller or its board is gone
  }
}

}  // namespace

int timer_priority(std::optional<int> wished, const BoardFiles& files) {
  if (wished) return *wished;
  const auto stat = files.texts.find("thread/tick/stat");
  const auto tick = stat == files.texts.end() ? std::nullopt : scheduling(stat->second);
  return tick && tick->is_real_time() ? tick->priority : kUsualPriority;
}

Figures measure(const std::string& address, const Wish& wish, const std::function<void(const std::string&)>& tell) {
  link::Controller controller(address, {}, wish.is_over);
  link::BoardShell shell(link::read_address(address), wish.is_over);
  Figures figures;
  figures.address = address;
  figures.subject = subject_of(controller, shell);
  figures.period_ns = std::max(controller.welcome().period_ns, 1U);
  figures.board = read_description(shell.run(describe_command(), kFirstPatience).text);
  const auto read_subject = [&] {
    figures.subject.device = controller.device().serial.view();
    figures.subject.settings = trace::hash_text(controller.settings().checksum);
  };
  read_subject();

  Causes causes(shell, wish.trace);
  tell("the ticks, for " + std::to_string(static_cast<int>(wish.seconds)) + " s");
  const BoardFiles files_before = read_practice(shell.run(practice_command(), kPatience).text);
  (void)controller.worst_ticks(true);
  const Counts before = counts(controller);
  Looks looks(controller, shell, before.status, wish.is_over);
  const auto [after, seconds, worst] = measure_undisturbed(controller, looks, causes, wish, figures);
  figures.seconds = seconds;
  look_at_practice(shell, files_before, wish, figures);
  figures.subject.field = after.status.field_hash == 0 ? "" : trace::hash_text(after.status.field_hash);

  figures.ticks = after.status.ticks - before.status.ticks;
  figures.late = after.status.late - before.status.late;
  figures.page_faults = after.status.page_faults - before.status.page_faults;
  figures.allocations = after.status.allocations - before.status.allocations;
  for (std::size_t i = 0; i < protocol::kMeasures; ++i) figures.measures[i] = between(before.measures[i], after.measures[i]);
  for (const protocol::WorstTick& tick : worst) figures.worst.push_back({tick, causes.of(tick.number)});
  figures.cause_unknown = causes.why();

  try {
    if (figures.end_unknown.empty()) read_subject();  // somebody may have set something meanwhile
  } catch (const InputError& e) {
    figures.end_unknown = e.what();
  }
  const auto note_interruption = [&] {
    if (wish.is_over()) figures.end_unknown = address + kInterrupted;
  };
  note_interruption();
  if (figures.is_cut()) {
    figures.cold_unknown = kColdCut;
    figures.timer_unknown = kTimerCut;
    return figures;
  }
  if (wish.cold_seconds > 0) tell("the ticks while other programs write to memory");
  measure_cold(controller, shell, wish, figures);
  looks.look_later(figures);
  note_interruption();
  if (figures.is_cut()) {
    figures.timer_unknown = kTimerCut;
    return figures;
  }

  figures.timer_priority = timer_priority(wish.priority, files_before);
  if (figures.timer_priority > 0) tell("cyclictest, as long again");
  measure_timer(looks, shell, wish, figures);
  note_interruption();
  return figures;
}

}  // namespace isotouch::qualify
