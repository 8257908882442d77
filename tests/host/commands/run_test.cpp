#include "host/board_commands/run.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "host/commands/commands.h"
#include "host/trace/trace_file.h"
#include "shared/files/nearest_name.h"
#include "tests/support/chained.h"
#include "tests/support/no_more_threads.h"
#include "tests/support/scratch_folder.h"

namespace isotouch::commands {
namespace {

struct Answer {
  int code = 0;
  std::string out, err;
};

/// What `isotouch` with these arguments answers, by way of its own parser.
Answer answer(std::vector<std::string> words, void (*add)(CLI::App&) = add_all) {
  words.insert(words.begin(), "isotouch");
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  Answer got;
  got.code = run("isotouch", "about", add, static_cast<int>(argv.size()), argv.data());
  got.out = testing::internal::GetCapturedStdout();
  got.err = testing::internal::GetCapturedStderr();
  return got;
}

TEST(NearestName, IsTheOneThatWasProbablyMeant) {
  const std::vector<std::string> names = {"build", "bench", "status", "trace"};
  EXPECT_EQ(files::nearest_name("biuld", names), "build");
  EXPECT_EQ(files::nearest_name("buil", names), "build");
  EXPECT_EQ(files::nearest_name("statsu", names), "status");
  EXPECT_EQ(files::nearest_name("tace", names), "trace");
  EXPECT_EQ(files::nearest_name("calibrate", names), "");
  EXPECT_EQ(files::nearest_name("xy", names), "");
}

TEST(Run, AMistypedCommandOrOptionIsAnsweredWithTheOneThatWasMeant) {
  EXPECT_EQ(answer({"biuld"}).err, "isotouch: there is no command 'biuld'; did you mean 'build'? isotouch --help lists them\n");
  EXPECT_EQ(answer({"trace", "mke"}).err, "isotouch: there is no command 'mke'; did you mean 'make'? isotouch trace --help lists them\n");
  EXPECT_EQ(answer({"build", "a.ply", "--stifness", "3"}).err,
            "isotouch: there is no option '--stifness'; did you mean '--stiffness'? isotouch build --help lists them\n");
  EXPECT_EQ(answer({"build", "a.ply", "--stifness=3"}).code, 2);
  EXPECT_EQ(answer({"nonsense"}).err, "isotouch: there is no command 'nonsense'; isotouch --help lists them\n");
  EXPECT_EQ(answer({"nonsense"}).code, 2);
}

TEST(Run, SeveralNumbersAreTakenWithCommasOrSpaces) {
  for (const char* words : {"--viewpoint 1,2,3 nosuch.ply", "--viewpoint 1 2 3 nosuch.ply", "--viewpoint -1,2,-3 nosuch.ply",
                            "--method live --box 0,0,0,1,1,1 nosuch.ply", "--method live --box 0 0 0 1 1 1 nosuch.ply",
                            "--intrinsics 500 500 320 240 nosuch.ply", "--intrinsics 500,500,320,240 nosuch.ply"}) {
    std::vector<std::string> all = {"build", "-o", "a.itf"};
    std::istringstream list(words);
    for (std::string word; list >> word;) all.push_back(word);
    EXPECT_EQ(answer(all).err, "isotouch: nosuch.ply: cannot be read: No such file or directory\n") << words;
  }
  EXPECT_EQ(answer({"build", "a.ply", "-o", "a.itf", "--viewpoint", "1,2"}).err,
            "isotouch: --viewpoint takes 3 numbers, X,Y,Z, with commas or spaces between them\n");
  EXPECT_EQ(answer({"build", "a.ply", "-o", "a.itf", "--viewpoint", "1", "2", "x"}).err,
            "isotouch: --viewpoint takes 3 numbers, X,Y,Z, with commas or spaces between them\n");
  const Answer box = answer({"build", "a.ply", "-o", "a.itf", "--box", "0,0,0"});
  EXPECT_EQ(box.err, "isotouch: --box takes 6 numbers, X,Y,Z,X,Y,Z, with commas or spaces between them\n");
  EXPECT_EQ(box.code, 2);
  EXPECT_EQ(answer({"calibrate", "--to", "unix:/nosuch", "--at", "0,0"}).err,
            "isotouch: --at takes 3 numbers, X,Y,Z, with commas or spaces between them\n");
}

TEST(Run, OptionsThatExcludeEachOtherAreNamed) {
  const Answer both = answer({"build", "a.ply", "-o", "a.itf", "--voxel", "1mm", "--grid", "100"});
  EXPECT_EQ(both.code, 2);
  EXPECT_THAT(both.err, testing::AnyOf("isotouch: give --voxel or --grid, not both\n", "isotouch: give --grid or --voxel, not both\n"));
}

TEST(Run, AnEvaluationOfNothingIsNoSuccess) {
  const Answer clean = answer({"evaluate", "--only", "shpere"});
  EXPECT_EQ(clean.code, 2);
  EXPECT_EQ(clean.err, "isotouch: --only: no object's name contains 'shpere'; the objects are sphere, torus, box, plate, capsules\n");
  const Answer dirty = answer({"evaluate", "--dirty", "--only", "owl stray 5"});
  EXPECT_EQ(dirty.code, 2);
  EXPECT_EQ(dirty.out, "");
  EXPECT_THAT(dirty.err, testing::HasSubstr(
                             "isotouch: --only: no row of the dirty scans contains 'owl stray 5'; a row is, for example, 'sphere clean'"));
}

TEST(Run, AWrongChoiceNamesTheChoicesAndNoWordOfTheParser) {
  const Answer wrong = answer({"trace", "make", "prss", "-o", "a.trace"});
  EXPECT_EQ(wrong.code, 2);
  EXPECT_THAT(wrong.err, testing::HasSubstr("there is no 'prss'; did you mean 'press'? the choices are press slide"));
  EXPECT_THAT(wrong.err, testing::Not(testing::HasSubstr("ENUM")));
}

TEST(Run, AThreadThatTheSystemDoesNotGiveIsASentence) {
  const test::NoMoreThreads none;
  const Answer wrong = answer({"build"}, [](CLI::App& app) { app.add_subcommand("build")->callback([] { std::thread([] {}).join(); }); });
  EXPECT_EQ(wrong.code, 1);
  EXPECT_EQ(wrong.err, "isotouch: the system starts no more threads; end other programs, or raise its limit of processes (ulimit -u)\n");
}

TEST(Run, WhatAFileHoldsMovesNoCursor) {
  const ScratchFolder folder;
  const std::string table = folder.write("hand.csv", "\x1b[2J\x07owned,x_mm\n0,0\n").string();
  const Answer wrong = answer({"trace", "import", table, "-o", table + ".trace"});
  EXPECT_EQ(wrong.code, 1);
  EXPECT_THAT(wrong.err, testing::HasSubstr("no column is called 't_s', there are: ?[2J?owned x_mm;"));
}

TEST(Run, CommandsStandByTaskWithTheNamesOfTheirValues) {
  const Answer help = answer({"--help"});
  EXPECT_EQ(help.code, 0);
  EXPECT_THAT(help.out, testing::HasSubstr("Build and judge a field:"));
  EXPECT_THAT(help.out, testing::HasSubstr("Record and replay:"));
  const std::string build = answer({"build", "--help"}).out;
  EXPECT_THAT(build, testing::HasSubstr("  --grid NUMBER             voxels along"));
  EXPECT_THAT(build, testing::HasSubstr("; 8 to 4000"));
  EXPECT_THAT(build, testing::HasSubstr("  --normals NAME "));
  EXPECT_THAT(build, testing::HasSubstr("  --viewpoint X,Y,Z "));
  EXPECT_THAT(build, testing::HasSubstr("of default live published"));
  EXPECT_THAT(build, testing::HasSubstr("(required)"));
  for (const char* raw : {"ENUM", "BOOLEAN", "FLOAT", "->", " in ["}) EXPECT_THAT(build, testing::Not(testing::HasSubstr(raw)));
  EXPECT_THAT(help.out, testing::Not(testing::HasSubstr("Subcommands:"))) << "a command without a task";
}

TEST(Run, TheVersionNamesCommitFormatsAndCompiler) {
  const Answer version = answer({"--version"});
  EXPECT_EQ(version.code, 0);
  EXPECT_THAT(version.out,
              testing::MatchesRegex("isotouch [0-9.]+, commit [0-9a-z]+; formats: field [0-9.]+, packed field [0-9.]+, trace [0-9.]+, "
                                    "protocol [0-9.]+; [A-Za-z]+ [0-9.]+\n"));
}

TEST(Run, ATraceFromTheMiddleOfARunEndsABisection) {
  const ScratchFolder folder;
  const std::filesystem::path golden = ISOTOUCH_GOLDEN, file = folder.path() / "middle.trace";
  const trace::Trace whole = trace::read_trace(golden / "packets.trace");
  trace::TraceWriter writer(file, whole.header());
  Chain chain(whole.header());
  for (std::size_t tick = 400; tick < whole.size(); ++tick) writer.append(test::chained(chain, whole.record(tick)));
  writer.finish();
  const auto bisected = [&](const std::filesystem::path& trace) {
    return answer({"farm", "bisect", (golden / "field_1_1.itf").string(), trace.string(), "false"});
  };
  EXPECT_EQ(bisected(golden / "packets.trace").code, 125) << "nobody answers";
  const Answer refused = bisected(file);
  EXPECT_EQ(refused.code, 128);
  EXPECT_THAT(refused.err, testing::HasSubstr("middle.trace: begins in the middle of a run"));
}

}  // namespace
}  // namespace isotouch::commands
