/// What clients ask of a running controller, and what becomes of it: uploads, state, recordings, settings, stop (SPEC.md, section 6). Who is connected is
/// for `control_server.h`, whose thread calls everything here. Not for the tick; it waits for no disk.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "firmware/control/calibration.h"
#include "firmware/control/control_client.h"
#include "firmware/control/field_reader.h"
#include "firmware/control/field_worker.h"
#include "firmware/control/posture_meter.h"
#include "firmware/control/tick_feed.h"
#include "firmware/control/upload.h"
#include "firmware/control/worst_ticks.h"
#include "firmware/loop/clock.h"
#include "firmware/loop/latest.h"
#include "firmware/loop/requests.h"
#include "firmware/loop/tick_record.h"
#include "firmware/loop/tick_stats.h"
#include "firmware/store/field_intake.h"
#include "shared/files/refusal.h"
#include "shared/protocol.h"
#include "shared/trace.h"

namespace isotouch::control {

/// What the server exchanges with the rest of the program; all of it lives longer.
struct ControlNeighbours {
  store::FieldIntake& fields;
  loop::Requests& requests;
  const loop::TickStats& stats;
  loop::Latest<loop::TickRecord>& shown;  ///< the server is its one reader
  loop::Clock& clock;                     ///< of the machine
  loop::TraceRing* ring = nullptr;        ///< every tick, read by the server alone; nullptr: nothing to watch or record
  Calibration* calibration = nullptr;     ///< nullptr: there is no device to calibrate
  /// Sets a setting by name; returns why not. `may_raise`: beyond the limits of the start. Empty: none may be set
  std::function<Refusal(std::string_view name, std::string_view value, std::uint32_t author, bool may_raise)> set = nullptr;
  /// The settings that differ from their default, see protocol::SettingsReport. Empty: none are told
  std::function<std::string()> different = nullptr;
  /// Gets one line for each change that a client makes: who, and what.
  std::function<void(const std::string&)> log = nullptr;
};

class ControlRequests {
 public:
  /// recordings  device, settings and period of every recording
  /// clients     all places for one; live longer
  /// patience_ns   with an upload that does not get on
  ControlRequests(const TraceHeader& recordings, const ControlNeighbours& neighbours, std::span<ControlClient> clients,
                  std::int64_t patience_ns);

  /// Does what is asked, and answers or promises to: a client that waits for the field worker is marked so. The client has room for an answer.
  void answer(ControlClient& client, const protocol::Frame& frame);

  /// Is this request to be answered later, because the field worker is at work?
  bool must_wait(const protocol::Frame& frame) const;

  /// Answers whatever has ended meanwhile, and hands ticks to those who watch.
  ///
  /// returns   true: somebody watches or is being measured; call again soon
  bool go_on();

  /// A connection has ended, for whatever reason: what it had begun is void.
  void forget(const ControlClient& client);

  bool is_sending(const ControlClient& client) const { return upload_.is_from(client); }
  bool sends_too_slowly(const ControlClient& client) const { return upload_.is_too_slow(client, neighbours_.clock.now_ns()); }
  bool is_working() const { return !worker_.is_idle(); }
  /// Somebody records, sends a field, is being measured, or waits for the field worker.
  bool is_in_use() const;
  /// The place among the clients of whoever had the worker last.
  std::size_t last_worked_for() const { return last_worked_for_; }
  /// Readable when `go_on` has something to answer; for poll.
  int bell() const { return worker_.bell(); }

 private:
  bool may(ControlClient& client, protocol::Kind request, protocol::Role wanted);
  void log(std::uint32_t user, const std::string& change) const;
  void commit(ControlClient& client);
  void read_image(ControlClient& client, const protocol::ReadImage& wanted);
  void start_work(ControlClient& client, FieldWork::Kind kind, const protocol::Begin& field);
  void await(ControlClient& client);
  void finish_work();
  void log_done(const FieldDone& done) const;
  void set(ControlClient& client, const protocol::Set& wanted);
  void settings(ControlClient& client);
  void histogram(ControlClient& client, std::uint8_t measure);
  void worst(ControlClient& client, bool anew);
  void begin_recording(ControlClient& client);
  void measure(ControlClient& client);
  void finish_measuring();
  void calibrate(ControlClient& client, const protocol::Calibrate& measured);

  TraceHeader recordings_;
  ControlNeighbours neighbours_;
  std::span<ControlClient> clients_;
  TickFeed feed_;
  FieldWorker worker_;
  ControlClient* awaiting_ = nullptr;  ///< whoever asked for the work under way; nullptr: has gone
  std::size_t last_worked_for_;        ///< place of the client; at first the last one
  Upload upload_;
  FieldReader reader_;
  ControlClient* measuring_ = nullptr;  ///< whoever asked where the arms stand; nullptr: nobody, or has gone
  std::int64_t measured_by_ns_ = 0;     ///< else the loop does not run
  PostureMeter posture_;
  WorstTicks worst_;
  std::vector<std::uint8_t> scratch_;
};

}  // namespace isotouch::control
