#include "host/qualify/measure.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "host/error.h"
#include "host/qualify/verdict.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/scripted_controller.h"

namespace isotouch::qualify {
namespace {

/// What is read of a board whose tick is scheduled so.
BoardFiles board_with_tick(int priority, int policy) {
  BoardFiles files;
  std::string stat = "12 (tick) S";
  for (int field = 4; field < 40; ++field) stat += " 0";
  files.texts["thread/tick/stat"] = stat + " " + std::to_string(priority) + " " + std::to_string(policy) + " 0 0";
  return files;
}

TEST(TimerPriority, IsTheTicksOwnUnlessOneIsGiven) {
  EXPECT_EQ(timer_priority(std::nullopt, board_with_tick(55, 1)), 55);
  EXPECT_EQ(timer_priority(70, board_with_tick(55, 1)), 70);
  EXPECT_EQ(timer_priority(0, board_with_tick(55, 1)), 0) << "0 is no priority but a wish";
}

TEST(TimerPriority, Is80WhereTheTickHasNone) {
  EXPECT_EQ(timer_priority(std::nullopt, board_with_tick(0, 0)), 80);
  EXPECT_EQ(timer_priority(std::nullopt, BoardFiles{}), 80);
}

using testing::HasSubstr;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point then) { return std::chrono::duration<double>(Clock::now() - then).count(); }

/// A controller without a device, whose ticks come in time.
///
/// goes_on   asked for each histogram, of which four are read before the ticks are measured and four a second; false: it closes the connection
test::Scripted::Talk ticking(std::function<bool(int histograms)> goes_on) {
  return [goes_on = std::move(goes_on)](int client) {
    using protocol::Kind;
    using test::frame;
    const Clock::time_point begin = Clock::now();
    test::Bytes heard;
    for (int histograms = 0;;) {
      test::Bytes more(4096);
      const ssize_t size = ::recv(client, more.data(), more.size(), 0);
      if (size <= 0) return;
      heard.insert(heard.end(), more.begin(), more.begin() + size);
      for (;;) {
        const auto asked = protocol::read_frame(heard);
        if (!asked || asked->size == 0) break;
        if (asked->kind == Kind::kHistogram && !goes_on(++histograms)) {
          ::shutdown(client, SHUT_RDWR);  // the measurement's shell has a copy
          return;
        }
        protocol::StatusReport status;
        status.ticks = static_cast<std::uint64_t>(1000 * seconds_since(begin));
        const test::Bytes answer = asked->kind == Kind::kHello       ? frame(Kind::kWelcome, protocol::Welcome{})
                                   : asked->kind == Kind::kStatus    ? frame(Kind::kStatusReport, status)
                                   : asked->kind == Kind::kHistogram ? frame(Kind::kHistogramReport, protocol::HistogramReport{})
                                   : asked->kind == Kind::kWorst     ? frame(Kind::kWorstTicks, protocol::WorstTicks{})
                                   : asked->kind == Kind::kDevice    ? frame(Kind::kDeviceReport, protocol::DeviceReport{})
                                                                     : frame(Kind::kSettingsReport, protocol::SettingsReport{});
        heard.erase(heard.begin(), heard.begin() + static_cast<std::ptrdiff_t>(asked->size));
        (void)::send(client, answer.data(), answer.size(), MSG_NOSIGNAL);
      }
    }
  };
}

Figures measured(const test::Scripted& controller, const Wish& wish) {
  return measure(controller.address(), wish, [](const std::string&) {});
}

constexpr double kLong = 600;

TEST(Measure, WhatWasCountedStaysWhereTheControllerIsLost) {
  const test::Scripted controller({ticking([](int histograms) { return histograms <= 10; })});
  const Figures figures = measured(controller, {.seconds = kLong, .priority = 0, .trace = false});
  EXPECT_TRUE(figures.is_cut());
  EXPECT_THAT(figures.end_unknown, HasSubstr("closed the connection"));
  EXPECT_GT(figures.seconds, 0.9);
  EXPECT_GE(figures.ticks, 900U);
  EXPECT_FALSE(figures.moments.empty());
  EXPECT_FALSE(is_fit(judge(figures, {})));
}

TEST(Measure, WhatWasCountedStaysWhereSomebodyEndsIt) {
  std::atomic<bool> is_over = false;
  const test::Scripted controller({ticking([&](int histograms) {
    is_over = is_over || histograms >= 10;
    return true;
  })});
  const Figures figures =
      measured(controller, {.seconds = kLong, .priority = 0, .trace = false, .is_over = [&] { return is_over.load(); }});
  EXPECT_TRUE(figures.is_cut());
  EXPECT_THAT(figures.end_unknown, HasSubstr("the measurement was interrupted"));
  EXPECT_GE(figures.ticks, 900U);
  EXPECT_FALSE(is_fit(judge(figures, {})));
}

TEST(Measure, WhereNothingWasCountedThereIsNoReport) {
  std::atomic<bool> is_over = false;
  const test::Scripted controller({ticking([&](int histograms) {
    is_over = is_over || histograms >= 4;
    return true;
  })});
  const Wish wish{.seconds = kLong, .priority = 0, .trace = false, .is_over = [&] { return is_over.load(); }};
  EXPECT_THROW((void)measured(controller, wish), InputError);
}

/// As long as it lives, the board's shell is this script.
class FakeShell {
 public:
  FakeShell(const ScratchFolder& folder, const std::string& text) {
    ::chmod(folder.write("sh", "#!/bin/sh\n" + text + '\n').c_str(), 0755);
    ::setenv("PATH", (folder.path().string() + ":" + path_).c_str(), 1);
  }
  ~FakeShell() { ::setenv("PATH", path_.c_str(), 1); }
  FakeShell(const FakeShell&) = delete;
  FakeShell& operator=(const FakeShell&) = delete;

 private:
  std::string path_ = std::getenv("PATH");
};

/// What is measured of a board with these sensors at first, whose sensor 0 is removed or made unreadable after the first look.
Figures measured_with(const std::vector<const char*>& sensors, bool is_removed) {
  namespace fs = std::filesystem;
  const ScratchFolder folder;  // that of the controller, too, which empties it
  const auto sensor = [&](std::size_t number) { return folder.path() / ("thermal_zone" + std::to_string(number)) / "temp"; };
  const test::Scripted controller({ticking([&](int histograms) {
    if (histograms != 5) return true;
    fs::remove(sensor(0));
    if (!is_removed) fs::create_directories(sensor(0));
    return true;
  })});
  for (std::size_t i = 0; i < sensors.size(); ++i) {
    fs::create_directories(*sensors[i] == '\0' ? sensor(i) : sensor(i).parent_path());  // a folder cannot be read
    if (*sensors[i] != '\0') std::ofstream(sensor(i)) << sensors[i] << '\n';
  }
  const FakeShell shell(folder, "sed -u 's,/sys/class/thermal," + folder.path().string() + ",g' | /bin/sh");
  return measured(controller, {.seconds = 2, .cold_seconds = 0, .priority = 0, .trace = false});
}

TEST(Measure, ATemperatureThatIsNotReadAtEachCheckIsNotKnown) {
  const Figures gone = measured_with({"45000"}, true);
  EXPECT_EQ(gone.moments.front().celsius, 45);
  EXPECT_EQ(gone.moments.back().celsius, std::nullopt);
  for (const Figures& figures :
       {gone, measured_with({"45000"}, false), measured_with({"60000", "45000"}, true), measured_with({""}, false)}) {
    EXPECT_EQ(figures.sensors_unknown, "the temperature could not be read at each check: a sensor of the board gave none");
  }
}

TEST(Measure, ASensorThatNeverGivesANumberDoesNotCountBesideOthers) {
  EXPECT_THAT(measured_with({"", "45000"}, false).sensors_unknown, testing::IsEmpty());
  EXPECT_THAT(measured_with({}, true).sensors_unknown, testing::IsEmpty());
}

TEST(Measure, WithoutItsShellTheTicksAreMeasuredAllTheSame) {
  const ScratchFolder folder;
  const std::string end = (folder.path() / "end").string();
  const test::Scripted controller({ticking([&](int histograms) {
    if (histograms == 5) std::ofstream(end) << "now";
    return true;
  })});
  const FakeShell shell(folder, "(until [ -e " + end + " ]; do sleep 0.1; done; kill -9 $$) &\nexec /bin/sh");
  const Figures figures = measured(controller, {.seconds = 4, .priority = 0, .trace = false});
  EXPECT_FALSE(figures.is_cut());
  EXPECT_GE(figures.seconds, 4);
  EXPECT_GE(figures.ticks, 3500U);
  EXPECT_THAT(figures.cold_unknown, HasSubstr("the shell there has ended"));
  EXPECT_THAT(figures.sensors_unknown, HasSubstr("the shell there has ended"));
  EXPECT_THAT(figures.practice_unknown, HasSubstr("the shell there has ended"));
}

}  // namespace
}  // namespace isotouch::qualify
