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

TEST(Settings, TheWatchGoesBeforeTheTickAndTheTickBeforeWhatTalksToTheDevice) {
  const Settings settings;
  EXPECT_GT(settings.watchdog_priority, settings.priority);
  EXPECT_GT(settings.priority, settings.exchange_priority);
}

}  // namespace
}  // namespace isotouch::settings
