#include "host/cloud/forked_call.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/support/sanitized.h"

namespace isotouch::cloud {
namespace {

TEST(ForkedCall, ACallThatReturnsChangesNothingHere) {
  int calls = 0;
  const ForkedCall trial = call_in_fork([&] {
    ++calls;
    return std::string("done");
  });
  EXPECT_FALSE(trial.crashed);
  EXPECT_EQ(trial.thrown, "");
  EXPECT_EQ(trial.answer, "done");
  EXPECT_EQ(calls, 0);
}

TEST(ForkedCall, WhatACallThrowsIsTold) {
  const ForkedCall trial = call_in_fork([]() -> std::string { throw std::runtime_error(std::string(5000, 'n')); });
  EXPECT_FALSE(trial.crashed);
  EXPECT_EQ(trial.thrown, std::string(5000, 'n'));
}

TEST(ForkedCall, ACallThatEndsTheProcessCrashes) {
  EXPECT_TRUE(call_in_fork([] { return std::to_string(std::raise(SIGKILL)); }).crashed);
  EXPECT_TRUE(call_in_fork([]() -> std::string { std::_Exit(0); }).crashed) << "even with success";
  EXPECT_TRUE(call_in_fork([]() -> std::string { std::_Exit(1); }).crashed);
}

TEST(ForkedCall, TheMemoryThatACallNeededIsTold) {
  const auto with = [](std::size_t bytes) {
    return call_in_fork([bytes] { return std::to_string(std::vector<char>(bytes, 'x').back()); });
  };
  const std::uint64_t little = with(1).peak_bytes;
  const std::uint64_t much = with(std::size_t{64} << 20).peak_bytes;
  EXPECT_GT(little, 0U);
  EXPECT_GT(much, little + (std::uint64_t{60} << 20));
  EXPECT_LT(much, little + (std::uint64_t{90} << 20));
}

TEST(ForkedCall, MemoryBeyondTheLimitIsRefusedThereAndNotHere) {
  const auto greedy = [] {
    const std::vector<char> bytes(std::size_t{256} << 20U, 'x');
    return std::string(1, bytes[bytes.size() / 2]);
  };
  EXPECT_EQ(call_in_fork(greedy).answer, "x");
  if (test::kSanitized) return;  // shadow memory needs more address space than any limit
  const ForkedCall limited = call_in_fork([&] {
    limit_this_process({.more_bytes = std::uint64_t{64} << 20U});
    return greedy();
  });
  EXPECT_FALSE(limited.crashed);
  EXPECT_EQ(limited.thrown, "std::bad_alloc");
}

TEST(ForkedCall, TimeBeyondTheLimitIsACrash) {
  const ForkedCall endless = call_in_fork([] {
    limit_this_process({.cpu_seconds = 1});
    volatile bool on = true;
    while (on) {
    }
    return std::string();
  });
  EXPECT_TRUE(endless.crashed);
}

TEST(ForkedCall, ACallThatWaitsForEverIsACrash) {
  const ForkedCall waiting = call_in_fork([] {
    limit_this_process({.wall_seconds = 1});
    for (;;) pause();
    return std::string();
  });
  EXPECT_TRUE(waiting.crashed);
}

}  // namespace
}  // namespace isotouch::cloud
