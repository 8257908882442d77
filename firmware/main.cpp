/// isotouchd: wiring only. Options, device, slots, threads, go.
#include <pthread.h>
#include <signal.h>  // NOLINT(modernize-deprecated-headers): sigtimedwait
#include <sys/stat.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "firmware/control/calibration.h"
#include "firmware/control/control_server.h"
#include "firmware/daemon/crash.h"
#include "firmware/daemon/hardware.h"
#include "firmware/daemon/lines.h"
#include "firmware/daemon/options.h"
#include "firmware/daemon/service_notify.h"
#include "firmware/daemon/status_lines.h"
#include "firmware/falcon/falcon_port.h"
#include "firmware/falcon/replay_port.h"
#include "firmware/loop/direct_device.h"
#include "firmware/loop/exchange_thread.h"
#include "firmware/loop/linux_clock.h"
#include "firmware/loop/loop.h"
#include "firmware/loop/measured_delay.h"
#include "firmware/loop/realtime.h"
#include "firmware/recording/recorder.h"
#include "firmware/settings/apply.h"
#include "firmware/settings/control.h"
#include "firmware/settings/live.h"
#include "firmware/store/field_intake.h"
#include "firmware/store/linux_folder.h"
#include "firmware/store/run_mark.h"

namespace isotouch::daemon {
namespace {

std::atomic<bool> stop_ticks{false}, stop_exchange{false}, go{false}, ticks_ended{false};
std::atomic<unsigned> refused{0};

void say(const std::string& line) {
  std::printf("%s\n", line.c_str());
  std::fflush(stdout);
}

int refuse(const std::string& sentence) {
  std::fprintf(stderr, "isotouchd: %s\n", sentence.c_str());
  return 1;
}

std::string load_field(const std::string& path, store::FieldIntake& intake) {
  std::ifstream file(path, std::ios::binary);
  const std::vector<std::uint8_t> bytes((std::istreambuf_iterator<char>(file)), {});
  if (bytes.empty()) return path + ": it cannot be read; give a blob that 'isotouch build' made";
  const std::string refusal = intake.begin_with(bytes);
  return refusal.empty() ? refusal : path + ": " + refusal;
}

void tick_thread(const settings::Settings& settings, loop::Loop& loop, std::uint64_t ticks) {
  pthread_setname_np(pthread_self(), "tick");
  loop::keep_crash_stack();
  refused |= loop::become_realtime(settings.priority, settings.core);
  loop::touch_stack();
  go.wait(false);
  loop.run(stop_ticks, ticks);
  ticks_ended = true;
}

void exchange_thread(const settings::Settings& settings, loop::ExchangeThread& exchange) {
  pthread_setname_np(pthread_self(), "exchange");
  refused |= loop::become_realtime(settings.exchange_priority, -1);
  go.wait(false);
  exchange.serve(stop_exchange);
}

/// Nothing that a person began would be cut off by a new start in this state.
bool may_begin_again(SupervisorState state) {
  return state == SupervisorState::kBoot || state == SupervisorState::kHoming || state == SupervisorState::kIdle;
}

/// Watches the ticks until the exchange ends, for whatever reason; then everything is off.
void watch_thread(const settings::Settings& settings, loop::Watch& watch) {
  loop::keep_crash_stack();
  refused |= loop::become_realtime(settings.watch_priority, -1);
  loop::touch_stack();
  go.wait(false);
  while (!stop_exchange) watch.step();
  watch.leave();
}

/// Those by which a person or the system ends the program: it then leaves words of zero. A terminal that is closed is one of them.
sigset_t ending_signals() {
  sigset_t signals;
  sigemptyset(&signals);
  for (const int signal : {SIGTERM, SIGINT, SIGHUP, SIGQUIT}) sigaddset(&signals, signal);
  return signals;
}

/// Says what changes, until a signal comes or the ticks have ended.
///
/// judge_delay     one sentence when the delay that was measured meanwhile has changed something
/// returns   false: another calibration than the one in use is to hold, and now is the time to begin again with it
bool watch(const Options& options, const Hardware& hardware, const recording::Recorder& recorder, control::Calibration& calibration,
           const loop::TickStats& stats, const std::function<std::string()>& judge_delay, daemon::ServiceNotify& systemd) {
  systemd.ready();
  const sigset_t signals = ending_signals();
  const timespec pause{0, 100'000'000};
  std::string device, supervisor;
  while (!ticks_ended) {
    if (hardware.falcon) {
      const falcon::PortReport& report = hardware.falcon->shown().get();
      const std::string line = device_line(report);
      if (line != device) {
        say(device = line);
        calibration.answers(report.state == falcon::SessionState::kRunning ? report.serial.data() : "");
      }
    }
    const std::string line = supervisor_line(recorder.state(), recorder.faults());
    if (line != supervisor) {
      say(supervisor = line);
      systemd.status(line);
    }
    if (const std::string changed = judge_delay(); !changed.empty()) say(changed);
    systemd.alive(stats.ticks.value());
    if (calibration.waits() && may_begin_again(recorder.state()) && !options.lockstep && options.settings.record.empty()) return false;
    if (sigtimedwait(&signals, nullptr, &pause) > 0) break;
  }
  systemd.ending();
  return true;
}

/// A run that follows one without an orderly end is in fault until a person resumes. In lockstep nobody is there.
void mark_run(store::RunMark& mark, const std::string& folder, loop::Requests& requests) {
  if (mark.was_left()) {
    requests.ask(kRequestStop);
    say("the run before had no orderly end; no force until 'resume'");
  }
  if (const Result<void> set = mark.set(); !set)
    say(folder + ": a crash of this run will not be known to the next: " + describe(set.error()));
}

/// again     not for the first time
/// returns   the exit code; nothing: begin again
std::optional<int> run(const Options& options, settings::LiveSettings& live, daemon::ServiceNotify& systemd, bool again) {
  stop_ticks = stop_exchange = go = ticks_ended = false;
  refused = 0;
  const settings::Settings settings = live.now();
  if (!settings::device_model(settings, {})) return refuse("the settings' numbers make no device together");
  Hardware hardware;
  if (const std::string complaint = make_hardware(options, stop_exchange, hardware); !complaint.empty()) return refuse(complaint);
  std::optional<store::LinuxFolder> folder;
  std::optional<store::FieldStore> store;
  std::optional<store::CalibrationStore> measured;
  if (!settings.state.empty()) {
    folder.emplace(settings.state);
    if (!folder->is_open()) return refuse(settings.state + ": the state folder cannot be used: " + describe(folder->trouble()));
    store.emplace(*folder, 8);
    measured.emplace(*folder);
  }
  const auto by_settings = [&](const std::string& serial) {
    const bool named = settings.calibrations.count(serial) > 0;
    return control::Calibration::Choice{*settings::device_model(settings, serial),
                                        named ? wire::AnglesFrom::kSettings : wire::AnglesFrom::kGeometry};
  };
  control::Calibration calibration(measured ? &*measured : nullptr, by_settings, serial_of(options, hardware));
  if (!calibration.trouble().empty()) say(calibration.trouble());
  loop::LoopSettings loop_settings{calibration.in_use().model, settings::tick_settings(settings), settings::period_ns(settings),
                                   options.lockstep};
  TraceHeader header;
  header.device = loop_settings.device;
  header.period_ns = loop_settings.period_ns;
  header.settings = loop_settings.tick;

  // Everything that the tick exchanges with other threads.
  loop::LinuxClock real_clock;
  loop::VirtualClock virtual_clock;
  loop::FieldSlots fields(settings::field_bytes(settings));
  loop::Requests requests;
  const auto ticks_in = [&](double seconds) { return static_cast<std::size_t>(seconds * settings.tick_hz); };
  loop::TraceRing trace(ticks_in(4)), watched(ticks_in(4));
  loop::Latest<loop::TickRecord> shown;
  loop::TickStats stats;
  Lines lines;
  if (!options.lockstep) {
    if (const std::string complaint = take_lines(settings, real_clock, stats, lines); !complaint.empty()) return refuse(complaint);
    if (!lines.watch) say(no_lines_line());
  }
  std::unique_ptr<loop::ExchangeThread> exchange;
  std::unique_ptr<loop::DirectDevice> direct;
  if (options.lockstep) {
    direct = std::make_unique<loop::DirectDevice>(hardware.port(), virtual_clock, loop_settings.period_ns, stop_ticks);
  } else {
    exchange = std::make_unique<loop::ExchangeThread>(hardware.port(), real_clock, static_cast<std::int64_t>(settings.refresh_ms * 1e6),
                                                      std::int64_t{loop_settings.device.hold_ticks + 1} * loop_settings.period_ns);
  }
  loop::Device& device = direct ? static_cast<loop::Device&>(*direct) : *exchange;
  loop::Clock& clock = direct ? static_cast<loop::Clock&>(virtual_clock) : real_clock;

  const auto measured_delay = [&] { return loop::measured_delay_ticks(stats, loop_settings.period_ns); };
  store::FieldIntake intake(fields, store ? &*store : nullptr, real_clock,
                            [&](const BlobView& field) { return settings::refusal_of(field, live.now(), measured_delay()); });
  const bool by_name = !settings.field.empty() && !(again && store && store->active());  // what was sent since counts more
  if (const std::string refusal = by_name ? load_field(settings.field, intake) : intake.begin_with_active(); !refusal.empty()) {
    if (by_name) return refuse(refusal);
    say(refusal);
  }
  systemd.busy();  // a large field from a slow card
  const auto hash_of = [&](std::uint32_t generation) { return intake.generation() == generation ? intake.hash() : 0; };
  recording::Recorder recorder({header, settings.state, ticks_in(settings.before_fault_s), ticks_in(0.5)}, trace,
                               settings.control.empty() ? nullptr : &watched, requests, hash_of, say);
  if (!settings.record.empty()) {
    if (const std::string complaint = recorder.start(settings.record); !complaint.empty()) return refuse(complaint);
  }
  std::optional<control::ControlServer> control;
  if (!settings.control.empty()) {
    control::ControlSettings wish;
    if (const std::string complaint = settings::apply_control(settings, wish); !complaint.empty()) return refuse(complaint);
    wish.program = "isotouchd";
    wish.recordings = header;
    control.emplace(std::move(wish), control::ControlNeighbours{intake, requests, stats, shown, real_clock, &watched, &calibration,
                                                                [&](std::string_view name, std::string_view value) {
                                                                  return live.set(name, value, requests, measured_delay());
                                                                }});
    if (const std::string complaint = control->start(); !complaint.empty()) return refuse(complaint);
  }

  std::optional<store::RunMark> mark;
  if (folder && !options.lockstep) mark_run(mark.emplace(*folder), settings.state, requests);

  rest_on_crash(stop_exchange);
  loop::keep_crash_stack();
  loop::Loop loop(loop_settings, device, clock, {fields, requests, trace, shown, stats, &lines.state});
  std::atomic<bool> stop_recorder{false};
  std::thread records([&] {
    loop::keep_crash_stack();
    for (; !stop_recorder; std::this_thread::sleep_for(std::chrono::milliseconds(options.lockstep ? 1 : 50))) recorder.drain();
  });
  std::thread exchanges;
  if (exchange) exchanges = std::thread([&] { exchange_thread(settings, *exchange); });
  std::thread watches;
  if (lines.watch) watches = std::thread([&] { watch_thread(settings, *lines.watch); });
  std::thread ticks([&] { tick_thread(settings, loop, options.ticks); });
  if (settings.lock_memory) refused |= loop::lock_memory();
  std::this_thread::sleep_for(std::chrono::milliseconds(20));  // both threads have asked for their priorities
  if (const std::string line = refusal_line(refused); !line.empty()) say(line);
  go = true;
  go.notify_all();

  // What was judged before there was a measurement is judged again: once for every delay and field.
  const auto judge_delay = [&, judged = std::pair(static_cast<std::uint32_t>(settings.delay_ticks), std::uint32_t{0})]() mutable {
    const std::pair now(options.lockstep ? 0 : measured_delay(), intake.generation());
    if (now.first <= static_cast<std::uint32_t>(settings.delay_ticks) || now == judged) return std::string();
    std::string changed = live.keep_within(requests, now.first);
    if (changed.empty() && !intake.check_again(changed)) return std::string();
    judged = now;
    return changed;
  };
  const bool to_the_end = watch(options, hardware, recorder, calibration, stats, judge_delay, systemd);
  stop_exchange = true;
  stop_ticks = true;
  if (exchanges.joinable()) exchanges.join();
  if (watches.joinable()) watches.join();
  ticks.join();
  hardware.port().rest();
  if (control) control->stop();
  stop_recorder = true;
  records.join();
  recorder.drain();
  recorder.stop();
  if (mark) mark->clear();
  if (!to_the_end) {
    systemd.busy();
    say("device: calibrated, beginning again with it");
    return std::nullopt;
  }
  say("at the end, " + supervisor_line(recorder.state(), recorder.faults()));
  std::fputs(figures(stats).c_str(), stdout);
  return 0;
}

}  // namespace
}  // namespace isotouch::daemon

int main(int argc, char** argv) {
  using namespace isotouch::daemon;
  sigset_t signals = ending_signals();
  sigaddset(&signals, SIGPIPE);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);  // before any thread: they all inherit it, `watch` takes them
  isotouch::loop::limit_stacks();
  try {
    Options options;
    int exit_code = 0;
    if (!read_options(argc, argv, options, exit_code)) return exit_code;
    isotouch::settings::LiveSettings live(options.settings);
    const char* socket = std::getenv("NOTIFY_SOCKET");
    isotouch::daemon::ServiceNotify systemd(socket == nullptr ? "" : socket);
    std::optional<int> ended;
    for (bool again = false; !ended; again = true) ended = run(options, live, systemd, again);
    return *ended;
  } catch (const std::exception& error) {
    return refuse(error.what());
  }
}
