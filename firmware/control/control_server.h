/// What host tools ask of a running controller: uploads, state, recordings, stop (SPEC.md, section 6). One thread with ordinary priority and one poll;
/// with the tick it shares only slots, rings and atomics, so that nothing a client does or leaves undone can delay a tick.
#pragma once

#include <poll.h>
#include <sys/types.h>

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "firmware/control/calibration.h"
#include "firmware/control/control_client.h"
#include "firmware/control/control_socket.h"
#include "firmware/control/field_worker.h"
#include "firmware/control/peer.h"
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

namespace isotouch::control {

struct ControlSettings {
  std::string path;                           ///< of the socket
  mode_t mode = 0660;                         ///< of the socket's file
  std::optional<gid_t> group;                 ///< of the socket's file
  Admission admission;                        ///< who may come in, and what for
  std::string program;                        ///< name and version, for people
  TraceHeader recordings;                     ///< device, settings and period of every recording
  std::size_t clients = 8;                    ///< at once; one place more is kept for whoever wants to stop
  std::int64_t patience_ns = 10'000'000'000;  ///< with a client that stops in the middle of something, or does not complete its greeting
  std::function<Peer(int)> peer = peer_of;    ///< who is at the other end; a seam for tests
};

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

class ControlServer {
 public:
  ControlServer(ControlSettings settings, const ControlNeighbours& neighbours);
  /// As `stop`.
  ~ControlServer();
  ControlServer(const ControlServer&) = delete;
  ControlServer& operator=(const ControlServer&) = delete;

  /// Listens and starts the thread.
  ///
  /// returns   why it does not run
  Refusal start();

  /// Closes every connection and joins the thread. An upload that is being checked is finished first.
  void stop();

 private:
  void run();
  bool wait(bool busy);
  void admit();
  std::string full() const;
  void turn_away(int socket, const Peer& peer, const Refusal& refusal);
  bool is_for_stop(const ControlClient& client) const { return &client == &clients_.back(); }
  void serve(ControlClient& client);
  bool may(ControlClient& client, protocol::Kind request, protocol::Role wanted);
  void log(std::uint32_t user, const std::string& change) const;
  bool must_wait(const protocol::Frame& frame) const;
  void answer(ControlClient& client, const protocol::Frame& frame);
  void hello(ControlClient& client, const protocol::Frame& frame) const;
  void commit(ControlClient& client);
  void start_work(ControlClient& client, FieldWork::Kind kind, const protocol::Begin& field);
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
  void forget(ControlClient& client);
  void dismiss_the_idle();

  ControlSettings settings_;
  ControlNeighbours neighbours_;
  ControlSocket socket_;
  std::vector<ControlClient> clients_;  ///< the last place is for a stop, when all others are taken
  ControlClient stranger_;              ///< whoever is told why not, and goes
  std::int64_t deaf_until_ns_ = 0;      ///< nobody is let in before: there were no file handles
  std::vector<pollfd> polled_;
  TickFeed feed_;
  FieldWorker worker_;
  ControlClient* awaiting_ = nullptr;  ///< whoever asked for the work under way; nullptr: has gone
  Upload upload_;
  ControlClient* measuring_ = nullptr;  ///< whoever asked where the arms stand; nullptr: nobody, or has gone
  std::int64_t measured_by_ns_ = 0;     ///< else the loop does not run
  PostureMeter posture_;
  WorstTicks worst_;
  std::vector<std::uint8_t> scratch_;
  int bell_ = -1;  ///< rung by `stop`
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

}  // namespace isotouch::control
