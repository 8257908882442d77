/// The USB side of the chip between host and board: control requests, line settings, and the buffer towards the host with its status bytes.
///
/// It has no clock: what waits in the buffer is handed over at the next read, and with nothing there a read finds what the latency timer
/// would send, a bare status pair. When that falls due is the face's business.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <deque>
#include <span>
#include <utility>

#include "hil/falcon_model/descriptors.h"

namespace isotouch::falcon_model {

struct ControlAnswer {
  bool stalled = false;  ///< the device does not know the request
  Bytes data;            ///< device-to-host requests only, cut to wLength

  friend bool operator==(const ControlAnswer&, const ControlAnswer&) = default;
};

/// What the chip sends and expects on the line to the board.
struct Line {
  double rate = 9600;
  bool eight_none_one = true;  ///< 8 data bits, no parity, 1 stop bit
  bool dtr = false;
  bool rts = false;
};

class Ft232r {
 public:
  explicit Ft232r(Strings strings) : strings_(std::move(strings)) {}

  /// Plugged in again: as after power on.
  void reset();

  /// One request with its eight setup bytes.
  ControlAnswer control(std::span<const std::uint8_t, 8> setup);

  const Line& line() const { return line_; }
  const Strings& strings() const { return strings_; }
  unsigned latency_ms() const { return latency_ms_; }
  bool empty() const { return waiting_.empty() && breaks_.empty(); }
  /// Whether a whole USB packet waits: that does not wait for the latency timer.
  bool fills_packet() const { return waiting_.size() >= kUsbPacketBytes - 2; }

  /// Bytes from the board. What does not fit 256 bytes is lost, and the status says "overrun".
  void receive(std::span<const std::uint8_t> bytes);
  /// Bytes from the board at a rate that the chip is not set to.
  void receive_garbled(std::span<const std::uint8_t> bytes);
  /// What was received from now on travels in another USB packet than what was received before.
  void split() { breaks_.push_back(waiting_.size()); }

  /// One bulk-in transfer of up to `capacity` bytes, a multiple of 64: it ends full or with a packet of fewer than 64 bytes.
  Bytes read(std::size_t capacity);
  /// The next so many reads find a bare status pair although bytes wait.
  void withhold(int reads) { withheld_reads_ = std::max(withheld_reads_, reads); }

 private:
  ControlAnswer standard(std::uint8_t request, std::uint16_t value, std::uint16_t length);
  ControlAnswer vendor_out(std::uint8_t request, std::uint16_t value, std::uint16_t index);
  ControlAnswer vendor_in(std::uint8_t request, std::uint16_t index, std::uint16_t length);
  void clear();
  std::array<std::uint8_t, 2> take_status();

  Strings strings_;
  Line line_;
  unsigned latency_ms_ = 16;
  std::uint8_t errors_ = 0;  ///< of the line status, until they are sent
  std::deque<std::uint8_t> waiting_;
  std::deque<std::size_t> breaks_;  ///< after so many waiting bytes a USB packet ends
  int withheld_reads_ = 0;
  std::uint8_t configuration_ = 0;
};

}  // namespace isotouch::falcon_model
