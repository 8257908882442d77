#include "firmware/settings/read_settings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "firmware/settings/table.h"
#include "tests/support/scratch_folder.h"

namespace isotouch::settings {
namespace {

Settings read(const std::string& text) {
  Settings settings;
  EXPECT_EQ(parse_settings(text, "F.toml", settings).sentence(), "") << text;
  return settings;
}

/// "[section] … name = "
std::string line_of(const Setting& setting, const char* between) {
  return std::string("[").append(setting.section).append("]").append(between).append(setting.name).append(" = ");
}

TEST(ReadSettings, AnEmptyFileIsTheDefaults) {
  EXPECT_EQ(read(""), Settings{});
  EXPECT_EQ(read("# nothing\n[loop]\n[feel]\n"), Settings{});
}

TEST(ReadSettings, EveryKindOfValueFindsItsPlace) {
  const Settings settings = read(R"([loop]
tick_hz = 4000
core = 3
lock_memory = false
[device]
geometry = "martin-hillier"
gear_ratio = 7.5
workspace_origin_mm = [1, -2.5, 110]
[feel]
stiffness = 1.25
[calibration.FTPNM0FB]
angle_at_zero_deg = [34.5, 35, 36]
)");
  EXPECT_EQ(settings.tick_hz, 4000);
  EXPECT_EQ(settings.core, 3);
  EXPECT_FALSE(settings.lock_memory);
  EXPECT_EQ(settings.geometry, "martin-hillier");
  EXPECT_EQ(settings.gear_ratio, 7.5);
  EXPECT_EQ(settings.workspace_origin_mm, (std::array<double, 3>{1, -2.5, 110}));
  EXPECT_EQ(settings.stiffness, 1.25);
  EXPECT_EQ(settings.calibrations.at("FTPNM0FB").angle_at_zero_deg, (std::array<double, 3>{34.5, 35, 36}));
}

TEST(ReadSettings, WhatIsNotInTheTableOrNotOfItsKindIsRefusedWithItsLine) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"[loop]\n\ntick_rate = 3",
       "F.toml:3: there is no setting 'tick_rate' in section 'loop'; 'isotouchd --print-config' lists all settings"},
      {"[lop]\ntick_hz = 1000", "F.toml:1: there is no section 'lop'; 'isotouchd --print-config' lists all settings"},
      {"tick_hz = 1000", "F.toml:1: 'tick_hz' is outside every section; 'isotouchd --print-config' lists all settings"},
      {"loop = 3", "F.toml:1: 'loop' is outside every section; 'isotouchd --print-config' lists all settings"},
      {"[feel.deep]\nx = 1", "F.toml:1: there is no setting 'deep' in section 'feel'; 'isotouchd --print-config' lists all settings"},
      {"[device]\ngeometry = \"delta\"", "F.toml:2: device.geometry must be one of libnifalcon|martin-hillier"},
      {"[device]\ngeometry = \"libnifalcon|martin-hillier\"", "F.toml:2: device.geometry must be one of libnifalcon|martin-hillier"},
      {"[device]\ngeometry = \"\"", "F.toml:2: device.geometry must be one of libnifalcon|martin-hillier"},
      {"[device]\nworkspace_origin_mm = [1, 2]",
       "F.toml:2: device.workspace_origin_mm must be three numbers in brackets, each from -300 to 300 mm"},
      {"[device]\nworkspace_origin_mm = [1, 2, 3, 4]",
       "F.toml:2: device.workspace_origin_mm must be three numbers in brackets, each from -300 to 300 mm"},
      {"[device]\nworkspace_origin_mm = [1, \"2\", 3]",
       "F.toml:2: device.workspace_origin_mm must be three numbers in brackets, each from -300 to 300 mm"},
      {"[device]\nworkspace_origin_mm = [1, 2, 301]",
       "F.toml:2: device.workspace_origin_mm must be three numbers in brackets, each from -300 to 300 mm"},
      {"[calibration]\nX = 3", "F.toml:2: a calibration needs a section of its own, [calibration.SERIAL]"},
      {"[calibration.X]\nscale = 3", "F.toml:2: there is no setting 'scale' in a calibration; it may hold angle_at_zero_deg"},
      {"[calibration.X]", "F.toml:1: the calibration of 'X' is empty; give it angle_at_zero_deg or leave it out"},
      {"[calibration.X]\nangle_at_zero_deg = 35",
       "F.toml:2: angle_at_zero_deg must be three numbers in brackets, each from -180 to 180 degrees"},
      {"calibration = 3", "F.toml:1: 'calibration' is outside every section; 'isotouchd --print-config' lists all settings"},
  };
  for (const auto& [text, complaint] : cases) {
    Settings settings;
    EXPECT_EQ(parse_settings(text, "F.toml", settings).sentence(), complaint) << text;
  }
}

/// A value on either side of a range is taken at its end and refused beyond it.
TEST(ReadSettings, EveryRangeOfTheTableHolds) {
  int ranges = 0;
  for (const Setting& setting : table()) {
    if (setting.low == setting.high) continue;
    const std::string head = line_of(setting, "\n");
    const bool whole = std::holds_alternative<int Settings::*>(setting.member);
    const bool three = std::holds_alternative<std::array<double, 3> Settings::*>(setting.member);
    const auto with = [&](double value) {
      std::string text = std::to_string(value);
      if (whole) text = std::to_string(static_cast<long long>(value));
      return head + (three ? "[0, 0, " + text + "]" : text);
    };
    const double step = whole ? 1 : 0.0001;
    for (const double good : {setting.low, setting.high}) {
      Settings settings;
      EXPECT_EQ(parse_settings(with(good), "F", settings).sentence().find("F:2: "), std::string::npos) << with(good);
    }
    for (const double bad : {setting.low - step, setting.high + step}) {
      Settings settings;
      EXPECT_NE(parse_settings(with(bad), "F", settings).sentence().find("F:2: "), std::string::npos) << with(bad);
    }
    ++ranges;
  }
  EXPECT_GE(ranges, 25);
}

TEST(ReadSettings, EveryValueOfAnotherKindIsRefused) {
  for (const Setting& setting : table()) {
    const bool text = std::holds_alternative<std::string Settings::*>(setting.member);
    const bool flag = std::holds_alternative<bool Settings::*>(setting.member);
    const bool whole = std::holds_alternative<int Settings::*>(setting.member);
    for (const std::string value : {text ? "1" : "\"1\"", flag ? "1" : "true", whole ? "1.5" : "2020-01-01", "{}", "[]", "nan"}) {
      Settings settings;
      const std::string complaint = parse_settings(line_of(setting, "\n\n") + value, "F", settings).sentence();
      EXPECT_EQ(complaint.find("F:3: "), 0U) << setting.name << " = " << value << ": " << complaint;
    }
  }
}

TEST(ReadSettings, AWordThatCouldNotChangeByOneInATickIsRefused) {
  Settings settings;
  EXPECT_EQ(parse_settings("[loop]\ntick_hz = 5000\n[limits]\nword_slew = 5000\n", "a.toml", settings).sentence(), "");
  EXPECT_EQ(parse_settings("[loop]\ntick_hz = 5001\n[limits]\nword_slew = 5000\n", "a.toml", settings).sentence(),
            "a.toml: limits.word_slew must be at least loop.tick_hz (one unit a tick); with less, motor commands could rise but not fall");
}

TEST(ReadSettings, SettingsThatContradictEachOtherAreRefused) {
  const std::string chip = "[lines]\nchip = \"gpiochip0\"\n";
  const std::pair<std::string, std::string> refused[] = {
      {"[lines]\nstop = 4", "lines.stop needs a GPIO chip"},
      {"[lines]\nenable = 4", "lines.enable needs a GPIO chip"},
      {"[lines]\nenable_back = 4", "lines.enable_back needs a GPIO chip"},
      {"[lines]\nheartbeat = 0", "lines.heartbeat needs a GPIO chip"},
      {"[lines]\nlight = 4", "lines.light needs a GPIO chip"},
      {chip + "stop = 4\nenable = 4", "lines.enable and lines.stop are both line 4"},
      {chip + "enable_back = 0\nlight = 0", "lines.light and lines.enable_back are both line 0"},
      {chip + "priority = 80", "lines.priority must be above loop.priority"},
      {chip + "priority = 0", "lines.priority must be above loop.priority"},
      {"[loop]\nexchange_priority = 80", "loop.exchange_priority must be below loop.priority"},
      {"[loop]\npriority = 0", "loop.exchange_priority must be below loop.priority"},
      {"[device]\nled_idle = \"green\"", "device.led_active must differ"},
      {"[device]\nled_homing = \"green\"", "device.led_active must differ"},
      {"[device]\nled_active = \"none\"\nled_idle = \"none\"", "device.led_active must differ"},
      {"[buttons]\nmask = 0\nhold_to_run = true", "buttons.hold_to_run is true, but buttons.mask = 0"},
  };
  for (const auto& [text, complaint] : refused) {
    Settings settings;
    EXPECT_EQ(parse_settings(text, "F.toml", settings).sentence().find("F.toml: " + complaint), 0U) << text;
  }
  for (const std::string& good :
       {chip + "stop = 4\nenable = 5", chip + "priority = 81", std::string("[loop]\npriority = 0\nexchange_priority = 0\n") + chip,
        std::string("[loop]\nexchange_priority = 79"), std::string("[loop]\nexchange_priority = 0"), std::string("[lines]\npriority = 0"),
        std::string("[device]\nled_idle = \"none\"\nled_homing = \"none\""), std::string("[buttons]\nmask = 0")}) {
    EXPECT_EQ(read(good).line_light, -1);
  }
}

TEST(ReadSettings, WhereLinesAreRequiredTheFileNamesThem) {
  const auto said = [](const std::string& lines) {
    Settings settings;
    return parse_settings("[lines]\nrequired = true\n" + lines, "a.toml", settings).sentence();
  };
  const std::string all = "chip = \"gpiochip0\"\nstop = 1\nenable = 2\nenable_back = 3\nheartbeat = 4\n";
  EXPECT_EQ(said(all), "");
  EXPECT_EQ(
      said(""),
      "a.toml: lines.required is true, so [lines] must name chip, stop, enable, enable_back and heartbeat; name them, or set required = "
      "false");
  for (const char* one : {"chip = \"gpiochip0\"\n", "stop = 1\n", "enable = 2\n", "enable_back = 3\n", "heartbeat = 4\n"}) {
    std::string without = all;
    without.erase(without.find(one), std::string(one).size());
    EXPECT_NE(said(without), "") << one;
  }
}

TEST(ReadSettings, WhatIsNotTomlIsRefusedWithItsLine) {
  for (const char* text :
       {"[loop\n", "[loop]\ntick_hz = \n", "[loop]\ntick_hz = 1000\ntick_hz = 1000\n", "\x01", "[a]\n[a]\n", "x = \"\\q\""}) {
    Settings settings;
    const std::string complaint = parse_settings(text, "F", settings).sentence();
    EXPECT_EQ(complaint.find("F:"), 0U) << text;
    EXPECT_NE(complaint.find(": this is not TOML: "), std::string::npos) << complaint;
    EXPECT_EQ(complaint.find('\n'), std::string::npos) << "one sentence";
  }
}

TEST(ReadSettings, ATextWithoutQuotesIsNamed) {
  const auto said = [](const std::string& text) {
    Settings settings;
    return parse_settings(text, "a.toml", settings).sentence();
  };
  const std::string remedy = " is no value; write a number, true or false, or a text in quotes";
  for (const std::string value : {"soft", "true1", "no", "0.8N/mm", "/dev/x", "inner", "1 2"}) {
    for (const char* rest : {"", "  # a comment", "\r", "\ndamping = 0"})
      EXPECT_EQ(said("[feel]\nstiffness = " + value + rest), "a.toml:2: '" + value + "'" + remedy) << value;
  }
  EXPECT_THAT(said("[feel]\nstiffness = 1\nstiffness = 1"), testing::StartsWith("a.toml:3: this is not TOML: "));
}

TEST(ReadSettings, ATableWhoseNameBeginsWithNoLetterIsRefusedAndEndsNothing) {
  for (const char* text : {"\n[$a]\nb = 1\n",
                           "\n[\x17"
                           "evice]\n",
                           "\n[a.$b]\n", "\n[[#]]\n"}) {
    Settings settings;
    EXPECT_EQ(parse_settings(text, "F.toml", settings).sentence().rfind("F.toml:2: this is not TOML: ", 0), 0U) << text;
  }
}

TEST(ReadSettings, AFileIsReadByItsName) {
  const ScratchFolder folder;
  const std::string path = (folder.path() / "f.toml").string();
  Settings settings;
  EXPECT_EQ(read_settings(path, settings).sentence(), path + ": it cannot be read; give the name of a settings file");
  folder.write("f.toml", "[loop]\ntick_hz = 250\n");
  EXPECT_EQ(read_settings(path, settings).sentence(), "");
  EXPECT_EQ(settings.tick_hz, 250);
}

}  // namespace
}  // namespace isotouch::settings
