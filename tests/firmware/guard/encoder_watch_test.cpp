#include "firmware/guard/encoder_watch.h"

#include <gtest/gtest.h>

#include <initializer_list>

namespace isotouch::guard {
namespace {

using Counts = std::array<std::int16_t, 3>;

/// Homed, and once through all of its ways.
EncoderMemory homed() {
  EncoderMemory memory;
  for (const std::int16_t count : std::initializer_list<std::int16_t>{-500, 500, 0}) follow_counts({count, count, count}, true, memory);
  return memory;
}

TEST(EncoderWatch, ALegThatRestsWhileAnotherTravelsIsStuck) {
  for (std::size_t leg = 0; leg < 3; ++leg) {
    EncoderMemory memory = homed();
    for (std::int16_t travel = 1; travel <= 410; ++travel) {
      Counts counts{};
      counts[(leg + 1) % 3] = travel;
      counts[(leg + 2) % 3] = static_cast<std::int16_t>(travel % 2);
      follow_counts(counts, true, memory);
      ASSERT_EQ(is_stuck(memory), travel > kStuckTravel) << travel;
    }
    Counts moved{1, 1, 1};
    follow_counts(moved, true, memory);
    EXPECT_FALSE(is_stuck(memory)) << "it moves again";
  }
}

TEST(EncoderWatch, ACountThatFlickersIsNotStuck) {
  EncoderMemory memory = homed();
  for (std::int16_t travel = 1; travel <= 500; ++travel) {
    follow_counts({static_cast<std::int16_t>(travel / 100 % 2), travel, travel}, true, memory);
    ASSERT_FALSE(is_stuck(memory)) << travel;
  }
}

TEST(EncoderWatch, ALegAtItsStopProvesNothing) {
  for (const std::int16_t stop : std::initializer_list<std::int16_t>{-500, -497, 497, 500}) {
    EncoderMemory memory = homed();
    for (std::int16_t travel = 0; travel < 460; ++travel)
      follow_counts({stop, travel, static_cast<std::int16_t>(travel % 2)}, true, memory);
    EXPECT_FALSE(is_stuck(memory)) << stop;
  }
  EncoderMemory memory = homed();
  for (std::int16_t travel = 0; travel < 460; ++travel) follow_counts({496, travel, static_cast<std::int16_t>(travel % 2)}, true, memory);
  EXPECT_TRUE(is_stuck(memory));
}

TEST(EncoderWatch, ACountThatLeapsIsNoWayOfTheHand) {
  EncoderMemory memory = homed();
  follow_counts({0, 3, 3}, true, memory);
  follow_counts({0, 450, 3}, true, memory);
  EXPECT_FALSE(is_stuck(memory));
  for (std::int16_t travel = 0; travel <= 450; travel = static_cast<std::int16_t>(travel + 50))
    follow_counts({0, travel, travel}, true, memory);
  EXPECT_TRUE(is_stuck(memory)) << "as fast as a hand";
}

TEST(EncoderWatch, AllThatRestUnderAnotherForceAreStuck) {
  for (const double newton : {1.4, 1.6}) {
    EncoderMemory memory = homed();
    follow_counts({7, 7, 7}, true, memory);
    follow_force({0, 1, 0}, memory);
    for (std::uint32_t packet = 1; packet < 500; ++packet) {
      follow_counts({7, 7, 7}, true, memory);
      follow_force({0, 1, packet >= 100 ? newton : 0}, memory);
      ASSERT_EQ(is_stuck(memory), newton > kStuckForce && packet >= 100 + kStuckPackets) << packet;
    }
    follow_counts({7, 7, 8}, true, memory);
    EXPECT_FALSE(is_stuck(memory));
  }
}

TEST(EncoderWatch, AForceThatComesBackInTimeMovesNobody) {
  EncoderMemory memory = homed();
  for (int round = 0; round < 20; ++round) {
    for (int packet = 0; packet < 80; ++packet) {
      follow_counts({7, 7, 7}, true, memory);
      follow_force({0, 0, packet < 40 ? 3.0 : 0.0}, memory);
      ASSERT_FALSE(is_stuck(memory));
    }
  }
}

TEST(EncoderWatch, ForceWithoutPacketsProvesNothing) {
  EncoderMemory memory = homed();
  follow_counts({7, 7, 7}, true, memory);
  for (int command = 0; command < 500; ++command) follow_force({0, 0, command < 10 ? 0.0 : 3.0}, memory);
  EXPECT_FALSE(is_stuck(memory));
}

TEST(EncoderWatch, ALostReferenceBeginsAnew) {
  EncoderMemory memory = homed();
  for (std::int16_t travel = 0; travel < 460; ++travel) follow_counts({0, travel, 0}, true, memory);
  ASSERT_TRUE(is_stuck(memory));
  follow_counts({0, 460, 0}, false, memory);
  EXPECT_FALSE(is_stuck(memory));
  for (std::int16_t travel = 0; travel < 460; ++travel) follow_counts({0, travel, 0}, true, memory);
  EXPECT_FALSE(is_stuck(memory)) << "nobody knows yet where its stops are";
}

}  // namespace
}  // namespace isotouch::guard
