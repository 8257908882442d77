/// The whole device as USB sees it: chip, board, firmware, mechanism and the hand that holds it. It has no clock and no files of its own;
/// a run is a pure function of its settings and of the requests in their order.
///
/// The mechanism moves once per command packet, by a fixed time, whether or not the board hears the packet.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "hil/falcon_model/board.h"
#include "hil/falcon_model/faults.h"
#include "hil/falcon_model/firmware.h"
#include "hil/falcon_model/ft232r.h"
#include "hil/falcon_model/hand.h"
#include "hil/falcon_model/mechanism.h"
#include "hil/falcon_model/reply_wire.h"

namespace isotouch::falcon_model {

struct Settings {
  Strings strings;
  Quirks quirks;
  MechanismSettings mechanism;
  HandSettings hand;
  Path path;                  ///< what the hand does; none: nobody holds the grip
  double step_ms = 1;         ///< of the mechanism, per packet
  double hold_ms = 10;        ///< a torque lasts so long without a new packet
  std::vector<Fault> faults;  ///< ordered by packet
  /// Told of each when it happens: one of a reply with the reply that suffers it.
  std::function<void(const Fault&)> on_fault = [](const Fault&) {};
};

class SimulatedFalcon {
 public:
  /// fails     std::invalid_argument as Mechanism; or steps or hold times that are not positive
  explicit SimulatedFalcon(Settings settings);

  // ---- USB ----

  /// Somebody opens the device. False: it is unplugged, try again.
  bool open();
  bool present() const { return present_; }
  /// The eight setup bytes of a request; an unplugged device stalls.
  ControlAnswer control(std::span<const std::uint8_t, 8> setup);
  /// Bulk out; all bytes are taken while the device is plugged in, the number is returned.
  std::size_t write(std::span<const std::uint8_t> bytes);
  /// Bulk in: one transfer of up to `capacity` bytes, a multiple of 64, status pairs included; empty when unplugged.
  Bytes read(std::size_t capacity);
  /// Whether a read would find more than a bare status pair.
  bool has_data() const { return present_ && !chip_.empty(); }
  /// So much time went by in which the host sent nothing: torques run out, nothing else happens.
  void silence(double ms);

  // ---- what a test may look at ----

  const Ft232r& chip() const { return chip_; }
  const Board& board() const { return board_; }
  const Firmware& firmware() const { return firmware_; }
  const Mechanism& mechanism() const { return mechanism_; }
  const Hand& hand() const { return hand_; }
  std::uint64_t packets() const { return packets_; }
  /// The last packet that asked for torque, heard or not; 0 = none did.
  std::uint64_t last_torque_packet() const { return last_torque_packet_; }
  /// How often the firmware was uploaded.
  int uploads() const { return uploads_; }

 private:
  void take(const CommandPacket& packet);
  void apply_faults();
  void apply(const Fault& fault);
  bool running() const { return board_.state() == Board::State::kRun; }

  Settings settings_;
  Ft232r chip_;
  Board board_;
  Firmware firmware_;
  Mechanism mechanism_;
  Hand hand_;
  ReplyWire wire_;
  PacketScanner scanner_;
  std::uint64_t packets_ = 0, last_torque_packet_ = 0;
  int uploads_ = 0;
  std::size_t next_fault_ = 0;
  int stalled_ = 0;
  int pressed_ = 0;
  int stuck_ = 0;
  std::uint8_t buttons_ = 0;
  bool present_ = true;
  int refusals_ = 0;
};

}  // namespace isotouch::falcon_model
