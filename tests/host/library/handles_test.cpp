#include <gtest/gtest.h>

#include <atomic>
#include <thread>
#include <vector>

#include "host/library/isotouch.h"
#include "tests/host/library/golden.h"

namespace isotouch {
namespace {

using test::Field;

isotouch_status describe_field(std::uint64_t handle) {
  isotouch_field_facts facts{};
  return isotouch_field_describe(handle, &facts, sizeof facts);
}

TEST(Handles, NoneIsAnErrorToUseAndNothingToFree) {
  EXPECT_REFUSED(describe_field(0), ISOTOUCH_BAD_HANDLE, "the handle is 0");
  EXPECT_DONE(isotouch_free(0));
}

TEST(Handles, AFreedHandleIsAnErrorHoweverItIsUsed) {
  isotouch_field field = 0;
  ASSERT_DONE(isotouch_field_load(test::golden("field_1_1.itf").c_str(), &field));
  ASSERT_DONE(isotouch_free(field));
  EXPECT_REFUSED(describe_field(field), ISOTOUCH_BAD_HANDLE, "was freed");
  EXPECT_REFUSED(isotouch_free(field), ISOTOUCH_BAD_HANDLE, "was freed");
  isotouch_touch touch = 0;
  EXPECT_REFUSED(isotouch_touch_new(field, nullptr, 0, &touch), ISOTOUCH_BAD_HANDLE, "was freed");
  EXPECT_REFUSED(isotouch_field_sample(field, 0, nullptr, nullptr, nullptr, nullptr, nullptr), ISOTOUCH_BAD_HANDLE, "was freed");
  EXPECT_REFUSED(isotouch_touch_path(field, 0, nullptr, nullptr, 0), ISOTOUCH_BAD_HANDLE, "was freed");
  EXPECT_REFUSED(isotouch_trace_doubles(field, "tick", 0, 0, nullptr), ISOTOUCH_BAD_HANDLE, "was freed");
  Field next;  // takes the same place
  EXPECT_NE(next.handle, field);
  EXPECT_REFUSED(describe_field(field), ISOTOUCH_BAD_HANDLE, "was freed");
  EXPECT_DONE(describe_field(next.handle));
}

TEST(Handles, NumbersThatWereNeverGivenOutAreErrors) {
  const Field field;
  for (const std::uint64_t handle : {std::uint64_t{1}, ~std::uint64_t{0}, field.handle + 1, field.handle ^ (std::uint64_t{1} << 40),
                                     field.handle | 0xFFFF, std::uint64_t{0x0100000000001000}}) {
    EXPECT_EQ(describe_field(handle), ISOTOUCH_BAD_HANDLE) << handle;
    EXPECT_EQ(isotouch_free(handle), ISOTOUCH_BAD_HANDLE) << handle;
  }
}

TEST(Handles, AHandleOfAnotherKindIsNamed) {
  const Field field;
  isotouch_felt felt{};
  const double hip[3] = {0, 0, 0};
  EXPECT_REFUSED(isotouch_touch_position(field.handle, hip, 0, &felt, sizeof felt), ISOTOUCH_BAD_HANDLE, "the handle of a field");
  EXPECT_REFUSED(isotouch_controller_stop(field.handle), ISOTOUCH_BAD_HANDLE, "that of a controller is needed");
}

TEST(Handles, MoreThanThereIsRoomForIsAnError) {
  const Field field;
  std::vector<isotouch_touch> touches;
  isotouch_touch touch = 0;
  isotouch_status status = ISOTOUCH_OK;
  while ((status = isotouch_touch_new(field.handle, nullptr, 0, &touch)) == ISOTOUCH_OK) touches.push_back(touch);
  EXPECT_REFUSED(status, ISOTOUCH_NO_MEMORY, "4096 handles");
  EXPECT_EQ(touches.size(), 4095U);
  for (const isotouch_touch each : touches) EXPECT_DONE(isotouch_free(each));
  EXPECT_DONE(isotouch_touch_new(field.handle, nullptr, 0, &touch));
  EXPECT_DONE(isotouch_free(touch));
}

TEST(Handles, ThreadsThatUseAndFreeAtOnceGetErrorsAndNeverCrash) {
  std::atomic<isotouch_touch> shared{0};
  std::atomic<bool> ends{false};
  std::atomic<int> good{0}, strange{0};
  const Field field;
  const auto use = [&] {
    const double hip[3] = {0, 30, 0};
    while (!ends) {
      isotouch_felt felt{};
      const isotouch_status status = isotouch_touch_position(shared, hip, 0, &felt, sizeof felt);
      if (status == ISOTOUCH_OK)
        ++good;
      else if (status != ISOTOUCH_BAD_HANDLE && status != ISOTOUCH_BUSY)
        ++strange;
    }
  };
  std::vector<std::thread> threads;
  for (int i = 0; i < 2; ++i) threads.emplace_back(use);
  for (int round = 0; round < 50 || (good == 0 && round < 2'000'000); ++round) {
    isotouch_touch touch = 0;
    EXPECT_DONE(isotouch_touch_new(field.handle, nullptr, 0, &touch));
    shared = touch;
    while (isotouch_free(touch) == ISOTOUCH_BUSY) std::this_thread::yield();
  }
  ends = true;
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(strange, 0);
  EXPECT_GT(good, 0);
}

TEST(Handles, TheSentenceBelongsToItsThread) {
  (void)isotouch_fail(ISOTOUCH_BAD_DATA, "here");
  std::thread([] {
    EXPECT_STREQ(isotouch_last_error(), "");
    (void)isotouch_fail(ISOTOUCH_BAD_DATA, "there");
  }).join();
  EXPECT_STREQ(isotouch_last_error(), "here");
  EXPECT_DONE(isotouch_free(0));
  EXPECT_STREQ(isotouch_last_error(), "here");
  EXPECT_EQ(isotouch_fail(ISOTOUCH_BUSY, nullptr), ISOTOUCH_BUSY);
  EXPECT_STREQ(isotouch_last_error(), "");
  (void)isotouch_fail(ISOTOUCH_BUSY, std::string(999, 'a').append("ä").c_str());
  EXPECT_EQ(std::string(isotouch_last_error()), std::string(999, 'a'));
}

}  // namespace
}  // namespace isotouch
