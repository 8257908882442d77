/// One run of the controller, from its settings to its end: what its threads share, the threads, and the order in which they begin and end.
///
///   build       device, state folder, safety lines, field and control socket are there; nothing runs
///   start       every thread has asked the system for its priority, then all of them run
///   supervise   says what changes, until somebody or something ends the run
///   stop        every thread has ended, the device is left without force
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <latch>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "firmware/control/calibration.h"
#include "firmware/control/control_server.h"
#include "firmware/daemon/crash.h"
#include "firmware/daemon/hardware.h"
#include "firmware/daemon/lines.h"
#include "firmware/daemon/options.h"
#include "firmware/daemon/printer.h"
#include "firmware/daemon/service_notify.h"
#include "firmware/guard/device_guard.h"
#include "firmware/loop/direct_device.h"
#include "firmware/loop/exchange_thread.h"
#include "firmware/loop/latency_request.h"
#include "firmware/loop/linux_clock.h"
#include "firmware/loop/loop.h"
#include "firmware/loop/measured_delay.h"
#include "firmware/loop/memory_check.h"
#include "firmware/recording/recorder.h"
#include "firmware/settings/apply.h"
#include "firmware/settings/live.h"
#include "firmware/store/field_intake.h"
#include "firmware/store/linux_folder.h"
#include "firmware/store/run_mark.h"
#include "shared/files/refusal.h"

namespace isotouch::daemon {

class Controller {
 public:
  enum class End : std::uint8_t { kOver, kBeginAgain };

  /// What a run leaves to the next one.
  struct Legacy {
    std::uint32_t heat = 0;    ///< as core::heat_input gives it; 0 = not known
    std::string serial;        ///< of the device that answered; empty: not known
    std::uint16_t faults = 0;  ///< that nobody has resumed after: the next one begins in a fault
    std::optional<std::vector<std::uint8_t>>
        image;               ///< of the field that it had, with every patch; empty: it had none; not given: it was no run
    std::string field_name;  ///< of that field
  };

  /// All of them live longer. Signals that end the program must be blocked already: `supervise` takes them.
  ///
  /// live      the settings as they are now; what is set while it runs stays there for the next run
  /// before    what the run before leaves
  Controller(const Options& options, settings::LiveSettings& live, ServiceNotify& systemd, Printer& printer, Legacy before);
  /// As `stop`.
  ~Controller() { stop(); }
  Controller(const Controller&) = delete;
  Controller& operator=(const Controller&) = delete;

  /// returns   what is missing or wrong; then nothing may follow
  Refusal build();

  void start();

  /// returns   kBeginAgain: another calibration than the one in use is to hold, and a new run may begin without cutting anything off
  End supervise();

  void stop();

  /// When it has stopped.
  Legacy legacy() const;

  /// The signal that has ended it; 0: none did.
  int ended_by() const { return ended_by_; }

  /// What became of the recording. When it has stopped.
  recording::Recorder::Outcome recording() const { return recorder_ ? recorder_->outcome() : recording::Recorder::Outcome::kAsAsked; }

  /// What there is to say when it has stopped.
  std::string summary();

 private:
  void say(const std::string& line) { printer_.say(line); }
  Refusal open_state();
  void choose_calibration();
  Refusal connect_device();
  Refusal load_field();
  Refusal begin_recording();
  Refusal listen();
  bool must_confirm_angles() const;
  void mark_run();
  std::uint16_t faults() const;
  void keep_mark();
  void tick_in_lockstep();
  std::thread begin_thread(const char* name, settings::ThreadRights rights, std::function<void()> life);
  std::size_t ticks_in(double seconds) const { return static_cast<std::size_t>(seconds * settings_.tick_hz); }
  std::uint32_t measured_delay() const { return delay_.ticks(); }
  void know_device();
  bool may_begin_again() const;
  void stay_awake();
  void check_memory();
  void say_what_changed();
  void keep_stiffness();
  std::string judge_delay();

  const Options& options_;
  settings::LiveSettings& live_;
  ServiceNotify& systemd_;
  Printer& printer_;
  const settings::Settings settings_;  ///< of this run
  Legacy before_;                      ///< its image only until it is loaded

  // What the threads exchange.
  std::atomic<bool> stop_ticks_{false}, stop_exchange_{false}, stop_recorder_{false}, ticks_ended_{false};
  std::atomic<unsigned> refused_{0};  ///< loop::Refusals
  loop::LinuxClock real_clock_;
  loop::VirtualClock virtual_clock_;
  loop::FieldSlots fields_;
  loop::Requests requests_;
  loop::TraceRing trace_, watched_;
  loop::Latest<loop::TickRecord> shown_;
  loop::TickStats stats_;

  loop::MeasuredDelay delay_;     ///< looked at by the main thread
  loop::LatencyRequest latency_;  ///< the main thread's

  // What stands around the tick, in the order in which it is built.
  Hardware hardware_;
  std::optional<store::LinuxFolder> folder_;
  std::optional<store::FieldStore> store_;
  std::optional<store::CalibrationStore> measured_;
  std::optional<store::RunMark> mark_;
  std::optional<control::Calibration> calibration_;
  TraceHeader header_;  ///< of every recording
  Lines lines_;
  std::optional<guard::DeviceGuard> guard_;
  std::unique_ptr<loop::ExchangeThread> exchange_;  ///< either this
  std::unique_ptr<loop::DirectDevice> direct_;      ///< or, in lockstep, this
  std::optional<store::FieldIntake> intake_;
  std::optional<recording::Recorder> recorder_;
  std::optional<control::ControlServer> control_;
  std::optional<loop::Loop> loop_;
  std::optional<loop::MemoryCheck> memory_check_;
  std::optional<RestOnCrash> crash_;

  std::optional<std::latch> asked_;  ///< the threads that have yet to ask for their priority
  std::latch go_{1};
  std::thread exchanges_, watchdogs_, ticks_, records_;

  bool had_device_ = false;                                     ///< one was heard in this run
  bool was_idle_ = false;                                       ///< at the last look; the recorder's thread's
  int ended_by_ = 0;                                            ///< a signal
  bool begins_again_ = false;                                   ///< a new run follows
  bool stopped_late_ = false;                                   ///< a stop came after the last tick
  std::uint64_t answering_ = 0;                                 ///< the device that answers, by the port's count; 0: none
  std::string device_line_, supervisor_line_;                   ///< as said last
  int latency_error_ = 0;                                       ///< the same
  loop::Damage damage_ = loop::Damage::kNone;                   ///< the same
  GuardVerdict verdict_ = GuardVerdict::kNone;                  ///< the same
  std::pair<std::uint32_t, std::uint32_t> judged_delay_{0, 0};  ///< and for which field
};

}  // namespace isotouch::daemon
