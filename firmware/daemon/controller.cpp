#include "firmware/daemon/controller.h"

#include <pthread.h>
#include <signal.h>  // NOLINT(modernize-deprecated-headers): sigtimedwait

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <string_view>
#include <vector>

#include "firmware/daemon/ending_signals.h"
#include "firmware/daemon/status_lines.h"
#include "firmware/loop/realtime.h"
#include "firmware/settings/control.h"
#include "firmware/settings/table.h"
#include "shared/fault_names.h"
#include "shared/files/version_text.h"

namespace isotouch::daemon {

using protocol::OtherAngles;

namespace {

/// A run that needs a person's confirmation begins in fault and leaves it by a resume.
bool is_homed_and_confirmed(SupervisorState state) {
  return state == SupervisorState::kIdle || state == SupervisorState::kReady || state == SupervisorState::kActive ||
         state == SupervisorState::kHold;
}

Refusal begin_with_file(const std::string& path, store::FieldIntake& intake) {
  std::ifstream file(path, std::ios::binary);
  const std::vector<std::uint8_t> bytes((std::istreambuf_iterator<char>(file)), {});
  if (bytes.empty()) return path + ": it cannot be read; give a field that 'isotouch build' made";
  if (const Refusal refusal = intake.begin_with(bytes, std::filesystem::path(path).stem().string()))
    return path + ": " + refusal.sentence();
  return {};
}

}  // namespace

Controller::Controller(const Options& options, settings::LiveSettings& live, ServiceNotify& systemd, Printer& printer, Legacy before)
    : options_(options),
      live_(live),
      systemd_(systemd),
      printer_(printer),
      settings_(live.now()),
      before_(std::move(before)),
      fields_(settings::field_bytes(settings_)),
      trace_(ticks_in(4)),
      watched_(ticks_in(4)),
      latency_(settings_.latency_file) {}

Refusal Controller::build() {
  if (!settings::device_model(settings_, {}))
    return "the numbers in the settings contradict each other: no device can have them; check [device] and [limits]";
  if (Refusal refusal = open_state()) return refusal;
  const bool home_anew = mark_ && mark_->recalibrated();
  if (Refusal refusal = make_hardware(options_, home_anew, stop_exchange_, hardware_)) return refusal;
  choose_calibration();
  if (Refusal refusal = connect_device()) return refusal;
  if (Refusal refusal = load_field()) return refusal;
  if (Refusal refusal = begin_recording()) return refusal;
  if (Refusal refusal = listen()) return refusal;
  mark_run();
  return {};
}

Refusal Controller::open_state() {
  if (settings_.state.empty()) {
    if (!options_.lockstep) say(no_state_line());
    return {};
  }
  folder_.emplace(settings_.state);
  if (!folder_->is_open()) return settings_.state + ": the state folder cannot be used: " + describe(folder_->trouble());
  store_.emplace(*folder_, 8);
  measured_.emplace(*folder_);
  if (!options_.lockstep) mark_.emplace(*folder_);  // there nobody is there to resume
  return {};
}

void Controller::choose_calibration() {
  const auto by_settings = [this](const std::string& serial) {
    const bool named = settings_.calibrations.count(serial) > 0;
    return control::Calibration::Choice{*settings::device_model(settings_, serial),
                                        named ? protocol::AnglesFrom::kSettings : protocol::AnglesFrom::kGeometry};
  };
  const std::string serial = !before_.serial.empty() ? before_.serial : serial_of(options_, hardware_);
  std::function<void(bool)> distrust;
  if (!options_.lockstep) {
    distrust = [this](bool in_use) {
      if (hardware_.falcon) hardware_.falcon->distrust(in_use);
    };
  }
  calibration_.emplace(measured_ ? &*measured_ : nullptr, mark_ ? &*mark_ : nullptr, by_settings, serial, distrust);
  if (hardware_.falcon && !options_.lockstep) hardware_.falcon->expect(serial);
  if (calibration_->trouble()) say(calibration_->trouble().sentence() + (must_confirm_angles() ? "; no force until 'resume'" : ""));
  header_.device = calibration_->in_use().model;
  header_.settings = settings::tick_settings(settings_);
  header_.period_ns = settings::period_ns(settings_);
  header_.settings_checksum = settings::checksum(settings_);
  say(settings_line(header_.settings_checksum));
}

/// The device with its guard, and the lines beside it, joined to the loop: by a thread, or in lockstep without one and without time.
Refusal Controller::connect_device() {
  guard_.emplace(header_.device, header_.settings, header_.period_ns, fields_, requests_, lines_.state);
  if (!guard_->is_ready())
    return "the system gives no memory for the guard (memfd_create); check the service's limits and system call filter";
  if (!options_.lockstep) {
    if (Refusal refusal = take_lines(settings_, real_clock_, stats_, lines_)) return refusal;
    for (const std::string& missing : missing_lines(settings_)) say(missing);
    exchange_ = std::make_unique<loop::ExchangeThread>(hardware_.port(), real_clock_, static_cast<std::int64_t>(settings_.refresh_ms * 1e6),
                                                       std::int64_t{header_.device.hold_ticks} * header_.period_ns, &*guard_);
  } else {
    direct_ = std::make_unique<loop::DirectDevice>(hardware_.port(), virtual_clock_, header_.period_ns, stop_ticks_, &*guard_);
  }
  return {};
}

/// What the run before had, whatever the settings and the state folder name; at the first run what these name, the settings first.
Refusal Controller::load_field() {
  const auto check = [this](const FieldView& field) { return settings::refusal_of(field, live_.now(), measured_delay()); };
  intake_.emplace(fields_, store_ ? &*store_ : nullptr, real_clock_, check);
  if (const std::optional<std::vector<std::uint8_t>> image = std::exchange(before_.image, std::nullopt)) {
    const Refusal refusal = image->empty() ? Refusal() : intake_->begin_with(*image, before_.field_name);
    if (refusal) say("the field is not loaded again: " + refusal.sentence());
  } else if (!settings_.field.empty()) {
    if (Refusal refusal = begin_with_file(settings_.field, *intake_)) return refusal;
  } else if (const Refusal refusal = intake_->begin_with_active()) {
    say(refusal.sentence());
  }
  if (const store::PublishedField field = intake_->published(); field.generation != 0) say(field_line(field.name.view(), field.image_hash));
  return {};
}

Refusal Controller::begin_recording() {
  const auto hash_of = [this](std::uint32_t generation) { return intake_->hash_of(generation); };
  recorder_.emplace(recording::RecorderSettings{header_, settings_.state, ticks_in(settings_.before_fault_s), ticks_in(0.5)}, trace_,
                    settings_.control.empty() ? nullptr : &watched_, requests_, hash_of, std::bind_front(&Controller::say, this));
  intake_->tell_patches([this](std::uint64_t hash, std::span<const std::uint8_t> patch) { recorder_->tell_patch(hash, patch); });
  if (settings_.record.empty()) return {};
  return recorder_->start(options_.numbers_recordings ? recording::NumberedTraces(settings_.record).next() : settings_.record);
}

Refusal Controller::listen() {
  if (settings_.control.empty()) return {};
  control::ControlSettings wish;
  if (Refusal refusal = settings::apply_control(settings_, wish)) return refusal;
  wish.program = files::short_version_text("isotouchd");
  wish.recordings = header_;
  const auto set = [this](std::string_view name, std::string_view value, std::uint32_t author, bool may_raise) {
    return live_.set(name, value, requests_, measured_delay(), {author, may_raise, intake_->published().stiffness});
  };
  const auto different = [this] { return settings::different(live_.now()); };
  control_.emplace(std::move(wish), control::ControlNeighbours{*intake_, requests_, stats_, shown_, real_clock_, &watched_, &*calibration_,
                                                               set, different, std::bind_front(&Controller::say, this)});
  return control_->listen();
}

/// What was kept for the device cannot be used. In lockstep nobody is there to resume.
bool Controller::must_confirm_angles() const { return calibration_->trouble() && !options_.lockstep; }

void Controller::mark_run() {
  const Refusal doubt = mark_ ? mark_->begin() : Refusal();
  if (doubt || before_.faults != 0 || must_confirm_angles()) requests_.ask(kRequestStop);
  if (doubt) say(doubt.sentence());
}

/// What the next start must know of this run, and that a person has confirmed what was before it.
void Controller::keep_mark() {
  if (const Refusal unnamed = mark_ ? mark_->note(loop_->faults() & kServiceFaults) : Refusal()) say(unnamed.sentence());
  const SupervisorState state = lines_.state.told();
  const bool idle = state == SupervisorState::kIdle;  // a resume without a device is idle for one tick
  if (mark_ && is_homed_and_confirmed(state) && (!idle || was_idle_)) mark_->confirm();
  was_idle_ = idle;
}

/// Without time nobody is late: here, and only here, the tick waits for the recorder, so that no record is lost.
void Controller::tick_in_lockstep() {
  for (std::uint64_t ticks = 0; ticks < options_.ticks && !stop_ticks_ && loop_->step(); ++ticks) {
    while (trace_.is_full() && !stop_ticks_) std::this_thread::sleep_for(std::chrono::microseconds(100));
  }
}

/// A thread that asks the system for its priority and begins its life when all others have asked, too.
std::thread Controller::begin_thread(const char* name, settings::ThreadRights rights, std::function<void()> life) {
  return std::thread([this, name, rights, life = std::move(life)] {
    pthread_setname_np(pthread_self(), name);
    loop::keep_crash_stack();
    refused_ |= loop::become_realtime(rights.priority, rights.core);
    loop::touch_stack();
    asked_->count_down();
    go_.wait();
    life();
  });
}

void Controller::start() {
  crash_.emplace(stop_exchange_);
  loop::keep_crash_stack();
  loop::Device& device = direct_ ? static_cast<loop::Device&>(*direct_) : *exchange_;
  loop::Clock& clock = direct_ ? static_cast<loop::Clock&>(virtual_clock_) : real_clock_;
  const auto faults = static_cast<std::uint16_t>(before_.faults | (mark_ ? mark_->faults() : 0));
  loop_.emplace(loop::LoopSettings{header_.device, header_.settings, header_.period_ns, before_.heat, faults, options_.lockstep}, device,
                clock, loop::Neighbours{fields_, requests_, trace_, shown_, stats_, &lines_.state});
  memory_check_.emplace(fields_, loop::MemoryCheck::Prepared{loop_->constants(), guard_->constants()});
  records_ = std::thread([this] {
    pthread_setname_np(pthread_self(), "record");
    loop::keep_crash_stack();
    for (; !stop_recorder_; std::this_thread::sleep_for(std::chrono::milliseconds(options_.lockstep ? 1 : 50))) {
      recorder_->drain();
      keep_mark();  // here, because it waits for a disk
    }
  });
  asked_.emplace(1 + (exchange_ ? 1 : 0) + (lines_.watchdog ? 1 : 0));
  const settings::Threads rights = settings::thread_rights(settings_);
  if (exchange_) exchanges_ = begin_thread("exchange", rights.exchange, [this] { exchange_->serve(stop_exchange_); });
  if (lines_.watchdog) {
    watchdogs_ = begin_thread("watchdog", rights.watchdog, [this] {
      while (!stop_exchange_) lines_.watchdog->step();
      lines_.watchdog->leave();
    });
  }
  ticks_ = begin_thread("tick", rights.tick, [this] {
    options_.lockstep ? tick_in_lockstep() : loop_->run(stop_ticks_, options_.ticks);
    ticks_ended_ = true;
  });
  if (settings_.lock_memory) refused_ |= loop::lock_memory();
  asked_->wait();
  if (const std::string line = refusal_line(refused_); !line.empty()) say(line);
  go_.count_down();
}

Controller::End Controller::supervise() {
  systemd_.ready();
  const sigset_t signals = ending_signals();
  const timespec pause{0, 100'000'000}, soon{0, 1'000'000};
  bool serves = !control_;
  while (!ticks_ended_) {
    // A client is let in after the first tick, because only from then on does the status show the faults of the run before. In lockstep no fault is
    // handed over, and the first tick waits for a device, so clients are let in at once.
    if (!serves && (options_.lockstep || stats_.ticks.value() > 1)) control_->serve(), serves = true;
    say_what_changed();
    know_device();
    keep_stiffness();
    systemd_.alive(stats_.ticks.value());
    stay_awake();
    check_memory();
    if (begins_again_ = may_begin_again(); begins_again_) {
      systemd_.busy();  // already for the end of this run: a slow disk may hold it up
      return End::kBeginAgain;
    }
    if (const int signal = sigtimedwait(&signals, nullptr, serves ? &pause : &soon); signal > 0) {
      ended_by_ = signal;
      say(ending_line(signal));
      break;
    }
  }
  systemd_.ending();
  return End::kOver;
}

/// From a homed device a force may come within a few ticks. Until the processors are asked for, at most a pause has passed, and the force has not
/// risen yet (`[limits] ramp_after_rest_ms`).
void Controller::stay_awake() {
  const int error = latency_.hold(!options_.lockstep && is_homed_and_confirmed(lines_.state.told()));
  if (error == 0 || error == latency_error_) return;
  latency_error_ = error;
  say(latency_line(settings_.latency_file, error));
}

void Controller::check_memory() {
  const loop::Damage found = memory_check_->step(), damage = std::max(found, loop_->take_damage());
  lines_.state.put_damaged(found != loop::Damage::kNone);
  if (damage == damage_) return;
  damage_ = damage;
  if (damage != loop::Damage::kNone) say(memory_line(damage));
}

void Controller::say_what_changed() {
  if (hardware_.falcon) {
    const falcon::PortReport& report = hardware_.falcon->shown().get();
    if (std::string line = device_line(report); line != device_line_) say(device_line_ = std::move(line));
  }
  if (std::string line = supervisor_line(recorder_->condition(), calibration_->others()); line != supervisor_line_) {
    say(supervisor_line_ = std::move(line));
    systemd_.status(supervisor_line_);
  }
  if (const GuardVerdict verdict = lines_.state.verdict(); verdict != verdict_) {
    verdict_ = verdict;
    if (verdict != GuardVerdict::kNone) say(guard_line(verdict));
  }
}

/// A device counts as soon as it is known that the angles in use are its own, and as long as they are: where it has to be booted, before its first packet.
void Controller::know_device() {
  if (!hardware_.falcon) return;
  const falcon::PortReport& report = hardware_.falcon->shown().get();
  const bool is_there = report.state != falcon::SessionState::kSearching;
  if (const std::uint64_t answering = is_there ? report.found : 0; answering != answering_) {
    answering_ = answering;
    delay_.begin_anew(stats_);
    calibration_->answers(is_there ? std::optional<std::string>(report.serial.data()) : std::nullopt);
  }
  if (is_there && calibration_->others() == OtherAngles::kNone) {
    hardware_.falcon->trust(report.found);
    had_device_ |= report.state == falcon::SessionState::kRunning;
  }
  if (calibration_->others() != OtherAngles::kNone) hardware_.falcon->distrust();  // also if they were kept since the look above
}

/// Other angles wait to be used, and nothing that a person began would be cut off. What was begun before there was a device begins again whole.
bool Controller::may_begin_again() const {
  if (calibration_->others() == OtherAngles::kNone || (control_ && control_->is_in_use())) return false;
  const SupervisorState state = lines_.state.told();
  const bool gives_force = state == SupervisorState::kReady || state == SupervisorState::kActive || state == SupervisorState::kHold;
  return !had_device_ || (settings_.record.empty() && !gives_force);
}

/// No stiffer than the measured delay allows, and the field where it is the limit.
void Controller::keep_stiffness() {
  delay_.look(stats_, header_.period_ns);
  if (const std::string changed = judge_delay(); !changed.empty()) say(changed);
  if (const store::PublishedField field = intake_->published(); field.generation != 0) {
    if (const std::string fallen = live_.keep_within_field(requests_, field.stiffness); !fallen.empty()) say(fallen);
  }
}

/// What was judged before there was a measurement is judged again: once for every delay and field.
///
/// returns   what that has changed; empty: nothing
std::string Controller::judge_delay() {
  const auto assumed = static_cast<std::uint32_t>(settings_.delay_ticks);
  const std::pair now(options_.lockstep ? 0 : measured_delay(), intake_->published().generation);
  if (now.first <= assumed || now == judged_delay_) return {};
  if (std::string lowered = live_.keep_within(requests_, now.first); !lowered.empty()) {
    judged_delay_ = now;
    return lowered;
  }
  Refusal taken_away;
  if (!intake_->check_again(taken_away)) return {};
  judged_delay_ = now;
  return taken_away.sentence();
}

void Controller::stop() {
  if (!crash_) return;  // it has not started, or has stopped
  stop_exchange_ = stop_ticks_ = true;
  if (!go_.try_wait()) go_.count_down();  // the system gave no more threads: those that wait end at once
  for (std::thread* thread : {&exchanges_, &watchdogs_, &ticks_}) {
    if (thread->joinable()) thread->join();
  }
  hardware_.port().rest();
  latency_.hold(false);
  if (control_) control_->stop();
  stop_recorder_ = true;
  if (records_.joinable()) records_.join();
  recorder_->drain();
  begins_again_ ? recorder_->discard() : recorder_->stop(stats_.ticks.value());
  keep_mark();
  stopped_late_ = (requests_.take().bits & kRequestStop) != 0;  // after the last tick; it was answered
  const bool must_stay = (faults() & (kServiceFaults | kFaultStopped)) != 0;
  if (const Refusal unnamed = mark_ ? mark_->end(must_stay ? faults() : std::uint16_t{0}) : Refusal()) say(unnamed.sentence());
  crash_.reset();
}

/// At the end, that nobody has resumed after. The silence of a device that was not listened to, because it was calibrated, is no fault of its cable.
std::uint16_t Controller::faults() const {
  const std::uint16_t of_ticks = loop_ ? loop_->faults() : before_.faults;
  const std::uint16_t not_real = calibration_->others() == OtherAngles::kKept ? kFaultSilent : 0;
  return static_cast<std::uint16_t>((of_ticks & ~not_real) | (stopped_late_ ? kFaultStopped : 0));
}

Controller::Legacy Controller::legacy() const {
  Legacy legacy{
      loop_ ? loop_->heat() : before_.heat, std::string(calibration_->report().serial.view()), faults(), std::vector<std::uint8_t>(), {}};
  if (const loop::ActiveField field = fields_.published(); field.view != nullptr) {
    legacy.image->assign(field.view->image.begin(), field.view->image.end());
    legacy.field_name = intake_->published().name.view();
  }
  return legacy;
}

std::string Controller::summary() {
  std::string text =
      "at the end, " + supervisor_line(recording::Recorder::condition_of(shown_.get()), calibration_->others()) + "\n" + figures(stats_);
  text.pop_back();  // whoever prints it ends the line
  return text;
}

}  // namespace isotouch::daemon
