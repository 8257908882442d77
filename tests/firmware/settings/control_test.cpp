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
  settings.watch_users = "root, 1234,";
  settings.watch_groups = "77 root";
  settings.operate_users = "12";
  settings.operate_groups = "13";
  settings.service_users = "14";
  settings.service_groups = "15";
  control::ControlSettings control;
  ASSERT_EQ(apply_control(settings, control).sentence(), "");
  EXPECT_EQ(control.path, "/run/x");
  EXPECT_EQ(control.mode, 0600U);
  EXPECT_EQ(control.group, gid_t{0});
  const control::Admission& roles = control.admission;
  EXPECT_THAT(roles.watch.users, ElementsAre(0U, 1234U));
  EXPECT_THAT(roles.watch.groups, ElementsAre(77U, 0U));
  EXPECT_THAT(roles.operate.users, ElementsAre(12U));
  EXPECT_THAT(roles.operate.groups, ElementsAre(13U));
  EXPECT_THAT(roles.service.users, ElementsAre(14U));
  EXPECT_THAT(roles.service.groups, ElementsAre(15U));
}

TEST(ControlSettings, TheDefaultsAreThoseOfTheServer) {
  control::ControlSettings control;
  ASSERT_EQ(apply_control({}, control).sentence(), "");
  EXPECT_EQ(control.mode, control::ControlSettings{}.mode);
  EXPECT_FALSE(control.group);
  const control::Admission& roles = control.admission;
  for (const control::Members& members : {roles.watch, roles.operate, roles.service})
    EXPECT_TRUE(members.users.empty() && members.groups.empty());
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
  EXPECT_THAT(refusal(&Settings::watch_users, "root,no-such-user"), HasSubstr("[control] watch_users: there is no user no-such-user"));
  EXPECT_THAT(refusal(&Settings::operate_groups, "no-such-group"), HasSubstr("[control] operate_groups: there is no group no-such-group"));
  EXPECT_THAT(refusal(&Settings::service_users, "no-such-user"), HasSubstr("[control] service_users"));
}

}  // namespace
}  // namespace isotouch::settings
