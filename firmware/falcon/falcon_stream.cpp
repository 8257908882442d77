#include "firmware/falcon/falcon_stream.h"

namespace isotouch::falcon {

namespace {
constexpr std::uint8_t kBegin = '<', kEnd = '>';
}

std::size_t FalconStream::feed(std::span<std::uint8_t> transfer) {
  const std::size_t data = ft232::strip_status(transfer, counts_.line);
  if (data == 0) return 0;
  begun_earlier_ = size_ > 0;
  std::size_t replies = 0;
  for (const std::uint8_t byte : transfer.first(data)) {
    if (!take(byte)) continue;
    counts_.split += begun_earlier_ ? 1U : 0U;
    counts_.merged += replies > 0 ? 1U : 0U;
    begun_earlier_ = false;
    ++replies;
  }
  counts_.replies += replies;
  return replies;
}

/// Adds one byte; true when it completes a valid reply.
bool FalconStream::take(std::uint8_t byte) {
  if (byte == kBegin) {
    counts_.cut += size_ > 0 ? 1U : 0U;
    begun_earlier_ = false;
    packet_[0] = byte;
    size_ = 1;
    return false;
  }
  if (size_ == 0) {
    ++counts_.skipped;
    return false;
  }
  packet_[size_++] = byte;
  if (byte != kEnd && size_ < packet_.size()) return false;
  const bool whole = size_ == packet_.size();
  size_ = 0;
  if (!whole) {
    ++counts_.cut;
    return false;
  }
  const Result<FalconReply> reply = decode_reply(packet_);
  if (!reply) {
    ++counts_.corrupt;
    return false;
  }
  newest_ = *reply;
  newest_packet_ = packet_;
  return true;
}

void FalconStream::restart() {
  size_ = 0;
  begun_earlier_ = false;
}

}  // namespace isotouch::falcon
