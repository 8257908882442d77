#include "firmware/io/control_server.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>
#include <vector>

#include "tests/firmware/io/control_rig.h"
#include "tests/firmware/io/packed_field.h"
#include "tests/support/random.h"

namespace isotouch::io {
namespace {

using testing::HasSubstr;
using testing::MatchesRegex;
using wire::Kind;

/// The frames of one upload, in order.
std::vector<std::vector<std::uint8_t>> frames_of(const PackedField& field, std::size_t chunk) {
  std::vector<std::vector<std::uint8_t>> frames;
  const auto add = [&](auto write) {
    std::vector<std::uint8_t> frame(wire::kMaxFrame);
    frame.resize(write(std::span(frame)));
    frames.push_back(frame);
  };
  add([](auto out) { return wire::encode(Kind::kHello, wire::Hello{}, out); });
  add([&](auto out) { return wire::encode(Kind::kBegin, field.promise, out); });
  for (std::size_t at = 0; at < field.bytes.size(); at += chunk) {
    const wire::Chunk piece{at, std::span(field.bytes).subspan(at, std::min(chunk, field.bytes.size() - at))};
    add([&](auto out) { return wire::encode(Kind::kChunk, piece, out); });
  }
  add([](auto out) { return wire::seal_frame(Kind::kCommit, 0, out); });
  return frames;
}

/// Sends a field and returns the last answer.
Heard upload(Speaker& speaker, const PackedField& field, std::size_t chunk = 4096) {
  Heard heard;
  const auto frames = frames_of(field, chunk);
  for (const auto& frame : frames) {
    speaker.send(frame);
    heard = speaker.hear();
    if (heard.kind == Kind::kRefused) break;
  }
  return heard;
}

void expect_sentence(const Heard& heard, const std::string& about) {
  EXPECT_THAT(heard.refusal(), HasSubstr(about));
  EXPECT_THAT(heard.refusal(), HasSubstr("; ")) << "it says what to do";
}

TEST(ControlServer, AnUploadIsFeltWhenItIsAccepted) {
  ControlRig rig;
  const PackedField ball = packed_ball(1);
  Speaker speaker(rig.settings.path);
  const Heard heard = upload(speaker, ball);
  ASSERT_EQ(heard.kind, Kind::kAccepted) << heard.refusal();
  EXPECT_EQ(wire::decode<wire::Accepted>(heard.body)->image_hash, ball.promise.image_hash);
  EXPECT_EQ(rig.tick.felt, ball.promise.image_hash);
  EXPECT_EQ(rig.tick.generation, wire::decode<wire::Accepted>(heard.body)->generation);
}

TEST(ControlServer, RequestsMayBeSentAheadOfTheirAnswers) {
  ControlRig rig;
  const PackedField ball = packed_ball(1);
  Speaker speaker(rig.settings.path);
  const auto frames = frames_of(ball, 512);
  for (const auto& frame : frames) ASSERT_TRUE(speaker.send(frame));
  speaker.say(Kind::kFields);
  speaker.say(Kind::kStatus);
  EXPECT_EQ(speaker.hear().kind, Kind::kWelcome);
  for (std::size_t i = 2; i < frames.size(); ++i) EXPECT_EQ(speaker.hear().kind, Kind::kDone);
  EXPECT_EQ(speaker.hear().kind, Kind::kAccepted);
  const Heard list = speaker.hear();
  ASSERT_EQ(list.kind, Kind::kFieldList);
  EXPECT_EQ(wire::decode<wire::FieldList>(list.body)->count, 1U);
  const Heard status = speaker.hear();
  ASSERT_EQ(status.kind, Kind::kStatusReport);
  EXPECT_EQ(wire::decode<wire::StatusReport>(status.body)->field_hash, ball.promise.image_hash);
}

TEST(ControlServer, AnUploadCutAtAnyFrameLeavesTheOldField) {
  ControlRig rig;
  const PackedField old = packed_ball(1), other = packed_ball(2);
  {
    Speaker speaker(rig.settings.path);
    ASSERT_EQ(upload(speaker, old).kind, Kind::kAccepted);
  }
  const auto frames = frames_of(other, 128);
  ASSERT_GT(frames.size(), 10U);
  for (std::size_t whole = 0; whole < frames.size(); ++whole) {
    for (const bool half : {false, true}) {
      Speaker speaker(rig.settings.path);
      for (std::size_t i = 0; i < whole; ++i) speaker.send(frames[i]);
      if (half) speaker.send(std::span(frames[whole]).first(frames[whole].size() / 2));
      if (whole > 0) {
        EXPECT_NE(speaker.hear().kind, Kind::kRefused);  // the server has begun to read when the sender dies
      }
    }
    ASSERT_EQ(rig.tick.felt, old.promise.image_hash) << "cut after " << whole << " frames";
  }
  Speaker speaker(rig.settings.path);
  Heard heard = upload(speaker, other);
  EXPECT_EQ(heard.kind, Kind::kAccepted) << heard.refusal();
  EXPECT_EQ(rig.tick.felt, other.promise.image_hash);
}

TEST(ControlServer, AnUploadThatStartsAgainBeginsFromTheFront) {
  ControlRig rig;
  const PackedField ball = packed_ball(1);
  Speaker speaker(rig.settings.path);
  const auto frames = frames_of(ball, 512);
  for (std::size_t i = 0; i + 2 < frames.size(); ++i) speaker.send(frames[i]), speaker.hear();
  for (std::size_t i = 1; i + 1 < frames.size(); ++i) {
    speaker.send(frames[i]);
    EXPECT_EQ(speaker.hear().kind, Kind::kDone);
  }
  speaker.send(frames.back());
  EXPECT_EQ(speaker.hear().kind, Kind::kAccepted);
}

TEST(ControlServer, WhatCannotBeAnUploadIsRefusedWithASentence) {
  ControlRig rig;
  const PackedField ball = packed_ball(1);
  Speaker speaker(rig.settings.path);
  speaker.greet();
  const auto ask = [&](Kind kind, const auto& message) {
    speaker.say(kind, message);
    return speaker.hear();
  };
  wire::Begin large = ball.promise;
  large.image_bytes = rig.intake.image_limit() + 1;
  expect_sentence(ask(Kind::kBegin, large), "has room for 1048576");
  large = ball.promise;
  large.packed_bytes = UINT64_MAX;
  expect_sentence(ask(Kind::kBegin, large), "has room for");
  expect_sentence(ask(Kind::kChunk, wire::Chunk{0, ball.bytes}), "no upload is under way");
  speaker.say(Kind::kCommit);
  expect_sentence(speaker.hear(), "no upload is under way");

  ASSERT_EQ(ask(Kind::kBegin, ball.promise).kind, Kind::kDone);
  expect_sentence(ask(Kind::kChunk, wire::Chunk{1, ball.bytes}), "does not follow");
  ASSERT_EQ(ask(Kind::kBegin, ball.promise).kind, Kind::kDone);
  std::vector<std::uint8_t> longer = ball.bytes;
  longer.push_back(0);
  expect_sentence(ask(Kind::kChunk, wire::Chunk{0, longer}), "does not follow");
  ASSERT_EQ(ask(Kind::kBegin, ball.promise).kind, Kind::kDone);
  speaker.say(Kind::kCommit);
  expect_sentence(speaker.hear(), "ended after 0 of " + std::to_string(ball.bytes.size()));
  ASSERT_EQ(ask(Kind::kBegin, ball.promise).kind, Kind::kDone);
  speaker.say(Kind::kAbort);
  EXPECT_EQ(speaker.hear().kind, Kind::kDone);
  speaker.say(Kind::kCommit);
  expect_sentence(speaker.hear(), "no upload is under way");
  speaker.say(Kind::kBegin);
  expect_sentence(speaker.hear(), "shorter than its kind demands");
  speaker.say(static_cast<Kind>(100));
  expect_sentence(speaker.hear(), "does not know the request");
  EXPECT_EQ(rig.tick.generation, 0U);
  EXPECT_EQ(upload(speaker, ball).kind, Kind::kAccepted) << "and the connection is as good as before";
}

TEST(ControlServer, TwoSendersDoNotMixTheirFields) {
  ControlRig rig;
  const PackedField one = packed_ball(1), two = packed_ball(2);
  Speaker first(rig.settings.path), second(rig.settings.path);
  first.greet(), second.greet();
  first.say(Kind::kBegin, one.promise);
  ASSERT_EQ(first.hear().kind, Kind::kDone);
  second.say(Kind::kBegin, two.promise);
  expect_sentence(second.hear(), "another client is sending");
  second.say(Kind::kSelect, wire::Select{1});
  expect_sentence(second.hear(), "another client is sending");
  first.hang_up();
  Heard heard;
  for (int tries = 0; tries < 100 && heard.kind != Kind::kAccepted; ++tries) heard = upload(second, two);
  EXPECT_EQ(heard.kind, Kind::kAccepted) << heard.refusal();
}

TEST(ControlServer, AnotherVersionIsToldWhatToDo) {
  ControlRig rig;
  Speaker speaker(rig.settings.path);
  expect_sentence(speaker.greet(2), "speaks version 1 of the wire and the tool 2; install the same release");
  EXPECT_EQ(speaker.hear().kind, Kind{}) << "and the connection ends";
  Speaker newer(rig.settings.path);
  newer.say(Kind::kHello, wire::Hello{wire::kMajor, 99});
  EXPECT_EQ(newer.hear().kind, Kind::kWelcome) << "a newer minor version only adds";
  Speaker rude(rig.settings.path);
  rude.say(Kind::kStop);
  expect_sentence(rude.hear(), "begins with a greeting");
  EXPECT_EQ(rig.tick.obeyed, 0) << "what it asked for was not done";
  Speaker other(rig.settings.path);
  const std::string request = "GET / HTTP/1.1\r\n\r\n";
  other.send({reinterpret_cast<const std::uint8_t*>(request.data()), request.size()});
  expect_sentence(other.hear(), "cannot be understood");
}

TEST(ControlServer, StopAndResumeReachTheTick) {
  ControlRig rig;
  Speaker speaker(rig.settings.path);
  speaker.greet();
  const auto obeyed_in_time = [&](std::uint8_t bit) {
    for (int tries = 0; tries < 5000 && (rig.tick.obeyed & bit) == 0; ++tries) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return rig.tick.obeyed.load();
  };
  speaker.say(Kind::kStop);
  EXPECT_EQ(speaker.hear().kind, Kind::kDone);
  EXPECT_EQ(obeyed_in_time(kCommandStop), kCommandStop);
  speaker.say(Kind::kResume);
  EXPECT_EQ(speaker.hear().kind, Kind::kDone);
  EXPECT_EQ(obeyed_in_time(kCommandResume), kCommandStop | kCommandResume);
}

TEST(ControlServer, StatusAndHistogramsAreTheTicks) {
  ControlRig rig;
  Speaker speaker(rig.settings.path);
  const Heard welcome = speaker.greet();
  ASSERT_EQ(welcome.kind, Kind::kWelcome);
  EXPECT_EQ(wire::decode<wire::Welcome>(welcome.body)->program.view(), "a test");
  EXPECT_EQ(wire::decode<wire::Welcome>(welcome.body)->image_limit, 1U << 20);
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  speaker.say(Kind::kStatus);
  const Heard heard = speaker.hear();
  const auto status = wire::decode<wire::StatusReport>(heard.body);
  ASSERT_TRUE(status);
  EXPECT_EQ(status->state, static_cast<std::uint16_t>(SupervisorState::kIdle));
  EXPECT_GT(status->ticks, 0U);
  const wire::Quantiles tick = status->measures[static_cast<std::size_t>(wire::Measure::kTick)];
  EXPECT_GE(tick.p999, tick.p50);
  EXPECT_GT(tick.max, 0U);
  speaker.say(Kind::kHistogram, wire::HistogramRequest{static_cast<std::uint8_t>(wire::Measure::kTick)});
  const Heard answer = speaker.hear();
  const auto histogram = wire::decode<wire::HistogramReport>(answer.body);
  ASSERT_TRUE(histogram);
  std::uint64_t sum = 0;
  ASSERT_EQ(histogram->bins.size() % wire::kBinBytes, 0U);
  for (std::size_t at = 0; at < histogram->bins.size(); at += wire::kBinBytes) {
    sum += wire::decode<wire::Bin>(histogram->bins.subspan(at, wire::kBinBytes))->count;
  }
  EXPECT_EQ(sum, histogram->count);
  EXPECT_GE(sum, status->ticks - 1);
  speaker.say(Kind::kHistogram, wire::HistogramRequest{4});
  expect_sentence(speaker.hear(), "does not measure that");
}

/// The records of one frame, or none with what was said instead.
std::vector<DeviceTraceRecord> records_of(const Heard& heard) {
  std::vector<DeviceTraceRecord> records;
  const auto said = heard.kind == Kind::kRecords ? wire::decode<wire::Records>(heard.body) : Result<wire::Records>(Error::kBadMessage);
  if (!said) return records;
  constexpr std::size_t kBytes = device_trace_layout::kRecordBytes;
  EXPECT_EQ(said->record_bytes, kBytes);
  for (std::size_t at = 0; at + kBytes <= said->bytes.size(); at += kBytes) {
    const auto record = decode_device_record(said->bytes.subspan(at).first<kBytes>());
    EXPECT_TRUE(record);
    records.push_back(*record);
  }
  return records;
}

TEST(ControlServer, TicksAreWatchedAtAnyRate) {
  ControlRig rig;
  Speaker speaker(rig.settings.path);
  speaker.greet();
  for (const std::uint32_t every : {1U, 7U}) {
    speaker.say(Kind::kSubscribe, wire::Subscribe{every});
    Heard heard = speaker.hear();
    while (heard.kind == Kind::kRecords) heard = speaker.hear();  // of the subscription before
    ASSERT_EQ(heard.kind, Kind::kDone);
    std::size_t seen = 0;
    for (int frames = 0; frames < 20; ++frames) {
      heard = speaker.hear();
      ASSERT_EQ(heard.kind, Kind::kRecords);
      const auto said = wire::decode<wire::Records>(heard.body);
      ASSERT_TRUE(said);
      EXPECT_EQ(said->every, every);
      EXPECT_EQ(said->first_tick % every, 0U);
      seen += records_of(heard).size();
    }
    EXPECT_GT(seen, 20U);
  }
  speaker.say(Kind::kSubscribe, wire::Subscribe{0});
  Heard heard = speaker.hear();
  while (heard.kind == Kind::kRecords) heard = speaker.hear();
  EXPECT_EQ(heard.kind, Kind::kDone);
}

TEST(ControlServer, ARecordingBeginsAnewAndItsChainHolds) {
  ControlRig rig;
  Speaker speaker(rig.settings.path), other(rig.settings.path);
  speaker.greet(), other.greet();
  speaker.say(Kind::kRecord);
  Heard heard = speaker.hear();
  ASSERT_EQ(heard.kind, Kind::kRecording);
  const auto header = decode_device_header(wire::decode<wire::Recording>(heard.body)->header, device_trace_layout::kHeaderBytes);
  ASSERT_TRUE(header);
  EXPECT_EQ(header->device, rig.settings.recordings.device);
  other.say(Kind::kRecord);
  expect_sentence(other.hear(), "another client is recording");
  DeviceChain chain(*header);
  std::size_t ticks = 0;
  while (ticks < 500) {
    heard = speaker.hear();
    const std::vector<DeviceTraceRecord> records = records_of(heard);
    ASSERT_FALSE(records.empty()) << heard.refusal();
    for (const DeviceTraceRecord& record : records) {
      EXPECT_EQ((record.input.commands & kCommandRestart) != 0, ticks == 0);
      EXPECT_EQ(chain.extend(record.input, record.output), record.chain);
      ++ticks;
    }
  }
  // Another field would be another trace.
  ASSERT_EQ(upload(other, packed_ball(1)).kind, Kind::kAccepted);
  while (heard.kind == Kind::kRecords) heard = speaker.hear();
  expect_sentence(heard, "another field was taken over");
  other.say(Kind::kRecord);
  EXPECT_EQ(other.hear().kind, Kind::kRecording) << "the next may record";
  other.say(Kind::kRecordEnd);
  do heard = other.hear();
  while (heard.kind == Kind::kRecords);
  EXPECT_EQ(heard.kind, Kind::kDone);
}

TEST(ControlServer, AUserWhoIsNotListedIsRefusedWithASentence) {
  Peer stranger{true, 4711, {4711, 4712}};
  ControlRig rig(1 << 20, [&](ControlSettings& settings) {
    settings.peer = [&](int) { return stranger; };
    settings.admission.users = {1234};
    settings.admission.groups = {77};
  });
  Speaker refused(rig.settings.path);
  expect_sentence(refused.hear(), "user 4711 may not use this controller");
  EXPECT_EQ(refused.hear().kind, Kind{});
  stranger.groups.push_back(77);
  Speaker let_in(rig.settings.path);
  EXPECT_EQ(let_in.greet().kind, Kind::kWelcome);
}

TEST(ControlServer, ARealStrangerIsRefused) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root can become another user";
  ControlRig rig(1 << 20, [](ControlSettings& settings) { settings.mode = 0666; });
  ::chmod(rig.scratch.path().c_str(), 0755);
  const pid_t child = ::fork();
  if (child == 0) {
    // Refused with the right sentence: 42.
    if (::setegid(65534) != 0 || ::seteuid(65534) != 0) ::_exit(1);
    Speaker speaker(rig.settings.path);
    ::_exit(speaker.hear().refusal().find("user 65534 may not") != std::string::npos ? 42 : 2);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 42) << status;
}

TEST(ControlServer, TheSocketHasItsPermissionsAndGoesWithTheServer) {
  ControlRig rig(1 << 20, [](ControlSettings& settings) { settings.mode = 0600; });
  struct stat about {};
  ASSERT_EQ(::stat(rig.settings.path.c_str(), &about), 0);
  EXPECT_EQ(about.st_mode & 0777U, 0600U);
  ControlServer second(rig.settings, {rig.intake, rig.tick.commands, rig.tick.stats, rig.tick.shown, rig.clock, nullptr});
  EXPECT_THAT(second.start(), HasSubstr("another program listens there"));
  rig.server->stop();
  EXPECT_NE(::stat(rig.settings.path.c_str(), &about), 0);
  EXPECT_EQ(rig.server->start(), "");
  rig.server->stop();
  std::ofstream(rig.settings.path) << "a file";
  EXPECT_THAT(rig.server->start(), HasSubstr("is a file already"));
}

TEST(ControlServer, ASocketThatNobodyListensAtIsReplaced) {
  ControlRig rig;
  rig.server->stop();
  {
    ControlSocket left;
    ASSERT_EQ(left.open(rig.settings.path, 0600, std::nullopt), "");
    const std::string moved = rig.settings.path + ".old";
    ASSERT_EQ(::rename(rig.settings.path.c_str(), moved.c_str()), 0);
    left.close();
    ASSERT_EQ(::rename(moved.c_str(), rig.settings.path.c_str()), 0);
  }
  EXPECT_EQ(rig.server->start(), "");
  Speaker speaker(rig.settings.path);
  EXPECT_EQ(speaker.greet().kind, Kind::kWelcome);
}

TEST(ControlServer, MoreClientsThanPlacesAreToldSo) {
  ControlRig rig(1 << 20, [](ControlSettings& settings) { settings.clients = 2; });
  Speaker one(rig.settings.path), two(rig.settings.path);
  one.greet(), two.greet();
  Speaker three(rig.settings.path);
  expect_sentence(three.hear(), "2 clients are connected");
}

TEST(ControlServer, WhoStopsInTheMiddleIsNotWaitedFor) {
  ControlRig rig(1 << 20, [](ControlSettings& settings) { settings.clients = 1, settings.patience_ns = 50'000'000; });
  Speaker half(rig.settings.path);
  half.greet();
  half.send(std::vector<std::uint8_t>{'I', 'T', 'C'});
  EXPECT_EQ(half.hear().kind, Kind{}) << "its place is given to others";
  Speaker next(rig.settings.path);
  EXPECT_EQ(next.greet().kind, Kind::kWelcome);
}

TEST(ControlServer, WhoDoesNotReadLosesRecordsAndDelaysNobody) {
  ControlRig rig;
  Speaker deaf(rig.settings.path), other(rig.settings.path);
  deaf.greet(), other.greet();
  const int small = 4096;
  ::setsockopt(deaf.socket(), SOL_SOCKET, SO_RCVBUF, &small, sizeof small);
  for (int i = 0; i < 200; ++i) deaf.say(Kind::kSubscribe, wire::Subscribe{1});
  const std::uint64_t before = rig.tick.stats.ticks.value();
  while (rig.tick.stats.ticks.value() < before + 10'000) {
    other.say(Kind::kStatus);
    ASSERT_EQ(other.hear().kind, Kind::kStatusReport);
  }
  std::uint64_t lost = 0;
  for (int frames = 0; lost == 0 && frames < 20'000; ++frames) {
    const Heard heard = deaf.hear();
    ASSERT_NE(heard.kind, Kind{});
    if (heard.kind == Kind::kRecords) lost = wire::decode<wire::Records>(heard.body)->lost;
  }
  EXPECT_GT(lost, 0U) << "and it is told so";
}

std::ptrdiff_t open_files() {
  return std::distance(std::filesystem::directory_iterator("/proc/self/fd"), std::filesystem::directory_iterator());
}

TEST(ControlServer, TenThousandRandomConnectionsDisturbNobody) {
  ControlRig rig(1 << 18, [](ControlSettings& settings) { settings.patience_ns = 20'000'000; });
  const PackedField old = packed_ball(1), other = packed_ball(2);
  {
    Speaker speaker(rig.settings.path);
    ASSERT_EQ(upload(speaker, old).kind, Kind::kAccepted);
  }
  auto frames = frames_of(other, 700);
  frames.pop_back();  // never a commit
  for (const Kind kind : {Kind::kStatus, Kind::kFields, Kind::kAbort, Kind::kStop, Kind::kRecord, Kind::kRecordEnd}) {
    std::vector<std::uint8_t> frame(wire::kHeaderBytes);
    wire::seal_frame(kind, 0, frame);
    frames.push_back(frame);
  }
  const std::ptrdiff_t files = open_files();
  test::Random random(17);
  for (int round = 0; round < 10'000; ++round) {
    Speaker speaker(rig.settings.path);
    if (random.bits() % 2 == 0) speaker.send(frames[0]);
    for (std::uint64_t sent = random.bits() % 5; sent > 0; --sent) {
      std::vector<std::uint8_t> frame = frames[static_cast<std::size_t>(random.bits() % frames.size())];
      if (random.bits() % 3 == 0)
        frame[static_cast<std::size_t>(random.bits() % frame.size())] ^= static_cast<std::uint8_t>(1U << random.bits() % 8);
      if (random.bits() % 3 == 0) frame.resize(static_cast<std::size_t>(random.bits() % frame.size()));
      if (random.bits() % 16 == 0) {
        for (std::uint8_t& byte : frame) byte = static_cast<std::uint8_t>(random.bits());
      }
      if (!speaker.send(frame)) break;
    }
    if (random.bits() % 8 == 0) (void)speaker.hear();
  }
  EXPECT_EQ(rig.tick.felt, old.promise.image_hash);
  Heard heard;
  for (int tries = 0; tries < 100 && heard.kind != Kind::kAccepted; ++tries) {
    Speaker speaker(rig.settings.path);
    heard = upload(speaker, other);
  }
  EXPECT_EQ(heard.kind, Kind::kAccepted) << heard.refusal();
  for (int tries = 0; tries < 1000 && open_files() > files; ++tries) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  EXPECT_LE(open_files(), files) << "no connection is left behind";
}

}  // namespace
}  // namespace isotouch::io
