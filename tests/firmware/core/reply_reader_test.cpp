#include "firmware/core/reply_reader.h"

#include <gtest/gtest.h>

namespace isotouch::core {
namespace {

Input packet(const Counts& counts, std::uint8_t homed = 7) {
  Input in;
  in.packet = encode(FalconReply{counts, 5, homed});
  in.fresh = true;
  return in;
}

struct Reader {
  Reading operator()(const Input& in) { return read_reply(in, model, state); }
  DeviceModel model = libnifalcon_model();
  ReplyState state;
};

TEST(ReplyReader, HomedNeedsAllThreeLegsTwiceInARow) {
  for (std::uint8_t homed = 0; homed < 7; ++homed) {
    Reader read;
    for (int t = 0; t < 10; ++t) read(packet({1, 2, 3}, homed));
    EXPECT_FALSE(read.state.homed) << int{homed};
  }
  Reader read;
  read(packet({1, 2, 3}));
  EXPECT_FALSE(read.state.homed);
  read(packet({1, 2, 3}, 3));
  read(packet({1, 2, 3}));
  EXPECT_FALSE(read.state.homed);
  read(packet({1, 2, 3}));
  EXPECT_TRUE(read.state.homed);
  read(packet({1, 2, 3}, 0));
  EXPECT_TRUE(read.state.homed);
}

TEST(ReplyReader, AMalformedPacketInterruptsTheTwoInARow) {
  Reader read;
  read(packet({1, 2, 3}));
  Input malformed = packet({1, 2, 3});
  malformed.packet[15] = 'A';
  read(malformed);
  read(packet({1, 2, 3}));
  EXPECT_FALSE(read.state.homed);
  read(packet({1, 2, 3}));
  EXPECT_TRUE(read.state.homed);
}

TEST(ReplyReader, AStaleOrMalformedPacketChangesNoCount) {
  Reader read;
  read(packet({10, 20, 30}));
  Input in = packet({11, 21, 31});
  in.fresh = false;
  in.age = 4;
  EXPECT_FALSE(read(in).fresh);
  EXPECT_EQ(read.state.counts, (Counts{10, 20, 30}));
  EXPECT_EQ(read.state.stale, 4U) << "the loop's own count is taken where it is larger";
  in.fresh = true;
  in.packet[15] = 'A';
  const Reading reading = read(in);
  EXPECT_TRUE(reading.malformed);
  EXPECT_FALSE(reading.fresh);
  EXPECT_EQ(read.state.stale, 5U);
  EXPECT_TRUE(read(packet({11, 21, 31})).fresh);
  EXPECT_EQ(read.state.stale, 0U);
  EXPECT_EQ(read.state.buttons, 5);
}

TEST(ReplyReader, AJumpIsWhatNoHandDoesInTheTimeThatPassed) {
  Reader read;
  EXPECT_TRUE(read(packet({0, 0, 0})).jumped) << "the first counts come from nowhere";
  EXPECT_FALSE(read(packet({400, -400, 0})).jumped);
  EXPECT_TRUE(read(packet({400, 1, 0})).jumped);
  EXPECT_TRUE(read(packet({-32768, 1, 32767})).jumped);
  read(packet({0, 0, 0}));
  Input stale;
  read(stale);
  read(stale);
  EXPECT_FALSE(read(packet({1200, 0, 0})).jumped) << "three ticks";
  for (int t = 0; t < 1000; ++t) read(stale);
  EXPECT_TRUE(read(packet({1200 + 6401, 0, 0})).jumped) << "but never more than sixteen ticks' way";
}

TEST(ReplyReader, AJumpWithoutReferenceLosesIt) {
  Reader read;
  for (int t = 0; t < 3; ++t) read(packet({500, 500, 500}));
  EXPECT_TRUE(read.state.homed);
  read(packet({-500, 500, 500}));
  EXPECT_TRUE(read.state.homed);
  read(packet({0, 0, 0}, 0));
  EXPECT_FALSE(read.state.homed);
}

TEST(ReplyReader, WithoutBitsASmallJumpLosesTheReferenceHoweverLongTheyAreMissing) {
  Reader read;
  for (int t = 0; t < 3; ++t) read(packet({40, 40, 40}));
  for (int t = 0; t < 100; ++t) read(packet({41, 40, 40}, 0));
  EXPECT_TRUE(read.state.homed) << "sources disagree on the bits";
  read(packet({41, 90, 40}, 1));
  EXPECT_TRUE(read.state.homed);
  EXPECT_TRUE(read(packet({41, 141, 40}, 1)).jumped) << "a leg has found its mark again";
  EXPECT_FALSE(read.state.homed);
}

TEST(ReplyReader, BitsThatDisappearUnseenLoseTheReference) {
  const auto after = [](std::uint8_t bits_before, std::uint8_t late) {
    Reader read;
    for (int t = 0; t < 3; ++t) read(packet({500, 500, 500}));
    read(packet({500, 500, 500}, bits_before));
    Input next = packet({500, 500, 500}, 0);
    next.late = late;
    read(next);
    return read.state.homed;
  };
  EXPECT_TRUE(after(7, 0));
  EXPECT_FALSE(after(7, 1)) << "what came meanwhile is not known";
  {
    Reader read;
    for (int t = 0; t < 3; ++t) read(packet({500, 500, 500}));
    Input malformed;
    malformed.fresh = true;
    malformed.late = 1;
    read(malformed);
    read(packet({500, 500, 500}, 0));
    EXPECT_FALSE(read.state.homed) << "nor is it after a malformed packet";
  }
  EXPECT_TRUE(after(0, 1)) << "a device that shows no bits";
  EXPECT_TRUE(after(0, kMaxLate - 1));
  EXPECT_FALSE(after(0, kMaxLate));
}

TEST(ReplyReader, ADeviceThatWasSilentForLongAndShowsNoBitsMayHaveBegunAnew) {
  const auto after = [](std::uint8_t bits, std::uint32_t silent) {
    Reader read;
    for (int t = 0; t < 3; ++t) read(packet({300, 290, 280}));
    Input none = packet({300, 290, 280});
    none.fresh = false;
    for (none.age = 1; none.age <= silent; ++none.age) read(none);
    const bool jumped = read(packet({1, 0, -1}, bits)).jumped;
    EXPECT_EQ(jumped, !read.state.homed);
    return read.state.homed;
  };
  EXPECT_FALSE(after(0, kMaxLate)) << "its counts are of another reference, though so small a way a hand could have made";
  EXPECT_FALSE(after(0, 500));
  EXPECT_TRUE(after(7, 500)) << "it says that it has kept it";
  EXPECT_TRUE(after(0, kMaxLate - 1));
}

}  // namespace
}  // namespace isotouch::core
