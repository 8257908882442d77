#include "firmware/settings/apply.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/field_image.h"

namespace isotouch::settings {
namespace {

using testing::HasSubstr;

TEST(ApplySettings, TheDefaultsAreThoseOfTheLayersBelow) {
  const Settings settings;
  EXPECT_EQ(*device_model(settings, ""), libnifalcon_model());
  TickSettings tick;  // it knows no device
  tick.device_damping = Damping::of(0.003);
  tick.delay_ticks = 1;
  EXPECT_EQ(tick_settings(settings), tick);
  EXPECT_EQ(period_ns(settings), 1'000'000U);
  const falcon::SessionSettings session = session_settings(settings), plain;
  EXPECT_EQ(session.boot.attempts, plain.boot.attempts);
  EXPECT_EQ(session.boot.ignore_echo, plain.boot.ignore_echo);
  EXPECT_EQ(session.boot.always_upload, plain.boot.always_upload);
  EXPECT_EQ(session.device.reply_ns, 3'000'000) << "a hold";
  EXPECT_EQ(session.device.reply_ns * session.device.lost_after, 102'000'000);
  EXPECT_EQ(plain.device.reply_ns * plain.device.lost_after, 100'000'000) << "without settings a device is lost as late";
}

TEST(ApplySettings, TheOtherGeometryIsTheOtherModel) {
  Settings settings;
  settings.geometry = "martin-hillier";
  EXPECT_EQ(*device_model(settings, ""), martin_hillier_model());
}

TEST(ApplySettings, NumbersOfAPublishedSetWrittenOutAreThatSet) {
  Settings settings;
  settings.gear_ratio = 110.0 / 14.25;
  settings.angle_at_zero_deg = 35;
  settings.torque_per_word_nmm = 0.1;
  const DeviceModel model = *device_model(settings, ""), set = libnifalcon_model();
  EXPECT_EQ(model.word_torque, set.word_torque);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(model.legs[i].at_zero, set.legs[i].at_zero);
    EXPECT_NEAR(model.legs[i].per_count.raw(), set.legs[i].per_count.raw(), 1);
  }
}

TEST(ApplySettings, AnglesFarFromTheGeometrysAreRefused) {
  Settings settings;
  EXPECT_FALSE(refusal_of_angles(settings));
  settings.angle_at_zero_deg = 55;
  settings.calibrations["A1"].angle_at_zero_deg = {35, 55, 75};
  EXPECT_FALSE(refusal_of_angles(settings));
  settings.calibrations["A1"].angle_at_zero_deg[0] = 34.99;
  EXPECT_THAT(
      refusal_of_angles(settings).sentence(),
      HasSubstr("calibration.A1.angle_at_zero_deg has an arm at 34.99 degrees, more than 20 degrees away from device.angle_at_zero_deg"));
  settings.angle_at_zero_deg.reset();
  settings.calibrations["A1"].angle_at_zero_deg = {35, 35, -35};
  EXPECT_THAT(refusal_of_angles(settings).sentence(),
              HasSubstr("has an arm at -35 degrees, more than 20 degrees away from where the geometry"));
  settings.calibrations.clear();
  settings.angle_at_zero_deg = 55.01;
  EXPECT_THAT(refusal_of_angles(settings).sentence(), HasSubstr("device.angle_at_zero_deg has an arm at 55.01 degrees"));
  settings.geometry = "martin-hillier";
  EXPECT_FALSE(refusal_of_angles(settings)) << "40 degrees at count 0";
}

TEST(ApplySettings, EveryNumberArrivesInItsUnit) {
  Settings settings;
  settings.workspace_origin_mm = {1, -2.5, 110};
  settings.word = 2000;
  settings.word_slew = 5000;
  settings.penetration_mm = 7.5;
  settings.speed_mm_s = 1500;
  settings.hold_ms = 20;
  settings.fault_age_ms = 12.5;
  settings.count_jump = 99;
  settings.ramp_after_rest_ms = 44;
  settings.keep_homing_flag = false;
  settings.led_homing = "none";
  settings.led_idle = "green";
  settings.led_active = "red";
  settings.stiffness = 1.5;
  settings.damping = 0.001;
  settings.force_limit_n = 4;
  settings.ramp_ms = 28;
  settings.heat_word = 1234;
  settings.heat_s = 7.5;
  settings.button_mask = 5;
  settings.hold_to_run = true;
  settings.tick_hz = 250;
  const DeviceModel model = *device_model(settings, "");
  EXPECT_EQ(model.workspace_origin, (Vec3<Mm>{Mm::of(1), Mm::of(-2.5), Mm::of(110)}));
  EXPECT_EQ(model.word_limit, 2000);
  EXPECT_EQ(model.word_slew, 5000);
  EXPECT_EQ(model.penetration_limit, Mm::of(7.5));
  EXPECT_EQ(model.speed_limit, MmPerS::of(1500));
  EXPECT_EQ(model.hold_ticks, 5U);
  EXPECT_EQ(model.fault_age_ns, 12'500'000U);
  EXPECT_EQ(model.count_jump, 99);
  EXPECT_EQ(model.ramp_ticks, 11U);
  EXPECT_EQ(model.heat_word, 1234);
  EXPECT_EQ(model.heat_ms, 7500U);
  EXPECT_EQ(model.buttons, 5);
  EXPECT_EQ(model.hold_to_run, 1);
  EXPECT_EQ(model.homing_flag, 0);
  EXPECT_EQ(model.led_homing, 0);
  EXPECT_EQ(model.led_idle, kFalconGreen);
  EXPECT_EQ(model.led_active, kFalconRed);
  settings.friction = 0.5;
  settings.friction_damping = 0.001;
  settings.hand_damping = 0.002;
  settings.passivity_damping = 0.1;
  settings.weight_n = -0.75;
  settings.delay_ticks = 7;
  const TickSettings tick = tick_settings(settings);
  EXPECT_EQ(tick.friction, Ratio::of(0.5));
  EXPECT_EQ(tick.friction_damping, Damping::of(0.001));
  EXPECT_EQ(tick.hand_damping, Damping::of(0.002));
  EXPECT_EQ(tick.passivity, Damping::of(0.1));
  EXPECT_EQ(tick.weight, Newton::of(-0.75));
  EXPECT_EQ(tick.delay_ticks, 7U);
  EXPECT_EQ(tick.stiffness, Stiffness::of(1.5));
  EXPECT_EQ(tick.damping, Damping::of(0.001));
  EXPECT_EQ(tick.force_limit, Newton::of(4));
  EXPECT_EQ(tick.ramp_ticks, 7U);
  EXPECT_EQ(period_ns(settings), 4'000'000U);
  EXPECT_EQ(field_bytes(settings), 16U << 20);
}

TEST(ApplySettings, HowTheDeviceIsBroughtUpAndGivenUpIsTheSettings) {
  Settings settings;
  settings.attempts = 9;
  settings.ignore_echo = !settings.ignore_echo;
  settings.always_upload = !settings.always_upload;
  settings.lost_after = 77;
  const falcon::SessionSettings session = session_settings(settings);
  EXPECT_EQ(session.boot.attempts, 9);
  EXPECT_EQ(session.boot.ignore_echo, settings.ignore_echo);
  EXPECT_EQ(session.boot.always_upload, settings.always_upload);
  EXPECT_EQ(session.device.lost_after, 77);
}

TEST(ApplySettings, NoReplyIsWaitedForLongerThanAHold) {
  Settings settings;
  settings.reply_ms = 7.5;
  settings.hold_ms = 7.5;
  EXPECT_EQ(session_settings(settings).device.reply_ns, 7'500'000);
  settings.hold_ms = 3;
  EXPECT_EQ(session_settings(settings).device.reply_ns, 3'000'000);
  settings.reply_ms = 2.5;
  EXPECT_EQ(session_settings(settings).device.reply_ns, 2'500'000);
  settings.reply_ms = 100;
  settings.tick_hz = 250;  // a hold is at least two ticks
  EXPECT_EQ(session_settings(settings).device.reply_ns, 8'000'000);
}

TEST(ApplySettings, TimesStayTimesAtAnyRate) {
  Settings settings;
  settings.tick_hz = 10'000;
  EXPECT_EQ((*device_model(settings, "")).hold_ticks, 30U) << "a device of 1 kHz answers every tenth tick";
  EXPECT_EQ((*device_model(settings, "")).ramp_ticks, 2000U);
  EXPECT_EQ(tick_settings(settings).ramp_ticks, 500U);
  settings.tick_hz = 250;
  EXPECT_EQ((*device_model(settings, "")).hold_ticks, 2U);
}

TEST(ApplySettings, AFieldTooStiffForTheLoopIsRefusedWithTheStiffnessToSet) {
  const test::FieldImage field({16, 16, 16},
                               [](const test::Point& p) {
                                 return test::length(p - test::Point{8, 8, 8}) - 3.0;
                               },
                               {.band = 2.0});
  Settings settings;
  EXPECT_EQ(refusal_of(field.view(), settings).sentence(), "");
  settings.stiffness = 2.5;  // 2 * 0.003 / (3 * 0.001) = 2 would do
  EXPECT_EQ(refusal_of(field.view(), settings).sentence(),
            "the field is too stiff for this device at this rate; set feel.stiffness to at most 2 N/mm");
  settings.stiffness = 1.99;
  EXPECT_EQ(refusal_of(field.view(), settings).sentence(), "");
  settings.tick_hz = 250;
  EXPECT_EQ(refusal_of(field.view(), settings).sentence(),
            "the field is too stiff for this device at this rate; set feel.stiffness to at most 0.5 N/mm");
  settings.tick_hz = 1000;
  EXPECT_EQ(refusal_of(field.view(), settings, 1).sentence(), "");
  EXPECT_EQ(
      refusal_of(field.view(), settings, 3).sentence(),
      "the field is too stiff for this device at this rate and its measured delay of 3 ticks; set feel.stiffness to at most 0.857 N/mm");
  settings.tick_hz = 250;
  settings.delay_ticks = 0;
  settings.damping_n_s_mm = 0.006;
  EXPECT_EQ(refusal_of(field.view(), settings).sentence(), "");
}

TEST(ApplySettings, EachLineIsItsOwn) {
  Settings settings;
  settings.line_stop = 1, settings.line_enable = 2, settings.line_enable_back = 3, settings.line_heartbeat = 4, settings.line_light = 5;
  settings.line_settle_ms = 7;
  const lines::GpioSettings lines = gpio_settings(settings);
  EXPECT_EQ(lines.stop, 1);
  EXPECT_EQ(lines.enable, 2);
  EXPECT_EQ(lines.enable_back, 3);
  EXPECT_EQ(lines.heartbeat, 4);
  EXPECT_EQ(lines.light, 5);
  EXPECT_EQ(watchdog_settings(settings).settle_ns, 7'000'000);
}

TEST(ApplySettings, ACalibrationIsThatOfItsSerialOnly) {
  Settings settings;
  settings.angle_at_zero_deg = 40;
  settings.calibrations["A"] = {{34, 35, 36}};
  EXPECT_EQ((*device_model(settings, "A")).legs[2].at_zero, Angle::degrees(36));
  EXPECT_EQ((*device_model(settings, "B")).legs[2].at_zero, Angle::degrees(40));
}

TEST(Apply, EveryThreadAsksForItsOwnPriorityAndCore) {
  Settings settings;
  settings.priority = 11, settings.core = 1;
  settings.exchange_priority = 12, settings.exchange_core = 2;
  settings.watchdog_priority = 13, settings.watchdog_core = 3;
  const Threads threads = thread_rights(settings);
  EXPECT_EQ(threads.tick, (ThreadRights{11, 1}));
  EXPECT_EQ(threads.exchange, (ThreadRights{12, 2}));
  EXPECT_EQ(threads.watchdog, (ThreadRights{13, 3}));
}

}  // namespace
}  // namespace isotouch::settings
