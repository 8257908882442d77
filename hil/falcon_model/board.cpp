#include "hil/falcon_model/board.h"

#include "hil/falcon_model/baud.h"

namespace isotouch::falcon_model {

namespace {

constexpr double kHandshakeRate = 9600, kRunRate = 1.5e6;
constexpr double kFastestAutobaud = 1e6;  // beyond, the boot loader cannot time an 'A'; assumed
constexpr std::uint32_t kHandshake = 0x0A430D;
constexpr int kSpoiledByte = 100;
constexpr int kUnheardPerGarbage = 4;  // at a wrong rate several bytes look like one

}  // namespace

const char* name_of(Board::State state) {
  constexpr const char* kNames[] = {"COLD", "PIC", "UPLOAD", "RUN"};
  return kNames[static_cast<int>(state)];
}

Board::Board(const Quirks& quirks)
    : quirks_(quirks),
      state_(quirks.firmware_loaded && !quirks.no_wall_power ? State::kRun : State::kCold),
      powered_(!quirks.no_wall_power) {}

void Board::set_dtr(bool high) {
  if (high && !dtr_) {
    state_ = State::kPic;
    handshake_ = 0;
  } else if (!high && dtr_ && state_ == State::kPic) {
    state_ = State::kCold;
  }
  dtr_ = high;
}

void Board::lose_firmware() { state_ = dtr_ ? State::kPic : State::kCold; }

void Board::set_power(bool on) {
  powered_ = on;
  if (!on) lose_firmware();
}

bool Board::audible(const Line& line) const {
  const double rate = state_ == State::kPic      ? kHandshakeRate
                      : state_ == State::kUpload ? locked_rate_
                      : state_ == State::kRun    ? kRunRate
                                                 : line.rate;
  return line.eight_none_one && same_rate(line.rate, rate);
}

Board::Answer Board::receive(std::uint8_t byte, const Line& line) {
  if (!powered_) return {};
  if (!audible(line)) {
    if (state_ == State::kCold || quirks_.silent_on_wrong_rate || ++unheard_bytes_ % kUnheardPerGarbage != 0) return {};
    return {{byte}, true};
  }
  switch (state_) {
    case State::kCold: {
      const bool letter = byte == 'A' || byte == 'a';
      if (!letter || (line.rate > kFastestAutobaud && !quirks_.mislock)) return {};
      state_ = State::kUpload;
      locked_rate_ = line.rate;
      container_ = {};
      uploaded_bytes_ = 0;
      spoiled_ = quirks_.fail_uploads > 0;
      if (spoiled_) --quirks_.fail_uploads;
      if (quirks_.stray_13) return {{0x13, byte}};
      return {{byte}};
    }
    case State::kPic: return handshake(byte);
    case State::kUpload: return upload(byte);
    case State::kRun: return {};
  }
  return {};
}

Board::Answer Board::handshake(std::uint8_t byte) {
  handshake_ = (handshake_ << 8 | byte) & 0xFFFFFF;
  if (handshake_ != kHandshake) return {};
  if (quirks_.fail_handshakes > 0) {
    --quirks_.fail_handshakes;
    return {};
  }
  if (quirks_.leading_zero) return {{0x00, 0x0A, 0x44, 0x2C, 0x0D}};
  return {{0x0A, 0x44, 0x2C, 0x0D}};
}

Board::Answer Board::upload(std::uint8_t byte) {
  const bool spoil = spoiled_ && uploaded_bytes_ >= kSpoiledByte - 1;
  ++uploaded_bytes_;
  if (container_.push(byte) == Container::State::kComplete && !spoiled_) state_ = State::kRun;
  return {{static_cast<std::uint8_t>(spoil ? byte ^ 0x10 : byte)}};
}

}  // namespace isotouch::falcon_model
