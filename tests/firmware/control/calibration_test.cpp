#include "firmware/control/calibration.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <utility>

#include "tests/firmware/store/crashing_folder.h"

namespace isotouch::control {
namespace {

using protocol::AnglesFrom, protocol::OtherAngles;
using testing::HasSubstr;

/// A settings file that names a calibration for the serial SET.
Calibration::Choice by_settings(const std::string& serial) {
  return {libnifalcon_model(), serial == "SET" ? AnglesFrom::kSettings : AnglesFrom::kGeometry};
}

AnglesFrom from(const Calibration& calibration) { return static_cast<AnglesFrom>(calibration.report().from); }

struct CalibrationTest : testing::Test {
  /// A little beside where the geometry set has the arms.
  static std::uint32_t near(std::uint32_t by) { return libnifalcon_model().legs[0].at_zero.raw() + by; }
  static protocol::Calibrate measured(const char* serial) { return {protocol::Text::of(serial), {near(1), near(2), near(3)}}; }
  static store::AnglesAtZero angles(std::uint32_t by) {
    return {Angle::from_raw(near(by)), Angle::from_raw(near(by)), Angle::from_raw(near(by))};
  }

  store::CrashingFolder folder;
  store::CalibrationStore store{folder};
};

TEST_F(CalibrationTest, WhatIsKeptHoldsFromTheNextStartOn) {
  Calibration first(&store, nullptr, by_settings, "A1", [](bool) {});
  EXPECT_EQ(from(first), AnglesFrom::kGeometry);
  first.answers("A1");
  EXPECT_EQ(first.others(), OtherAngles::kNone);
  EXPECT_EQ(first.keep(measured("A1")).sentence(), "");
  EXPECT_EQ(first.others(), OtherAngles::kKept);
  EXPECT_EQ(first.report().waits, static_cast<std::uint8_t>(OtherAngles::kKept));
  EXPECT_EQ(first.in_use().model, libnifalcon_model());
  first.answers("A1");
  EXPECT_EQ(first.others(), OtherAngles::kUntrusted) << "it is plugged in anew";
  EXPECT_EQ(first.keep(measured("A1")).sentence(), "");
  EXPECT_EQ(first.others(), OtherAngles::kUntrusted) << "it is still not heard";

  Calibration next(&store, nullptr, by_settings, "A1", [](bool) {});
  EXPECT_EQ(from(next), AnglesFrom::kMeasured);
  EXPECT_EQ(next.report().at_zero, (std::array<std::uint32_t, 3>{near(1), near(2), near(3)}));
  next.answers("A1");
  EXPECT_EQ(next.others(), OtherAngles::kNone);
}

TEST_F(CalibrationTest, TheDeviceIsDistrustedAsSoonAsOtherAnglesAreKeptForIt) {
  int distrusted = 0;
  Calibration calibration(&store, nullptr, by_settings, "A1", [&](bool answers) { distrusted += answers ? 1 : 100; });
  calibration.answers("A1");
  EXPECT_EQ(calibration.keep({protocol::Text::of("A1"), {near(0), near(0), near(0)}}).sentence(), "");
  EXPECT_EQ(distrusted, 0) << "they are those in use";
  EXPECT_EQ(calibration.keep(measured("A1")).sentence(), "");
  EXPECT_EQ(distrusted, 1);
  EXPECT_THAT(calibration.keep(measured("B2")).sentence(), HasSubstr("another device"));
  EXPECT_EQ(distrusted, 1);
}

TEST_F(CalibrationTest, ADeviceThatComesLateOrInPlaceOfAnotherHasItsOwn) {
  ASSERT_TRUE(store.put("B2", angles(7)));
  Calibration unknown(&store, nullptr, by_settings, "", [](bool) {});
  EXPECT_EQ(unknown.others(), OtherAngles::kNone);
  unknown.answers("A1");
  EXPECT_EQ(unknown.others(), OtherAngles::kNone) << "nothing is kept for it";
  unknown.answers("B2");
  EXPECT_EQ(unknown.others(), OtherAngles::kUntrusted);
  unknown.answers(std::nullopt);
  EXPECT_EQ(unknown.others(), OtherAngles::kNone) << "no device, nothing to wait for";

  Calibration b(&store, nullptr, by_settings, "B2", [](bool) {});
  b.answers("A1");
  EXPECT_EQ(b.others(), OtherAngles::kUntrusted) << "the angles of another device are in use";
  b.answers("");
  EXPECT_EQ(b.others(), OtherAngles::kUntrusted) << "one without a serial is another one, too";
}

TEST_F(CalibrationTest, WhatIsKeptOfADeviceThatHasGoneSaysNothingOfTheOneThatAnswers) {
  ASSERT_TRUE(store.put("B2", angles(7)));
  std::optional<Calibration> calibration;
  std::string comes;
  const auto swaps = [&](const std::string& serial) {
    if (!comes.empty()) calibration->answers(std::exchange(comes, ""));
    return by_settings(serial);
  };
  std::string distrusted;
  calibration.emplace(&store, nullptr, swaps, "A1",
                      [&](bool answers) { distrusted += answers ? "the one in use" : "the one that has gone"; });
  calibration->answers("A1");
  comes = "B2";
  EXPECT_EQ(calibration->keep({protocol::Text::of("A1"), {near(0), near(0), near(0)}}).sentence(), "");
  EXPECT_EQ(calibration->others(), OtherAngles::kUntrusted) << "B2 does not have the angles in use";
  EXPECT_EQ(distrusted, "");
  calibration->answers("A1");
  comes = "C3";
  EXPECT_EQ(calibration->keep(measured("A1")).sentence(), "");
  EXPECT_EQ(calibration->others(), OtherAngles::kNone) << "C3 has the angles in use";
  EXPECT_EQ(distrusted, "the one that has gone") << "A1 would come back as the expected one";
}

TEST_F(CalibrationTest, ADeviceThatGoesWhileItsAnglesAreStoredIsDistrusted) {
  std::optional<Calibration> calibration;
  bool goes = false;
  int distrusted = 0;
  const auto by_leaving = [&](const std::string& serial) {
    if (std::exchange(goes, false)) calibration->answers(std::nullopt);
    return by_settings(serial);
  };
  calibration.emplace(&store, nullptr, by_leaving, "A1", [&](bool) { ++distrusted; });
  calibration->answers("A1");
  goes = true;
  EXPECT_EQ(calibration->keep(measured("A1")).sentence(), "");
  EXPECT_EQ(calibration->others(), OtherAngles::kNone) << "no device, nothing to wait for";
  EXPECT_EQ(distrusted, 1) << "back again, it is the expected one until somebody looks";
}

TEST_F(CalibrationTest, ADeviceThatComesWhileItsAnglesAreStoredIsNotFeltWithTheOldOnes) {
  ASSERT_TRUE(store.put("A1", angles(7)));
  Calibration calibration(&store, nullptr, by_settings, "A1", [](bool) {});
  calibration.answers("A1");
  EXPECT_EQ(calibration.others(), OtherAngles::kNone);
  folder.after_read = [&] { EXPECT_EQ(calibration.keep(measured("A1")).sentence(), ""); };
  calibration.answers("A1");
  EXPECT_EQ(calibration.others(), OtherAngles::kUntrusted) << "what was read is not what is stored by now";
}

/// In lockstep: who would trust one again is no part of it.
TEST_F(CalibrationTest, WhereNoDeviceIsDistrustedNoOtherAnglesWait) {
  ASSERT_TRUE(store.put("B2", angles(7)));
  Calibration calibration(&store, nullptr, by_settings, "A1");
  calibration.answers("A1");
  EXPECT_THAT(calibration.keep(measured("A1")).sentence(), HasSubstr("start it without --lockstep"));
  EXPECT_FALSE(store.read("A1"));
  calibration.answers("B2");
  EXPECT_EQ(calibration.others(), OtherAngles::kNone) << "it is heard with the angles in use";
}

TEST_F(CalibrationTest, AnglesFarFromTheGeometrysAreNeitherKeptNorUsed) {
  constexpr double kTurn = 4294967296.0;
  Calibration calibration(&store, nullptr, by_settings, "A1", [](bool) {});
  calibration.answers("A1");
  for (const double degrees : {-26.0, -25.0, -20.1, 20.1, 90.0, 180.0}) {
    const std::uint32_t at = near(static_cast<std::uint32_t>(static_cast<std::int64_t>(degrees / 360 * kTurn)));
    EXPECT_THAT(calibration.keep({protocol::Text::of("A1"), {near(1), near(2), at}}).sentence(), HasSubstr("more than 20 degrees away"))
        << degrees;
    EXPECT_EQ(calibration.others(), OtherAngles::kNone) << degrees;
    ASSERT_TRUE(store.put("A1", {Angle::from_raw(at), Angle::from_raw(near(2)), Angle::from_raw(near(3))}));
    Calibration next(&store, nullptr, by_settings, "A1", [](bool) {});
    EXPECT_EQ(from(next), AnglesFrom::kGeometry) << degrees;
    EXPECT_THAT(next.trouble().sentence(), HasSubstr("more than 20 degrees away")) << degrees;
    ASSERT_TRUE(folder.remove("calibration-A1"));
  }
  for (const double degrees : {-19.9, 15.0, 19.9}) {
    const std::uint32_t at = near(static_cast<std::uint32_t>(static_cast<std::int64_t>(degrees / 360 * kTurn)));
    EXPECT_EQ(calibration.keep({protocol::Text::of("A1"), {near(1), near(2), at}}).sentence(), "") << degrees;
  }
}

TEST_F(CalibrationTest, NoAnglesAreStoredThatThePersonIsNotAskedToConfirm) {
  for (const auto torn : {store::CrashingFolder::Content::kEmpty, store::CrashingFolder::Content::kTorn}) {
    bool stored = false;
    for (int steps = 0; !stored && steps < 100; ++steps) {
      store::CrashingFolder cut;
      store::CalibrationStore kept(cut);
      store::RunMark mark(cut);
      ASSERT_EQ(mark.begin().sentence(), "");
      Calibration calibration(&kept, &mark, by_settings, "A1", [](bool) {});
      calibration.answers("A1");
      cut.steps_left = steps;
      (void)calibration.keep(measured("A1"));
      store::CrashingFolder after = cut.after_power_cut(0, torn);
      stored = static_cast<bool>(store::CalibrationStore(after).read("A1"));
      EXPECT_TRUE(!stored || store::RunMark(after).recalibrated()) << steps;
    }
    EXPECT_TRUE(stored);
  }
}

TEST_F(CalibrationTest, TheSettingsOutweighWhatIsKept) {
  ASSERT_TRUE(store.put("SET", angles(7)));
  Calibration calibration(&store, nullptr, by_settings, "SET", [](bool) {});
  EXPECT_EQ(from(calibration), AnglesFrom::kSettings);
  calibration.answers("SET");
  EXPECT_EQ(calibration.others(), OtherAngles::kNone);
  EXPECT_THAT(calibration.keep(measured("SET")).sentence(), HasSubstr("remove [calibration.SET] from the settings"));
}

TEST_F(CalibrationTest, WhatCannotBeKeptIsToldInASentence) {
  Calibration calibration(&store, nullptr, by_settings, "A1", [](bool) {});
  EXPECT_THAT(calibration.keep(measured("A1")).sentence(), HasSubstr("; calibrate again")) << "it does not answer yet";
  calibration.answers("A1");
  EXPECT_THAT(calibration.keep(measured("B2")).sentence(), HasSubstr("another device"));
  folder.full = true;
  EXPECT_THAT(calibration.keep(measured("A1")).sentence(), HasSubstr("cannot be stored"));
  EXPECT_EQ(calibration.others(), OtherAngles::kNone);
  Calibration without(nullptr, nullptr, by_settings, "A1", [](bool) {});
  without.answers("A1");
  EXPECT_THAT(without.keep(measured("A1")).sentence(), HasSubstr("state folder"));
}

TEST_F(CalibrationTest, AFileThatWentBadIsToldAndNotUsed) {
  ASSERT_TRUE(store.put("A1", {}));
  ASSERT_TRUE(folder.write("calibration-A1", store::FileBytes(36, 'x')));
  Calibration calibration(&store, nullptr, by_settings, "A1", [](bool) {});
  EXPECT_THAT(calibration.trouble().sentence(), HasSubstr("calibration of A1 cannot be used"));
  EXPECT_THAT(calibration.trouble().sentence(), HasSubstr("; calibrate again"));
  EXPECT_EQ(from(calibration), AnglesFrom::kGeometry);
  calibration.answers("A1");
  EXPECT_EQ(calibration.others(), OtherAngles::kNone) << "the start has told";
  Calibration late(&store, nullptr, by_settings, "", [](bool) {});
  EXPECT_FALSE(late.trouble());
  late.answers("A1");
  EXPECT_EQ(late.others(), OtherAngles::kUntrusted) << "a new start tells, and waits for a person";
}

}  // namespace
}  // namespace isotouch::control
