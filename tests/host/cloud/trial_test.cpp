#include "host/cloud/trial.h"

#include <gtest/gtest.h>

#include <csignal>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <vector>

namespace isotouch::cloud {
namespace {

TEST(Trial, a_call_that_returns_changes_nothing_here) {
  int calls = 0;
  const Trial trial = try_out([&] {
    ++calls;
    return std::string("done");
  });
  EXPECT_FALSE(trial.crashed);
  EXPECT_EQ(trial.thrown, "");
  EXPECT_EQ(trial.answer, "done");
  EXPECT_EQ(calls, 0);
}

TEST(Trial, what_a_call_throws_is_told) {
  const Trial trial = try_out([]() -> std::string { throw std::runtime_error(std::string(5000, 'n')); });
  EXPECT_FALSE(trial.crashed);
  EXPECT_EQ(trial.thrown, std::string(5000, 'n'));
}

TEST(Trial, a_call_that_ends_the_process_crashes) {
  EXPECT_TRUE(try_out([] { return std::to_string(std::raise(SIGKILL)); }).crashed);
  EXPECT_TRUE(try_out([]() -> std::string { std::_Exit(0); }).crashed) << "even with success";
  EXPECT_TRUE(try_out([]() -> std::string { std::_Exit(1); }).crashed);
}

TEST(Trial, the_memory_that_a_call_needed_is_told) {
  const auto with = [](std::size_t bytes) { return try_out([bytes] { return std::to_string(std::vector<char>(bytes, 'x').back()); }); };
  const std::uint64_t little = with(1).peak_bytes;
  const std::uint64_t much = with(std::size_t{64} << 20).peak_bytes;
  EXPECT_GT(little, 0U);
  EXPECT_GT(much, little + (std::uint64_t{60} << 20));
  EXPECT_LT(much, little + (std::uint64_t{90} << 20));
}

}  // namespace
}  // namespace isotouch::cloud
