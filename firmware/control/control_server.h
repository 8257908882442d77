/// Who is connected to a running controller (SPEC.md, section 6): lets clients in, takes their frames in order, and sends them away. One thread with
/// ordinary priority and one poll; with the tick it shares only slots, rings and atomics, so that nothing a client does or leaves undone can delay a tick.
/// What is asked is for `control_requests.h`.
#pragma once

#include <poll.h>
#include <sys/types.h>

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include "firmware/control/control_client.h"
#include "firmware/control/control_requests.h"
#include "firmware/control/control_socket.h"
#include "firmware/control/peer.h"
#include "shared/files/refusal.h"

namespace isotouch::control {

/// poll(2) itself.
inline int poll_of_the_system(std::span<pollfd> polled, int wait_ms) { return ::poll(polled.data(), polled.size(), wait_ms); }

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
  std::function<int(std::span<pollfd>, int wait_ms)> poll = poll_of_the_system;  ///< as poll(2); a seam for tests
};

class ControlServer {
 public:
  ControlServer(ControlSettings settings, const ControlNeighbours& neighbours);
  /// As `stop`; then waits for the end of what the field worker does.
  ~ControlServer();
  ControlServer(const ControlServer&) = delete;
  ControlServer& operator=(const ControlServer&) = delete;

  /// From now on clients may connect, and wait.
  ///
  /// returns   why they may not
  Refusal listen();
  /// Lets them in and answers: starts the thread. Not before there is a tick, or they would hear of a state that never was.
  void serve();
  /// Both at once.
  Refusal start();

  /// Closes every connection and joins the thread. What the field worker does goes on: an upload that is being checked is not waited for.
  void stop();

  /// The end would cut off what a client began: it records, sends a field, or has yet to get its answer. Watching does not count. Any thread.
  bool is_in_use() const { return in_use_; }

 private:
  void run();
  std::int64_t turn_end_ns() const;
  bool wait(bool busy);
  void admit();
  std::string full() const;
  void turn_away(int socket, const Peer& peer, const Refusal& refusal);
  bool is_for_stop(const ControlClient& client) const { return &client == &clients_.back(); }
  void serve(ControlClient& client);
  void answer(ControlClient& client, const protocol::Frame& frame);
  void hello(ControlClient& client, const protocol::Frame& frame) const;
  void forget(ControlClient& client);
  bool waits_for_worker(const ControlClient& client) const;
  void dismiss_the_idle();

  ControlSettings settings_;
  ControlNeighbours neighbours_;
  ControlSocket socket_;
  std::vector<ControlClient> clients_;  ///< the last place is for a stop, when all others are taken
  ControlClient stranger_;              ///< whoever is told why not, and goes
  std::int64_t deaf_until_ns_ = 0;      ///< nobody is let in before: there were no file handles
  std::vector<pollfd> polled_;
  ControlRequests requests_;
  int bell_ = -1;  ///< rung by `stop`
  std::atomic<bool> stop_{false}, in_use_{false};
  std::thread thread_;
};

}  // namespace isotouch::control
