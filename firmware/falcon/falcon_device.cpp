#include "firmware/falcon/falcon_device.h"

#include <algorithm>

namespace isotouch::falcon {

namespace {

constexpr std::int16_t kMaxWord = 4095;
constexpr int kSuspectFor = 8;  // a late reply is at most some milliseconds late
constexpr int kEmptyPackets = 4;
constexpr int kRestPackets = 3;
constexpr std::uint32_t kWriteMs = 5;
constexpr std::int64_t kMs = 1'000'000;

}  // namespace

bool is_echo(const FalconReply& reply, const FalconCommand& command) {
  return reply.counts == command.words && reply.buttons == command.flags && reply.homed == 0;
}

FalconDevice::FalconDevice(FalconLink& link, loop::Clock& clock, const DeviceSettings& settings)
    : link_(link), clock_(clock), settings_(settings) {
  begin();
}

void FalconDevice::begin() {
  stream_.restart();
  silent_ = 0;
  suspect_ = kSuspectFor;
  gone_ = false;
}

Exchange FalconDevice::exchange(const FalconCommand& command) {
  ++counts_.exchanges;
  if (suspect_ > 0) drain();
  Exchange result;
  result.rested = silent_ > 0;
  FalconCommand sent = {{}, command.flags};
  for (std::size_t i = 0; i < sent.words.size() && !result.rested; ++i) {
    sent.words[i] = std::clamp<std::int16_t>(command.words[i], -kMaxWord, kMaxWord);
  }
  counts_.clamped += !result.rested && sent.words != command.words ? 1U : 0U;
  result.fresh = send(sent) && await_reply();
  if (result.fresh && is_echo(stream_.newest(), sent)) {
    ++counts_.echoes;
    result.fresh = false;
  }
  if (result.fresh) {
    last_ = stream_.newest();
    last_packet_ = stream_.newest_packet();
    silent_ = 0;
    suspect_ = std::max(suspect_ - 1, 0);
  } else {
    ++counts_.timeouts;
    ++silent_;
    suspect_ = kSuspectFor;
  }
  result.reply = last_;
  result.packet = last_packet_;
  result.lost = gone_ || silent_ >= settings_.lost_after;
  return result;
}

void FalconDevice::rest() {
  gone_ = false;  // one that is gone refuses the first packet
  for (int i = 0; i < kRestPackets && !gone_; ++i) {
    if (send({})) await_reply();
  }
}

DeviceCounts FalconDevice::counts() const {
  DeviceCounts counts = counts_;
  counts.stream = stream_.counts();
  return counts;
}

bool FalconDevice::send(const FalconCommand& command) {
  const FalconPacket packet = encode(command);
  const LinkResult<std::size_t> taken = link_.write(packet, kWriteMs);
  if (!taken && taken.error() == LinkError::kGone) gone_ = true;
  return taken && *taken == packet.size();
}

/// One transfer, if one comes in time; returns how many replies ended in it.
std::size_t FalconDevice::hear(std::uint32_t timeout_ms) {
  std::array<std::uint8_t, kUsbPacket> buffer{};
  const LinkResult<std::size_t> size = link_.read(buffer, timeout_ms);
  empty_ = !size || *size <= 2;
  if (!size && size.error() == LinkError::kGone) gone_ = true;
  return size ? stream_.feed(std::span(buffer).first(*size)) : 0;
}

/// Takes what came after its time off the link, so that it is not taken for the answer to the next packet.
void FalconDevice::drain() {
  for (int empty = 0; empty < kEmptyPackets && !gone_; empty += empty_ ? 1 : 0) counts_.late += hear(0);
}

bool FalconDevice::await_reply() {
  const std::int64_t until = clock_.now_ns() + settings_.reply_ns;
  for (std::int64_t left = settings_.reply_ns; left > 0 && !gone_; left = until - clock_.now_ns()) {
    const std::size_t replies = hear(static_cast<std::uint32_t>((left + kMs - 1) / kMs));
    if (replies == 0) continue;
    if (replies > 1) {
      counts_.late += replies - 1;
      suspect_ = kSuspectFor;
    }
    return true;
  }
  return false;
}

}  // namespace isotouch::falcon
