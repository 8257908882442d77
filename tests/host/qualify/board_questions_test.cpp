#include "host/qualify/board_questions.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "host/link/board_shell.h"
#include "tests/support/scratch_folder.h"

namespace isotouch::qualify {
namespace {

using testing::HasSubstr;

TEST(BoardQuestions, ADescriptionIsPairsAndNothingElse) {
  const auto pairs = read_description("motd: welcome\nkernel=Linux 6.1 #1 SMP\nmodel=\n=x\nboot options=isolcpus=3 quiet\n");
  ASSERT_EQ(pairs.size(), 2U);
  EXPECT_EQ(pairs[0].second, "Linux 6.1 #1 SMP");
  EXPECT_EQ(pairs[1].second, "isolcpus=3 quiet");
}

TEST(BoardQuestions, WhatTheBoardSaysIsOneLineForATerminalAndAPage) {
  const auto pairs = read_description("boot options=quiet \xff \x1b[31mred\n");
  ASSERT_EQ(pairs.size(), 1U);
  EXPECT_EQ(pairs[0].second, "quiet    [31mred");
  std::string why;
  EXPECT_FALSE(read_timer(4, "no \xff\x1b]0;timer\n", why));
  EXPECT_EQ(why, "no   ]0;timer");
  const auto causes = read_causes(
      "1 since kworker\xff-9 [001] d..2 5.0: sched_switch: prev_comm=kw\xff\x1b[2J prev_pid=9 prev_prio=1 prev_state=S ==> next_comm=tick "
      "next_pid=7 next_prio=1\n",
      1);
  ASSERT_EQ(causes.size(), 1U);
  EXPECT_EQ(causes[0], "processor 1: kw  [2J");
}

TEST(BoardQuestions, OfManySensorsTheHottestAndOfProcessorsTheSlowestCount) {
  Moment moment;
  const Sensors sensors =
      read_sensors("millicelsius 41500\nmillicelsius \nmillicelsius 63125\nkilohertz 1500000\nkilohertz 600000\nnoise\n", moment);
  EXPECT_EQ(sensors.read, 2U);
  EXPECT_EQ(sensors.silent, 1U);
  EXPECT_DOUBLE_EQ(moment.celsius.value(), 63.125);
  EXPECT_DOUBLE_EQ(moment.megahertz.value(), 600);
  Moment none;
  read_sensors("", none);
  EXPECT_FALSE(none.celsius || none.megahertz);
}

TEST(BoardQuestions, CyclictestsHistogramIsReadWithWhatItCouldNotHold) {
  std::string why;
  const auto timer = read_timer(0,
                                "# /dev/cpu_dma_latency set to 0us\n# Histogram\n000004 000012\n000011 000003\n# Total: 000000015\n"
                                "# Min Latencies: 00004\n# Max Latencies: 25001\n# Histogram Overflows: 00002\n",
                                why);
  ASSERT_TRUE(timer);
  EXPECT_EQ(timer->count, 17U);
  ASSERT_EQ(timer->bins.size(), 3U);
  EXPECT_EQ(timer->bins[0].upper, 5'000U);
  EXPECT_EQ(timer->bins[0].count, 12U);
  EXPECT_EQ(timer->bins[2].upper, 25'002'000U);
  EXPECT_EQ(timer->bins[2].count, 2U);
}

TEST(BoardQuestions, WhyThereIsNoTimerIsTheBoardsOwnSentence) {
  std::string why;
  EXPECT_FALSE(read_timer(3, "cyclictest is not installed there (package rt-tests)\n", why));
  EXPECT_THAT(why, HasSubstr("not installed"));
  EXPECT_FALSE(read_timer(0, "# Histogram\n# Total: 0\n", why));
  EXPECT_THAT(why, HasSubstr("counted nothing"));
  EXPECT_FALSE(read_timer(1, "", why));
  EXPECT_FALSE(why.empty());
}

TEST(BoardQuestions, TheTimerIsAskedWithWholeSecondsAndItsPriority) {
  const std::string command = timer_command(79, 1000, 2.5);
  EXPECT_THAT(command, HasSubstr("-p 79 -i 1000 "));
  EXPECT_THAT(command, HasSubstr("-D 3"));
}

TEST(BoardQuestions, MemoryIsWrittenForAsLongAsAskedAndByOneProgramAProcessor) {
  const ScratchFolder scratch;
  const std::string path = std::getenv("PATH");
  const auto program = [&](const char* name, const std::string& text) {
    std::filesystem::permissions(scratch.write(name, "#!/bin/sh\n" + text + "\n"), std::filesystem::perms::owner_all);
  };
  program("nproc", "echo 4");
  program("dd", "echo \"$@\" >>" + scratch.path().string() + "/asked; exec sleep 60");
  ::setenv("PATH", (scratch.path().string() + ":" + path).c_str(), 1);
  link::BoardShell shell(link::read_address("unix:/nowhere"));
  ::setenv("PATH", path.c_str(), 1);
  const auto begun = std::chrono::steady_clock::now();
  (void)shell.run(eviction_command(0.5), 30);
  EXPECT_GT(std::chrono::steady_clock::now() - begun, std::chrono::milliseconds(900)) << "whole seconds";
  EXPECT_LT(std::chrono::steady_clock::now() - begun, std::chrono::seconds(20));
  std::ifstream asked(scratch.path() / "asked");
  std::string line;
  int programs = 0;
  while (std::getline(asked, line)) {
    EXPECT_EQ(line, "if=/dev/zero of=/dev/null bs=16M");
    ++programs;
  }
  EXPECT_EQ(programs, 4);
}

/// What the kernel's tracer holds of a tick that should have begun at 100.001 s and did at 100.00104 s, and of others, each a second later.
const char* kTrace =
    "# tracer: nop\n"
    "        exchange-101     [001] d..2.   100.000100: sched_switch: prev_comm=exchange prev_pid=101 prev_prio=14 prev_state=S ==> "
    "next_comm=sshd next_pid=50 next_prio=120\n"
    "            sshd-50      [001] d.h..   100.001003: irq_handler_entry: irq=12 name=mmc0\n"
    "            bash-60      [000] d..2.   100.001004: sched_switch: prev_comm=bash prev_pid=60 prev_prio=120 prev_state=S ==> "
    "next_comm=swapper/0 next_pid=0 next_prio=120\n"
    "            sshd-50      [001] ..s..   100.001009: softirq_entry: vec=3 [action=NET_RX]\n"
    "            sshd-50      [001] d..2.   100.001040: sched_switch: prev_comm=sshd prev_pid=50 prev_prio=120 prev_state=R ==> "
    "next_comm=tick next_pid=99 next_prio=19\n"
    "            sshd-50      [001] d.h..   100.500000: irq_handler_entry: irq=13 name=between\n"
    "          <idle>-0       [003] d..2.   101.001040: sched_switch: prev_comm=swapper/3 prev_pid=0 prev_prio=120 "
    "prev_state=R ==> next_comm=tick next_pid=99 next_prio=19\n"
    "            tick-99      [000] d..2.   102.001020: sched_switch: prev_comm=tick prev_pid=99 prev_prio=19 prev_state=S ==> "
    "next_comm=swapper/0 next_pid=0 next_prio=120\n"
    "          <idle>-0       [001] d..2.   102.001040: sched_switch: prev_comm=swapper/1 prev_pid=0 prev_prio=120 "
    "prev_state=R ==> next_comm=tick next_pid=99 next_prio=19\n";

/// The causes of ticks, asked of a tracer with this content.
std::vector<std::string> causes(const std::string& trace, const std::vector<protocol::WorstTick>& ticks) {
  const ScratchFolder tracing;
  std::filesystem::create_directories(tracing.path() / "instances/isotouch");
  std::ofstream(tracing.path() / "instances/isotouch/trace") << trace;
  ::setenv("ISOTOUCH_TRACING", tracing.path().c_str(), 1);
  link::BoardShell shell(link::read_address("unix:/nowhere"));
  ::unsetenv("ISOTOUCH_TRACING");
  return read_causes(shell.run(trace_command(ticks), 10).text, ticks.size());
}

TEST(BoardQuestions, ACauseIsWhatHadTheTicksProcessorSinceItShouldHaveBegun) {
  const protocol::WorstTick held{7, 100'001'041'000, 41'000, 5'000}, slept{8, 101'001'041'000, 41'000, 5'000},
      forgotten{9, 50'000'000'000, 41'000, 5'000};
  const protocol::WorstTick followed{10, 102'001'041'000, 41'000, 5'000};
  EXPECT_THAT(causes(kTrace, {slept, forgotten, held, followed}),
              testing::ElementsAre("nothing else ran: the processor slept", "", "processor 1: interrupt 12 (mmc0), softirq NET_RX, sshd",
                                   "processor 1: the tick before, idle"));
}

TEST(BoardQuestions, WithoutATracerThereIsNoCause) {
  EXPECT_THAT(read_causes("awk: cannot open trace\n3 since x\n-1 since x\n", 2), testing::ElementsAre("", ""));
}

/// A folder like the kernel's: a buffer that is made has its files at once, and goes with them. Where `events` is false the kernel has none.
class FakeTracer {
 public:
  explicit FakeTracer(bool events) {
    std::filesystem::create_directories(tracing() / "instances");
    program("mkdir",
            std::string("exec /bin/mkdir -p \"$1\"") + (events ? " \"$1\"/events/sched/sched_switch \"$1\"/events/irq/irq_handler_entry"
                                                                 " \"$1\"/events/irq/softirq_entry"
                                                               : ""));
    program("rmdir", "exec rm -r \"$1\"");
    ::setenv("PATH", (scratch_.path().string() + ":" + path_).c_str(), 1);
    ::setenv("ISOTOUCH_TRACING", tracing().c_str(), 1);
  }
  ~FakeTracer() { ::unsetenv("ISOTOUCH_TRACING"), ::setenv("PATH", path_.c_str(), 1); }
  FakeTracer(const FakeTracer&) = delete;
  FakeTracer& operator=(const FakeTracer&) = delete;

  std::filesystem::path instance() const { return tracing() / "instances/isotouch"; }
  std::string file(const char* name) const {
    std::string text;
    std::getline(std::ifstream(instance() / name), text);
    return text;
  }

 private:
  std::filesystem::path tracing() const { return scratch_.path() / "tracing"; }
  void program(const char* name, const std::string& text) {
    std::filesystem::permissions(scratch_.write(name, "#!/bin/sh\n" + text + "\n"), std::filesystem::perms::owner_all);
  }
  ScratchFolder scratch_;
  std::string path_ = std::getenv("PATH");
};

TEST(BoardQuestions, TheTracersBufferIsMadeAndTakenAway) {
  const FakeTracer tracer(true);
  link::BoardShell shell(link::read_address("unix:/nowhere"));
  EXPECT_EQ(shell.run(begin_tracing_command(), 10).status, 0);
  EXPECT_EQ(tracer.file("tracing_on"), "1");
  EXPECT_EQ(tracer.file("events/irq/softirq_entry/enable"), "1");
  EXPECT_EQ(shell.run(begin_tracing_command(), 10).status, 0) << "one that was left over serves as well";
  EXPECT_EQ(shell.run(end_tracing_command(), 10).status, 0);
  EXPECT_FALSE(std::filesystem::exists(tracer.instance()));
  EXPECT_EQ(shell.run(end_tracing_command(), 10).status, 0) << "twice does no harm";
}

TEST(BoardQuestions, ABufferThatCannotTraceIsNotLeftBehind) {
  const FakeTracer tracer(false);
  link::BoardShell shell(link::read_address("unix:/nowhere"));
  EXPECT_NE(shell.run(begin_tracing_command(), 10).status, 0);
  EXPECT_FALSE(std::filesystem::exists(tracer.instance()));
}

}  // namespace
}  // namespace isotouch::qualify
