#include "firmware/falcon/falcon_device.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <deque>

#include "tests/firmware/falcon/fake_falcon.h"
#include "tests/support/alloc_guard.h"

namespace isotouch::falcon {
namespace {

using test::FakeClock;
using test::FakeFalcon;
using Words = std::array<std::int16_t, 3>;

/// A Falcon whose firmware runs, 1 ms latency and run-time rate set.
struct Desk {
  FakeClock clock;
  FakeFalcon falcon{clock};
  FalconDevice device{falcon, clock};

  Desk() {
    EXPECT_TRUE(falcon.open());
    EXPECT_TRUE(falcon.control(ft232::kLatency1, {}));
    EXPECT_TRUE(falcon.control(ft232::kBaudRun, {}));
    falcon.running = true;
    falcon.reply = {{-516, 17, 4}, 2, 0};
  }
};

TEST(FalconDevice, ExchangesWordsForAReply) {
  Desk desk;
  const Exchange exchange = desk.device.exchange({{1000, -2000, 4095}});
  EXPECT_TRUE(exchange.fresh);
  EXPECT_FALSE(exchange.lost || exchange.rested);
  EXPECT_EQ(exchange.reply, desk.falcon.reply);
  ASSERT_EQ(desk.falcon.commands.size(), 1U);
  EXPECT_EQ(desk.falcon.commands[0].words, (Words{1000, -2000, 4095}));
  EXPECT_EQ(desk.device.counts().exchanges, 1U);
  EXPECT_EQ(desk.device.counts().timeouts, 0U);
}

TEST(FalconDevice, HandsFlagsOutAndPacketsInAsTheyAre) {
  Desk desk;
  for (const std::uint8_t flags : std::array<std::uint8_t, 4>{0, 1, 5, 14}) {
    desk.falcon.reply = {{-516, 17, 4}, flags, 3};
    const Exchange exchange = desk.device.exchange({{1, 2, 3}, flags});
    EXPECT_EQ(desk.falcon.commands.back().flags, flags);
    EXPECT_EQ(exchange.packet, encode(desk.falcon.reply));
  }
}

TEST(FalconDevice, RestsOnceAfterAMissingReply) {
  Desk desk;
  desk.device.exchange({{100, 100, 100}});
  desk.falcon.faults.mute_replies = 1;
  const std::int64_t began = desk.clock.now;
  const Exchange missed = desk.device.exchange({{100, 100, 100}});
  EXPECT_FALSE(missed.fresh);
  EXPECT_FALSE(missed.lost);
  EXPECT_EQ(missed.reply, desk.falcon.reply) << "the old one";
  EXPECT_GE(desk.clock.now - began, 5'000'000);
  EXPECT_LE(desk.clock.now - began, 6'000'000);
  const Exchange rested = desk.device.exchange({{100, 100, 100}});
  EXPECT_TRUE(rested.fresh && rested.rested);
  EXPECT_EQ(desk.falcon.commands.back().words, Words{});
  EXPECT_FALSE(desk.device.exchange({{100, 100, 100}}).rested);
  EXPECT_EQ(desk.falcon.commands.back().words, (Words{100, 100, 100}));
  EXPECT_EQ(desk.device.counts().timeouts, 1U);
}

TEST(FalconDevice, ALateReplyIsNotTakenForTheNextOnesForLong) {
  Desk desk;
  desk.device.exchange({});
  desk.falcon.faults.late_replies = 1;
  desk.falcon.reply.counts[0] = 1;
  EXPECT_FALSE(desk.device.exchange({}).fresh);
  desk.clock.now += 5'000'000;  // now the late one is there
  desk.falcon.reply.counts[0] = 2;
  EXPECT_EQ(desk.device.exchange({}).reply.counts[0], 2);
  EXPECT_EQ(desk.device.counts().late, 1U);
  // Late by so much that it comes while the next is awaited: one reply is old, then it is noticed.
  desk.falcon.faults.late_replies = 1;
  desk.falcon.reply.counts[0] = 3;
  EXPECT_FALSE(desk.device.exchange({}).fresh);
  for (std::int16_t i = 4; i < 20; ++i) {
    desk.falcon.reply.counts[0] = i;
    const Exchange exchange = desk.device.exchange({});
    desk.clock.now += 500'000;
    EXPECT_TRUE(i <= 5 || exchange.reply.counts[0] == i) << i;
  }
  EXPECT_EQ(desk.device.counts().late, 2U);
}

TEST(FalconDevice, IsLostAfterTwentyMissingRepliesAndFoundAgainByOne) {
  Desk desk;
  desk.falcon.faults.mute_replies = 20;
  for (int i = 1; i <= 20; ++i) EXPECT_EQ(desk.device.exchange({}).lost, i == 20) << i;
  EXPECT_FALSE(desk.device.exchange({}).lost);
}

TEST(FalconDevice, IsLostAtOnceWhenUnplugged) {
  Desk desk;
  desk.falcon.faults.present = false;
  EXPECT_TRUE(desk.device.exchange({}).lost);
  desk.device.rest();
}

TEST(FalconDevice, TakesNoEchoForAReply) {
  Desk desk;
  desk.device.exchange({});
  desk.falcon.running = false;  // its power was away for a moment
  desk.falcon.faults.echoes_packets = true;
  const Exchange echoed = desk.device.exchange({{-500, 20, 30}});
  EXPECT_FALSE(echoed.fresh);
  EXPECT_EQ(echoed.reply, desk.falcon.reply) << "the old one";
  for (int i = 2; i <= 20; ++i) EXPECT_EQ(desk.device.exchange({}).lost, i == 20) << i;
  EXPECT_EQ(desk.device.counts().echoes, 20U);
  EXPECT_EQ(desk.device.counts().timeouts, 20U);
}

TEST(FalconDevice, CutsWordsAtTheDevicesLimit) {
  Desk desk;
  desk.device.exchange({{4096, -4096, 32767}});
  EXPECT_EQ(desk.falcon.commands.back().words, (Words{4095, -4095, 4095}));
  desk.device.exchange({{4095, -4095, -32768}});
  EXPECT_EQ(desk.falcon.commands.back().words, (Words{4095, -4095, -4095}));
  desk.device.exchange({{4095, -4095, 0}});
  EXPECT_EQ(desk.device.counts().clamped, 2U);
}

TEST(FalconDevice, RestsWithThreePacketsWithoutForceAndLight) {
  Desk desk;
  desk.device.exchange({{500, 500, 500}});
  desk.device.rest();
  ASSERT_EQ(desk.falcon.commands.size(), 4U);
  for (std::size_t i = 1; i < 4; ++i) EXPECT_EQ(desk.falcon.commands[i], FalconCommand{});
}

TEST(FalconDevice, ReadsRepliesInPieces) {
  Desk desk;
  desk.falcon.faults.byte_by_byte = true;
  for (int i = 0; i < 10; ++i) EXPECT_TRUE(desk.device.exchange({}).fresh);
  EXPECT_EQ(desk.device.counts().stream.split, 10U);
}

TEST(FalconDevice, ACommandThatIsNotTakenWholeIsNotWaitedFor) {
  Desk desk;
  desk.falcon.faults.short_writes = true;
  const std::int64_t began = desk.clock.now;
  EXPECT_FALSE(desk.device.exchange({{100, 100, 100}}).fresh);
  EXPECT_EQ(desk.clock.now, began);
  EXPECT_EQ(desk.device.counts().timeouts, 1U);
}

TEST(FalconDevice, IsLostAfterAsManyMissingRepliesAsItsSettingsSay) {
  for (const int most : {1, 3, 25}) {
    FakeClock clock;
    FakeFalcon falcon(clock);
    ASSERT_TRUE(falcon.open());
    FalconDevice device(falcon, clock, {.lost_after = most});
    for (int i = 1; i <= most; ++i) EXPECT_EQ(device.exchange({}).lost, i == most) << i << " of " << most;
  }
}

/// Is open, and takes every control request.
class OpenLink : public FalconLink {
 public:
  LinkResult<void> open() override { return {}; }
  void close() override {}
  bool is_open() const override { return true; }
  const FalconIdentity& identity() const override { return identity_; }
  LinkResult<std::size_t> control(const UsbSetup& /*setup*/, std::span<std::uint8_t> /*answer*/) override { return std::size_t{0}; }

 private:
  FalconIdentity identity_;
};

/// The transfers that a test has put there, and a millisecond after each command its reply: the command's first word comes back as the first count.
class TransferLink final : public OpenLink {
 public:
  explicit TransferLink(FakeClock& clock) : clock_(clock) {}

  static test::Bytes replies(std::initializer_list<std::int16_t> counts) {
    test::Bytes transfer = {0x01, 0x60};
    for (const std::int16_t count : counts) {
      const FalconPacket packet = encode(FalconReply{{count, 0, 0}, 0, 7});
      transfer.insert(transfer.end(), packet.begin(), packet.end());
    }
    return transfer;
  }
  static test::Bytes nothing() { return replies({}); }

  std::deque<test::Bytes> there;  ///< may be read at once
  bool mute = false;
  int reads = 0;

  LinkResult<std::size_t> write(std::span<const std::uint8_t> data, std::uint32_t /*timeout_ms*/) override {
    if (!mute) coming_.push_back(replies({decode_command(data.first<kFalconPacketBytes>())->words[0]}));
    return data.size();
  }
  LinkResult<std::size_t> read(std::span<std::uint8_t> buffer, std::uint32_t timeout_ms) override {
    ++reads;
    clock_.now += 1'000;
    if (there.empty() && timeout_ms > 0) {
      clock_.now += 999'000;
      there.swap(coming_);
    }
    if (there.empty()) return LinkError::kTimedOut;
    const test::Bytes transfer = there.front();
    there.pop_front();
    std::copy(transfer.begin(), transfer.end(), buffer.begin());
    return transfer.size();
  }

 private:
  FakeClock& clock_;
  std::deque<test::Bytes> coming_;
};

TEST(FalconDevice, RestsADeviceThatOnlyAFlippedBitCallsGone) {
  int gone = 0;
  for (std::size_t at = sizeof(FalconDevice) - 16; at < sizeof(FalconDevice); ++at) {  // the flags and counters at its end
    Desk desk;
    desk.device.exchange({{7, 7, 7}});
    reinterpret_cast<std::uint8_t*>(&desk.device)[at] ^= 1;
    const bool lost = desk.device.exchange({{7, 7, 7}}).lost;
    gone += lost ? 1 : 0;
    desk.device.rest();
    EXPECT_EQ(desk.falcon.commands.back(), FalconCommand{}) << at;
  }
  EXPECT_EQ(gone, 1);
}

struct TransferDesk {
  FakeClock clock;
  TransferLink link{clock};
  FalconDevice device{link, clock};

  /// The first count of what one exchange brings; -1 when it brings nothing fresh.
  int exchange(std::int16_t word) {
    const Exchange exchange = device.exchange({{word, 0, 0}});
    return exchange.fresh ? exchange.reply.counts[0] : -1;
  }
  /// Until no late reply is expected any more.
  void calm() {
    for (std::int16_t i = 0; i < 20; ++i) ASSERT_EQ(exchange(i), i);
  }
};

TEST(FalconDevice, ALateReplyBehindEmptyPacketsIsNotTakenForTheNext) {
  TransferDesk desk;
  desk.link.there = {TransferLink::nothing(), TransferLink::nothing(), TransferLink::replies({77})};
  EXPECT_EQ(desk.exchange(5), 5);
  EXPECT_EQ(desk.device.counts().late, 1U);
}

TEST(FalconDevice, AfterMergedRepliesALateOneIsNotTakenForTheNext) {
  TransferDesk desk;
  desk.calm();
  desk.link.there = {TransferLink::replies({70, 71})};
  desk.link.mute = true;
  EXPECT_EQ(desk.exchange(5), 71) << "of two that come together the newer one";
  desk.link.mute = false;
  desk.link.there = {TransferLink::replies({72})};
  EXPECT_EQ(desk.exchange(6), 6);
  EXPECT_EQ(desk.device.counts().late, 2U);
}

TEST(FalconDevice, APartOfAMillisecondIsWaitedForToo) {
  FakeClock clock;
  TransferLink link(clock);
  FalconDevice device(link, clock, {.reply_ns = 500'000});
  EXPECT_TRUE(device.exchange({{5, 0, 0}}).fresh);
  EXPECT_LE(link.reads, 6) << "it does not spin";
}

/// Takes everything, answers at once, and allocates nothing.
class QuietLink final : public OpenLink {
 public:
  LinkResult<std::size_t> write(std::span<const std::uint8_t> data, std::uint32_t /*timeout_ms*/) override {
    waiting_ = true;
    return data.size();
  }
  LinkResult<std::size_t> read(std::span<std::uint8_t> buffer, std::uint32_t /*timeout_ms*/) override {
    if (!waiting_) return LinkError::kTimedOut;
    waiting_ = false;
    const FalconPacket packet = encode(FalconReply{});
    buffer[0] = 0x01, buffer[1] = 0x60;
    std::copy(packet.begin(), packet.end(), buffer.begin() + 2);
    return packet.size() + 2;
  }

 private:
  bool waiting_ = false;
};

TEST(FalconDevice, AllocatesNothingOfItsOwn) {
  FakeClock clock;
  QuietLink link;
  FalconDevice device(link, clock);
  std::uint64_t fresh = 0;
  const test::AllocGuard guard;
  for (int i = 0; i < 100000; ++i) fresh += device.exchange({{1, 2, 3}}).fresh ? 1U : 0U;
  EXPECT_EQ(guard.count(), 0U);
  EXPECT_EQ(fresh, 100000U);
}

}  // namespace
}  // namespace isotouch::falcon
