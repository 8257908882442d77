#include "firmware/settings/control.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace isotouch::settings {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(ControlSettings, NamesAndNumbersBecomeWhoMayComeIn) {
  Settings settings;
  settings.control = "/run/x";
  settings.control_mode = "0600";
  settings.control_group = "0";
  settings.control_users = "root, 1234,";
  settings.control_groups = "77 root";
  control::ControlSettings control;
  ASSERT_EQ(apply_control(settings, control).sentence(), "");
  EXPECT_EQ(control.path, "/run/x");
  EXPECT_EQ(control.mode, 0600U);
  EXPECT_EQ(control.group, gid_t{0});
  EXPECT_THAT(control.admission.users, ElementsAre(0U, 1234U));
  EXPECT_THAT(control.admission.groups, ElementsAre(77U, 0U));
}

TEST(ControlSettings, TheDefaultsAreThoseOfTheServer) {
  control::ControlSettings control;
  ASSERT_EQ(apply_control({}, control).sentence(), "");
  EXPECT_EQ(control.mode, control::ControlSettings{}.mode);
  EXPECT_FALSE(control.group);
  EXPECT_TRUE(control.admission.users.empty() && control.admission.groups.empty());
}

TEST(ControlSettings, WhatIsNoNameIsToldWithItsPlace) {
  const auto refusal = [](std::string Settings::*member, const char* value) {
    Settings settings;
    settings.*member = value;
    control::ControlSettings control;
    return apply_control(settings, control).sentence();
  };
  for (const char* mode : {"", "rw", "0668", "1777", "-1"})
    EXPECT_THAT(refusal(&Settings::control_mode, mode), HasSubstr("[control] mode")) << mode;
  EXPECT_THAT(refusal(&Settings::control_group, "no-such-group"), HasSubstr("[control] group"));
  EXPECT_THAT(refusal(&Settings::control_users, "root,no-such-user"), HasSubstr("no user no-such-user"));
  EXPECT_THAT(refusal(&Settings::control_groups, "no-such-group"), HasSubstr("no group no-such-group"));
}

}  // namespace
}  // namespace isotouch::settings
