#include "host/board_commands/every_option.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "host/commands/commands.h"
#include "host/error.h"

namespace isotouch::commands {
namespace {

using ::testing::HasSubstr;

/// None of the commands works, which is what a value that is not refused would lead to, and none wants anything besides that value.
void keep_from_work(CLI::App& app) {
  app.parse_complete_callback([] { throw CLI::Success(); });  // the callback stays: it owns what the options write to
  for (CLI::Option* option : app.get_options({})) {
    option->required(false);
    for (CLI::Option* needed : std::set<CLI::Option*>(option->get_needs())) option->remove_needs(needed);
  }
  for (CLI::App* command : app.get_subcommands(nullptr)) keep_from_work(*command);
}

void add_checked(CLI::App& app) {
  add_all(app);
  check_every_option(app);
  keep_from_work(app);
}

using Words = std::vector<std::string>;

/// Every option and argument of a command below `app`, with the words that lead to it.
void each_option(const CLI::App& app, const Words& words, const std::function<void(const Words&, const CLI::Option&)>& use) {
  for (const CLI::Option* option : app.get_options()) {
    if (option->get_type_size() > 0 && option->get_expected_max() > 0) use(words, *option);
  }
  for (const CLI::App* command : app.get_subcommands(nullptr)) {
    Words longer = words;
    longer.push_back(command->get_name());
    each_option(*command, longer, use);
  }
}

/// Leaves a command this argument alone, or none: what is refused then is no other one's value.
void keep_argument(CLI::App& app, const Words& words, const std::string& name) {
  CLI::App* command = &app;
  for (const std::string& word : words) {
    if (!word.empty()) command = command->get_subcommand(word);
  }
  for (CLI::Option* option : command->get_options([&](const CLI::Option* one) { return one->get_positional() && one->get_name() != name; }))
    command->remove_option(option);
}

/// How the parser refuses these words.
///
/// argument  named: the command has no other ones
std::string refusal(Words words, const std::string& argument = "") {
  CLI::App app;
  add_checked(app);
  if (!argument.empty()) keep_argument(app, words, argument);
  std::reverse(words.begin(), words.end());
  try {
    app.parse(words);
  } catch (const CLI::ValidationError& error) {
    return error.what();
  } catch (const std::exception& error) {
    return std::string("no wrong value: ") + error.what();
  }
  return "nothing";
}

TEST(EveryOption, RefusesAnEmptyText) {
  CLI::App all;
  add_checked(all);
  int asked = 0;
  each_option(all, {}, [&](Words words, const CLI::Option& option) {
    if (option.get_items_expected_min() == 0) return;  // it may stand alone, and to the parser an empty text is no value then
    const std::string name = option.get_name();
    if (!option.get_positional()) words.push_back(name);
    words.insert(words.end(), static_cast<std::size_t>(option.get_items_expected_min()), "");
    EXPECT_THAT(refusal(words, option.get_positional() ? name : ""), testing::StartsWith(name + ": ")) << testing::PrintToString(words);
    ++asked;
  });
  EXPECT_GT(asked, 150);
  EXPECT_EQ(refusal({"record", "--to", "unix:control", "-o", ""}),
            "--out: its value is empty; name one, or check the variable of the shell that it comes from");
  EXPECT_THAT(refusal({"stream", "a.ply", "--to="}), HasSubstr("--to: "));
}

TEST(EveryOption, OfAWholeNumberRefusesASignAndMoreThan64Bits) {
  CLI::App all;
  add_checked(all);
  int asked = 0;
  each_option(all, {}, [&](Words words, const CLI::Option& option) {
    if (!option.get_type_name().starts_with("UINT")) return;
    const Words before = words;
    for (const char* wrong : {"-1", "18446744073709551616"}) {
      words = before;
      words.push_back(option.get_name() + "=" + wrong);
      EXPECT_THAT(refusal(words), testing::StartsWith(option.get_name() + ": ")) << option.get_name() << ' ' << wrong;
    }
    ++asked;
  });
  EXPECT_GT(asked, 15);
}

/// One range, also for what no parser could read.
TEST(EveryOption, ANumberOutsideItsBoundsIsRefusedWithTheBounds) {
  for (const char* ticks : {"-5", "100000001", "18446744073709551616", "many"}) {
    EXPECT_EQ(refusal({"trace", "make", "press", "-o", "a.trace", "--ticks", ticks}),
              std::string("--ticks: '") + ticks + "' is not a whole number from 0 to 100000000");
  }
  EXPECT_EQ(refusal({"build", "a.ply", "-o", "a.itf", "--grid=-8"}), "--grid: '-8' is not a whole number from 8 to 4000");
}

/// What would fill the disk, and a gate that could not fail.
TEST(EveryOption, CountsOfTicksHaveAnEnd) {
  EXPECT_THAT(refusal({"trace", "make", "press", "-o", "a.trace", "--ticks", "100000001"}), testing::StartsWith("--ticks: "));
  EXPECT_THAT(refusal({"trace", "stop-latency", "a.trace", "--most", "100000001"}), testing::StartsWith("--most: "));
}

/// Distances to them could not be computed, and other things would be blamed.
TEST(EveryOption, PlacesBeyondAllNumbersAreRefused) {
  for (const std::string far : {"1e200", "-1e308", "nan"}) {
    for (const char* command : {"build", "stream"}) {
      EXPECT_THAT(refusal({command, "a.ply", "-o", "a.itf", "--viewpoint", "0", far, "0"}),
                  testing::StartsWith("--viewpoint: its three numbers must lie within"))
          << command << ' ' << far;
      EXPECT_THAT(refusal({command, "a.ply", "-o", "a.itf", "--box=" + far + ",0,0,1,1,1"}),
                  testing::StartsWith("--box: its two corners must lie within"))
          << command << ' ' << far;
    }
  }
}

}  // namespace
}  // namespace isotouch::commands
