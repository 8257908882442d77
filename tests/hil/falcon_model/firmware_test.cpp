#include "hil/falcon_model/firmware.h"

#include <gtest/gtest.h>

namespace isotouch::falcon_model {
namespace {

constexpr CommandPacket kHoming{{0, 0, 0}, true, 4}, kPlain{{100, -200, 300}, false, 2};
using Encoders = std::array<std::int16_t, 3>;

TEST(Firmware, CountsFromWhereItWokeUntilAnAxisPassesItsReference) {
  Firmware firmware({}, 10);
  firmware.start({-500, -40, 700});
  EXPECT_EQ(firmware.take(kHoming, {-490, -40, 690}, 0).encoders, (Encoders{10, 0, -10}));
  const ReplyPacket reply = firmware.take(kHoming, {-480, 3, 680}, 0);
  EXPECT_EQ(reply.encoders, (Encoders{20, 3, -20}));  // the second jumped by its 40
  EXPECT_EQ(reply.homed, 2);
  firmware.take(kHoming, {2, 100, 200}, 0);
  EXPECT_EQ(firmware.take(kHoming, {50, 100, -1}, 0).homed, 7);
  EXPECT_EQ(firmware.take(kPlain, {-3, 100, 20}, 0).encoders, (Encoders{-3, 100, 20}));
  EXPECT_EQ(firmware.homed(), 7);
}

TEST(Firmware, HomesNothingWithoutTheFlag) {
  Firmware firmware({}, 10);
  firmware.start({-5, -5, -5});
  EXPECT_EQ(firmware.take(kPlain, {5, 5, 5}, 0).homed, 0);
  EXPECT_EQ(firmware.take(kHoming, {6, 6, 6}, 0).homed, 0);  // it has passed already
}

TEST(Firmware, TorquesRunOutLightsDoNot) {
  Firmware firmware({}, 10);
  firmware.start({});
  firmware.take(kPlain, {}, 0);
  firmware.miss(9);
  EXPECT_EQ(firmware.expired(), 0);
  EXPECT_EQ(firmware.commands(), (Commands{100, -200, 300}));
  firmware.miss();
  EXPECT_EQ(firmware.commands(), Commands{});
  EXPECT_EQ(firmware.leds(), 2);
  firmware.miss(20);
  EXPECT_EQ(firmware.expired(), 1);  // it had ended already
  firmware.take(kPlain, {}, 0);
  EXPECT_EQ(firmware.commands(), (Commands{100, -200, 300}));
  EXPECT_EQ(firmware.expired(), 1);
}

TEST(Firmware, AStuckAxisReportsWhatItReportedLast) {
  Firmware firmware({}, 10);
  firmware.start({0, 0, 0});
  firmware.stick(5, {10, 20, 30});
  EXPECT_EQ(firmware.take(kPlain, {10, 20, 30}, 0).encoders, (Encoders{10, 20, 30}));
  EXPECT_EQ(firmware.take(kPlain, {90, 91, 92}, 0).encoders, (Encoders{10, 91, 30}));
  firmware.stick(0, {});
  EXPECT_EQ(firmware.take(kPlain, {90, 91, 92}, 0).encoders, (Encoders{90, 91, 92}));
}

TEST(Firmware, ShowsButtons) {
  Firmware firmware({}, 10);
  EXPECT_EQ(firmware.take(kPlain, {}, 9).buttons, 9);
}

TEST(Firmware, OtherReadingsOfTheSourcesAreOnOrder) {
  Firmware shy({.homed_only_while_homing = true}, 10);
  shy.start({-1, -1, -1});
  EXPECT_EQ(shy.take(kHoming, {1, 1, 1}, 0).homed, 7);
  EXPECT_EQ(shy.take(kPlain, {1, 1, 1}, 0).homed, 0);
  EXPECT_EQ(shy.take(kHoming, {1, 1, 1}, 0).homed, 7);
  Firmware frozen({.frozen_until_homed = true}, 10);
  frozen.start({-100, -100, -100});
  EXPECT_EQ(frozen.take(kHoming, {-50, -50, 7}, 0).encoders, (Encoders{0, 0, 7}));
}

}  // namespace
}  // namespace isotouch::falcon_model
