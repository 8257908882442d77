#include "host/vdb/trial.h"

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <stdexcept>
#include <string>

namespace isotouch::vdb {
namespace {

TEST(Trial, a_call_that_returns_changes_nothing_here) {
  int calls = 0;
  const Trial trial = try_out([&] { ++calls; });
  EXPECT_FALSE(trial.crashed);
  EXPECT_EQ(trial.thrown, "");
  EXPECT_EQ(calls, 0);
}

TEST(Trial, what_a_call_throws_is_told) {
  const Trial trial = try_out([] { throw std::runtime_error(std::string(5000, 'n')); });
  EXPECT_FALSE(trial.crashed);
  EXPECT_EQ(trial.thrown, std::string(5000, 'n'));
}

TEST(Trial, a_call_that_ends_the_process_crashes) {
  EXPECT_TRUE(try_out([] { std::raise(SIGKILL); }).crashed);
  EXPECT_TRUE(try_out([] { std::_Exit(1); }).crashed);
}

}  // namespace
}  // namespace isotouch::vdb
