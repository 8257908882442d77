#include "host/board_commands/number_in.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "host/board_commands/commands.h"
#include "host/commands/commands.h"

namespace isotouch::commands {
namespace {

TEST(NumberIn, TakesWhatLiesWithinItsBoundsAndNothingElse) {
  const CLI::Validator range = number_in(0.1, 1000);
  for (const char* good : {"0.1", "1000", "1e2", "+5"}) EXPECT_EQ(range(std::string(good)), "") << good;
  for (const char* wrong : {"0.09", "1001", "nan", "-nan", "NaN", "inf", "-inf", "", "five", "1 2"})
    EXPECT_EQ(range(std::string(wrong)), std::string("'") + wrong + "' is not a number from 0.1 to 1000") << wrong;
}

/// Counts the options below `app` that take real numbers within bounds, and expects each to refuse nan.
void none_takes_nan(const CLI::App& app, const std::string& words, void (*add)(CLI::App&), int& asked) {
  for (const CLI::Option* option : app.get_options()) {
    const std::string type = option->get_type_name(), name = option->get_single_name();
    const bool bounded = type.starts_with("FLOAT:") || (type.find(',') < type.find(':') && type.find(':') != std::string::npos);
    if (!bounded) continue;
    CLI::App all;
    add(all);
    std::string line = words.substr(1) + " --" + name;
    for (int i = 0; i < option->get_items_expected_min(); ++i) line += " nan";
    EXPECT_THROW(all.parse(line), CLI::ValidationError) << line;
    ++asked;
  }
  for (const CLI::App* command : app.get_subcommands(nullptr)) none_takes_nan(*command, words + ' ' + command->get_name(), add, asked);
}

TEST(NumberIn, NoOptionWithBoundsTakesNan) {
  const auto add = [](CLI::App& app) {
    for (const auto command : {add_build, add_scan, add_trace, add_render, add_plot, add_on_desk, add_calibrate, add_qualify, add_stream})
      command(app);
  };
  CLI::App all;
  add(all);
  int asked = 0;
  none_takes_nan(all, "", add, asked);
  EXPECT_EQ(asked, 68) << "a new option with a number? count it here";
}

}  // namespace
}  // namespace isotouch::commands
