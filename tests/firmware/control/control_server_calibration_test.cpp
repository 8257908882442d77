#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "tests/firmware/control/control_rig.h"
#include "tests/firmware/store/packed_field.h"

namespace isotouch::control {
namespace {

using protocol::Kind;

TEST(ControlServerCalibration, MeasuresKeepsAndTells) {
  ControlRig rig;
  rig.calibration.answers("A1");
  rig.tick.count = -123;
  Speaker speaker(rig.settings.path);
  speaker.greet();
  const Heard heard = ask(speaker, Kind::kPosture);
  ASSERT_EQ(heard.kind, Kind::kPostureReport) << heard.refusal();
  const auto posture = *protocol::decode<protocol::PostureReport>(heard.body);
  EXPECT_EQ(posture.serial.view(), "A1");
  EXPECT_EQ(posture.counts, (std::array<std::int32_t, 3>{-123 * 256, -123 * 256, -123 * 256}));
  const DeviceModelBytes model = encode(libnifalcon_model());
  EXPECT_THAT(posture.device, testing::ElementsAreArray(model));

  const std::uint32_t near = libnifalcon_model().legs[0].at_zero.raw();
  speaker.say(Kind::kCalibrate, protocol::Calibrate{protocol::Text::of("A1"), {near + 5, near + 6, near + 7}});
  const Heard kept = speaker.hear();
  EXPECT_EQ(kept.kind, Kind::kDone) << kept.refusal();
  EXPECT_EQ((*rig.measured.read("A1"))[1].raw(), near + 6);
  const Heard device = ask(speaker, Kind::kDevice);
  ASSERT_EQ(device.kind, Kind::kDeviceReport);
  const auto report = *protocol::decode<protocol::DeviceReport>(device.body);
  EXPECT_EQ(report.serial.view(), "A1");
  EXPECT_EQ(report.waits, static_cast<std::uint8_t>(protocol::OtherAngles::kKept));
  EXPECT_EQ(report.at_zero[0], libnifalcon_model().legs[0].at_zero.raw()) << "in use is what was there at the start";
  for (const Kind kind : {Kind::kResume, Kind::kSelect, Kind::kCommit, Kind::kPosture, Kind::kCalibrate})
    expect_sentence(ask(speaker, kind),
                    "other angles were measured for this device, so it gets no force until the controller has started again");
  rig.calibration.answers("A1");
  for (const Kind kind : {Kind::kResume, Kind::kSelect, Kind::kCommit, Kind::kPosture, Kind::kCalibrate})
    expect_sentence(ask(speaker, kind), "the angles in use are not those of the device that answers, so it gets no force");
}

TEST(ControlServerCalibration, TheSecondOfTwoThatMeasuredReplacesNothing) {
  ControlRig rig;
  rig.calibration.answers("A1");
  Speaker first(rig.settings.path), second(rig.settings.path);
  for (Speaker* speaker : {&first, &second}) {
    speaker->greet();
    ASSERT_EQ(ask(*speaker, Kind::kPosture).kind, Kind::kPostureReport);
  }
  const std::uint32_t near = libnifalcon_model().legs[0].at_zero.raw();
  first.say(Kind::kCalibrate, protocol::Calibrate{protocol::Text::of("A1"), {near + 5, near + 6, near + 7}});
  ASSERT_EQ(first.hear().kind, Kind::kDone);
  second.say(Kind::kCalibrate, protocol::Calibrate{protocol::Text::of("A1"), {near + 8, near + 8, near + 8}});
  expect_sentence(second.hear(), "other angles were measured for this device");
  EXPECT_EQ((*rig.measured.read("A1"))[1].raw(), near + 6);
}

TEST(ControlServerCalibration, IsRefusedInOneSentenceWithWhatToDo) {
  ControlRig rig;
  Speaker speaker(rig.settings.path);
  speaker.greet();
  expect_sentence(ask(speaker, Kind::kPosture), "no device");
  rig.calibration.answers("A1");
  speaker.say(Kind::kCalibrate, protocol::Calibrate{protocol::Text::of("B2"), {}});
  expect_sentence(speaker.hear(), "another device");
  speaker.say(Kind::kCalibrate);
  expect_sentence(speaker.hear(), "too short");

  rig.tick.sway = 50;
  expect_sentence(ask(speaker, Kind::kPosture), "the hand moves");

  ASSERT_EQ(upload(speaker, store::packed_ball(1)).kind, Kind::kAccepted);
  expect_sentence(ask(speaker, Kind::kPosture), "force is active");
}

TEST(ControlServerCalibration, NothingThatLeadsToForceIsTakenMeanwhile) {
  ControlRig rig;
  rig.calibration.answers("A1");
  Speaker measurer(rig.settings.path), other(rig.settings.path), third(rig.settings.path);
  measurer.greet();
  third.greet();
  rig.tick.rests = true;
  measurer.say(Kind::kPosture);
  expect_sentence(upload(other, store::packed_ball(1)), "is being measured");
  expect_sentence(ask(third, Kind::kPosture), "is being measured");
  expect_sentence(ask(third, Kind::kResume), "is being measured");
  EXPECT_EQ(ask(third, Kind::kStop).kind, Kind::kDone) << "but stop is always heard";
  rig.tick.rests = false;
  EXPECT_EQ(measurer.hear().kind, Kind::kPostureReport);
  EXPECT_EQ(upload(other, store::packed_ball(1)).kind, Kind::kAccepted) << "and everything after it";
}

TEST(ControlServerCalibration, NobodyResumesWhileItIsStored) {
  ControlRig rig;
  rig.calibration.answers("A1");
  Speaker measurer(rig.settings.path), other(rig.settings.path);
  rig.disk_is_busy = true;
  const int before = rig.looked_up;
  const std::uint32_t near = libnifalcon_model().legs[0].at_zero.raw();
  measurer.greet();
  measurer.say(Kind::kCalibrate, protocol::Calibrate{protocol::Text::of("A1"), {near + 5, near + 6, near + 7}});
  while (rig.looked_up == before) std::this_thread::yield();
  other.greet();
  expect_sentence(ask(other, Kind::kResume), "measured or stored");
  EXPECT_EQ(ask(other, Kind::kStop).kind, Kind::kDone) << "but stop is always heard";
  rig.disk_is_busy = false;
  rig.disk_is_busy.notify_all();
  EXPECT_EQ(measurer.hear().kind, Kind::kDone);
  expect_sentence(ask(other, Kind::kResume), "other angles were measured");
}

/// A tick that is under way when somebody asks may not have heard of the stop before.
TEST(ControlServerCalibration, TheTickUnderWayDoesNotCount) {
  ControlRig rig;
  rig.calibration.answers("A1");
  Speaker measurer(rig.settings.path), other(rig.settings.path);
  measurer.greet();
  other.greet();
  rig.tick.rests = true;
  for (std::uint64_t before = 0; before != rig.tick.stats.ticks.value();) {
    before = rig.tick.stats.ticks.value();
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  rig.tick.word = 100;
  measurer.say(Kind::kPosture);
  expect_sentence(ask(other, Kind::kPosture), "is being measured");
  rig.tick.rests = false;
  const Heard heard = measurer.hear();
  EXPECT_EQ(heard.kind, Kind::kPostureReport) << heard.refusal();
}

TEST(ControlServerCalibration, WhoHangsUpWhileItIsMeasuredHoldsNobodyUp) {
  ControlRig rig;
  rig.calibration.answers("A1");
  Speaker other(rig.settings.path);
  {
    Speaker measurer(rig.settings.path);
    measurer.greet();
    measurer.say(Kind::kPosture);
  }
  EXPECT_EQ(upload(other, store::packed_ball(1)).kind, Kind::kAccepted);
}

}  // namespace
}  // namespace isotouch::control
