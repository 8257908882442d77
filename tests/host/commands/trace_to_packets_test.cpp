#include <gtest/gtest.h>

#include <string>

#include "host/trace/trace_file.h"
#include "tests/host/commands/run_command.h"
#include "tests/support/scratch_folder.h"

namespace isotouch::commands {
namespace {

/// The device that `trace to-packets` makes of a hand with this period.
DeviceModel device_at(const std::string& period) {
  const ScratchFolder folder;
  const std::string field = ISOTOUCH_GOLDEN "/field_1_1.itf", hand = (folder.path() / "hand.trace").string();
  const std::string packets = (folder.path() / "packets.trace").string();
  run_command("trace make press " + field + " --ticks 10 --period " + period + " -o " + hand);
  run_command("trace to-packets " + field + " " + hand + " -o " + packets);
  return trace::read_trace(packets).header().device;
}

TEST(TraceToPackets, ADeviceIsHeldAndReturnsInTheSameTimeAtAnyPeriod) {
  const DeviceModel standard = device_at("1ms"), fast = device_at("0.25ms");
  EXPECT_EQ(standard, libnifalcon_model());
  EXPECT_EQ(fast.hold_ticks, 4 * standard.hold_ticks);
  EXPECT_EQ(fast.ramp_ticks, 4 * standard.ramp_ticks);
}

}  // namespace
}  // namespace isotouch::commands
