#include "firmware/daemon/lines.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>

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
