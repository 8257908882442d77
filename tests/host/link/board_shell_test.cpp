#include "host/link/board_shell.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "host/error.h"
#include "tests/support/scratch_folder.h"

namespace isotouch::link {
namespace {

TEST(BoardShell, AnswersEveryCommandWithItsOwnTextAndStatus) {
  BoardShell shell(read_address("unix:/nowhere"));
  for (int i = 0; i < 3; ++i) {
    const auto answer = shell.run("echo one; echo two >&2; x=" + std::to_string(i) + "; exit $((x + 4))", 10);
    EXPECT_EQ(answer.status, 4 + i);
    EXPECT_EQ(answer.text, "one\ntwo\n");
  }
  EXPECT_EQ(shell.run("echo \"${x:-gone}\"", 10).text, "gone\n") << "one command leaves nothing to the next";
  EXPECT_EQ(shell.run("cat; printf 'no end of line'", 10).text, "no end of line") << "the input is empty";
}

TEST(BoardShell, LongAnswersComeWhole) {
  BoardShell shell(read_address("unix:/nowhere"));
  const auto answer = shell.run("i=0; while [ $i -lt 5000 ]; do echo \"line $i\"; i=$((i + 1)); done", 30);
  EXPECT_THAT(answer.text, testing::EndsWith("line 4999\n"));
  EXPECT_EQ(answer.text.size(), 10U * 7 + 90 * 8 + 900 * 9 + 4000 * 10);
}

TEST(BoardShell, OneThatHangsOrEndsIsSaid) {
  const auto complaint = [](const char* command, double patience_s) {
    BoardShell shell(read_address("unix:/nowhere"));
    try {
      (void)shell.run(command, patience_s);
    } catch (const InputError& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  EXPECT_THAT(complaint("sleep 10", 0.1), testing::HasSubstr("has not ended in time"));
  EXPECT_THAT(complaint("kill -9 $$", 10), testing::AllOf(testing::HasSubstr("has ended"), testing::Not(testing::HasSubstr("ssh"))));
}

TEST(BoardShell, OneThatHasEndedIsNotCalledOneThatCouldNotBeStarted) {
  BoardShell shell(read_address("unix:/nowhere"));
  EXPECT_EQ(shell.run("echo here", 10).text, "here\n");
  EXPECT_THROW((void)shell.run("kill -9 $$", 10), InputError);
  try {
    for (int i = 0; i < 2; ++i) (void)shell.run("echo again", 10);
    ADD_FAILURE() << "it still answers";
  } catch (const InputError& e) {
    EXPECT_THAT(e.what(), testing::AllOf(testing::HasSubstr("the shell there has ended"), testing::Not(testing::HasSubstr("ssh"))));
  }
}

TEST(BoardShell, WhoNoLongerWaitsIsNotKept) {
  bool is_over = false;
  BoardShell shell(read_address("unix:/nowhere"), [&] { return is_over; });
  EXPECT_EQ(shell.run("echo here", 10).text, "here\n");
  is_over = true;
  EXPECT_THROW((void)shell.run("sleep 10", 10), InputError);
}

using Clock = std::chrono::steady_clock;

TEST(BoardShell, WhoStopsWaitingWithinACommandIsHeardSoon) {
  const auto end = Clock::now() + std::chrono::milliseconds(300);
  BoardShell shell(read_address("unix:/nowhere"), [&] { return Clock::now() >= end; });
  EXPECT_THROW((void)shell.run("sleep 20", 15), InputError);
  EXPECT_LT(Clock::now() - end, std::chrono::seconds(5)) << "also where no signal wakes it";
}

TEST(BoardShell, ItsEndDoesNotWaitForACommand) {
  const ScratchFolder scratch;
  const auto done = scratch.path() / "done", begun = scratch.path() / "begun";
  Clock::time_point end;
  {
    BoardShell shell(read_address("unix:/nowhere"), [&] { return std::filesystem::exists(begun); });
    shell.at_end("echo done >\"" + done.string() + "\"");
    EXPECT_THROW((void)shell.run("echo begun >\"" + begun.string() + "\"; sleep 20; echo", 15), InputError);
    end = Clock::now();
  }
  EXPECT_LT(Clock::now() - end, std::chrono::seconds(5));
  EXPECT_TRUE(std::filesystem::exists(done)) << "but for what it does at its end";
}

TEST(BoardShell, ALateAnswerIsNotThatOfTheNextCommand) {
  BoardShell shell(read_address("unix:/nowhere"));
  EXPECT_THROW((void)shell.run("sleep 0.5; echo late; exit 3", 0.1), InputError);
  for (const char* word : {"next", "last"}) {
    const auto answer = shell.run(std::string("echo ") + word, 10);
    EXPECT_EQ(answer.text, std::string(word) + "\n");
    EXPECT_EQ(answer.status, 0);
  }
}

TEST(BoardShell, WhatItDoesAtItsEndIsDoneHoweverItEnds) {
  const ScratchFolder scratch;
  for (const char* end : {"true", "kill -HUP $$", "kill -INT $$", "kill -PIPE $$", "kill -TERM $$"}) {
    const auto done = scratch.path() / "it's done";
    {
      BoardShell shell(read_address("unix:/nowhere"));
      shell.at_end("echo done >\"" + done.string() + "\"");
      EXPECT_EQ(shell.run("echo here", 10).text, "here\n");
      EXPECT_FALSE(std::filesystem::exists(done)) << "not before";
      try {
        (void)shell.run(end, 10);
      } catch (const InputError&) {  // so it has ended
      }
    }
    EXPECT_TRUE(std::filesystem::remove(done)) << end;
  }
}

TEST(BoardShell, ARemoteOneIsReachedByTheChosenProgram) {
  const ScratchFolder scratch;
  const std::string ssh = (scratch.path() / "ssh").string();
  std::ofstream(ssh) << "#!/bin/sh\nwhile [ \"$1\" != -- ]; do shift; done\necho \"at $2\" >\"$0.said\"\nexec sh -c \"$3\"\n";
  ::chmod(ssh.c_str(), 0755);
  ::setenv("ISOTOUCH_SSH", ssh.c_str(), 1);
  {
    BoardShell shell(read_address("ssh://me@board"));
    EXPECT_EQ(shell.run("echo here", 10).text, "here\n");
  }
  ::unsetenv("ISOTOUCH_SSH");
  std::string said;
  std::getline(std::ifstream(ssh + ".said"), said);
  EXPECT_EQ(said, "at board");
}

}  // namespace
}  // namespace isotouch::link
