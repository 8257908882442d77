#include "firmware/daemon/status_lines.h"

#include <gtest/gtest.h>

#include <cerrno>
#include <csignal>
#include <string>

#include "firmware/loop/realtime.h"

namespace isotouch::daemon {
namespace {

TEST(StatusLines, AStateIsToldInItsSentence) {
  const files::Condition condition{static_cast<std::uint16_t>(SupervisorState::kFault), kFaultStopped, 0, true};
  EXPECT_EQ(supervisor_line(condition), "state: " + files::state_text(condition, protocol::OtherAngles::kNone, "isotouchctl"));
  const auto others = protocol::OtherAngles::kKept;
  EXPECT_EQ(supervisor_line(condition, others), "state: " + files::state_text(condition, others, "isotouchctl"));
}

TEST(StatusLines, TheSettingsAreToldByTheirChecksum) { EXPECT_EQ(settings_line(0x1234), "settings: checksum 0000000000001234"); }

TEST(StatusLines, ASignalIsToldByItsName) {
  EXPECT_EQ(ending_line(SIGXCPU), "the controller ends: SIGXCPU");
  EXPECT_EQ(ending_line(40), "the controller ends: signal 40");
}

TEST(StatusLines, AFieldIsToldByNameAndHash) {
  EXPECT_EQ(field_line("ball", 0x1234), "field: ball, 0000000000001234");
  EXPECT_EQ(field_line("", 0x1234), "field: 0000000000001234");
}

TEST(StatusLines, ADeviceIsLookedForBroughtUpAndNamed) {
  falcon::PortReport report;
  EXPECT_EQ(device_line(report), "device: looking for one");
  report.troubled = true;
  report.trouble = falcon::LinkError::kNotFound;
  EXPECT_EQ(device_line(report), "device: looking for one; no such device is there");
  report.state = falcon::SessionState::kBooting;
  EXPECT_EQ(device_line(report), "device: found, being brought up");
  report.state = falcon::SessionState::kRunning;
  report.serial = {'A', '1'};
  EXPECT_EQ(device_line(report), "device: running, serial A1");
  report.state = falcon::SessionState::kSearching;
  report.boots = 1;
  report.boot.outcome = falcon::BootOutcome::kNoHandshake;
  EXPECT_EQ(device_line(report), "device: " + falcon::explain(report.boot));
}

TEST(StatusLines, EveryDamageOfMemoryHasALineOfItsOwn) {
  using enum loop::Damage;
  EXPECT_EQ(memory_line(kNone), "");
  EXPECT_NE(memory_line(kState).find("tick remembers"), std::string::npos);
  EXPECT_NE(memory_line(kField).find("send the field again"), std::string::npos);
  EXPECT_NE(memory_line(kPrepared).find("restart"), std::string::npos);
}

TEST(StatusLines, ARefusalNamesWhatIsMissing) {
  EXPECT_EQ(refusal_line(0), "");
  EXPECT_EQ(refusal_line(loop::kRefusedPriority | loop::kRefusedMemory).find("runs without a real-time priority, locked memory, because"),
            0U);
}

TEST(StatusLines, EveryProtectionThatNoLineGivesIsNamed) {
  settings::Settings settings;
  EXPECT_EQ(missing_lines(settings).size(), 2U);
  settings.line_chip = "gpiochip0";
  settings.line_enable = 1;
  EXPECT_EQ(missing_lines(settings).size(), 2U) << "a chip alone protects nobody";
  settings.line_stop = 2;
  ASSERT_EQ(missing_lines(settings).size(), 1U);
  EXPECT_EQ(missing_lines(settings)[0].find("no watchdog relay is set up"), 0U);
  settings.line_heartbeat = 3;
  EXPECT_EQ(missing_lines(settings).size(), 0U);
  settings.line_stop = -1;
  ASSERT_EQ(missing_lines(settings).size(), 1U);
  EXPECT_EQ(missing_lines(settings)[0].find("no emergency stop is set up"), 0U);
}

TEST(StatusLines, AFileThatCannotBeHeldIsToldWithWhatToDo) {
  const std::string begin = "processors may fall asleep while there is force, and ticks then begin late: /dev/x cannot be held (";
  EXPECT_EQ(latency_line("/dev/x", EACCES), begin + "Permission denied); install 60-isotouch-latency.rules and be in the group isotouch");
  EXPECT_EQ(latency_line("/dev/x", ENOTTY), begin + "it is no character device); name a character device in [loop] latency_file, or \"\"");
  for (const int error : {ENOENT, EIO}) EXPECT_NE(latency_line("/dev/x", error).find("set [loop] latency_file = \"\""), std::string::npos);
}

TEST(StatusLines, FiguresLeaveOutWhatWasNeverMeasured) {
  loop::TickStats stats;
  stats.ticks.add(5);
  stats.missed.add(3);
  stats.tick_time.add(1'500'000);
  const std::string text = figures(stats);
  EXPECT_NE(text.find("ticks 5, fresh 0"), std::string::npos);
  EXPECT_NE(text.find("late 0, missed 3\n"), std::string::npos);
  EXPECT_NE(text.find("max    1500.0 us"), std::string::npos);
  EXPECT_EQ(text.find("round trip"), std::string::npos);
}

}  // namespace
}  // namespace isotouch::daemon
