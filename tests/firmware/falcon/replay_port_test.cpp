#include "firmware/falcon/replay_port.h"

#include <gtest/gtest.h>

#include <vector>

#include "firmware/loop/virtual_clock.h"
#include "shared/files/trace_file.h"

namespace isotouch::falcon {
namespace {

/// What a device sent in a tick: nothing in every fourth.
TraceRecord record(std::int16_t number) {
  TraceRecord record;
  record.input.fresh = number % 4 != 0;
  record.input.age = record.input.fresh ? 0 : 1;
  record.input.packet = encode(FalconReply{{std::int16_t(number / 4 * 4), 0, 0}, 0, 7});
  return record;
}

TEST(ReplayPort, GivesFreshPacketsSilenceBetweenAndAnEnd) {
  TraceHeader header;
  header.device = martin_hillier_model();
  header.period_ns = 500'000;
  std::vector<TraceRecord> records;
  for (std::int16_t i = 1; i <= 8; ++i) records.push_back(record(i));
  const files::TraceFile trace("a.trace", header, records);
  loop::VirtualClock clock;
  ReplayPort port(trace, clock);
  for (std::int16_t i = 1; i <= 8; ++i) {
    FalconPacket packet{};
    const loop::Answer answer = port.exchange({{9, 9, 9}, 0}, packet);
    EXPECT_EQ(answer, i % 4 == 0 ? loop::Answer::kSilent : loop::Answer::kReply);
    if (answer == loop::Answer::kReply) {
      EXPECT_EQ(packet, record(i).input.packet);
    }
    EXPECT_EQ(clock.now_ns(), std::int64_t{i} * 500'000);
  }
  FalconPacket packet{};
  EXPECT_EQ(port.exchange({}, packet), loop::Answer::kEnd);
}

}  // namespace
}  // namespace isotouch::falcon
