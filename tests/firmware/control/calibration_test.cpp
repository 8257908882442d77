#include "firmware/control/calibration.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/firmware/store/crashing_folder.h"

namespace isotouch::control {
namespace {

using protocol::AnglesFrom;
using testing::HasSubstr;

/// A settings file that names a calibration for the serial SET.
Calibration::Choice by_settings(const std::string& serial) {
  return {libnifalcon_model(), serial == "SET" ? AnglesFrom::kSettings : AnglesFrom::kGeometry};
}

AnglesFrom from(const Calibration& calibration) { return static_cast<AnglesFrom>(calibration.report().from); }

struct CalibrationTest : testing::Test {
  protocol::Calibrate measured(const char* serial) { return {protocol::Text::of(serial), {1, 2, 3}}; }

  store::CrashingFolder folder;
  store::CalibrationStore store{folder};
};

TEST_F(CalibrationTest, WhatIsKeptHoldsFromTheNextStartOn) {
  Calibration first(&store, by_settings, "A1");
  EXPECT_EQ(from(first), AnglesFrom::kGeometry);
  first.answers("A1");
  EXPECT_FALSE(first.waits());
  EXPECT_EQ(first.keep(measured("A1")).sentence(), "");
  EXPECT_TRUE(first.waits());
  EXPECT_EQ(first.report().waits, 1);
  EXPECT_EQ(first.in_use().model, libnifalcon_model());

  Calibration next(&store, by_settings, "A1");
  EXPECT_EQ(from(next), AnglesFrom::kMeasured);
  EXPECT_EQ(next.report().at_zero, (std::array<std::uint32_t, 3>{1, 2, 3}));
  next.answers("A1");
  EXPECT_FALSE(next.waits());
}

TEST_F(CalibrationTest, ADeviceThatComesLateOrInPlaceOfAnotherHasItsOwn) {
  ASSERT_TRUE(store.put("B2", {Angle::from_raw(7), Angle::from_raw(8), Angle::from_raw(9)}));
  Calibration unknown(&store, by_settings, "");
  EXPECT_FALSE(unknown.waits());
  unknown.answers("A1");
  EXPECT_FALSE(unknown.waits()) << "nothing is kept for it";
  unknown.answers("B2");
  EXPECT_TRUE(unknown.waits());
  unknown.answers("");
  EXPECT_FALSE(unknown.waits()) << "no device, nothing to wait for";

  Calibration b(&store, by_settings, "B2");
  b.answers("A1");
  EXPECT_TRUE(b.waits()) << "the angles of another device are in use";
}

TEST_F(CalibrationTest, TheSettingsOutweighWhatIsKept) {
  ASSERT_TRUE(store.put("SET", {Angle::from_raw(7), Angle::from_raw(8), Angle::from_raw(9)}));
  Calibration calibration(&store, by_settings, "SET");
  EXPECT_EQ(from(calibration), AnglesFrom::kSettings);
  calibration.answers("SET");
  EXPECT_FALSE(calibration.waits());
  EXPECT_THAT(calibration.keep(measured("SET")).sentence(), HasSubstr("remove [calibration.SET] from the settings"));
}

TEST_F(CalibrationTest, WhatCannotBeKeptIsToldInASentence) {
  Calibration calibration(&store, by_settings, "A1");
  EXPECT_THAT(calibration.keep(measured("A1")).sentence(), HasSubstr("; calibrate again")) << "it does not answer yet";
  calibration.answers("A1");
  EXPECT_THAT(calibration.keep(measured("B2")).sentence(), HasSubstr("another device"));
  folder.full = true;
  EXPECT_THAT(calibration.keep(measured("A1")).sentence(), HasSubstr("cannot be stored"));
  EXPECT_FALSE(calibration.waits());
  Calibration without(nullptr, by_settings, "A1");
  without.answers("A1");
  EXPECT_THAT(without.keep(measured("A1")).sentence(), HasSubstr("state folder"));
}

TEST_F(CalibrationTest, AFileThatWentBadIsToldAndNotUsed) {
  ASSERT_TRUE(store.put("A1", {}));
  ASSERT_TRUE(folder.write("calibration-A1", store::FileBytes(36, 'x')));
  Calibration calibration(&store, by_settings, "A1");
  EXPECT_THAT(calibration.trouble().sentence(), HasSubstr("calibration of A1 cannot be used"));
  EXPECT_EQ(from(calibration), AnglesFrom::kGeometry);
}

}  // namespace
}  // namespace isotouch::control
