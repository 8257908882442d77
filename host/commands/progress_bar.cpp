#include "host/commands/progress_bar.h"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <string_view>
#include <system_error>
#include <utility>

namespace isotouch::commands {

namespace {

constexpr double kStraight = 0.7;      // of the time that a stage is expected to take; then the bar slows down
constexpr double kDoubt = 0.05;        // of the whole: so much weighs the plan against the time that was measured
constexpr double kFirstSeconds = 0.3;  // a command that is faster shows nothing

constexpr std::string_view kWipe = "\r\033[K";
std::atomic<bool> line_is_drawn{false};

void put(std::string_view text) {
  [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, text.data(), text.size());  // where nobody reads, nobody misses it
}

/// Ctrl-C leaves no half a bar behind.
extern "C" void wipe_and_end(int signal) {
  if (line_is_drawn) put(kWipe);
  std::raise(signal);  // its handler was taken away when this began
}

void catch_signals() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction now {};
    if (sigaction(signal, nullptr, &now) != 0 || now.sa_handler != SIG_DFL) continue;
    struct sigaction wiping {};
    wiping.sa_handler = wipe_and_end;
    wiping.sa_flags = static_cast<int>(SA_RESETHAND | SA_NODEFER);
    sigaction(signal, &wiping, nullptr);
  }
}

double sum(const std::vector<PlannedStage>& plan, std::size_t count) {
  double seconds = 0;
  for (std::size_t i = 0; i < std::min(count, plan.size()); ++i) seconds += plan[i].seconds;
  return seconds;
}

/// The share of a stage that is probably done after so much of the time that it is expected to take: never all of it.
double likely(double time) {
  if (time < kStraight) return time;
  constexpr double kLeft = 1 - kStraight;
  return 1 - kLeft * kLeft / (time - kStraight + kLeft);
}

}  // namespace

ProgressBar::ProgressBar(std::vector<PlannedStage> plan, Drawn drawn)
    : plan_(std::move(plan)), drawn_(drawn), on_terminal_(drawn != Drawn::kNever && isatty(STDERR_FILENO) != 0) {
  if (!on_terminal_) return;
  catch_signals();
  if (drawn_ == Drawn::kAtBegins) return;
  const auto draw_on = [this](const std::stop_token& stop) {
    std::unique_lock held(lock_);
    while (!stop.stop_requested()) {
      woken_.wait_for(held, stop, std::chrono::milliseconds(100), [] { return false; });
      if (!stop.stop_requested()) draw();
    }
  };
  try {
    drawer_ = std::jthread(draw_on);
  } catch (const std::system_error&) {
    drawn_ = Drawn::kAtBegins;  // the system gives no more threads
  }
}

ProgressBar::~ProgressBar() { end(); }

void ProgressBar::plan(std::vector<PlannedStage> plan) {
  const std::scoped_lock held(lock_);
  least_ = done(now());
  plan_ = std::move(plan);
  const auto here = std::find_if(plan_.begin(), plan_.end(), [&](const PlannedStage& planned) { return planned.name == stage_; });
  next_ = here == plan_.end() ? 0 : static_cast<std::size_t>(here - plan_.begin()) + 1;
  before_ = sum(plan_, next_ == 0 ? 0 : next_ - 1);
}

void ProgressBar::begin(const std::string& stage) {
  const std::scoped_lock held(lock_);
  least_ = std::max(least_, done(now()));
  const auto rest = plan_.begin() + static_cast<std::ptrdiff_t>(std::min(next_, plan_.size()));
  const auto found = std::find_if(rest, plan_.end(), [&](const PlannedStage& planned) { return planned.name == stage; });
  if (found != plan_.end()) next_ = static_cast<std::size_t>(found - plan_.begin()) + 1;
  before_ = sum(plan_, found == plan_.end() ? next_ : next_ - 1);
  seconds_ = found == plan_.end() ? 0 : found->seconds;
  stage_ = stage;
  told_.reset();
  began_ = now();
  if (on_terminal_ && drawn_ == Drawn::kAtBegins) draw();
}

void ProgressBar::end() {
  const std::scoped_lock held(lock_);
  stage_.clear();
  wipe();
}

void ProgressBar::aside(const std::function<void()>& print) {
  const std::scoped_lock held(lock_);
  wipe();
  print();
}

field::Progress::Show ProgressBar::show() {
  return [this](const std::string& stage, double fraction) { report(stage, fraction); };
}

void ProgressBar::report(const std::string& stage, double fraction) {
  if (fraction >= 1) return end();
  if (fraction <= 0) return begin(stage);
  const std::scoped_lock held(lock_);
  told_ = fraction;
}

double ProgressBar::done(double now) const {
  const double whole = sum(plan_, plan_.size());
  if (!(whole > 0)) return least_;
  const double doubt = kDoubt * whole;
  const double slowness = (began_ + doubt) / (before_ + doubt);
  const double expected = std::max(1e-3, slowness * seconds_);
  const double share = stage_.empty() ? 0 : told_ ? *told_ : likely(std::max(0.0, now - began_) / expected);
  return std::max(least_, (before_ + seconds_ * share) / whole);
}

void ProgressBar::draw() {
  const double time = now();
  if (stage_.empty() || time < kFirstSeconds) return;
  least_ = done(time);  // what was drawn is not taken back when a stage tells better
  const int percent = std::clamp(static_cast<int>(100 * least_), 0, 99);
  if (percent == shown_ && stage_ == shown_stage_) return;
  shown_ = percent;
  shown_stage_ = stage_;
  constexpr int kCells = 40;
  std::string bar(kCells, ' ');
  std::fill_n(bar.begin(), percent * kCells / 100, '#');
  char number[8];
  std::snprintf(number, sizeof number, "%3d", percent);
  std::string name = stage_.substr(0, 20);
  name.resize(20, ' ');
  line_is_drawn = true;
  put(std::string(kWipe) + name + " [" + bar + "] " + number + " %");
}

void ProgressBar::wipe() {
  if (shown_ < 0) return;
  shown_ = -1;
  put(kWipe);
  line_is_drawn = false;
}

}  // namespace isotouch::commands
