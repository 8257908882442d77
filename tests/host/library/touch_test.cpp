#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "host/library/isotouch.h"
#include "tests/host/library/golden.h"
#include "tests/support/alloc_guard.h"
#include "tests/support/scratch_folder.h"

namespace isotouch {
namespace {

using test::Field;

isotouch_settings defaults() {
  isotouch_settings settings{};
  EXPECT_EQ(isotouch_settings_default(&settings, sizeof settings), ISOTOUCH_OK);
  return settings;
}

/// A touch that ends with the test.
class Touch {
 public:
  explicit Touch(const Field& field, const isotouch_settings& settings = defaults()) {
    EXPECT_EQ(isotouch_touch_new(field.handle, &settings, sizeof settings, &handle), ISOTOUCH_OK) << isotouch_last_error();
  }
  ~Touch() { isotouch_free(handle); }
  Touch(const Touch&) = delete;
  Touch& operator=(const Touch&) = delete;

  isotouch_felt at(const double (&hip)[3]) const {
    isotouch_felt felt{};
    EXPECT_EQ(isotouch_touch_position(handle, hip, 0, &felt, sizeof felt), ISOTOUCH_OK) << isotouch_last_error();
    return felt;
  }

  isotouch_touch handle = 0;
};

/// From above the object to its middle.
std::vector<double> path_into(const isotouch_field_facts& object, int ticks) {
  std::vector<double> path;
  for (int tick = 0; tick < ticks; ++tick) {
    for (int axis = 0; axis < 3; ++axis) {
      const double middle = (object.low_mm[axis] + object.high_mm[axis]) / 2;
      path.push_back(axis == 1 ? object.high_mm[1] + (middle - object.high_mm[1]) * tick / ticks : middle);
    }
  }
  return path;
}

TEST(LibraryTouch, AHandThatSinksInIsPushedOutAndTheProxyStays) {
  const Field field;
  const Touch touch(field);
  const std::vector<double> path = path_into(field.facts(), 1000);
  std::vector<isotouch_felt> felt(1000);
  ASSERT_DONE(isotouch_touch_path(touch.handle, 1000, path.data(), felt.data(), felt.size() * sizeof felt[0]));
  EXPECT_EQ(felt.front().contact, 0U);
  EXPECT_EQ(felt.front().penetration_mm, 0);
  const isotouch_felt& last = felt.back();
  EXPECT_EQ(last.tick, 999U);
  EXPECT_EQ(last.contact, 1U);
  EXPECT_GT(last.force_n[1], 0);
  EXPECT_GT(last.proxy_mm[1], last.hip_mm[1]);
  const double way[3] = {last.proxy_mm[0] - last.hip_mm[0], last.proxy_mm[1] - last.hip_mm[1], last.proxy_mm[2] - last.hip_mm[2]};
  EXPECT_NEAR(last.penetration_mm, std::hypot(way[0], way[1], way[2]), 1e-9);
  EXPECT_GT(last.penetration_mm, 1);
  EXPECT_LE(std::hypot(last.force_n[0], last.force_n[1], last.force_n[2]), 8.001);
}

TEST(LibraryTouch, OneByOneAndAsAPathAreTheSameToTheBit) {
  const Field field;
  const Touch one(field), path(field);
  const std::vector<double> hips = path_into(field.facts(), 500);
  std::vector<isotouch_felt> felt(500);
  ASSERT_DONE(isotouch_touch_path(path.handle, 500, hips.data(), felt.data(), felt.size() * sizeof felt[0]));
  for (std::size_t tick = 0; tick < felt.size(); ++tick) {
    const isotouch_felt each = one.at({hips[3 * tick], hips[3 * tick + 1], hips[3 * tick + 2]});
    for (int axis = 0; axis < 3; ++axis) ASSERT_EQ(each.force_n[axis], felt[tick].force_n[axis]) << tick;
  }
}

TEST(LibraryTouch, ATickAllocatesNothing) {
  const Field field;
  isotouch_settings settings = defaults();
  settings.friction = 0.3;
  settings.hand_damping = 0.002;
  settings.record_ticks = 2000;
  const Touch positions(field, settings), counts(field, settings);
  const std::vector<double> path = path_into(field.facts(), 2000);
  isotouch_felt felt{};
  isotouch_status worst = ISOTOUCH_OK;
  const test::AllocGuard guard;
  for (std::size_t tick = 0; tick < 2000; ++tick) {
    worst = std::max(worst, isotouch_touch_position(positions.handle, path.data() + 3 * tick, 0, &felt, sizeof felt));
    const std::int32_t legs[3] = {static_cast<std::int32_t>(tick / 4), 0, 0};
    worst = std::max(worst, isotouch_touch_counts(counts.handle, legs, 7, 0, &felt, sizeof felt));
    if (tick % 50 == 0) worst = std::max(worst, isotouch_touch_missed(counts.handle, &felt, sizeof felt));
  }
  EXPECT_EQ(guard.count(), 0U);
  EXPECT_EQ(worst, ISOTOUCH_OK) << isotouch_last_error();
  (void)isotouch_free(1);  // a sentence is made of strings: the guard counts
  EXPECT_GT(guard.count(), 0U);
}

TEST(LibraryTouch, ADeviceGoesThroughTheStatesOfAController) {
  const Field field;
  const Touch touch(field);
  isotouch_felt felt{};
  const std::int32_t counts[3] = {0, 0, 0};
  ASSERT_DONE(isotouch_touch_counts(touch.handle, counts, 0, 0, &felt, sizeof felt));
  EXPECT_STREQ(isotouch_state_name(felt.state), "homing");
  for (int tick = 0; tick < 10; ++tick) ASSERT_DONE(isotouch_touch_counts(touch.handle, counts, 7, 0, &felt, sizeof felt));
  EXPECT_STREQ(isotouch_state_name(felt.state), "active");
  ASSERT_DONE(isotouch_touch_request(touch.handle, ISOTOUCH_STOP));
  ASSERT_DONE(isotouch_touch_counts(touch.handle, counts, 7, 0, &felt, sizeof felt));
  EXPECT_EQ(felt.state, ISOTOUCH_FAULT);
  EXPECT_NE(felt.faults, 0U);
  ASSERT_DONE(isotouch_touch_request(touch.handle, ISOTOUCH_RESUME));
  for (int tick = 0; tick < 3; ++tick) ASSERT_DONE(isotouch_touch_counts(touch.handle, counts, 7, 0, &felt, sizeof felt));
  EXPECT_EQ(felt.state, ISOTOUCH_ACTIVE);
  for (int tick = 0; tick < 5; ++tick) ASSERT_DONE(isotouch_touch_missed(touch.handle, &felt, sizeof felt));
  EXPECT_EQ(felt.state, ISOTOUCH_HOLD);
  EXPECT_STREQ(isotouch_state_name(7), "unknown");
  EXPECT_STREQ(isotouch_state_name(0x10004), "unknown");
}

/// A device that answers every ms, felt at some period: whether all its ticks are active, and how long it then takes without an answer until it holds, ms.
std::pair<bool, double> active_and_ms_until_hold(std::uint32_t period_ns) {
  const Field field;
  isotouch_settings settings = defaults();
  settings.period_ns = period_ns;
  const Touch touch(field, settings);
  const std::int32_t counts[3] = {0, 0, 0};
  isotouch_felt felt{};
  bool is_active = true;
  for (std::uint32_t ns = 0, asked_ns = 0; ns < 200'000'000; ns += period_ns) {
    if (ns >= asked_ns) {
      EXPECT_DONE(isotouch_touch_counts(touch.handle, counts, 7, 0, &felt, sizeof felt));
      asked_ns = ns + 1'000'000;
    } else {
      EXPECT_DONE(isotouch_touch_missed(touch.handle, &felt, sizeof felt));
    }
    is_active = is_active && (ns < 100'000'000 || felt.state == ISOTOUCH_ACTIVE);
  }
  EXPECT_DONE(isotouch_touch_counts(touch.handle, counts, 7, 0, &felt, sizeof felt));
  for (int missed = 1; missed < 1000; ++missed) {
    EXPECT_DONE(isotouch_touch_missed(touch.handle, &felt, sizeof felt));
    if (felt.state == ISOTOUCH_HOLD) return {is_active, 1e-6 * missed * period_ns};
  }
  return {is_active, 0};
}

TEST(LibraryTouch, ADeviceIsHeldAfterTheSameTimeAtAnyPeriod) {
  EXPECT_EQ(active_and_ms_until_hold(1'000'000), std::pair(true, 3.0));
  EXPECT_EQ(active_and_ms_until_hold(250'000), std::pair(true, 3.0));
  EXPECT_EQ(active_and_ms_until_hold(4'000'000), std::pair(true, 8.0)) << "at least two ticks";
}

TEST(LibraryTouch, AFieldMayBeFreedWhileItIsTouched) {
  isotouch_field field = 0;
  ASSERT_DONE(isotouch_field_load(test::golden("field_1_1.itf").c_str(), &field));
  isotouch_touch touch = 0;
  ASSERT_DONE(isotouch_touch_new(field, nullptr, 0, &touch));
  ASSERT_DONE(isotouch_free(field));
  isotouch_felt felt{};
  const double hip[3] = {0, 10, 0};
  EXPECT_DONE(isotouch_touch_position(touch, hip, 0, &felt, sizeof felt));
  EXPECT_DONE(isotouch_free(touch));
}

TEST(LibraryTouch, WrongArgumentsAreErrorsAndNoTick) {
  const Field field;
  const Touch touch(field);
  isotouch_felt felt{};
  const double hip[3] = {0, 60, 0}, nan[3] = {0, std::numeric_limits<double>::quiet_NaN(), 0};
  EXPECT_REFUSED(isotouch_touch_missed(touch.handle, &felt, sizeof felt), ISOTOUCH_BAD_ARGUMENT, "no sample has come");
  EXPECT_REFUSED(isotouch_touch_position(touch.handle, nan, 0, &felt, sizeof felt), ISOTOUCH_BAD_ARGUMENT, "not finite");
  EXPECT_REFUSED(isotouch_touch_position(touch.handle, nullptr, 0, &felt, sizeof felt), ISOTOUCH_BAD_ARGUMENT, "hip_mm is a null pointer");
  EXPECT_REFUSED(isotouch_touch_position(touch.handle, hip, 0, nullptr, sizeof felt), ISOTOUCH_BAD_ARGUMENT, "felt is a null pointer");
  EXPECT_REFUSED(isotouch_touch_position(touch.handle, hip, 0, &felt, sizeof felt + 1), ISOTOUCH_BAD_ARGUMENT, "instead of");
  EXPECT_REFUSED(isotouch_touch_position(touch.handle, hip, 16, &felt, sizeof felt), ISOTOUCH_BAD_ARGUMENT, "buttons");
  EXPECT_REFUSED(isotouch_touch_path(touch.handle, 2, hip, &felt, sizeof felt), ISOTOUCH_BAD_ARGUMENT, "felt");
  EXPECT_REFUSED(isotouch_touch_path(touch.handle, SIZE_MAX / 2, hip, &felt, sizeof felt), ISOTOUCH_BAD_ARGUMENT, "fit no memory");
  EXPECT_REFUSED(isotouch_touch_request(touch.handle, 4), ISOTOUCH_BAD_ARGUMENT, "requests");
  EXPECT_EQ(touch.at(hip).tick, 0U);
  const std::int32_t counts[3] = {0, 0, 0}, far[3] = {0, 40000, 0};
  EXPECT_REFUSED(isotouch_touch_counts(touch.handle, counts, 7, 0, &felt, sizeof felt), ISOTOUCH_BAD_ARGUMENT, "begun with positions");
  const Touch device(field);
  EXPECT_REFUSED(isotouch_touch_counts(device.handle, far, 7, 0, &felt, sizeof felt), ISOTOUCH_BAD_ARGUMENT, "16 bits");
  EXPECT_REFUSED(isotouch_touch_counts(device.handle, counts, 8, 0, &felt, sizeof felt), ISOTOUCH_BAD_ARGUMENT, "homed");
  EXPECT_DONE(isotouch_touch_counts(device.handle, counts, 7, 0, &felt, sizeof felt));
  EXPECT_REFUSED(isotouch_touch_position(device.handle, hip, 0, &felt, sizeof felt), ISOTOUCH_BAD_ARGUMENT, "begun with encoder counts");
}

TEST(LibraryTouch, SettingsHaveTheRangesOfTheController) {
  const Field field;
  isotouch_touch touch = 0;
  const auto refused = [&](auto change, const char* words) {
    isotouch_settings settings = defaults();
    change(settings);
    EXPECT_REFUSED(isotouch_touch_new(field.handle, &settings, sizeof settings, &touch), ISOTOUCH_BAD_ARGUMENT, words);
  };
  refused([](auto& s) { s.friction = 1.6; }, "friction is 1.6 and must be from 0 to 1.5");
  refused([](auto& s) { s.friction = std::numeric_limits<double>::quiet_NaN(); }, "friction");
  refused([](auto& s) { s.stiffness = 101; }, "N/mm and must be from 0.001 to 100, or 0 for unset");
  refused([](auto& s) { s.ramp_ticks = 1.5; }, "a whole number");
  refused([](auto& s) { s.device = 2; }, "device");
  refused([](auto& s) { s.record_ticks = 10'000'001; }, "record_ticks");
  const isotouch_settings settings = defaults();
  EXPECT_REFUSED(isotouch_touch_new(field.handle, &settings, sizeof settings - 8, &touch), ISOTOUCH_BAD_ARGUMENT, "isotouch_settings");
  EXPECT_REFUSED(isotouch_touch_new(field.handle, &settings, sizeof settings, nullptr), ISOTOUCH_BAD_ARGUMENT, "touch");
  EXPECT_REFUSED(isotouch_settings_default(nullptr, sizeof settings), ISOTOUCH_BAD_ARGUMENT, "settings");
  EXPECT_EQ(touch, 0U);
}

TEST(LibraryTouch, ARefusedSettingHasTheNameOfItsMember) {
  const Field field;
  const auto first_word = [&](auto change) {
    isotouch_settings settings = defaults();
    change(settings);
    isotouch_touch touch = 0;
    EXPECT_EQ(isotouch_touch_new(field.handle, &settings, sizeof settings, &touch), ISOTOUCH_BAD_ARGUMENT);
    const std::string sentence = isotouch_last_error();
    return sentence.substr(0, sentence.find(' '));
  };
#define EXPECT_NAMED(member) EXPECT_EQ(first_word([](auto& settings) { settings.member = 5'000'000; }), #member)
  EXPECT_NAMED(period_ns);
  EXPECT_NAMED(play_mm);
  EXPECT_NAMED(stiffness);
  EXPECT_NAMED(damping);
  EXPECT_NAMED(force_limit_n);
  EXPECT_NAMED(friction);
  EXPECT_NAMED(friction_damping);
  EXPECT_NAMED(hand_damping);
  EXPECT_NAMED(passivity_damping);
  EXPECT_NAMED(weight_n);
  EXPECT_NAMED(ramp_ticks);
  EXPECT_NAMED(device_damping);
  EXPECT_NAMED(delay_ticks);
#undef EXPECT_NAMED
}

TEST(LibraryTouch, AStiffnessThatADeviceCannotRenderIsRefused) {
  const Field field;
  isotouch_settings settings = defaults();
  settings.device_damping = 0.003;
  settings.stiffness = 10;
  isotouch_touch touch = 0;
  EXPECT_REFUSED(isotouch_touch_new(field.handle, &settings, sizeof settings, &touch), ISOTOUCH_BAD_DATA,
                 "set stiffness to at most 6 N/mm");
  settings.stiffness = 6;
  EXPECT_DONE(isotouch_touch_new(field.handle, &settings, sizeof settings, &touch));
  EXPECT_DONE(isotouch_free(touch));
}

TEST(LibraryTouch, OnlyWhatWasKeptIsSaved) {
  const ScratchFolder folder;
  const Field field;
  const std::string path = (folder.path() / "felt.trace").string();
  const Touch without(field);
  EXPECT_REFUSED(isotouch_touch_save(without.handle, path.c_str(), nullptr), ISOTOUCH_MISSING, "record_ticks");
  isotouch_settings settings = defaults();
  settings.record_ticks = 5;
  const Touch touch(field, settings);
  for (int tick = 0; tick < 8; ++tick) touch.at({0, 60.0 - tick, 0});
  std::uint64_t ticks = 0;
  ASSERT_DONE(isotouch_touch_save(touch.handle, path.c_str(), &ticks));
  EXPECT_EQ(ticks, 5U);
  isotouch_trace trace = 0;
  ASSERT_DONE(isotouch_trace_load(path.c_str(), &trace));
  double y[5] = {};
  ASSERT_DONE(isotouch_trace_doubles(trace, "hip_y_mm", 0, 5, y));
  EXPECT_EQ(y[4], 56);
  EXPECT_DONE(isotouch_free(trace));
  EXPECT_REFUSED(isotouch_touch_save(touch.handle, "/nowhere/felt.trace", nullptr), ISOTOUCH_BAD_DATA, "/nowhere");
}

}  // namespace
}  // namespace isotouch
