#include "firmware/daemon/lines.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>

#include "firmware/loop/linux_clock.h"

namespace isotouch::daemon {
namespace {

namespace fs = std::filesystem;

std::string taken(const std::string& chip) {
  settings::Settings settings;
  settings.line_chip = chip;
  loop::LinuxClock clock;
  const loop::TickStats stats;
  Lines lines;
  return take_lines(settings, clock, stats, lines).sentence();
}

TEST(Lines, WithoutAChipNothingIsTaken) { EXPECT_EQ(taken(""), ""); }

TEST(Lines, AChipThatIsNotThereIsToldWithWhatToDo) {
  const std::string said = taken("/dev/no-such-chip");
  if (said.find("libgpiod") != std::string::npos) GTEST_SKIP() << said;
  EXPECT_EQ(said, "lines.chip = /dev/no-such-chip: No such file or directory; name a chip that 'gpiodetect' shows");
}

/// A chip all of whose lines are high.
class HighGpio final : public lines::Gpio {
 public:
  std::unique_ptr<lines::GpioLine> input(unsigned /*offset*/, bool /*with_edges*/) override { return std::make_unique<Line>(); }
  std::unique_ptr<lines::GpioLine> output(unsigned /*offset*/) override { return std::make_unique<Line>(); }

 private:
  struct Line final : lines::GpioLine {
    int get() override { return 1; }
    bool set(bool /*high*/) override { return true; }
    bool wait_edge(std::int64_t /*timeout_ns*/, std::int64_t& /*edge_ns*/) override { return true; }
  };
};

TEST(Lines, AWatchdogThatIsSilentForATenthOfASecondIsAStop) {
  for (const double tick_hz : {1000.0, 4000.0}) {
    settings::Settings settings;
    settings.line_chip = "any";
    settings.line_stop = 3;
    settings.tick_hz = tick_hz;
    loop::LinuxClock clock;
    const loop::TickStats stats;
    Lines lines;
    const auto open = [](const std::string&) -> std::unique_ptr<lines::Gpio> { return std::make_unique<HighGpio>(); };
    ASSERT_FALSE(take_lines(settings, clock, stats, lines, open));
    ASSERT_TRUE(lines.watchdog);
    lines.watchdog->step();
    const int patience = static_cast<int>(tick_hz / 10);
    for (int tick = 0; tick <= patience; ++tick) ASSERT_EQ(lines.state.get() & kLineStop, 0) << tick;
    EXPECT_NE(lines.state.get() & kLineStop, 0) << tick_hz;
  }
}

/// A device's file that nobody may open. There is no chip behind it, which libgpiod 1 finds out only later; libgpiod 2 looks for that first.
TEST(LinesDeathTest, AChipThatThisUserMayNotOpenIsToldWithTheGroup) {
  if (!fs::is_directory("/dev/shm")) GTEST_SKIP() << "no /dev/shm";
  const std::string chip = "/dev/shm/isotouch-chip-" + std::to_string(::getpid());
  std::ofstream(chip) << "";
  fs::permissions(chip, fs::perms::none);
  const auto as_a_stranger = [&] {
    if (::getuid() == 0 && ::setuid(65534) != 0) ::_exit(1);
    std::fputs(taken(chip).c_str(), stderr);
    ::_exit(0);
  };
  EXPECT_EXIT(
      as_a_stranger(), ::testing::ExitedWithCode(0),
      "lines.chip = " + chip +
          ": (may not be opened by this user; add the user to the group gpio, and install 60-isotouch-gpio.rules|Inappropriate ioctl)");
  fs::remove(chip);
}

}  // namespace
}  // namespace isotouch::daemon
