#include "firmware/daemon/options.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace isotouch::daemon {
namespace {

using testing::HasSubstr;

struct Parsed {
  bool runs = false;
  int exit_code = -1;
  std::string said;
  Options options;
};

Parsed parse(std::vector<std::string> words) {
  words.insert(words.begin(), "isotouchd");
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  Parsed parsed;
  testing::internal::CaptureStderr();
  parsed.runs = read_options(static_cast<int>(argv.size()), argv.data(), parsed.options, parsed.exit_code);
  parsed.said = testing::internal::GetCapturedStderr();
  return parsed;
}

TEST(Options, AnEmptyTextIsWrongUsage) {
  for (const char* option : {"--config", "--check-config", "--device", "--control", "--field", "--record"}) {
    const Parsed wrong = parse({"--control", "here", option, ""});
    EXPECT_FALSE(wrong.runs) << option;
    EXPECT_EQ(wrong.exit_code, 2) << option;
    EXPECT_THAT(wrong.said, HasSubstr(std::string(option) + ": its value is empty")) << option;
  }
  const Parsed relay = parse({"relay", ""});
  EXPECT_FALSE(relay.runs);
  EXPECT_EQ(relay.exit_code, 2);
  EXPECT_THAT(relay.said, HasSubstr("socket: its value is empty"));
}

TEST(Options, ACountOfTicksIsTakenAsItIsWritten) {
  EXPECT_EQ(parse({"--control", "here"}).options.ticks, UINT64_MAX);
  EXPECT_EQ(parse({"--control", "here", "--ticks", "3000"}).options.ticks, 3000U);
  for (const char* ticks : {"-1", "1e3", "-18446744073709551615", "18446744073709551616", "1000000000001", ""}) {
    const Parsed wrong = parse({"--control", "here", std::string("--ticks=") + ticks});
    EXPECT_FALSE(wrong.runs) << ticks;
    EXPECT_EQ(wrong.exit_code, 2) << ticks;
  }
}

TEST(Options, WhatTakesThePlaceOfARunStandsAlone) {
  const std::vector<std::vector<std::string>> modes = {{"--check-config", "missing"}, {"--print-config"}, {"--list"}};
  std::vector<std::vector<std::string>> others = {{"--config", "a"}, {"--device", "usb"}, {"--control", "a"}, {"--field", "a"},
                                                  {"--record", "a"}, {"--lockstep"},      {"--ticks", "3"},   {"relay"}};
  others.insert(others.end(), modes.begin(), modes.end());
  for (const std::vector<std::string>& mode : modes) {
    for (const std::vector<std::string>& other : others) {
      if (mode == other) continue;
      std::vector<std::string> words = mode;
      words.insert(words.end(), other.begin(), other.end());
      const Parsed wrong = parse(words);
      EXPECT_FALSE(wrong.runs) << mode[0] << other[0];
      EXPECT_EQ(wrong.exit_code, 2) << mode[0] << other[0];
      EXPECT_THAT(wrong.said, testing::AllOf(HasSubstr(mode[0]), HasSubstr(other[0]), HasSubstr("stands alone; leave ")));
    }
  }
  EXPECT_EQ(parse({"--check-config", "missing"}).exit_code, 1) << "alone it is looked at";
}

}  // namespace
}  // namespace isotouch::daemon
