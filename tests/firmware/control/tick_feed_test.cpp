#include "firmware/control/tick_feed.h"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
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

/// A server's thread that comes late finds many ticks in the ring: a client that reads gets them all.
TEST(TickFeed, ManyTicksAtOnceReachAClientThatReads) {
  std::array<int, 2> ends{};
  ASSERT_EQ(::socketpair(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK, 0, ends.data()), 0);
  loop::TraceRing ring(4096);
  loop::Requests requests;
  TickFeed feed(&ring, TraceHeader{}, requests);
  PostureMeter meter;
  WorstTicks worst;
  std::array<ControlClient, 1> clients;
  clients[0].open(ends[0], 0);
  feed.record(clients[0], {0, 0});
  loop::TickRecord tick;
  tick.in.requests = requests.take();
  for (tick.number = 1; tick.number <= kTicks; ++tick.number) {
    ASSERT_TRUE(ring.push(tick));
    tick.in.requests = 0;
  }
  feed.pump(clients, meter, worst, 0);

  std::vector<std::uint8_t> bytes = all_of(ends[1]);
  ASSERT_TRUE(clients[0].send(0));
  for (const std::uint8_t byte : all_of(ends[1])) bytes.push_back(byte);
  std::size_t records = 0;
  for (std::span<const std::uint8_t> left(bytes); !left.empty();) {
    const Result<protocol::Frame> frame = protocol::read_frame(left);
    ASSERT_TRUE(frame && frame->size > 0);
    EXPECT_NE(frame->kind, protocol::Kind::kRefused);
    if (frame->kind == protocol::Kind::kRecords)
      records += protocol::decode<protocol::Records>(frame->body)->bytes.size() / trace_layout::kRecordBytes;
    left = left.subspan(frame->size);
  }
  EXPECT_EQ(records, kTicks);
  ::close(ends[1]);
}

}  // namespace
}  // namespace isotouch::control
