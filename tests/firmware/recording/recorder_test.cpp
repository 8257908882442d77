#include "firmware/recording/recorder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "shared/files/trace_file.h"
#include "tests/support/full_disk.h"
#include "tests/support/scratch_folder.h"

namespace isotouch::recording {
namespace {

using testing::HasSubstr;

/// The recordings in a state folder.
std::vector<std::string> saved(const std::string& state) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(state)) {
    if (entry.path().extension() == ".trace") names.push_back(entry.path().filename().string());
  }
  return names;
}

/// A recorder whose ticks the test makes.
struct Bench {
  explicit Bench(bool keeps = false) {
    if (keeps) std::filesystem::create_directory(state);
    TraceHeader header;
    header.device = libnifalcon_model();
    recorder.emplace(
        RecorderSettings{header, keeps ? state : std::string(), 50, 10, 2}, ring, &watched, commands,
        [this](std::uint32_t generation) { return generation == newest ? generation * 1000ULL : 0; },
        [this](const std::string& line) { said.push_back(line); });
  }

  void ticks(int count, std::uint32_t generation = 0, SupervisorState shown = SupervisorState::kIdle) {
    newest = std::max(newest, generation);
    for (int i = 0; i < count; ++i) {
      loop::TickRecord tick;
      tick.number = ++number;
      tick.in.requests = commands.take().bits;
      tick.in.field_generation = generation;
      tick.out.state = static_cast<std::uint16_t>(shown);
      tick.faults = tick.out.faults = shown == SupervisorState::kFault ? kFaultSilent : 0;
      ring.push(tick);
    }
    recorder->drain();
  }
  static files::TraceFile read(const std::string& file) {
    files::TraceFile trace;
    EXPECT_EQ(files::read_trace(file, trace).sentence(), "");
    return trace;
  }

  ScratchFolder folder;
  std::string path = (folder.path() / "a.trace").string(), state = (folder.path() / "state").string();
  loop::TraceRing ring{1024}, watched{16};
  loop::Requests commands;
  std::vector<std::string> said;
  std::uint64_t number = 0;
  std::uint32_t newest = 0;  ///< field; the hashes of those before are forgotten
  std::optional<Recorder> recorder;
};

TEST(Recorder, BeginsWithTheTickThatForgotAndEndsWhenAsked) {
  Bench bench;
  bench.ticks(5);
  ASSERT_EQ(bench.recorder->start(bench.path).sentence(), "");
  bench.ticks(10);
  bench.recorder->stop(bench.number);
  bench.ticks(5);
  const files::TraceFile trace = bench.read(bench.path);
  ASSERT_EQ(trace.size(), 10U);
  EXPECT_EQ(trace.record(0).input.requests, kRequestRestart);
  EXPECT_EQ(trace.header().field_hash, 0U);
  EXPECT_EQ(bench.said, std::vector<std::string>{bench.path + ": 10 ticks recorded; as asked"});
  EXPECT_EQ(bench.recorder->outcome(), Recorder::Outcome::kAsAsked);
}

TEST(Recorder, ARecordingThatBeginsAnewLeavesNothing) {
  Bench bench;
  std::ofstream(bench.path) << "an earlier one";
  ASSERT_EQ(bench.recorder->start(bench.path).sentence(), "");
  bench.ticks(10);
  bench.recorder->discard();
  bench.recorder->discard();
  EXPECT_FALSE(std::filesystem::exists(bench.path + ".part"));
  EXPECT_EQ(std::filesystem::file_size(bench.path), 14U);
  EXPECT_EQ(bench.said, std::vector<std::string>{bench.path + ": the recording begins anew"});
  EXPECT_EQ(bench.recorder->outcome(), Recorder::Outcome::kAsAsked);
}

/// A tick that takes a patch over which leads to an image of this hash.
void moved_tick(Bench& bench, std::uint32_t generation, std::uint32_t moved_to) {
  loop::TickRecord tick;
  tick.number = ++bench.number;
  tick.in.requests = kRequestMoved;
  tick.in.moved_to = moved_to;
  tick.in.field_generation = generation;
  bench.ring.push(tick);
  bench.recorder->drain();
}

TEST(Recorder, WhatAKillLeftOfARecordingStays) {
  Bench bench;
  std::ofstream(bench.path + ".part") << "an hour of ticks";
  EXPECT_NE(bench.recorder->start(bench.path).sentence().find("is left of a recording that was cut off"), std::string::npos);
  bench.ticks(5);
  EXPECT_EQ(std::filesystem::file_size(bench.path + ".part"), 16U);
  std::filesystem::remove(bench.path + ".part");
  const std::string patches = patches_of(bench.path) + ".part";
  std::ofstream(patches) << "its patches";
  EXPECT_EQ(bench.recorder->start(bench.path).sentence(),
            patches + ": is left of a recording that was cut off; rename it to keep it, or remove it");
  EXPECT_FALSE(std::filesystem::exists(bench.path + ".part"));
  std::filesystem::remove(patches);
  std::filesystem::create_directory(patches);
  EXPECT_EQ(bench.recorder->start(bench.path).sentence(), patches + ": cannot be opened: Is a directory; rename or remove it");
  std::filesystem::remove(patches);
  std::filesystem::create_directory(patches_of(bench.path));
  EXPECT_EQ(bench.recorder->start(bench.path).sentence(),
            patches_of(bench.path) + ": patches of the recording could not be written there: it is a folder, a device or a pipe; name " +
                "the recording otherwise");
  std::filesystem::remove(patches_of(bench.path));
  EXPECT_EQ(bench.recorder->start(bench.path).sentence(), "");
  std::ofstream(patches) << "of another program";
  const std::vector<std::uint8_t> patch = {1, 2, 3};
  bench.recorder->tell_patch(7, patch);
  bench.ticks(1, 1);
  moved_tick(bench, 2, 7);
  bench.recorder->stop(bench.number);
  EXPECT_EQ(std::filesystem::file_size(patches), 18U);
}

std::vector<std::uint8_t> bytes_of(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(Recorder, PatchesStandBesideTheRecordingInTheOrderOfTheirTicks) {
  Bench bench;
  const std::vector<std::uint8_t> one = {1, 2, 3}, never = {9, 9}, two = {4, 5};
  ASSERT_EQ(bench.recorder->start(bench.path).sentence(), "");
  bench.ticks(5, 1);
  bench.recorder->tell_patch(0xA00000001, one);
  moved_tick(bench, 2, 1);
  bench.ticks(3, 2);
  bench.recorder->tell_patch(0xB00000002, never);  // taken back
  bench.recorder->tell_patch(0xC00000003, two);
  moved_tick(bench, 4, 3);
  bench.ticks(3, 4);
  bench.recorder->stop(bench.number);
  const files::TraceFile trace = bench.read(bench.path);
  EXPECT_EQ(trace.size(), 13U);
  EXPECT_EQ(trace.header().field_hash, 1000U) << "the field before the first patch";
  EXPECT_EQ(bytes_of(patches_of(bench.path)), (std::vector<std::uint8_t>{1, 2, 3, 4, 5}));
  EXPECT_FALSE(std::filesystem::exists(patches_of(bench.path) + ".part"));
}

TEST(Recorder, EndsAtAPatchThatIsMissing) {
  Bench bench;
  ASSERT_EQ(bench.recorder->start(bench.path).sentence(), "");
  bench.ticks(5, 1);
  moved_tick(bench, 2, 1);
  bench.ticks(5, 2);
  EXPECT_EQ(bench.read(bench.path).size(), 5U);
  EXPECT_EQ(bench.said, std::vector<std::string>{bench.path + ": 5 ticks recorded; a patch was not kept until its tick came"});
  EXPECT_FALSE(std::filesystem::exists(patches_of(bench.path)));
}

TEST(Recorder, OutsideARecordingTheLastPatchAloneIsKept) {
  for (const bool last : {false, true}) {
    Bench bench;
    bench.recorder->tell_patch(1, std::vector<std::uint8_t>{1});
    bench.recorder->tell_patch(2, std::vector<std::uint8_t>{2});
    ASSERT_EQ(bench.recorder->start(bench.path).sentence(), "");
    bench.ticks(5, 1);
    moved_tick(bench, 2, last ? 2 : 1);
    bench.recorder->stop(bench.number);
    EXPECT_EQ(std::filesystem::exists(patches_of(bench.path)), last);
    EXPECT_EQ(bench.read(bench.path).size(), last ? 6U : 5U);
  }
}

TEST(Recorder, PatchesThatNoTickTakesDoNotFillTheMemory) {
  Bench bench;
  ASSERT_EQ(bench.recorder->start(bench.path).sentence(), "");
  bench.ticks(5, 1);
  const std::vector<std::uint8_t> large(std::size_t{20} << 20U, 7);
  bench.recorder->tell_patch(1, large);
  bench.recorder->tell_patch(2, large);
  moved_tick(bench, 2, 1);
  EXPECT_EQ(bench.said, std::vector<std::string>{bench.path + ": 5 ticks recorded; a patch was not kept until its tick came"});
}

TEST(Recorder, WithoutItsPatchesARecordingIsLost) {
  Bench bench;
  ASSERT_EQ(bench.recorder->start(bench.path).sentence(), "");
  bench.ticks(5, 1);
  bench.recorder->tell_patch(1, std::vector<std::uint8_t>{1});
  moved_tick(bench, 2, 1);
  std::filesystem::create_directory(patches_of(bench.path));  // no file can get that name
  EXPECT_EQ(bench.recorder->outcome(), Recorder::Outcome::kAsAsked);
  bench.recorder->stop(bench.number);
  EXPECT_EQ(bench.recorder->outcome(), Recorder::Outcome::kLost);
  ASSERT_EQ(bench.said.size(), 1U);
  EXPECT_THAT(bench.said[0], HasSubstr("without them " + bench.path + " does not replay"));
  EXPECT_FALSE(std::filesystem::exists(patches_of(bench.path) + ".part"));
}

TEST(Recorder, ThePatchesOfATraceHaveItsName) {
  EXPECT_EQ(patches_of("/a.b/c.trace"), "/a.b/c.patches");
  EXPECT_EQ(patches_of("/a.b/c"), "/a.b/c.patches");
  EXPECT_EQ(patches_of("c.d.trace"), "c.d.patches");
}

TEST(Recorder, OneRecordingAtATime) {
  Bench bench;
  ASSERT_EQ(bench.recorder->start(bench.path).sentence(), "");
  EXPECT_EQ(bench.recorder->start("b").sentence(), "a recording is under way: " + bench.path);
}

TEST(Recorder, NamesItsFieldAndEndsWhereAnotherIsLoaded) {
  Bench bench;
  ASSERT_EQ(bench.recorder->start(bench.path).sentence(), "");
  bench.ticks(3);
  bench.ticks(4, 7);
  bench.ticks(2, 0);
  bench.ticks(5, 8);
  const files::TraceFile trace = bench.read(bench.path);
  EXPECT_EQ(trace.size(), 9U);
  EXPECT_EQ(trace.header().field_hash, 7000U);
  EXPECT_NE(bench.said.at(0).find("another field was loaded"), std::string::npos);
  bench.recorder->stop(bench.number);
  EXPECT_EQ(bench.recorder->outcome(), Recorder::Outcome::kEndedEarly);
}

TEST(Recorder, EndsWhereTheRingLostATick) {
  Bench bench;
  ASSERT_EQ(bench.recorder->start(bench.path).sentence(), "");
  bench.ticks(3);
  ++bench.number;
  bench.ticks(3);
  EXPECT_EQ(bench.read(bench.path).size(), 3U);
  EXPECT_NE(bench.said.at(0).find("ticks were lost"), std::string::npos);
  EXPECT_EQ(bench.recorder->outcome(), Recorder::Outcome::kEndedEarly);
}

TEST(Recorder, SaysThatTheRingLostTheLastTicks) {
  Bench bench;
  ASSERT_EQ(bench.recorder->start(bench.path).sentence(), "");
  bench.ticks(3);
  bench.recorder->stop(bench.number + 2);
  EXPECT_EQ(bench.read(bench.path).size(), 3U);
  EXPECT_EQ(bench.said, std::vector<std::string>{bench.path + ": 3 ticks recorded; ticks were lost because the recorder was too slow"});
  EXPECT_EQ(bench.recorder->outcome(), Recorder::Outcome::kEndedEarly);
}

TEST(Recorder, PassesEveryTickOnAsLongAsThereIsRoom) {
  Bench bench;
  bench.ticks(20);
  loop::TickRecord tick;
  for (std::uint64_t i = 1; i <= 16; ++i) {
    ASSERT_TRUE(bench.watched.pop(tick));
    EXPECT_EQ(tick.number, i);
  }
  EXPECT_FALSE(bench.watched.pop(tick));
}

TEST(Recorder, KeepsWhatWasBeforeAFault) {
  Bench bench(true);
  const std::string& state = bench.state;
  bench.ticks(100, 3, SupervisorState::kActive);
  bench.ticks(5, 3, SupervisorState::kFault);
  EXPECT_EQ(bench.recorder->condition().faults, kFaultSilent);
  EXPECT_TRUE(saved(state).empty()) << "what comes after it belongs to it";
  bench.ticks(100, 3, SupervisorState::kFault);
  const files::TraceFile trace = bench.read(state + "/fault-1.trace");
  ASSERT_EQ(trace.size(), 61U);
  EXPECT_EQ(trace.header().field_hash, 3000U);
  for (std::size_t i = 0; i < 61; ++i) EXPECT_EQ(trace.record(i).output.faults, i < 50 ? 0 : kFaultSilent) << i;
  for (int fault = 0; fault < 3; ++fault) {
    bench.ticks(20, 3, SupervisorState::kIdle);
    bench.ticks(20, 3, SupervisorState::kFault);
  }
  EXPECT_TRUE(std::filesystem::exists(state + "/fault-2.trace"));
  EXPECT_FALSE(std::filesystem::exists(state + "/fault-3.trace")) << "a fault that comes and goes does not fill the disk";
}

TEST(Recorder, TheLastTicksOfAKilledRunAreSavedByTheNext) {
  Bench bench(true);
  bench.ticks(100, 3, SupervisorState::kActive);
  const std::string left = bench.state + "/last-ticks", aside = (bench.folder.path() / "aside").string();
  std::filesystem::copy_file(left, aside);  // as a kill leaves it
  bench.recorder.reset();
  EXPECT_FALSE(std::filesystem::exists(left)) << "an orderly end";
  std::string said;
  const auto start = [&] {
    const RecorderSettings settings{TraceHeader{}, bench.state, 50, 10, 2};
    const Recorder next(
        settings, bench.ring, nullptr, bench.commands, [](std::uint32_t) { return 0; }, [&](const std::string& line) { said = line; });
  };
  std::filesystem::copy_file(aside, left);
  {
    const FullDisk disk(200);
    start();
  }
  EXPECT_THAT(said, HasSubstr("they stay in " + left));
  EXPECT_EQ(bytes_of(left), bytes_of(aside)) << "what cannot be saved is not lost";
  start();
  ASSERT_EQ(saved(bench.state), std::vector<std::string>{"crash-1.trace"});
  const files::TraceFile trace = Bench::read(bench.state + "/crash-1.trace");
  EXPECT_EQ(trace.size(), 61U);
  EXPECT_EQ(trace.header().field_hash, 3000U);
}

TEST(Recorder, OfManyRunsTheNewestFaultsAreKept) {
  Bench bench(true);
  for (const char* name : {"fault-7.trace", "fault-9.trace", "fault-10.trace", "fault-x.trace", "fault-12.trace.part", "crash-1.trace"})
    std::ofstream(bench.state + "/" + name) << "of a run before";
  RecorderSettings settings{TraceHeader{}, bench.state, 50, 10, 2};
  settings.most_kept = 3;
  bench.recorder.reset();
  bench.recorder.emplace(
      settings, bench.ring, nullptr, bench.commands, [](std::uint32_t) { return 0; }, [](const std::string&) {});
  bench.ticks(100, 3, SupervisorState::kActive);
  bench.ticks(100, 3, SupervisorState::kFault);
  for (const char* kept : {"fault-9.trace", "fault-10.trace", "fault-13.trace", "fault-x.trace", "fault-12.trace.part", "crash-1.trace"})
    EXPECT_TRUE(std::filesystem::exists(bench.state + "/" + kept)) << kept;
  EXPECT_FALSE(std::filesystem::exists(bench.state + "/fault-7.trace")) << "the oldest goes";
}

TEST(Recorder, ARunThatBeginsInFaultHasNothingToShow) {
  Bench bench(true);
  bench.ticks(200, 3, SupervisorState::kFault);
  EXPECT_EQ(bench.recorder->condition().faults, kFaultSilent);
  EXPECT_TRUE(saved(bench.state).empty());
}

/// Saved with so many ticks before the fault and from it on; no others.
void expect_saved(const Bench& bench, std::size_t before, std::size_t from) {
  const files::TraceFile trace = bench.read(bench.state + "/fault-1.trace");
  ASSERT_EQ(trace.size(), before + from);
  EXPECT_EQ(trace.header().field_hash, 3000U) << "the field of the fault";
  for (std::size_t i = 0; i < before + from; ++i) EXPECT_EQ(trace.record(i).output.faults, i < before ? 0 : kFaultSilent) << i;
}

TEST(Recorder, AFaultIsInItsRecordingWhenAnotherFieldComesAfterIt) {
  Bench bench(true);
  bench.ticks(20, 2, SupervisorState::kActive);
  bench.ticks(30, 3, SupervisorState::kActive);
  bench.ticks(4, 3, SupervisorState::kFault);
  bench.ticks(20, 4, SupervisorState::kFault);
  expect_saved(bench, 30, 4);
}

TEST(Recorder, AFaultIsInItsRecordingWhenATickIsLostAfterIt) {
  Bench bench(true);
  bench.ticks(20, 3, SupervisorState::kActive);
  ++bench.number;
  bench.ticks(30, 3, SupervisorState::kActive);
  bench.ticks(1, 3, SupervisorState::kFault);
  ++bench.number;
  bench.ticks(20, 3, SupervisorState::kFault);
  expect_saved(bench, 30, 1);
}

TEST(Recorder, AFaultIsInItsRecordingWhenTheProgramEndsSoonAfterIt) {
  Bench bench(true);
  bench.ticks(70, 3, SupervisorState::kActive);
  bench.ticks(3, 3, SupervisorState::kFault);
  bench.recorder.reset();
  expect_saved(bench, 58, 3);
}

TEST(Recorder, AnEndInTheMiddleCompletesWhatIsWritten) {
  Bench bench;
  ASSERT_EQ(bench.recorder->start(bench.path).sentence(), "");
  bench.ticks(3);
  bench.recorder.reset();
  EXPECT_EQ(bench.read(bench.path).size(), 3U);
}

}  // namespace
}  // namespace isotouch::recording
