#include "hil/falcon_model/ft232r.h"

#include <algorithm>
#include <utility>

#include "hil/falcon_model/baud.h"

namespace isotouch::falcon_model {

namespace {

constexpr std::size_t kBufferBytes = 256;
constexpr std::uint8_t kModemStatus = 0x01, kLineIdle = 0x60;                     // transmitter empty, twice
constexpr std::uint8_t kOverrun = 0x02, kFramingError = 0x08, kFifoError = 0x80;  // of the line status
constexpr std::uint8_t kVendorOut = 0x40, kVendorIn = 0xC0;

std::uint16_t word(std::span<const std::uint8_t, 8> setup, std::size_t at) {
  return static_cast<std::uint16_t>(setup[at] | setup[at + 1] << 8);
}

ControlAnswer answer(Bytes data, std::uint16_t length) {
  if (data.empty()) return {true, {}};
  data.resize(std::min<std::size_t>(data.size(), length));
  return {false, std::move(data)};
}

}  // namespace

void Ft232r::reset() {
  line_ = {};
  latency_ms_ = 16;
  configuration_ = 0;
  errors_ = 0;
  clear();
}

void Ft232r::clear() {
  waiting_.clear();
  breaks_.clear();
  withheld_reads_ = 0;
}

ControlAnswer Ft232r::control(std::span<const std::uint8_t, 8> setup) {
  const std::uint8_t type = setup[0], request = setup[1];
  const std::uint16_t value = word(setup, 2), index = word(setup, 4), length = word(setup, 6);
  if (type == kVendorOut) return vendor_out(request, value, index);
  if (type == kVendorIn) return vendor_in(request, index, length);
  if ((type & 0x60) == 0) return standard(request, value, length);
  return {true, {}};
}

ControlAnswer Ft232r::vendor_out(std::uint8_t request, std::uint16_t value, std::uint16_t index) {
  switch (request) {
    case 0:  // reset, or purge: libftdi found that 1 is the buffer towards the board, always empty here, and 2 the one towards the host
      if (value > 2) return {true, {}};
      if (value == 0) line_.dtr = line_.rts = false;
      if (value != 1) clear();
      return {};
    case 1:  // modem lines: values in the low byte, which of them in the high byte
      if ((value & 0x100) != 0) line_.dtr = (value & 1) != 0;
      if ((value & 0x200) != 0) line_.rts = (value & 2) != 0;
      return {};
    case 2: return {};  // flow control: the board has no lines for it
    case 3: line_.rate = baud_rate(value, index); return {};
    case 4: line_.eight_none_one = (value & 0x7FFF) == 8; return {};
    case 6:
    case 7: return {};  // event and error character: they only choose when a packet is sent
    case 9: latency_ms_ = std::max(1U, value & 0xFFU); return {};
    case 0x0B: return {};  // bit mode
    default: return {true, {}};
  }
}

ControlAnswer Ft232r::vendor_in(std::uint8_t request, std::uint16_t index, std::uint16_t length) {
  switch (request) {
    case 5: return answer({kModemStatus, kLineIdle}, length);
    case 0x0A: return answer({static_cast<std::uint8_t>(latency_ms_)}, length);
    case 0x90: {
      const std::uint16_t memory = memory_words(strings_)[index & 63U];
      return answer({static_cast<std::uint8_t>(memory & 0xFF), static_cast<std::uint8_t>(memory >> 8)}, length);
    }
    default: return {true, {}};
  }
}

ControlAnswer Ft232r::standard(std::uint8_t request, std::uint16_t value, std::uint16_t length) {
  switch (request) {
    case 0: return answer({0, 0}, length);  // status
    case 1:                                 // clear feature: an endpoint's halt
    case 3:
    case 11: return {};  // the one setting of the one interface
    case 6:
      switch (value >> 8) {
        case 1: return answer(device_descriptor(), length);
        case 2: return answer(configuration_descriptor(), length);
        case 3: return answer(string_descriptor(strings_, value & 0xFFU), length);
        default: return {true, {}};
      }
    case 8: return answer({configuration_}, length);
    case 9: configuration_ = static_cast<std::uint8_t>(value & 0xFF); return {};
    case 10: return answer({0}, length);
    default: return {true, {}};
  }
}

void Ft232r::receive(std::span<const std::uint8_t> bytes) {
  const std::size_t fits = std::min(bytes.size(), kBufferBytes - waiting_.size());
  waiting_.insert(waiting_.end(), bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(fits));
  if (fits < bytes.size()) errors_ |= kOverrun;
}

void Ft232r::receive_garbled(std::span<const std::uint8_t> bytes) {
  Bytes garbage;
  for (const std::uint8_t b : bytes) garbage.push_back(static_cast<std::uint8_t>((b * 0x9DU + 0x35U) | 0x80U));
  receive(garbage);
  if (!bytes.empty()) errors_ |= kFramingError | kFifoError;
}

std::array<std::uint8_t, 2> Ft232r::take_status() {
  return {kModemStatus, static_cast<std::uint8_t>(kLineIdle | std::exchange(errors_, std::uint8_t{0}))};
}

Bytes Ft232r::read(std::size_t capacity) {
  Bytes transfer;
  while (transfer.size() + kUsbPacketBytes <= capacity) {
    const auto status = take_status();
    transfer.insert(transfer.end(), status.begin(), status.end());
    if (withheld_reads_ > 0) {
      --withheld_reads_;
      break;
    }
    std::size_t count = std::min(waiting_.size(), kUsbPacketBytes - status.size());
    if (!breaks_.empty()) {
      count = std::min(count, breaks_.front());
      for (std::size_t& at : breaks_) at -= count;
      if (breaks_.front() == 0) breaks_.pop_front();
    }
    const auto end = waiting_.begin() + static_cast<std::ptrdiff_t>(count);
    transfer.insert(transfer.end(), waiting_.begin(), end);
    waiting_.erase(waiting_.begin(), end);
    if (count < kUsbPacketBytes - status.size()) break;
  }
  return transfer;
}

}  // namespace isotouch::falcon_model
