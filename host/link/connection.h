/// A byte stream to a controller: its local socket, or ssh as a child process. No port is opened and no cryptography is ours.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "host/link/address.h"
#include "shared/protocol.h"
#include "shared/protocol_messages.h"

namespace isotouch::link {

constexpr int kGreetingMs = 60'000;  ///< until a controller lets in, and until it greets: somebody may have to type a password

class Connection {
 public:
  /// Connects; for a remote controller the program is that of `ssh_program`.
  ///
  /// patience_ms   longest time to wait until the controller lets in, and until it takes a frame; 0 = kGreetingMs, and for ever
  /// is_over       asked ten times a second while the controller is waited for; true: nobody waits for it any more. It alone decides that:
  ///               Ctrl-C and the end of the terminal leave the ssh of a remote controller alone
  /// fails         InputError: what is not there and what to do
  explicit Connection(const Address& address, int patience_ms = 0, std::function<bool()> is_over = {});
  ~Connection();
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  const Address& address() const { return address_; }

  /// What cannot be sent is no failure yet: the controller may have said why, and `receive` reports it.
  ///
  /// fails     InputError: nobody waits any more, or the conversation has ended
  template <class Message>
  void send(protocol::Kind kind, const Message& message) {
    send_frame(protocol::encode(kind, message, frame_));
  }
  void send(protocol::Kind kind) { send_frame(protocol::seal_frame(kind, 0, frame_)); }

  /// The next frame; valid until the next call.
  ///
  /// patience_ms   until the whole frame has come
  /// enough        asked as `is_over` is, besides it
  /// fails         LinkError: the controller is gone, its frame is not there in time, nobody waits any more; InputError: what comes breaks the protocol. The
  ///               conversation has ended then: a frame that comes late would pass for the answer to what is asked next
  protocol::Frame receive(int patience_ms, const std::function<bool()>& enough = {});

  /// What came does not fit what was asked: nobody knows what comes next. Nothing can be sent any more.
  void end_conversation() { has_ended_ = true; }
  bool has_ended() const { return has_ended_; }

  /// Waits at most so long for anything to come, be it a part of a frame.
  bool has_input(int patience_ms = 0);

 private:
  using Clock = std::chrono::steady_clock;

  void send_frame(std::size_t bytes);
  bool wait(short event, Clock::time_point end, const std::function<bool()>& enough = {});
  void read_more();
  [[noreturn]] void complain_of_the_end();

  Address address_;
  int send_patience_ms_;
  std::function<bool()> is_over_;
  Clock::time_point asked_;  ///< whether anybody still waits
  int stream_ = -1;
  pid_t child_ = -1;
  const pid_t owner_;  ///< the process that made this
  std::vector<std::uint8_t> frame_, in_;
  std::size_t in_size_ = 0, used_ = 0;
  bool has_ended_ = false;  ///< what comes may be the answer to something else
  bool broken_ = false;     ///< it takes no more; what it said before may still be read
};

}  // namespace isotouch::link
