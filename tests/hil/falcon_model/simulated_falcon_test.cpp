#include "hil/falcon_model/simulated_falcon.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "tests/hil/falcon_model/driver.h"

namespace isotouch::falcon_model {
namespace {

using driver::data_of;
using driver::exchange;
using driver::running;
using driver::send;
using Encoders = std::array<std::int16_t, 3>;

Bytes status_pair() { return {0x01, 0x60}; }

/// A running device with faults, a hand at rest.
SimulatedFalcon faulty(const std::string& script) {
  Settings settings;
  std::istringstream in(script);
  settings.faults = read_faults(in, "script");
  settings.path = scripted_path("rest");
  return running(settings);
}

Bytes after_command(SimulatedFalcon& falcon, std::size_t capacity = 64) {
  send(falcon, driver::command({}));
  return falcon.read(capacity);
}

/// A wall in the arms: each is pushed outwards by what its count lacks. Integers only.
Commands wall(const ReplyPacket& reply) {
  Commands commands{};
  for (std::size_t i = 0; i < kLegs; ++i) commands[i] = reply.homed == 7 ? std::min(0, 2 * (reply.encoders[i] + 300)) : 0;
  return commands;
}

class Hash {
 public:
  void add(const Bytes& bytes) {
    for (const std::uint8_t byte : bytes) value_ = (value_ ^ byte) * 0x100000001B3ULL;
  }
  void add(double number) {
    const auto bits = std::bit_cast<std::uint64_t>(number);
    for (unsigned i = 0; i < 64; i += 8) add(Bytes{static_cast<std::uint8_t>(bits >> i & 0xFF)});
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xCBF29CE484222325ULL;
};

TEST(SimulatedFalcon, TwentyThousandPacketsAreTheSameBitsEverywhere) {
  Settings settings;
  settings.path = scripted_path("tour");
  std::istringstream script("at 9000 encoder-jump 1 40\nat 9500 stall 30\nat 15000 homing-lost");
  settings.faults = read_faults(script, "script");
  SimulatedFalcon falcon(settings);
  ASSERT_TRUE(driver::boot(falcon));
  Hash hash;
  Commands commands{};
  int forced = 0, followed = 0;
  for (int i = 0; i < 20000; ++i) {
    send(falcon, driver::command(commands));
    const Bytes transfer = falcon.read(64);
    hash.add(transfer);
    if (const auto reply = driver::decode(data_of(transfer))) commands = wall(*reply);
    forced += commands != Commands{} ? 1 : 0;
    followed += falcon.hand().follows_path() ? 1 : 0;
  }
  const Vector p = falcon.mechanism().position_mm(), v = falcon.mechanism().velocity_mm_s();
  for (const double number : {p.x, p.y, p.z, v.x, v.y, v.z}) hash.add(number);
  EXPECT_GT(forced, 5000);
  EXPECT_GT(followed, 12000);
  EXPECT_EQ(hash.value(), 0x918FC0FCC81F26C0ULL);
}

TEST(SimulatedFalcon, TheGoldenReplyStandsAtItsPose) {
  Settings settings;
  settings.mechanism.start_mm = {0, 0, 110.0102};  // in the middle of count -516
  settings.mechanism.gravity_n = {};
  std::istringstream script("at 0 encoder-jump 0 -516\nat 0 encoder-jump 1 -516\nat 0 encoder-jump 2 -516");
  settings.faults = read_faults(script, "script");
  SimulatedFalcon falcon = running(settings);
  send(falcon, driver::command({}));
  Bytes reply = falcon.read(64);
  ASSERT_EQ(reply.size(), 18U);
  EXPECT_EQ(reply[15], 'A');  // not homed; homed it would be B1
  reply[15] = 0xB1;
  EXPECT_EQ(reply, (Bytes{0x01, 0x60, 0x3c, 0x4d, 0x50, 0x4e, 0x50, 0x4d, 0x50, 0x4e, 0x50, 0x4d, 0x50, 0x4e, 0x50, 0xb1, 0x41, 0x3e}));
}

TEST(SimulatedFalcon, TellsOfAFaultWhenItHappens) {
  Settings settings;
  std::istringstream script("at 1 short\nat 3 stall 3\nat 4 repeated");
  settings.faults = read_faults(script, "script");
  std::vector<std::string> told;
  settings.on_fault = [&told](const Fault& fault) { told.push_back(line_of(fault)); };
  SimulatedFalcon falcon = running(settings);
  std::vector<std::size_t> after;
  for (int packet = 1; packet <= 6; ++packet) {
    send(falcon, driver::command({}));
    after.push_back(told.size());
  }
  EXPECT_EQ(told, (std::vector<std::string>{"at 1 short", "at 3 stall 3", "at 4 repeated"}));
  EXPECT_EQ(after, (std::vector<std::size_t>{1, 1, 2, 2, 2, 3}));  // the packets that are not heard have no reply that could be repeated
}

TEST(SimulatedFalcon, TwoQueuedRepliesComeInOnePacket) {
  SimulatedFalcon falcon = running({});
  send(falcon, driver::command({}));
  send(falcon, driver::command({}));
  EXPECT_EQ(falcon.read(64).size(), 34U);
}

TEST(SimulatedFalcon, APacketInPiecesIsOnePacket) {
  SimulatedFalcon falcon = running({});
  const Bytes packet = driver::command({});
  for (const std::uint8_t byte : packet) {
    EXPECT_EQ(falcon.read(64), status_pair());
    send(falcon, {byte});
  }
  EXPECT_EQ(falcon.read(64).size(), 18U);
}

TEST(SimulatedFalcon, TheHandHomesAndThenFollowsItsPath) {
  Settings settings;
  settings.path = scripted_path("rest");
  SimulatedFalcon falcon = running(settings);
  EXPECT_EQ(exchange(falcon)->homed, 0);
  ASSERT_TRUE(driver::until_homed(falcon));
  for (int i = 0; i < 1000; ++i) exchange(falcon);
  EXPECT_EQ(exchange(falcon)->homed, 7);
  EXPECT_LT(length(falcon.mechanism().position_mm() - Vector{0, -1.6, 125}), 0.05);  // 0.8 N of weight on 0.5 N/mm
  const Counts true_counts = falcon.mechanism().counts();
  const Encoders shown = exchange(falcon)->encoders;
  for (std::size_t i = 0; i < kLegs; ++i) EXPECT_EQ(shown[i], true_counts[i]);
}

TEST(SimulatedFalcon, WithoutTheHomingFlagTheHandPullsInVain) {
  Settings settings;
  settings.path = scripted_path("rest");
  SimulatedFalcon falcon = running(settings);
  for (int i = 0; i < 5000; ++i) EXPECT_EQ(exchange(falcon, {}, false)->homed, 0);
}

TEST(SimulatedFalcon, AForceMovesTheHandAndRunsOutWithoutPackets) {
  SimulatedFalcon falcon = faulty("at 6000 stall 200");
  ASSERT_TRUE(driver::until_homed(falcon));
  const Commands outwards{-800, -800, -800};  // 3.2 N along z
  while (falcon.packets() < 5990) exchange(falcon, outwards);
  const double pushed = falcon.mechanism().position_mm().z;
  EXPECT_NEAR(pushed - 125, 3.2 / 0.5, 0.5);
  for (int i = 0; i < 15; ++i) exchange(falcon, outwards);
  EXPECT_NEAR(falcon.mechanism().position_mm().z, pushed, 0.05);  // held for 10 ms
  for (int i = 0; i < 180; ++i) exchange(falcon, outwards);
  EXPECT_LT(falcon.mechanism().position_mm().z, 126);
}

TEST(SimulatedFalcon, SilenceEndsATorqueAndMovesNothing) {
  SimulatedFalcon falcon = running({});
  exchange(falcon, {-800, -800, -800});
  const Vector before = falcon.mechanism().position_mm();
  falcon.silence(9);
  EXPECT_NE(falcon.firmware().commands(), Commands{});
  falcon.silence(1);
  EXPECT_EQ(falcon.firmware().commands(), Commands{});
  EXPECT_EQ(falcon.mechanism().position_mm(), before);
}

TEST(SimulatedFalcon, RepliesAreDamagedOnOrder) {
  SimulatedFalcon falcon = faulty("at 2 short\nat 4 corrupt\nat 5 corrupt 0 0x01\nat 7 modem-only 2\nat 9 split 5");
  EXPECT_EQ(after_command(falcon).size(), 18U);
  EXPECT_EQ(after_command(falcon).size(), 16U);
  EXPECT_EQ(after_command(falcon).size(), 18U);
  const Bytes bad = after_command(falcon);
  EXPECT_EQ(bad.size(), 18U);
  EXPECT_FALSE(driver::decode(data_of(bad)).has_value());
  EXPECT_EQ(after_command(falcon)[2], '=');
  EXPECT_TRUE(driver::decode(data_of(after_command(falcon))).has_value());
  EXPECT_EQ(after_command(falcon), status_pair());
  EXPECT_EQ(falcon.read(64), status_pair());
  EXPECT_EQ(falcon.read(64).size(), 18U);
  EXPECT_EQ(after_command(falcon).size(), 18U);
  EXPECT_EQ(after_command(falcon).size(), 7U);
  EXPECT_EQ(falcon.read(64).size(), 13U);
}

TEST(SimulatedFalcon, RepliesAreDelayedOnOrder) {
  SimulatedFalcon falcon = faulty("at 2 merged\nat 5 late 3");
  std::vector<std::size_t> sizes;
  for (int i = 0; i < 9; ++i) sizes.push_back(data_of(after_command(falcon, 256)).size());
  EXPECT_EQ(sizes, (std::vector<std::size_t>{16, 0, 32, 16, 0, 0, 0, 64, 16}));
}

TEST(SimulatedFalcon, ARepliesCopyComesOnOrder) {
  SimulatedFalcon falcon = faulty("at 40 repeated");
  ReplyPacket before{};
  for (int i = 1; i <= 38; ++i) exchange(falcon);
  before = *exchange(falcon);
  EXPECT_EQ(exchange(falcon)->encoders, before.encoders);
  EXPECT_NE(exchange(falcon)->encoders, before.encoders);  // the hand pulls all the time
}

TEST(SimulatedFalcon, AStallAnswersNothing) {
  SimulatedFalcon falcon = faulty("at 3 stall 4");
  std::string answers;
  for (int i = 0; i < 8; ++i) answers += exchange(falcon) ? 'y' : 'n';
  EXPECT_EQ(answers, "yynnnnyy");
}

TEST(SimulatedFalcon, UnpluggedItIsGoneUntilSomebodyAsksOftenEnough) {
  SimulatedFalcon falcon = faulty("at 3 unplug 2");
  exchange(falcon);
  exchange(falcon);
  EXPECT_FALSE(exchange(falcon).has_value());
  EXPECT_FALSE(falcon.present());
  EXPECT_TRUE(falcon.control(driver::kLatency1).stalled);
  EXPECT_TRUE(falcon.read(64).empty());
  EXPECT_EQ(falcon.write(driver::command({})), 0U);
  EXPECT_FALSE(falcon.open());
  EXPECT_FALSE(falcon.open());
  EXPECT_TRUE(falcon.open());
  EXPECT_EQ(falcon.chip().latency_ms(), 16U);  // the chip begins anew
  driver::run_mode(falcon);
  EXPECT_TRUE(exchange(falcon).has_value());  // the firmware outlived it
}

TEST(SimulatedFalcon, FirmwareDiesWithTheCableOnOrder) {
  Settings settings;
  settings.quirks.forgets_on_unplug = true;
  settings.faults = {{1, FaultKind::kUnplug, {}}};
  SimulatedFalcon falcon = running(settings);
  exchange(falcon);
  EXPECT_TRUE(falcon.open());
  driver::run_mode(falcon);
  EXPECT_FALSE(exchange(falcon).has_value());
  EXPECT_TRUE(driver::boot(falcon));
}

TEST(SimulatedFalcon, FirmwareAndPowerAreLostAndFoundOnOrder) {
  SimulatedFalcon falcon = faulty("at 2 firmware-lost\nat 5 no-wall-power\nat 6 wall-power");
  EXPECT_TRUE(exchange(falcon).has_value());
  EXPECT_FALSE(exchange(falcon).has_value());
  ASSERT_TRUE(driver::boot(falcon));
  EXPECT_TRUE(exchange(falcon).has_value());
  EXPECT_TRUE(exchange(falcon).has_value());
  EXPECT_FALSE(exchange(falcon).has_value());
  EXPECT_FALSE(driver::boot(falcon));
  driver::run_mode(falcon);
  EXPECT_FALSE(exchange(falcon).has_value());  // power is back, firmware is not
  EXPECT_TRUE(driver::boot(falcon));
}

TEST(SimulatedFalcon, HomingIsLostAndTheHandHomesAgain) {
  SimulatedFalcon falcon = faulty("at 6000 homing-lost");
  ASSERT_TRUE(driver::until_homed(falcon));
  while (falcon.packets() < 5999) EXPECT_EQ(exchange(falcon)->homed, 7);
  const auto lost = exchange(falcon);
  EXPECT_EQ(lost->homed, 0);
  EXPECT_EQ(lost->encoders, (Encoders{0, 0, 0}));
  EXPECT_FALSE(falcon.hand().follows_path());
  ASSERT_TRUE(driver::until_homed(falcon));
}

TEST(SimulatedFalcon, AnEncoderJumpsAndButtonsArePressedOnOrder) {
  SimulatedFalcon falcon = faulty("at 2 encoder-jump 1 -300\nat 3 buttons 9 2");
  const Encoders before = exchange(falcon)->encoders;
  const auto jumped = exchange(falcon);
  EXPECT_NEAR(jumped->encoders[1] - before[1], -300, 2);
  EXPECT_NEAR(jumped->encoders[0] - before[0], 0, 2);
  std::vector<int> buttons{jumped->buttons};
  for (int i = 0; i < 3; ++i) buttons.push_back(exchange(falcon)->buttons);
  EXPECT_EQ(buttons, (std::vector<int>{0, 9, 9, 0}));
}

}  // namespace
}  // namespace isotouch::falcon_model
