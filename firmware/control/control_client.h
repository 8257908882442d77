/// One connection to the control server: bytes that came and are not yet a frame, bytes that wait to be taken. All memory is there from the start;
/// what does not fit waits in the sender.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "firmware/control/peer.h"
#include "shared/protocol.h"
#include "shared/protocol_messages.h"

namespace isotouch::control {

class ControlClient {
 public:
  ControlClient() : in_(protocol::kMaxFrame), out_(kOut) {}
  ~ControlClient() { close(); }
  ControlClient(const ControlClient&) = delete;
  ControlClient& operator=(const ControlClient&) = delete;

  void open(int socket, const Peer& peer, protocol::Role role, std::int64_t now_ns);
  void close();
  bool is_open() const { return socket_ >= 0; }
  int socket() const { return socket_; }

  /// Reads what is there and fits. returns false: the other side has closed, or broke
  bool receive(std::int64_t now_ns);
  /// The first frame of what has come; size 0 when there is none yet.
  Result<protocol::Frame> frame() const { return protocol::read_frame(std::span(in_).first(in_size_)); }
  /// Forgets the first frame.
  void drop(std::size_t bytes, std::int64_t now_ns);

  /// True when any frame would fit and leave room for a refusal.
  bool has_room() const { return out_.size() - (out_end_ - out_begin_) >= 2 * protocol::kMaxFrame; }
  /// Only with room.
  template <class Message>
  void say(protocol::Kind kind, const Message& message) {
    out_end_ += protocol::encode(kind, message, room());
  }
  void say(protocol::Kind kind) { out_end_ += protocol::seal_frame(kind, 0, room()); }
  /// What was asked for is not done, or no longer, and why. Needs no room after what was said with room.
  void refuse(protocol::Kind request, std::string_view sentence);
  /// Hands over as much as the other side takes. returns false: it broke
  bool send(std::int64_t now_ns);
  bool has_unsent() const { return out_begin_ != out_end_; }
  bool has_unread() const { return in_size_ > 0; }
  bool wants_more() const { return in_size_ < in_.size(); }

  protocol::Role role = protocol::Role::kNone;
  std::uint32_t user = 0;
  bool greeted = false;
  bool waiting = false;  ///< for the field worker: nothing further is read from it meanwhile
  bool leaving = false;  ///< to be closed as soon as it was told why
  std::int64_t opened_ns = 0;
  std::int64_t moved_ns = 0;  ///< when a frame last began or ended, or bytes were taken: a frame has one deadline, however slowly it comes
  std::uint32_t every = 0;    ///< subscription to ticks; 0 = none
  bool records = false;       ///< has the recording
  std::uint64_t lost = 0;     ///< records not sent since the subscription began
  std::uint32_t ring_lost = 0;  ///< what the ring had lost then

 private:
  static constexpr std::size_t kOut = 5 * protocol::kMaxFrame;
  std::span<std::uint8_t> room();

  int socket_ = -1;
  std::vector<std::uint8_t> in_, out_;
  std::size_t in_size_ = 0, out_begin_ = 0, out_end_ = 0;
};

}  // namespace isotouch::control
