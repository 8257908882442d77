#include "firmware/settings/table.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "firmware/settings/read_settings.h"

namespace isotouch::settings {
namespace {

TEST(SettingsTable, ThePrintedDefaultsAreTheDefaultsAndNameEverySetting) {
  const std::string file = default_file();
  Settings changed;
  changed.tick_hz = 500;
  changed.geometry = "martin-hillier";
  changed.lock_memory = false;
  changed.workspace_origin_mm = {1, 2, 3};
  EXPECT_EQ(parse_settings(file, "F", changed).sentence(), "");
  EXPECT_EQ(changed, Settings{});
  for (const Setting& setting : table()) {
    const bool stands = file.find(std::string("\n").append(setting.name).append(" = ")) != std::string::npos;
    EXPECT_EQ(stands, setting.otherwise.empty()) << setting.name;
    EXPECT_NE(file.find(setting.name), std::string::npos) << setting.name;
    EXPECT_NE(file.find(setting.meaning), std::string::npos) << setting.name;
  }
}

TEST(SettingsTable, EverySettingIsNamedOnceAndExplained) {
  std::set<std::string> names;
  for (const Setting& setting : table()) {
    EXPECT_TRUE(names.insert(std::string(setting.section).append(".").append(setting.name)).second) << setting.name;
    EXPECT_FALSE(setting.meaning.empty()) << setting.name;
    EXPECT_EQ(find(setting.section, setting.name), &setting);
    EXPECT_EQ(std::holds_alternative<std::optional<double> Settings::*>(setting.member), !setting.otherwise.empty()) << setting.name;
  }
  EXPECT_GE(names.size(), 38U);
  EXPECT_EQ(find("loop", "geometry"), nullptr);
}

TEST(SettingsTable, WhatDiffersIsNamedWithItsValue) {
  EXPECT_EQ(different({}), "");
  Settings settings;
  settings.tick_hz = 500;
  settings.stiffness = 0.8;
  settings.keep_homing_flag = false;
  settings.record = "a\x1b[2J";
  settings.workspace_origin_mm = {0, 1, 125};
  settings.calibrations["A1"] = {{35, 36, 37}};
  EXPECT_EQ(different(settings),
            "loop.tick_hz = 500\ndevice.workspace_origin_mm = [0, 1, 125]\ndevice.keep_homing_flag = false\nfeel.stiffness = 0.8\n"
            "files.record = \"a?[2J\"\ncalibration.A1.angle_at_zero_deg = [35, 36, 37]\n");
}

/// Another value than the default.
struct Change {
  Settings& settings;
  void operator()(double Settings::*m) const { settings.*m += 1e-9; }
  void operator()(int Settings::*m) const { settings.*m += 1; }
  void operator()(bool Settings::*m) const { settings.*m = !(settings.*m); }
  void operator()(std::string Settings::*m) const { settings.*m += "x"; }
  void operator()(std::optional<double> Settings::*m) const { settings.*m = 0.5; }
  void operator()(std::array<double, 3> Settings::*m) const { (settings.*m)[2] += 1e-9; }
};

TEST(SettingsTable, TheChecksumSeesEverySetting) {
  std::set<std::uint64_t> seen = {checksum({})};
  for (const Setting& setting : table()) {
    Settings settings;
    std::visit(Change{settings}, setting.member);
    EXPECT_EQ(seen.insert(checksum(settings)).second, setting.name != "record") << setting.section << "." << setting.name;
  }
  Settings settings;
  settings.calibrations["A1"] = {{35, 36, 37}};
  EXPECT_TRUE(seen.insert(checksum(settings)).second);
  EXPECT_EQ(checksum(Settings{}), checksum({}));
}

TEST(Settings, TheWatchGoesBeforeTheTickAndTheTickBeforeWhatTalksToTheDevice) {
  const Settings settings;
  EXPECT_GT(settings.watchdog_priority, settings.priority);
  EXPECT_GT(settings.priority, settings.exchange_priority);
}

}  // namespace
}  // namespace isotouch::settings
