#include "host/qualify/practice_questions.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "host/link/board_shell.h"
#include "tests/support/scratch_folder.h"

namespace isotouch::qualify {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// A folder that stands for / of a board.
class FakeBoard {
 public:
  void file(const std::string& path, const std::string& text) {
    const fs::path whole = root_.path() / path;
    fs::create_directories(whole.parent_path());
    std::ofstream(whole, std::ios::binary) << text;
  }
  BoardFiles read() {
    ::setenv("ISOTOUCH_BOARD_ROOT", root_.path().c_str(), 1);
    link::BoardShell shell(link::read_address("unix:/nowhere"));
    ::unsetenv("ISOTOUCH_BOARD_ROOT");
    const auto answer = shell.run(practice_command(), 20);
    EXPECT_EQ(answer.status, 0) << answer.text;
    return read_practice(answer.text);
  }

 private:
  ScratchFolder root_;
};

TEST(PracticeQuestions, EveryFileIsReadUnderItsOwnName) {
  FakeBoard board;
  const std::string cpu = "sys/devices/system/cpu/";
  board.file("proc/version", "Linux version 6: #1 SMP PREEMPT_RT\n");
  board.file("proc/interrupts", "  CPU0\n 24: 1 x\n");
  board.file("proc/irq/24/effective_affinity_list", "0\n");
  board.file("proc/sys/kernel/sched_rt_runtime_us", "950000\n");
  board.file(cpu + "isolated", "\n");
  board.file(cpu + "cpu10/cpufreq/scaling_governor", "performance\n");
  board.file(cpu + "cpu10/cpuidle/state2/time", "77\n");
  board.file("sys/bus/usb/devices/1-1/idVendor", "0403\n");
  board.file("sys/bus/usb/devices/1-1/power/control", "on\n");
  board.file("sys/bus/usb/devices/1-1:1.0/power/control", "auto\n");
  board.file("dev/cpu_dma_latency", std::string("\x32\0\0\0", 4));
  board.file("etc/default/grub", "");
  board.file("proc/2/comm", "kthreadd\n");
  board.file("proc/90/stat", "90 (irq/24-xhci_hcd) S\n");
  board.file("proc/91/stat", "91 (bash) S\n");
  const BoardFiles files = board.read();
  const auto text = [&](const std::string& path) { return files.texts.count(path) == 0 ? "?" : files.texts.at(path); };
  EXPECT_EQ(text("/proc/version"), "Linux version 6: #1 SMP PREEMPT_RT");
  EXPECT_EQ(text("/proc/interrupts"), "  CPU0\n 24: 1 x");
  EXPECT_EQ(text("/proc/irq/24/effective_affinity_list"), "0");
  EXPECT_EQ(text("/proc/sys/kernel/sched_rt_runtime_us"), "950000");
  EXPECT_THAT(text("/" + cpu + "isolated"), testing::AnyOf("", "\n"));
  EXPECT_EQ(text("/" + cpu + "cpu10/cpufreq/scaling_governor"), "performance");
  EXPECT_EQ(text("/" + cpu + "cpu10/cpuidle/state2/time"), "77");
  EXPECT_EQ(text("/sys/bus/usb/devices/1-1/power/control"), "on") << "of the device, not of an interface";
  EXPECT_THAT(text("/dev/cpu_dma_latency"), HasSubstr("50"));
  EXPECT_EQ(text("grub"), "");
  EXPECT_EQ(text("kernel_thread"), "kthreadd");
  EXPECT_EQ(text("irq_thread/90/stat"), "90 (irq/24-xhci_hcd) S");
  EXPECT_EQ(files.texts.count("irq_thread/91/stat"), 0U);
  EXPECT_NE(text("machine"), "?");
  EXPECT_EQ(files.missing.count("/" + cpu + "cpu0/cpufreq"), 1U);
  EXPECT_EQ(files.missing.count("/proc/version"), 0U);
}

TEST(PracticeQuestions, TheThreadsAreThoseOfOneController) {
  FakeBoard board;
  const auto thread = [&](int process, int id, const std::string& name, const std::string& cores) {
    const std::string folder = "proc/" + std::to_string(process) + "/task/" + std::to_string(id) + "/";
    board.file(folder + "comm", name + "\n");
    board.file(folder + "stat", std::to_string(id) + " (" + name + ") S 1\n");
    board.file(folder + "status", "Name:\t" + name + "\nCpus_allowed:\tf\nCpus_allowed_list:\t" + cores + "\n");
  };
  for (const int process : {100, 200, 300})
    board.file("proc/" + std::to_string(process) + "/comm", process == 100 ? "other\n" : "isotouchd\n");
  thread(100, 101, "tick", "7");
  thread(200, 200, "isotouchd", "0-3");
  thread(200, 201, "tick", "3");
  thread(200, 202, "exchange", "0,2");
  thread(300, 301, "tick", "1");
  const BoardFiles files = board.read();
  EXPECT_EQ(files.texts.at("thread/tick/stat"), "201 (tick) S 1");
  EXPECT_EQ(files.texts.at("thread/tick/cores"), "3");
  EXPECT_EQ(files.texts.at("thread/exchange/cores"), "0,2");
  EXPECT_EQ(files.texts.count("thread/watchdog/stat"), 0U);
  EXPECT_EQ(files.texts.count("thread/isotouchd/stat"), 0U);
}

TEST(PracticeQuestions, AnEmptyBoardAnswersThatNothingIsThere) {
  FakeBoard board;
  const BoardFiles files = board.read();
  EXPECT_EQ(files.missing.size(), 11U);
  EXPECT_EQ(files.texts.count("/proc/version"), 0U);
}

TEST(PracticeQuestions, OtherLinesAreLeftOut) {
  const BoardFiles files =
      read_practice("motd: hello there\n/a b:c\n:x\nmissing:/x y\nmissing:/x\n/a:1\n/a:2:3\ngrep: /x: binary file matches\n");
  EXPECT_EQ(files.texts,
            (std::map<std::string, std::string>{{"motd", " hello there"}, {"/a", "1\n2:3"}, {"grep", " /x: binary file matches"}}));
  EXPECT_EQ(files.missing, std::set<std::string>{"/x"});
}

}  // namespace
}  // namespace isotouch::qualify
