#include "firmware/control/tick_feed.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace isotouch::control {
namespace {

constexpr std::size_t kTicks = 3000;  // more than a client's own memory holds, less than that and what lies in the socket

/// All that the other side can read now.
std::vector<std::uint8_t> all_of(int socket) {
  std::vector<std::uint8_t> bytes(1 << 20);
  std::size_t size = 0;
  for (ssize_t got = 0; (got = ::recv(socket, bytes.data() + size, bytes.size() - size, MSG_DONTWAIT)) > 0;)
    size += static_cast<std::size_t>(got);
  bytes.resize(size);
  return bytes;
}

/// A feed with one client that records.
struct Recording {
  explicit Recording(std::size_t ring_size) : ring(ring_size) {
    EXPECT_EQ(::socketpair(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK, 0, ends.data()), 0);
    clients[0].open(ends[0], Peer{true, 1000, {}}, protocol::Role::kOperate, 0);
    feed.record(clients[0], {0, 0});
    tick.in.requests = requests.take().bits;
  }
  ~Recording() { ::close(ends[1]); }
  Recording(const Recording&) = delete;
  Recording& operator=(const Recording&) = delete;

  void push(std::uint64_t first, std::uint64_t last) {
    for (tick.number = first; tick.number <= last; ++tick.number) {
      ASSERT_TRUE(ring.push(tick));
      tick.in.requests = 0;
    }
  }
  void pump() {
    feed.pump(clients, meter, worst, 0);
    ASSERT_TRUE(clients[0].send(0));
  }

  std::array<int, 2> ends{};
  loop::TraceRing ring;
  loop::Requests requests;
  TickFeed feed{&ring, TraceHeader{}, requests};
  PostureMeter meter;
  WorstTicks worst;
  std::array<ControlClient, 1> clients;
  loop::TickRecord tick;
};

/// What a client was sent: how many records, and why there will be no more.
struct Sent {
  std::size_t records = 0;
  std::uint64_t lost = 0;                  ///< as the last frame has it
  std::vector<std::uint64_t> first_ticks;  ///< of each frame
  bool chained = true;                     ///< every record's chain follows from the header, or the records before
  std::string refusal;
};

Sent read_frames(std::span<const std::uint8_t> left) {
  Sent sent;
  std::optional<Chain> chain;
  while (!left.empty()) {
    const Result<protocol::Frame> frame = protocol::read_frame(left);
    if (!frame || frame->size == 0) {
      ADD_FAILURE() << "no whole frame";
      break;
    }
    if (frame->kind == protocol::Kind::kRecording)
      chain.emplace(*decode_header(protocol::decode<protocol::Recording>(frame->body)->header, trace_layout::kHeaderBytes));
    if (frame->kind == protocol::Kind::kRecords) {
      const auto said = *protocol::decode<protocol::Records>(frame->body);
      sent.lost = said.lost;
      sent.first_ticks.push_back(said.first_tick);
      for (std::size_t at = 0; at < said.bytes.size(); at += trace_layout::kRecordBytes, ++sent.records) {
        const auto record = *decode_record(said.bytes.subspan(at).first<trace_layout::kRecordBytes>());
        sent.chained = sent.chained && chain && chain->extend(record.input, record.output) == record.chain;
      }
    }
    if (frame->kind == protocol::Kind::kRefused) {
      const auto said = protocol::decode<protocol::Refusal>(frame->body)->sentence;
      sent.refusal.assign(said.begin(), said.end());
    }
    left = left.subspan(frame->size);
  }
  return sent;
}

/// A server's thread that comes late finds many ticks in the ring: a client that reads gets them all.
TEST(TickFeed, ManyTicksAtOnceReachAClientThatReads) {
  Recording recording(4096);
  recording.push(1, kTicks);
  recording.feed.pump(recording.clients, recording.meter, recording.worst, 0);
  std::vector<std::uint8_t> bytes = all_of(recording.ends[1]);
  ASSERT_TRUE(recording.clients[0].send(0));
  for (const std::uint8_t byte : all_of(recording.ends[1])) bytes.push_back(byte);
  const Sent sent = read_frames(bytes);
  EXPECT_EQ(sent.refusal, "");
  EXPECT_EQ(sent.records, kTicks);
}

TEST(TickFeed, ARecordingEndsWhereTheRingLostATick) {
  for (const bool at_once : {true, false}) {  // within what is taken from the ring at once, or between two of these
    Recording recording(64);
    recording.push(1, 10);
    if (!at_once) recording.pump();
    recording.push(12, 20);
    recording.pump();
    const Sent sent = read_frames(all_of(recording.ends[1]));
    EXPECT_THAT(sent.refusal, testing::HasSubstr("the recording ended")) << at_once;
    EXPECT_EQ(sent.records, 10U) << "all before it, and no more";
    EXPECT_FALSE(recording.clients[0].records);
  }
}

TEST(TickFeed, EveryRecordingHasAChainOfItsOwn) {
  Recording recording(64);
  for (const bool first : {true, false}) {
    if (!first) {
      recording.feed.end_recording(recording.clients[0]);
      recording.feed.record(recording.clients[0], {0, 0});
      recording.tick.in.requests = recording.requests.take().bits;
    }
    recording.push(first ? 1 : 11, first ? 10 : 20);
    recording.pump();
    const Sent sent = read_frames(all_of(recording.ends[1]));
    EXPECT_EQ(sent.records, 10U);
    EXPECT_TRUE(sent.chained) << first;
  }
}

TEST(TickFeed, ANewSubscriberGetsNoCountOfEarlierLosses) {
  Recording recording(16);
  recording.feed.end_recording(recording.clients[0]);
  for (int n = 0; n < 50; ++n) recording.ring.push(recording.tick);
  ASSERT_GT(recording.ring.lost(), 0U);
  loop::TickRecord dropped;
  while (recording.ring.pop(dropped)) {
  }
  recording.feed.subscribe(recording.clients[0], 1);
  recording.push(100, 105);
  recording.pump();
  const Sent before = read_frames(all_of(recording.ends[1]));
  EXPECT_EQ(before.records, 6U);
  EXPECT_EQ(before.lost, 0U);
  for (int n = 0; n < 20; ++n) recording.ring.push(recording.tick);
  recording.pump();
  EXPECT_EQ(read_frames(all_of(recording.ends[1])).lost, 4U);
}

TEST(TickFeed, AFrameEndsWhereTheRingLostATick) {
  Recording watching(64);
  watching.feed.end_recording(watching.clients[0]);
  watching.feed.subscribe(watching.clients[0], 1);
  watching.push(1, 5);
  watching.push(8, 10);
  watching.pump();
  const Sent sent = read_frames(all_of(watching.ends[1]));
  EXPECT_THAT(sent.first_ticks, testing::ElementsAre(1, 8));
  EXPECT_EQ(sent.records, 8U);
}

TEST(TickFeed, ARecordingEndsWhereAnotherFieldComes) {
  Recording recording(64);
  recording.push(1, 10);
  recording.tick.in.field_generation = 1;
  recording.push(11, 20);
  recording.pump();
  const Sent sent = read_frames(all_of(recording.ends[1]));
  EXPECT_THAT(sent.refusal, testing::HasSubstr("another field was loaded"));
  EXPECT_FALSE(recording.clients[0].records);
}

}  // namespace
}  // namespace isotouch::control
