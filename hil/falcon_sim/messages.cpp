#include "hil/falcon_sim/messages.h"

#include <algorithm>
#include <string>

namespace isotouch::falcon_sim {

namespace {

constexpr std::size_t kSetupBytes = 8;

std::uint32_t number(std::span<const std::uint8_t> bytes) {
  std::uint32_t value = 0;
  for (std::size_t i = bytes.size(); i-- > 0;) value = value << 8 | bytes[i];
  return value;
}

Bytes message_of(char kind, Status status, const Bytes& data) {
  Bytes bytes(2 + data.size());
  bytes[0] = static_cast<std::uint8_t>(kind);
  bytes[1] = status;
  std::copy(data.begin(), data.end(), bytes.begin() + 2);
  return bytes;
}

Bytes describe(const falcon_model::Strings& strings) {
  Bytes bytes{'d'};
  for (const std::uint8_t b : falcon_model::device_descriptor()) bytes.push_back(b);
  for (const std::string& text : {strings.manufacturer, strings.product, strings.serial}) {
    bytes.push_back(static_cast<std::uint8_t>(text.size()));
    for (const char c : text) bytes.push_back(static_cast<std::uint8_t>(c));
  }
  return bytes;
}

}  // namespace

std::optional<ReadRequest> parse_read(std::span<const std::uint8_t> message) {
  if (message.size() != 7 || message[0] != 'I') return std::nullopt;
  const std::size_t capacity = number(message.subspan(1, 2));
  if (capacity == 0 || capacity % falcon_model::kUsbPacketBytes != 0) return std::nullopt;
  return ReadRequest{capacity, number(message.subspan(3, 4))};
}

Bytes answer(std::span<const std::uint8_t> message, PacedDevice& device, Time now) {
  falcon_model::SimulatedFalcon& falcon = device.falcon();
  if (message.empty() || message.size() > kMaxMessage) return {};
  const auto body = message.subspan(1);
  switch (message[0]) {
    case 'D': return body.empty() ? describe(falcon.chip().strings()) : Bytes{};
    case 'C': {
      if (body.size() != kSetupBytes) return {};
      const falcon_model::ControlAnswer control = falcon.control(body.first<kSetupBytes>());
      return message_of('c', control.stalled ? kStalled : kOk, control.data);
    }
    case 'O': {
      if (body.empty()) return {};
      const std::size_t accepted = device.write(body, now);
      return {'o', falcon.present() ? kOk : kGone, static_cast<std::uint8_t>(accepted & 0xFF), static_cast<std::uint8_t>(accepted >> 8)};
    }
    default: return {};
  }
}

Bytes read_answer(Status status, const Bytes& data) { return message_of('i', status, data); }

bool says_gone(const Bytes& answer) { return answer.size() >= 2 && (answer[0] == 'i' || answer[0] == 'o') && answer[1] == kGone; }

}  // namespace isotouch::falcon_sim
