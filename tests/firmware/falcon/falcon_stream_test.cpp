#include "firmware/falcon/falcon_stream.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tests/support/random.h"

namespace isotouch::falcon {
namespace {

using Bytes = std::vector<std::uint8_t>;
using test::Random;

Bytes packet_of(const FalconReply& reply) {
  const FalconPacket packet = encode(reply);
  return {packet.begin(), packet.end()};
}

/// 0 to count − 1.
std::size_t below(Random& random, std::size_t count) { return static_cast<std::size_t>(random.bits() % count); }

FalconReply random_reply(Random& random) {
  FalconReply reply;
  for (std::int16_t& count : reply.counts) count = static_cast<std::int16_t>(random.bits());
  reply.buttons = random.bits() & 0x0FU;
  reply.homed = random.bits() & 0x07U;
  return reply;
}

/// Data as the chip sends it: at most 62 bytes behind each status pair.
Bytes transfer_of(const Bytes& data) {
  Bytes transfer;
  for (std::size_t at = 0; at < data.size() || at == 0; at += 62) {
    transfer.insert(transfer.end(), {0x01, 0x60});
    transfer.insert(transfer.end(), data.begin() + static_cast<std::ptrdiff_t>(at),
                    data.begin() + static_cast<std::ptrdiff_t>(std::min(at + 62, data.size())));
  }
  return transfer;
}

std::size_t feed(FalconStream& stream, const Bytes& data) {
  Bytes transfer = transfer_of(data);
  return stream.feed(transfer);
}

Bytes operator+(Bytes a, const Bytes& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

Bytes part(const Bytes& bytes, std::size_t from, std::size_t to) {
  return {bytes.begin() + static_cast<std::ptrdiff_t>(from), bytes.begin() + static_cast<std::ptrdiff_t>(to)};
}

TEST(FalconStream, AReplyInOneTransferIsRead) {
  Bytes golden = {0x01, 0x60, 0x3c, 0x4d, 0x50, 0x4e, 0x50, 0x4d, 0x50, 0x4e, 0x50, 0x4d, 0x50, 0x4e, 0x50, 0xb1, 0x41, 0x3e};
  FalconStream stream;
  EXPECT_EQ(stream.feed(golden), 1U);
  EXPECT_EQ(stream.newest(), (FalconReply{{-516, -516, -516}, 0, 7}));
  EXPECT_EQ(stream.counts().replies, 1U);
  EXPECT_EQ(stream.counts().split + stream.counts().merged + stream.counts().cut + stream.counts().corrupt + stream.counts().skipped, 0U);
}

TEST(FalconStream, AReplyMayBeSplitAnywhereWithEmptyPacketsBetween) {
  Random random(1);
  for (std::size_t cut = 1; cut < 16; ++cut) {
    FalconStream stream;
    const FalconReply reply = random_reply(random);
    const Bytes packet = packet_of(reply);
    EXPECT_EQ(feed(stream, part(packet, 0, cut)), 0U);
    EXPECT_EQ(feed(stream, {}), 0U);
    EXPECT_EQ(feed(stream, part(packet, cut, 16)), 1U);
    EXPECT_EQ(stream.newest(), reply);
    EXPECT_EQ(stream.counts().split, 1U);
    EXPECT_EQ(stream.counts().line.empty, 1U);
    EXPECT_EQ(feed(stream, packet), 1U);
    EXPECT_EQ(stream.counts().split, 1U);
  }
}

TEST(FalconStream, OfMergedRepliesTheLastIsTheNewest) {
  Random random(2);
  Bytes data;
  FalconReply last;
  for (int i = 0; i < 9; ++i) data = data + packet_of(last = random_reply(random));  // 144 bytes: three status pairs
  FalconStream stream;
  EXPECT_EQ(feed(stream, data), 9U);
  EXPECT_EQ(stream.newest(), last);
  EXPECT_EQ(stream.counts().merged, 8U);
  EXPECT_EQ(stream.counts().split, 0U);
}

TEST(FalconStream, AReplyThatLostBytesIsCountedAndTheNextOneRead) {
  Random random(3);
  for (std::size_t lost = 1; lost < 16; ++lost) {
    for (const std::size_t count : {1U, 2U, 5U}) {
      Bytes damaged = packet_of(random_reply(random));
      damaged.erase(damaged.begin() + static_cast<std::ptrdiff_t>(lost),
                    damaged.begin() + static_cast<std::ptrdiff_t>(std::min<std::size_t>(lost + count, 16)));
      const FalconReply next = random_reply(random);
      FalconStream stream;
      EXPECT_EQ(feed(stream, damaged + packet_of(next)), 1U) << lost;
      EXPECT_EQ(stream.newest(), next);
      EXPECT_EQ(stream.counts().cut, 1U);
      EXPECT_EQ(stream.counts().corrupt + stream.counts().skipped, 0U);
    }
  }
}

TEST(FalconStream, AReplyWithoutItsFirstByteIsSkipped) {
  FalconStream stream;
  const Bytes packet = packet_of({{1, 2, 3}, 0, 0});
  EXPECT_EQ(feed(stream, part(packet, 1, 16) + packet), 1U);
  EXPECT_EQ(stream.counts().skipped, 15U);
}

TEST(FalconStream, NoSingleChangedByteYieldsAWrongFrame) {
  const FalconReply truth{{1447, -1447, 12}, 4, 7}, next{{5, 6, 7}, 1, 2};
  int corrupt = 0, cut = 0, skipped = 0;
  for (std::size_t at = 0; at < 16; ++at) {
    for (int value = 0; value < 256; ++value) {
      Bytes packet = packet_of(truth);
      if (packet[at] == value) continue;
      packet[at] = static_cast<std::uint8_t>(value);
      const bool legal = at != 0 && at != 15 && value >= 0x41 && value <= (at == 13 ? 0xC0 : 0x50);  // no checksum guards against these
      FalconStream stream;
      EXPECT_EQ(feed(stream, packet), legal ? 1U : 0U) << at << " " << value;
      EXPECT_EQ(feed(stream, packet_of(next)), 1U) << at << " " << value;
      EXPECT_EQ(stream.newest(), next);
      const StreamCounts& counts = stream.counts();
      EXPECT_GE(counts.cut + counts.corrupt + counts.skipped, legal ? 0U : 1U);
      corrupt += static_cast<int>(counts.corrupt), cut += static_cast<int>(counts.cut), skipped += static_cast<int>(counts.skipped > 0);
    }
  }
  EXPECT_GT(corrupt, 2000);
  EXPECT_GT(cut, 10);
  EXPECT_GT(skipped, 200);
}

TEST(FalconStream, EveryByteOfARandomStreamIsAccountedFor) {
  Random random(4);
  std::uint64_t replies = 0, spoilt = 0, split = 0, merged = 0;
  for (int run = 0; run < 300; ++run) {
    FalconStream stream;
    std::size_t bytes = 0;
    for (int i = 0; i < 200; ++i) {
      Bytes data;
      for (std::uint64_t k = below(random, 4); k > 0; --k) {
        Bytes piece = packet_of(random_reply(random));
        if (below(random, 4) == 0)
          piece[below(random, 16)] = static_cast<std::uint8_t>(below(random, 4) == 0 ? 0x3C + 2 * below(random, 2) : random.bits());
        if (below(random, 4) == 0) piece.resize(below(random, 17));
        data = data + piece;
      }
      bytes += data.size();
      const std::size_t cut = data.empty() ? 0 : below(random, data.size());
      feed(stream, part(data, 0, cut));
      feed(stream, part(data, cut, data.size()));
    }
    const StreamCounts& counts = stream.counts();
    // 16 for a reply or a corrupt packet, 1 to 15 for a cut one or one that has begun, 1 for what is skipped.
    const std::uint64_t whole = 16 * (counts.replies + counts.corrupt) + counts.skipped;
    EXPECT_LE(whole + counts.cut, bytes);
    EXPECT_GE(whole + 15 * (counts.cut + 1), bytes);
    EXPECT_LE(counts.split + counts.merged, counts.replies);
    replies += counts.replies, spoilt += counts.cut + counts.corrupt, split += counts.split, merged += counts.merged;
  }
  EXPECT_GT(replies, 10000U);
  EXPECT_GT(spoilt, 10000U);
  EXPECT_GT(split, 100U);
  EXPECT_GT(merged, 1000U);
}

TEST(FalconStream, KnownDamageIsCountedExactly) {
  Random random(5);
  FalconStream stream;
  Bytes data;
  std::uint64_t good = 0, cut = 0, corrupt = 0, skipped = 0;
  FalconReply last;
  for (int i = 0; i < 5000; ++i) {
    const FalconReply reply = random_reply(random);
    Bytes packet = packet_of(reply);
    switch (below(random, 4)) {
      case 0: packet.erase(packet.begin() + 5, packet.begin() + 7), ++cut; break;  // the 14 bytes of real devices
      case 1: packet[1 + below(random, 12)] = 0x51, ++corrupt; break;
      case 2: {
        const std::size_t noise = below(random, 5);
        packet = Bytes(noise, 0x13) + packet;
        skipped += noise;
        [[fallthrough]];
      }
      default: last = reply, ++good;
    }
    data = data + packet;
  }
  std::size_t replies = 0;
  for (std::size_t at = 0; at < data.size();) {
    const std::size_t size = std::min<std::size_t>(below(random, 100), data.size() - at);
    replies += feed(stream, part(data, at, at + size));
    at += size;
  }
  const StreamCounts& counts = stream.counts();
  EXPECT_EQ(replies, good);
  EXPECT_EQ(counts.replies, good);
  EXPECT_EQ(counts.cut, cut);
  EXPECT_EQ(counts.corrupt, corrupt);
  EXPECT_EQ(counts.skipped, skipped);
  EXPECT_EQ(stream.newest(), last);
  EXPECT_GT(std::min({good, cut, corrupt, skipped}), 1000U);
}

TEST(FalconStream, RandomBytesNeverLeaveItStuck) {
  Random random(6);
  FalconStream stream;
  for (int i = 0; i < 20000; ++i) {
    Bytes transfer(below(random, 200));
    for (std::uint8_t& byte : transfer) byte = static_cast<std::uint8_t>(below(random, 3) == 0 ? 0x3C + below(random, 24) : random.bits());
    transfer.shrink_to_fit();  // so that the address sanitizer sees the first byte beyond
    stream.feed(transfer);
    if (i % 100 != 0) continue;
    const FalconReply reply = random_reply(random);
    EXPECT_EQ(feed(stream, packet_of(reply)), 1U);
    EXPECT_EQ(stream.newest(), reply);
  }
  EXPECT_GT(stream.counts().cut + stream.counts().corrupt, 10000U);
}

TEST(FalconStream, RestartForgetsWhatHasBegun) {
  FalconStream stream;
  const Bytes packet = packet_of({{1, 2, 3}, 0, 0});
  feed(stream, part(packet, 0, 8));
  stream.restart();
  EXPECT_EQ(feed(stream, part(packet, 8, 16)), 0U);
  EXPECT_EQ(stream.counts().skipped, 8U);
}

}  // namespace
}  // namespace isotouch::falcon
