/// The board from power on until its firmware runs: the controller that answers the handshake, and the processor's boot loader that echoes an upload.
///
///   COLD   ── DTR rises ──►  PIC     (from any state)
///   PIC    ── DTR falls ──►  COLD
///   COLD   ── 'A' ───────►  UPLOAD  (its rate is taken)
///   UPLOAD ── container complete ──►  RUN
#pragma once

#include <cstdint>

#include "hil/falcon_model/container.h"
#include "hil/falcon_model/ft232r.h"
#include "hil/falcon_model/quirks.h"

namespace isotouch::falcon_model {

class Board {
 public:
  enum class State { kCold, kPic, kUpload, kRun };

  /// What a byte from the host is answered with.
  struct Answer {
    Bytes bytes;
    bool garbled = false;  ///< sent at another rate than the host's
  };

  explicit Board(const Quirks& quirks);

  State state() const { return powered_ ? state_ : State::kCold; }
  bool powered() const { return powered_; }

  void set_dtr(bool high);
  /// One byte from the host, in every state; running firmware takes packets elsewhere and only garbage is answered here.
  Answer receive(std::uint8_t byte, const Line& line);

  void lose_firmware();
  void set_power(bool on);

 private:
  Answer handshake(std::uint8_t byte);
  Answer upload(std::uint8_t byte);
  bool audible(const Line& line) const;

  Quirks quirks_;
  State state_;
  bool powered_;
  bool dtr_ = false;
  double locked_rate_ = 0;
  Container container_;
  std::uint32_t handshake_ = 0;  ///< the last bytes of it
  int uploaded_bytes_ = 0;
  int unheard_bytes_ = 0;
  bool spoiled_ = false;  ///< this upload is one of those that fail
};

const char* name_of(Board::State state);

}  // namespace isotouch::falcon_model
