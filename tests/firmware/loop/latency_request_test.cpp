#include "firmware/loop/latency_request.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <string>

namespace isotouch::loop {
namespace {

namespace fs = std::filesystem;

/// How often this program has this file open.
int times_open(const std::string& path) {
  int times = 0;
  for (const auto& entry : fs::directory_iterator("/proc/self/fd")) {
    std::error_code gone;
    times += fs::read_symlink(entry.path(), gone) == path ? 1 : 0;
  }
  return times;
}

/// Stands for the kernel's file: a character device that takes what is written.
constexpr const char* kTakes = "/dev/zero";

TEST(LatencyRequest, TheFileIsOpenWhileItIsWanted) {
  const int before = times_open(kTakes);
  {
    LatencyRequest request(kTakes);
    EXPECT_EQ(times_open(kTakes), before);
    EXPECT_EQ(request.hold(true), 0);
    EXPECT_EQ(request.hold(true), 0) << "once is enough";
    EXPECT_TRUE(request.is_held());
    EXPECT_EQ(times_open(kTakes), before + 1);
    EXPECT_EQ(request.hold(false), 0);
    EXPECT_FALSE(request.is_held());
    EXPECT_EQ(times_open(kTakes), before);
    EXPECT_EQ(request.hold(true), 0);
  }
  EXPECT_EQ(times_open(kTakes), before) << "it goes with its owner";
}

TEST(LatencyRequest, WithoutAPathNothingIsAskedFor) {
  LatencyRequest request("");
  EXPECT_EQ(request.hold(true), 0);
  EXPECT_FALSE(request.is_held());
}

TEST(LatencyRequest, ARefusalIsToldAndTriedAgainAfterRest) {
  const std::string path = fs::temp_directory_path() / ("isotouch-latency-" + std::to_string(::getpid()));
  fs::remove(path);
  LatencyRequest request(path);
  EXPECT_EQ(request.hold(true), ENOENT);
  fs::create_symlink(kTakes, path);
  EXPECT_EQ(request.hold(true), ENOENT) << "not ten times a second";
  EXPECT_FALSE(request.is_held());
  EXPECT_EQ(request.hold(false), 0);
  EXPECT_EQ(request.hold(true), 0);
  EXPECT_TRUE(request.is_held());
  fs::remove(path);
}

TEST(LatencyRequest, AFileThatTakesNothingIsNotHeld) {
  LatencyRequest request("/dev/full");
  EXPECT_EQ(request.hold(true), ENOSPC);
  EXPECT_FALSE(request.is_held());
  EXPECT_EQ(times_open("/dev/full"), 0);
}

TEST(LatencyRequest, WhatIsNoDeviceStaysAsItIs) {
  const std::string path = fs::temp_directory_path() / ("isotouch-letter-" + std::to_string(::getpid()));
  std::ofstream(path) << "somebody's";
  LatencyRequest request(path);
  EXPECT_EQ(request.hold(true), ENOTTY);
  std::string kept;
  std::getline(std::ifstream(path), kept);
  EXPECT_EQ(kept, "somebody's");
  fs::remove(path);
  ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
  LatencyRequest of_a_pipe(path);
  EXPECT_EQ(of_a_pipe.hold(true), ENXIO) << "and it does not wait for a reader";
  fs::remove(path);
}

/// What was written, as the kernel would read it: through a terminal of our own in raw mode, which is a character device with another end.
TEST(LatencyRequest, TheKernelReadsAWholeNumberOfZeroMicroseconds) {
  const int other_end = ::posix_openpt(O_RDWR | O_NOCTTY);
  if (other_end < 0 || ::grantpt(other_end) != 0 || ::unlockpt(other_end) != 0) GTEST_SKIP() << "the system gives no terminal";
  LatencyRequest request(::ptsname(other_end));
  ASSERT_EQ(request.hold(true), 0);
  unsigned char bytes[8] = {9, 9, 9, 9, 9, 9, 9, 9};
  EXPECT_EQ(::read(other_end, bytes, sizeof bytes), 4);
  for (int i = 0; i < 4; ++i) EXPECT_EQ(bytes[i], 0) << i;
  request.hold(false);
  ::close(other_end);
}

}  // namespace
}  // namespace isotouch::loop
