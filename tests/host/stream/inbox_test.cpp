#include "host/stream/inbox.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <thread>

namespace isotouch::stream {
namespace {

using namespace std::chrono_literals;

Frame frame(std::uint64_t number) {
  return {number, [] { return cloud::Model{}; }, {}};
}

TEST(Inbox, KeepsTheNewestOfTheFramesThatNobodyTook) {
  Inbox inbox;
  for (std::uint64_t number = 1; number <= 1000; ++number) EXPECT_TRUE(inbox.offer(frame(number)));
  inbox.miss(3);
  EXPECT_EQ(inbox.offered(), 1003U);
  EXPECT_EQ(inbox.thinned(), 1002U);
  const auto taken = inbox.take(0ms);
  ASSERT_TRUE(taken);
  EXPECT_EQ(taken->number, 1000U);
  EXPECT_TRUE(taken->at);
  EXPECT_FALSE(inbox.take(0ms));
  EXPECT_FALSE(inbox.is_finished());
}

TEST(Inbox, AnEmptyFrameTakesNobodysPlace) {
  Inbox inbox;
  Frame empty = frame(2);
  empty.is_empty = true;
  inbox.offer(frame(1));
  EXPECT_TRUE(inbox.offer(empty));
  EXPECT_EQ(inbox.thinned(), 1U);
  EXPECT_EQ(inbox.take(0ms)->number, 1U);
  inbox.offer(empty);
  inbox.offer(frame(3));
  EXPECT_EQ(inbox.take(0ms)->number, 3U);
  EXPECT_EQ(inbox.offered(), 4U);
  EXPECT_EQ(inbox.thinned(), 2U);
}

TEST(Inbox, HasRoomWhereNoFrameWaits) {
  Inbox inbox;
  EXPECT_TRUE(inbox.has_room());
  inbox.offer(frame(1));
  EXPECT_FALSE(inbox.has_room());
  (void)inbox.take(0ms);
  EXPECT_TRUE(inbox.has_room());
}

TEST(Inbox, AFrameThatMayWaitIsNeverLeftOut) {
  Inbox inbox;
  std::thread source([&] {
    for (std::uint64_t number = 1; number <= 200; ++number) inbox.hand_over(frame(number));
    inbox.finish();
  });
  for (std::uint64_t number = 1; number <= 200; ++number) {
    const auto taken = inbox.take(10s);
    ASSERT_TRUE(taken);
    EXPECT_EQ(taken->number, number);
  }
  EXPECT_FALSE(inbox.take(10s));
  EXPECT_TRUE(inbox.is_finished());
  EXPECT_EQ(inbox.thinned(), 0U);
  source.join();
}

TEST(Inbox, ASourceThatWaitsEndsWhenNobodyTakesAnyMore) {
  Inbox inbox;
  ASSERT_TRUE(inbox.hand_over(frame(1)));
  std::thread waiting([&] { EXPECT_FALSE(inbox.hand_over(frame(2))); });
  std::thread pausing([&] { EXPECT_FALSE(inbox.wait_until(Clock::now() + 1h)); });
  inbox.close();
  waiting.join();
  pausing.join();
  EXPECT_FALSE(inbox.offer(frame(3)));
  EXPECT_TRUE(inbox.is_closed());
  EXPECT_EQ(inbox.offered(), 1U);
  EXPECT_EQ(inbox.thinned(), 1U);
  EXPECT_FALSE(inbox.take(0ms));
}

TEST(Inbox, TheErrorOfASourceComesBehindItsFrames) {
  Inbox inbox;
  inbox.offer(frame(1));
  inbox.finish(std::make_exception_ptr(std::runtime_error("broken")));
  EXPECT_TRUE(inbox.take(0ms));
  EXPECT_FALSE(inbox.is_finished());
  EXPECT_THROW(inbox.take(0ms), std::runtime_error);
  EXPECT_TRUE(inbox.is_finished());
}

}  // namespace
}  // namespace isotouch::stream
