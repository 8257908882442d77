#include "hil/falcon_model/simulated_falcon.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "hil/falcon_model/baud.h"

namespace isotouch::falcon_model {

namespace {

constexpr double kRunRate = 1.5e6;

int packets_in(double ms, double step_ms) {
  if (!(step_ms > 0) || !(ms > 0)) throw std::invalid_argument("the time of a step and the time a torque is held must be positive");
  return static_cast<int>(std::ceil(std::min(ms / step_ms, 1e6)));
}

}  // namespace

SimulatedFalcon::SimulatedFalcon(Settings settings)
    : settings_(std::move(settings)),
      chip_(settings_.strings),
      board_(settings_.quirks),
      firmware_(settings_.quirks, packets_in(settings_.hold_ms, settings_.step_ms)),
      mechanism_(settings_.mechanism),
      hand_(settings_.hand, settings_.path) {
  firmware_.start(mechanism_.counts());
  apply_faults();
}

bool SimulatedFalcon::open() {
  if (present_) return true;
  if (refusals_-- > 0) return false;
  present_ = true;
  chip_.reset();
  board_.set_dtr(false);
  scanner_.clear();
  wire_.clear();
  if (settings_.quirks.forgets_on_unplug) board_.lose_firmware();
  return true;
}

ControlAnswer SimulatedFalcon::control(std::span<const std::uint8_t, 8> setup) {
  if (!present_) return {true, {}};
  ControlAnswer answer = chip_.control(setup);
  board_.set_dtr(chip_.line().dtr);
  if (settings_.quirks.stale_status) chip_.withhold(1);
  return answer;
}

std::size_t SimulatedFalcon::write(std::span<const std::uint8_t> bytes) {
  std::size_t taken = 0;
  for (const std::uint8_t byte : bytes) {
    if (!present_) break;
    ++taken;
    const Board::State before = board_.state();
    const Board::Answer answer = board_.receive(byte, chip_.line());
    if (answer.garbled) {
      chip_.receive_garbled(answer.bytes);
    } else {
      chip_.receive(answer.bytes);
    }
    if (running() && before != Board::State::kRun) {
      ++uploads_;
      firmware_.start(mechanism_.counts());
    }
    if (!chip_.line().eight_none_one || !same_rate(chip_.line().rate, kRunRate)) continue;
    if (const auto packet = scanner_.push(byte)) take(*packet);
  }
  return taken;
}

Bytes SimulatedFalcon::read(std::size_t capacity) { return present_ ? chip_.read(capacity) : Bytes{}; }

void SimulatedFalcon::silence(double ms) { firmware_.miss(packets_in(ms, settings_.step_ms)); }

/// The reply tells of the moment of receipt; then the new commands move the mechanism.
void SimulatedFalcon::take(const CommandPacket& packet) {
  ++packets_;
  if (packet.motors != CommandPacket{}.motors) last_torque_packet_ = packets_;
  apply_faults();
  const bool heard = present_ && running() && stalled_ == 0;
  if (heard) {
    const std::uint8_t buttons = pressed_ > 0 ? buttons_ : std::uint8_t{0};
    for (const Fault& fault : wire_.orders()) settings_.on_fault(fault);
    wire_.send(encode_reply(firmware_.take(packet, mechanism_.counts(), buttons)), chip_);
  } else {
    firmware_.miss();
  }
  if (stalled_ > 0) --stalled_;
  if (pressed_ > 0) --pressed_;
  if (stuck_ > 0 && --stuck_ == 0) firmware_.stick(0, {});
  hand_.advance(settings_.step_ms, mechanism_.position_mm(), running() && firmware_.homed() == 7);
  const Commands commands = running() ? firmware_.commands() : Commands{};
  mechanism_.step(settings_.step_ms, commands, [&](const Vector& p, const Vector& v) { return hand_.force_n(p, v); });
}

void SimulatedFalcon::apply_faults() {
  for (; next_fault_ < settings_.faults.size() && settings_.faults[next_fault_].packet <= packets_; ++next_fault_) {
    apply(settings_.faults[next_fault_]);
  }
}

void SimulatedFalcon::apply(const Fault& fault) {
  const auto [first, second] = fault.arguments;
  switch (fault.kind) {
    case FaultKind::kStall: stalled_ = first; break;
    case FaultKind::kButtons:
      buttons_ = static_cast<std::uint8_t>(first);
      pressed_ = second;
      break;
    case FaultKind::kUnplug:
      present_ = false;
      refusals_ = first;
      break;
    case FaultKind::kFirmwareLost: board_.lose_firmware(); break;
    case FaultKind::kHomingLost: firmware_.lose_homing(mechanism_.counts()); break;
    case FaultKind::kEncoderJump: firmware_.jump(static_cast<std::size_t>(first), second); break;
    case FaultKind::kEncoderStuck:
      firmware_.stick(static_cast<std::uint8_t>(first), mechanism_.counts());
      stuck_ = second;
      break;
    case FaultKind::kNoWallPower: board_.set_power(false); break;
    case FaultKind::kWallPower: board_.set_power(true); break;
    default: wire_.order(fault); return;
  }
  settings_.on_fault(fault);
}

}  // namespace isotouch::falcon_model
