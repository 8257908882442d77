#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sys/resource.h>
#include <sys/utsname.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <optional>
#include <set>
#include <string>
#include <thread>
#include <utility>

#include "host/error.h"
#include "host/farm/answer.h"
#include "host/farm/ended_program.h"
#include "host/farm/report.h"
#include "host/farm/share.h"
#include "host/farm/task.h"
#include "host/files/whole_file.h"
#include "tests/support/scratch_folder.h"

namespace isotouch::farm {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

const fs::path kField = fs::path(ISOTOUCH_GOLDEN) / "field_1_1.itf";
const fs::path kTrace = fs::path(ISOTOUCH_GOLDEN) / "packets.trace";

/// A farm whose programs are scripts: what they print is what the recording expects, unless a test says otherwise.
class Farm : public ::testing::Test {
 protected:
  void SetUp() override {
    add("hand", kTrace);
    expected_ = read_recordings(recordings_file())[0].expected;
  }

  void add(const std::string& name, const fs::path& trace, const fs::path& field = kField) const {
    Recording recording;
    recording.name = name;
    recording.field.path = field;
    recording.trace.path = trace;
    recording.origin = "a test";
    add_recording(recordings_file(), recording);
  }
  fs::path recordings_file() const { return folder_.path() / "recordings.jsonl"; }
  fs::path programs_file() const { return folder_.path() / "programs.jsonl"; }
  fs::path answers() const { return folder_.path() / "answers"; }

  /// A program that does this, counts its calls in calls.txt, and is listed.
  void list(const std::string& processor, const std::string& commit, const std::string& body) {
    const std::string name = processor + "-" + commit;
    std::ofstream(folder_.path() / name) << "echo " << name << " >>" << (folder_.path() / "calls.txt").string() << "\n" << body << "\n";
    std::ofstream(programs_file(), std::ios::app) << R"({"processor": ")" << processor << R"(", "commit": ")" << commit
                                                  << R"(", "compiler": "none", "rung": "0", "command": ["sh", "./)" << name << "\"]}\n";
  }
  static std::string print(const std::string& hash, const std::string& difference = "null", int code = 0) {
    return R"(echo '{"ticks": 10, "seconds": 0.5, "hash": ")" + hash + R"(", "first_difference": )" + difference + "}'; exit " +
           std::to_string(code);
  }
  std::string equal() const { return print(expected_); }
  ShareReport run_all(const Share& share = {}) const {
    return run_share(read_recordings(recordings_file()), read_programs(programs_file()), answers(), share);
  }
  /// All answers; good until the next call.
  std::vector<Row> rows() {
    recordings_ = read_recordings(recordings_file());
    programs_ = read_programs(programs_file());
    return merge(recordings_, programs_, answers());
  }
  /// Where the equal answer to the first task is kept; the folder is there.
  fs::path kept_file() const {
    const std::string address = address_of(read_recordings(recordings_file())[0], read_programs(programs_file())[0]);
    fs::create_directories(answers() / address.substr(0, 2));
    return answers() / address.substr(0, 2) / (address.substr(2) + ".json");
  }
  std::string calls() const {
    std::ifstream file(folder_.path() / "calls.txt");
    return {std::istreambuf_iterator<char>(file), {}};
  }
  template <class Read>
  std::string complaint(const Read& read) const {
    try {
      read();
    } catch (const InputError& error) {
      return error.what();
    }
    return {};
  }
  std::string complaint_on_programs(const std::string& text) const {
    std::ofstream(programs_file()) << text;
    return complaint([this] { (void)read_programs(programs_file()); });
  }

  ScratchFolder folder_;
  std::string expected_;

 private:
  std::vector<Recording> recordings_;
  std::vector<Program> programs_;
};

TEST_F(Farm, EachTaskIsAskedOnce) {
  list("a", "1", equal()), list("b", "1", equal());
  EXPECT_EQ(run_all().asked, 2U);
  const ShareReport again = run_all();
  EXPECT_EQ(again.asked, 0U);
  EXPECT_EQ(again.kept, 2U);
  EXPECT_EQ(calls(), "a-1\nb-1\n");
}

TEST_F(Farm, TheSharesTogetherAreAllTasksAndNoneTwice) {
  for (const char* processor : {"a", "b", "c", "d", "e"}) list(processor, "1", equal());
  std::size_t tasks = 0;
  for (const std::size_t shard : {2U, 0U, 1U}) {
    const ShareReport report = run_all({.shard = shard, .shards = 3});
    EXPECT_EQ(report.asked, report.tasks);
    tasks += report.tasks;
  }
  EXPECT_EQ(tasks, 5U);
  EXPECT_EQ(run_all({.jobs = 4}).kept, 5U);
}

TEST_F(Farm, AFailureIsKeptWithItsSentenceAndAskedAgain) {
  list("a", "1", "echo no memory >&2; exit 1");
  EXPECT_EQ(run_all().failed, 1U);
  EXPECT_EQ(run_all().asked, 1U);
  const auto all = rows();
  EXPECT_EQ(count(all).failed, 1U);
  EXPECT_EQ(all[0].answer->said, "it ended with 1: no memory");
  EXPECT_EQ(calls(), "a-1\na-1\n");
}

TEST_F(Farm, EachOfAsManySharesAsProgramsGetsEveryProgram) {
  std::vector<Recording> recordings;
  for (int i = 0; i < 4; ++i) {
    recordings.push_back(read_recordings(recordings_file())[0]);
    recordings.back().expected[0] = static_cast<char>('0' + i);  // four questions
  }
  for (const char* processor : {"a", "b"}) list(processor, "1", equal());
  EXPECT_EQ(run_share(recordings, read_programs(programs_file()), answers(), {.shard = 0, .shards = 2}).tasks, 4U);
  EXPECT_EQ(calls(), "a-1\nb-1\na-1\nb-1\n");
}

TEST_F(Farm, WhatIsNoAnswerFailsWithItsReason) {
  const auto said = [&](const std::string& body) {
    fs::remove(programs_file());
    list("a", "1", body);
    EXPECT_EQ(run_all({.patience = {.seconds = 5}}).failed, 1U) << body;
    const auto all = rows();
    return all[0].answer ? all[0].answer->said : "";
  };
  const std::string hash = R"("hash": ")" + expected_ + '"';
  EXPECT_EQ(said("exit 0"), "it ended with 0 and printed no JSON object");
  EXPECT_EQ(said("echo first >&2; echo; echo the reason >&2; exit 7"), "it ended with 7: the reason");
  EXPECT_EQ(said(print(expected_, "null", 7)), "it ended with 7");
  EXPECT_EQ(said("kill -9 $$"), "it ended with 137");
  EXPECT_EQ(said("printf '\\033[2J\\n' >&2; exit 1"), "it ended with 1:  [2J");
  EXPECT_EQ(said("echo '{\"ticks\": 0, " + hash + "}'"), "it replayed no tick");
  EXPECT_EQ(said("echo '{\"ticks\": 5, \"hash\": \"a,b\"}'"), "its hash has not 16 hexadecimal digits");
  EXPECT_EQ(said("sleep 1000 & sleep 1000"), "it gave no answer in time");
  EXPECT_EQ(said("yes"), "it printed more than 16 MB");
  for (const std::string& object :
       {std::string("{\"ticks\": 5}"), "{" + hash + "}", "{\"ticks\": -5, " + hash + "}", "{\"ticks\": 5, \"seconds\": [], " + hash + "}"})
    EXPECT_THAT(said("echo '" + object + "'"), HasSubstr("are missing or of another kind")) << object;
  for (const std::string difference : {"{\"tick\": -1}", "\"7\"", "7.5", "true", "{\"field\": \"force\"}", "{\"tick\": null}", "-1"})
    EXPECT_THAT(said(print(expected_, difference)), HasSubstr("are missing or of another kind")) << difference;
}

TEST_F(Farm, WordsAroundTheAnswerDoNotMatter) {
  list("before", "1", "echo '{note}'; " + equal());
  list("after", "1", "( " + equal() + " ); echo done");
  list("lines", "1", "echo '{\"ticks\": 10,'; echo '\"hash\": \"" + expected_ + "\"}'");
  EXPECT_EQ(run_all().failed, 0U);
}

TEST_F(Farm, AFailureDoesNotTakeThePlaceOfAnAnswer) {
  for (const std::string& body : {equal(), print("0123456789abcdef", "7", 3)}) {
    fs::remove(programs_file());
    list("a", "1", body);
    run_all();
    const auto before = rows()[0].answer->outcome;
    keep(answers(), read_recordings(recordings_file())[0], read_programs(programs_file())[0], {});
    EXPECT_EQ(rows()[0].answer->outcome, before) << body;
  }
}

/// Each of two machines has answers of its own, and their folders are copied into one.
TEST_F(Farm, AnswersThatContradictAreADifferenceInWhateverOrderTheyCome) {
  list("a", "1", equal());
  const Recording recording = read_recordings(recordings_file())[0];
  const Program program = read_programs(programs_file())[0];
  const auto answer = [&](Answer::Outcome outcome, const std::string& hash, std::optional<std::uint64_t> tick) {
    Answer made;
    made.outcome = outcome, made.ticks = 10, made.hash = hash, made.first_different = tick;
    return made;
  };
  const Answer good = answer(Answer::Outcome::kEqual, expected_, {}), bad = answer(Answer::Outcome::kDiffers, "0123456789abcdef", 7),
               worse = answer(Answer::Outcome::kDiffers, "0123456789abcdef", 3),
               other = answer(Answer::Outcome::kDiffers, "fedcba9876543210", {});
  for (const auto& pair : std::vector<std::pair<Answer, Answer>>{{good, bad}, {bad, good}, {bad, worse}, {bad, other}, {good, other}}) {
    fs::remove_all(answers());
    keep(answers(), recording, program, pair.first);
    EXPECT_NE(rows()[0].answer->outcome, Answer::Outcome::kContradicts);
    keep(folder_.path() / "blue", recording, program, pair.second);
    fs::copy(folder_.path() / "blue", answers(), fs::copy_options::recursive | fs::copy_options::overwrite_existing);
    fs::remove_all(folder_.path() / "blue");
    const auto all = rows();
    EXPECT_EQ(count(all).differs, 1U);
    EXPECT_EQ(all[0].answer->outcome, Answer::Outcome::kContradicts);
    utsname system{};
    ::uname(&system);
    const auto where = [&](const Answer& each) {
      return std::string(name_of(each.outcome)) + (each.first_different ? " in tick " + std::to_string(*each.first_different) : "") +
             (each.outcome == Answer::Outcome::kDiffers ? " with hash " + each.hash : "") + " on " + system.nodename;
    };
    for (const Answer& each : {pair.first, pair.second}) EXPECT_THAT(all[0].answer->said, HasSubstr(where(each)));
    EXPECT_THAT(all[0].answer->said, testing::StartsWith("answers contradict: "));
    EXPECT_THAT(to_csv(all), HasSubstr("contradicts,,\n"));
    EXPECT_THAT(to_html(all), HasSubstr("answers contradict"));
    EXPECT_EQ(changes(all).size(), 1U);
    EXPECT_EQ(run_all().asked, 0U) << "it stays until somebody looks";
  }
  fs::remove_all(answers());
  for (int host = 0; host < 2; ++host) keep(answers(), recording, program, bad);
  EXPECT_EQ(rows()[0].answer->outcome, Answer::Outcome::kDiffers) << "the same twice is no contradiction";
}

TEST_F(Farm, AProgramThatIsReplacedWhileItRunsHasNoAnswer) {
  list("a", "1", R"(echo '# another' >>"$0"; )" + equal());
  const Answer answer = ask(read_recordings(recordings_file())[0], read_programs(programs_file())[0]);
  EXPECT_EQ(answer.outcome, Answer::Outcome::kFailed);
  EXPECT_THAT(answer.said, HasSubstr("a-1 is no longer the program of the table"));
}

TEST_F(Farm, PatchesOfARecordingAreHashedAndHandedOn) {
  const fs::path trace = folder_.path() / "grown.trace", patches = folder_.path() / "grown.patches";
  fs::copy_file(fs::path(ISOTOUCH_GOLDEN) / "positions_patches.trace", trace);
  fs::copy_file(fs::path(ISOTOUCH_GOLDEN) / "positions_patches.patches", patches);
  fs::remove(recordings_file());
  add("grown", trace, fs::path(ISOTOUCH_GOLDEN) / "field_1_3.itf");
  const Recording recording = read_recordings(recordings_file())[0];
  EXPECT_EQ(recording.patches.path, patches);
  EXPECT_EQ(recording.patches.hash, hash_of(patches));
  EXPECT_EQ(as_recorded(recording).expected, recording.expected);
  EXPECT_EQ(as_recorded(recording).patches.hash, recording.patches.hash);
  list("a", "1", R"sh([ $# = 3 ] && [ "$(basename "$3")" = grown.patches ] || exit 1; )sh" + print(recording.expected));
  EXPECT_EQ(run_all().failed, 0U);
  EXPECT_EQ(count(rows()).equal, 1U);
  Recording other = recording;
  other.patches.hash[0] ^= 1;
  const Program program = read_programs(programs_file())[0];
  EXPECT_NE(address_of(other, program), address_of(recording, program));
  std::ofstream(patches, std::ios::app) << "x";
  EXPECT_THAT(ask(recording, program).said, HasSubstr("grown.patches is no longer the file of the table"));
}

TEST_F(Farm, WhatIsNotEqualInEveryBitDiffers) {
  list("equal", "1", equal());
  list("other-hash", "1", print("0123456789abcdef"));
  list("other-code", "1", print(expected_, "null", 3));
  list("other-tick", "1", print(expected_, "7"));
  list("as-the-tool", "1", print("0123456789abcdef", R"({"tick": 9, "field": "force"})", 3));
  run_all();
  const auto all = rows();
  EXPECT_EQ(count(all).equal, 1U);
  EXPECT_EQ(count(all).differs, 4U);
  EXPECT_EQ(all[3].answer->first_different, 7U);
  EXPECT_EQ(all[4].answer->first_different, 9U);
}

TEST_F(Farm, AChangeIsNamedByTheFirstCommitThatHasItOnEachProcessor) {
  list("a", "1", equal()), list("b", "1", equal());
  list("a", "2", print("0123456789abcdef", "7", 3)), list("b", "2", equal());
  list("a", "3", print("0123456789abcdef", "7", 3)), list("b", "3", print("fedcba9876543210", "8", 3));
  run_all();
  const auto all = rows();
  const auto found = changes(all);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].since->processor + found[0].since->commit, "a2");
  EXPECT_EQ(found[0].tick, 7U);
  EXPECT_EQ(found[1].since->processor + found[1].since->commit, "b3");
  const std::string page = to_html(all);
  EXPECT_THAT(page, HasSubstr("3 equal, 3 different, 0 failed, 0 missing"));
  EXPECT_THAT(page, HasSubstr("a test"));
}

TEST_F(Farm, AChangeSaysWhatIsNotKnown) {
  list("a", "1", equal()), list("a", "2", "exit 1"), list("a", "3", print("0123456789abcdef")), list("a", "4", print("0123456789abcdef"));
  list("a", "5", equal()), list("a", "6", print("0123456789abcdef", "7"));
  run_all();
  const auto found = changes(rows());
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(in_words(found[0]), "since 3 on a (none, rung 0); equal at 1, not known at 1 commit before; equal again at 5");
  EXPECT_EQ(in_words(found[1]), "since 6 on a (none, rung 0), first in tick 7");
}

TEST_F(Farm, AnAnswerIsNotTakenForThatOfAnotherProgramTraceOrField) {
  list("a", "1", equal());
  run_all();
  const Recording recording = read_recordings(recordings_file())[0];
  const Program program = read_programs(programs_file())[0];
  const std::string address = address_of(recording, program);
  std::ofstream(folder_.path() / "a-1", std::ios::app) << "# another\n";
  EXPECT_NE(address_of(recording, read_programs(programs_file())[0]), address);
  Recording other_field = recording, other_trace = recording, other_hash = recording;
  other_field.field.hash[0] ^= 1, other_trace.trace.hash[0] ^= 1, other_hash.expected[0] ^= 1;
  for (const Recording& other : {other_field, other_trace, other_hash}) EXPECT_NE(address_of(other, program), address);
  EXPECT_EQ(run_all().asked, 1U);
}

TEST_F(Farm, AFileThatChangedSinceItWasAddedIsNotReplayed) {
  const fs::path copy = folder_.path() / "copy.trace";
  fs::copy_file(kTrace, copy);
  fs::remove(recordings_file());
  add("copy", copy);
  std::ofstream(copy, std::ios::app) << "x";
  list("a", "1", equal());
  EXPECT_EQ(run_all().failed, 1U);
  EXPECT_THAT(rows()[0].answer->said, HasSubstr("copy.trace is no longer the file of the table"));
  EXPECT_EQ(calls(), "");
}

TEST_F(Farm, AKeptAnswerCountsOnlyForTheFilesThatAreThere) {
  const fs::path copy = folder_.path() / "copy.trace";
  fs::copy_file(kTrace, copy);
  fs::remove(recordings_file());
  add("copy", copy);
  list("a", "1", equal());
  list("b", "1", equal());
  EXPECT_EQ(run_all().failed, 0U);
  EXPECT_EQ(run_all().changed, "");
  std::ofstream(copy, std::ios::app) << "x";
  const ShareReport report = run_all();
  EXPECT_EQ(report.kept, 2U);
  EXPECT_EQ(report.failed, 2U);
  EXPECT_EQ(report.changed,
            copy.string() + " is no longer the file of the table; remove the recording's line, and add it anew with isotouch farm add");
  EXPECT_EQ(count(rows()).equal, 2U) << "what was answered of the table's files stays";
  write_file(copy, "version https://git-lfs.github.com/spec/v1\noid sha256:00\nsize 100\n");
  EXPECT_EQ(run_all().changed, copy.string() + ": is a Git LFS pointer; fetch the file with git lfs pull");
}

TEST_F(Farm, AHalfAnswerIsNone) {
  list("a", "1", equal());
  run_all();
  for (const auto& entry : fs::recursive_directory_iterator(answers())) {
    if (entry.is_regular_file()) fs::resize_file(entry.path(), 40);
  }
  EXPECT_EQ(run_all().asked, 1U);
}

TEST_F(Farm, OfADifferenceHalfAnAnswerIsNotNone) {
  list("a", "1", equal());
  run_all();
  const fs::path half = fs::path(kept_file()).replace_extension(".differs") / "0123456789abcdef-7.json";
  fs::create_directories(half.parent_path());
  for (const char* text : {"", R"({"outcome": "differs", "ticks": 9, "seco)", "{}"}) {
    write_file(half, text);
    for (const bool runs : {false, true})
      EXPECT_THAT(complaint([&] { runs ? (void)run_all() : (void)rows(); }), HasSubstr(half.string() + ": its name is that of")) << text;
  }
  fs::remove(half);
  EXPECT_EQ(count(rows()).equal, 1U);
}

TEST_F(Farm, ARecordingThatIsCutOffOrDamagedIsNoneToCompareWith) {
  Recording recording;
  recording.name = recording.origin = "x";
  recording.field.path = kField;
  recording.trace.path = folder_.path() / "x.trace";
  const auto whole = read_file(kTrace);
  const auto complaints = [&](const std::vector<std::uint8_t>& bytes) {
    write_file(recording.trace.path, bytes.data(), bytes.size());
    return std::pair(complaint([&] { (void)as_recorded(recording); }), complaint([&] { add_recording(recordings_file(), recording); }));
  };
  EXPECT_EQ(complaints(whole), std::pair(std::string(), std::string()));
  recording.name = "y";
  const auto cut = complaints({whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(whole.size() * 3 / 4)});
  EXPECT_THAT(cut.first, HasSubstr("the recording was cut off"));
  EXPECT_THAT(cut.second, HasSubstr("or keep what there is with isotouch replay --check -o"));
  auto flipped = whole;
  flipped[whole.size() - 30] ^= 1;
  const auto damaged = complaints(flipped);
  EXPECT_THAT(damaged.first, HasSubstr("its bytes were changed after they were recorded"));
  EXPECT_THAT(damaged.second, HasSubstr("its bytes were changed after they were recorded"));
  write_file(recording.trace.path, whole.data(), whole.size());
  recording.field.path = kTrace;
  EXPECT_THAT(complaint([&] { (void)as_recorded(recording); }), HasSubstr(kTrace.string()));
}

TEST_F(Farm, AKeptAnswerThatContradictsItselfIsNone) {
  list("a", "1", equal());
  const fs::path file = kept_file();
  const auto keeps = [&](const std::string& outcome, const std::string& ticks, const std::string& hash, const std::string& different) {
    write_file(file, R"({"outcome": ")" + outcome + R"(", "ticks": )" + ticks + R"(, "seconds": 0.5, "hash": ")" + hash +
                         R"(", "first_different": )" + different + R"(, "said": ""})");
    return rows()[0].answer.has_value();
  };
  EXPECT_TRUE(keeps("equal", "10", expected_, "null"));
  EXPECT_FALSE(keeps("equal", "10", "0000000000000000", "null")) << "another hash than that of the recording";
  EXPECT_FALSE(keeps("equal", "10", expected_, "7"));
  EXPECT_FALSE(keeps("equal", "0", expected_, "null"));
  EXPECT_TRUE(keeps("differs", "10", "0000000000000000", "7"));
  EXPECT_TRUE(keeps("differs", "10", expected_, "null")) << "its exit code said so";
  EXPECT_FALSE(keeps("differs", "0", "0000000000000000", "7"));
  EXPECT_EQ(run_all().asked, 1U) << "it is asked again";
}

TEST_F(Farm, AnAnswerThatCannotBeReadIsNotAMissingOne) {
  list("a", "1", equal());
  const fs::path file = kept_file(), differs = fs::path(file).replace_extension(".differs"), folder = file.parent_path();
  EXPECT_FALSE(rows()[0].answer);
  for (const fs::path& loop : {file, differs}) {
    fs::create_symlink(loop.filename(), loop);  // a cause that root meets, too
    EXPECT_THAT(complaint([this] { (void)rows(); }), HasSubstr(loop.filename().string() + ": cannot be read: "));
    fs::remove(loop);
  }
  fs::remove_all(folder);
  write_file(folder, "no folder");
  EXPECT_FALSE(rows()[0].answer);
}

TEST_F(Farm, AKeptAnswerWithNumbersThatAreNoneIsNone) {
  list("a", "1", equal());
  const fs::path file = kept_file();
  const auto keeps = [&](const std::string& ticks, const std::string& seconds, const std::string& different, const std::string& hash) {
    write_file(file, R"({"outcome": "differs", "ticks": )" + ticks + R"(, "seconds": )" + seconds + R"(, "hash": ")" + hash +
                         R"(", "first_different": )" + different + R"(, "said": ""})");
    return rows()[0].answer.has_value();
  };
  EXPECT_TRUE(keeps("9", "0.5", "3", expected_));
  EXPECT_TRUE(keeps("9", "0.5", "null", expected_));
  for (const std::string number : {"-9", "1e300", "9.5", "true", "null", "18446744073709551616"})
    EXPECT_FALSE(keeps(number, "0.5", "3", expected_)) << number;
  for (const std::string number : {"-1", "1e300", "0.5", "true"}) EXPECT_FALSE(keeps("9", "0.5", number, expected_)) << number;
  for (const std::string number : {"-0.5", "null", "1e999"}) EXPECT_FALSE(keeps("9", number, "3", expected_)) << number;
  EXPECT_FALSE(keeps("9", "0.5", "3", "another hash"));
}

TEST_F(Farm, TheTableHasARowForEachTaskAnsweredOrNot) {
  Recording recording = read_recordings(recordings_file())[0];
  recording.name = "left, then \"right\"";
  const Program program{"a", "1", "none", "0", {}, {}, {}};
  Answer answer;
  answer.outcome = Answer::Outcome::kDiffers;
  answer.hash = expected_;
  answer.first_different = 7;
  answer.seconds = 3;
  EXPECT_EQ(to_csv({{&recording, &program, answer}, {&recording, &program, {}}}),
            "recording,processor,commit,compiler,rung,outcome,hash,first_different\n"
            "\"left, then \"\"right\"\"\",a,1,none,0,differs," +
                expected_ +
                ",7\n"
                "\"left, then \"\"right\"\"\",a,1,none,0,missing,,\n");
}

TEST_F(Farm, AFolderThatACommandNamesIsPartOfItsProgram) {
  const fs::path library = folder_.path() / "sysroot/lib/libc.so";
  fs::create_directories(library.parent_path());
  std::ofstream(library) << "old";
  fs::create_symlink("/lib/nowhere", folder_.path() / "sysroot/usr");
  std::ofstream(programs_file())
      << R"({"processor": "a", "commit": "1", "compiler": "c", "rung": "0", "command": ["./recordings.jsonl", "./sysroot"]})";
  const auto content = [this] { return read_programs(programs_file())[0].content; };
  std::set<std::string> seen = {content()};
  EXPECT_EQ(content(), *seen.begin());
  std::ofstream(library) << "new";
  EXPECT_TRUE(seen.insert(content()).second) << "a file's bytes";
  fs::rename(library, library.parent_path() / "libm.so");
  EXPECT_TRUE(seen.insert(content()).second) << "a file's name";
  fs::remove(folder_.path() / "sysroot/usr");
  fs::create_symlink("/lib/elsewhere", folder_.path() / "sysroot/usr");
  EXPECT_TRUE(seen.insert(content()).second) << "a link's target";
}

/// Without a descriptor for its end, a program would be waited for without end.
TEST_F(Farm, WithoutDescriptorsAProgramIsNotWaitedFor) {
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_NOFILE, &before), 0);
  for (rlim_t more = 0; more <= 3; ++more) {
    const int next = dup(0);
    close(next);
    const rlimit few{static_cast<rlim_t>(next) + more, before.rlim_max};
    ASSERT_EQ(setrlimit(RLIMIT_NOFILE, &few), 0);
    const std::string complained = complaint([] { (void)run_program({"true"}, {.seconds = 20}); });
    ASSERT_EQ(setrlimit(RLIMIT_NOFILE, &before), 0);
    EXPECT_THAT(complained, HasSubstr(more == 3 ? "" : more == 2 ? "true cannot be waited for" : "no memory for what it prints"));
    EXPECT_EQ(complained.empty(), more == 3);
  }
}

TEST_F(Farm, WhatAProgramLeavesBehindEndsWithIt) {
  const EndedProgram ended = run_program({"sh", "-c", "sleep 1000 & echo $!"}, {.seconds = 60});
  EXPECT_EQ(ended.code, 0);
  const std::string process = "/proc/" + std::to_string(std::stoi(ended.printed)) + "/stat";
  const auto runs = [&] {
    std::string number, name, state;  // Z: nobody has waited for it yet
    std::ifstream(process) >> number >> name >> state;
    return !state.empty() && state != "Z";
  };
  for (int i = 0; i < 100 && runs(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(50));
  EXPECT_FALSE(runs());
}

TEST_F(Farm, TablesAreRefusedWithTheirLine) {
  EXPECT_THAT(complaint_on_programs("\n{\"processor\": \"a\"\n"), HasSubstr("line 2: no JSON object"));
  EXPECT_THAT(complaint_on_programs("{\"processor\": \"a\"}\n"), HasSubstr("line 1: \"commit\" is missing"));
  EXPECT_THAT(complaint_on_programs(""), HasSubstr("it lists no programs"));
  const std::string program = R"({"processor": "a", "commit": "1", "compiler": "c", "rung": "0", "command": ["./recordings.jsonl"]})"
                              "\n";
  EXPECT_THAT(complaint_on_programs(program + program),
              HasSubstr("line 2: processor, commit, compiler and rung are those of a line above"));
  EXPECT_THAT(complaint_on_programs(R"({"processor": "a", "commit": "1", "compiler": "c", "rung": "0", "command": []})"),
              HasSubstr("\"command\" is missing"));
  EXPECT_THAT(complaint_on_programs(R"({"processor": "a", "commit": "1", "compiler": "c", "rung": "0", "command": ["./none"]})"),
              HasSubstr("none is not there"));
  EXPECT_THAT(complaint_on_programs(R"({"processor": "a", "commit": "1", "compiler": "c", "rung": "0", "command": ["isotouch"]})"),
              HasSubstr("no word of the command names a file by ./"));
  fs::create_directory(folder_.path() / "sysroot");
  EXPECT_THAT(complaint_on_programs(R"({"processor": "a", "commit": "1", "compiler": "c", "rung": "0", "command": ["sh", "./sysroot"]})"),
              HasSubstr("no word of the command names a file by ./"));
  EXPECT_THAT(complaint_on_programs("{\"processor\": \"a\\u001b[2J\"}"), HasSubstr("holds a control character"));
  EXPECT_THAT(complaint([this] { add("hand", kTrace); }), HasSubstr("'hand' is there; choose another with --name"));
  std::ofstream(recordings_file()) << R"({"name": "x", "field": "f", "trace": "t", "field_hash": "12", "trace_hash": "", "expected": ""})";
  EXPECT_THAT(complaint([this] { (void)read_recordings(recordings_file()); }), HasSubstr("\"field_hash\" is '12'; a hash has 16"));
}

TEST_F(Farm, AProgramThatCannotBeStartedFailsAlone) {
  list("a", "1", equal());
  std::ofstream(programs_file(), std::ios::app)
      << R"({"processor": "z", "commit": "1", "compiler": "c", "rung": "0", "command": ["no-such-program", "./recordings.jsonl"]})";
  const ShareReport report = run_all();
  EXPECT_EQ(report.asked, 2U);
  EXPECT_EQ(report.failed, 1U);
}

}  // namespace
}  // namespace isotouch::farm
