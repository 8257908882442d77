#include "firmware/control/control_server.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <thread>
#include <vector>

#include "tests/firmware/control/control_rig.h"
#include "tests/firmware/store/packed_field.h"
#include "tests/support/field_patch.h"

namespace isotouch::control {
namespace {

using protocol::Kind;

TEST(ControlServer, AnUploadIsFeltWhenItIsAccepted) {
  ControlRig rig;
  const store::PackedField ball = store::packed_ball(1);
  Speaker speaker(rig.settings.path);
  const Heard heard = upload(speaker, ball);
  ASSERT_EQ(heard.kind, Kind::kAccepted) << heard.refusal();
  EXPECT_EQ(protocol::decode<protocol::Accepted>(heard.body)->image_hash, ball.promise.image_hash);
  EXPECT_EQ(rig.tick.felt(), ball.promise.image_hash);
  EXPECT_EQ(rig.tick.generation(), protocol::decode<protocol::Accepted>(heard.body)->generation);
}

TEST(ControlServer, RequestsMayBeSentAheadOfTheirAnswers) {
  ControlRig rig;
  const store::PackedField ball = store::packed_ball(1);
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
  EXPECT_EQ(protocol::decode<protocol::FieldList>(list.body)->count, 1U);
  const Heard status = speaker.hear();
  ASSERT_EQ(status.kind, Kind::kStatusReport);
  EXPECT_EQ(protocol::decode<protocol::StatusReport>(status.body)->field_hash, ball.promise.image_hash);
}

TEST(ControlServer, TheWorstTicksAreThoseSinceTheyWereForgotten) {
  ControlRig rig;
  Speaker speaker(rig.settings.path);
  speaker.greet();
  const auto ask = [&](std::uint8_t anew) {
    speaker.say(Kind::kWorst, protocol::WorstRequest{anew});
    const Heard heard = speaker.hear();
    EXPECT_EQ(heard.kind, Kind::kWorstTicks);
    const auto report = protocol::decode<protocol::WorstTicks>(heard.body);
    EXPECT_EQ(report->ticks.size(), std::min<std::uint64_t>(report->seen, 10) * protocol::kWorstTickBytes);
    return report->seen;
  };
  for (int i = 0; i < 6000 && ask(0) < 20; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  const std::uint64_t before = ask(1);
  EXPECT_GE(before, 20U);
  EXPECT_LT(ask(0), before) << "they were not forgotten";
}

TEST(ControlServer, AnUploadCutAtAnyFrameLeavesTheOldField) {
  ControlRig rig;
  const store::PackedField old = store::packed_ball(1), other = store::packed_ball(2);
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
    ASSERT_EQ(rig.tick.felt(), old.promise.image_hash) << "cut after " << whole << " frames";
  }
  Speaker speaker(rig.settings.path);
  Heard heard = upload(speaker, other);
  EXPECT_EQ(heard.kind, Kind::kAccepted) << heard.refusal();
  EXPECT_EQ(rig.tick.felt(), other.promise.image_hash);
}

TEST(ControlServer, AnUploadThatStartsAgainBeginsFromTheFront) {
  ControlRig rig;
  const store::PackedField ball = store::packed_ball(1);
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
  const store::PackedField ball = store::packed_ball(1);
  Speaker speaker(rig.settings.path);
  speaker.greet();
  const auto ask = [&](Kind kind, const auto& message) {
    speaker.say(kind, message);
    return speaker.hear();
  };
  protocol::Begin large = ball.promise;
  large.image_bytes = rig.intake.image_limit() + 1;
  expect_sentence(ask(Kind::kBegin, large), "field_mib allows 1048576");
  large = ball.promise;
  large.packed_bytes = UINT64_MAX;
  expect_sentence(ask(Kind::kBegin, large), "the packed field takes");
  expect_sentence(ask(Kind::kChunk, protocol::Chunk{0, ball.bytes}), "no upload is under way");
  speaker.say(Kind::kCommit);
  expect_sentence(speaker.hear(), "no upload is under way");

  ASSERT_EQ(ask(Kind::kBegin, ball.promise).kind, Kind::kDone);
  expect_sentence(ask(Kind::kChunk, protocol::Chunk{1, ball.bytes}), "does not follow");
  ASSERT_EQ(ask(Kind::kBegin, ball.promise).kind, Kind::kDone);
  std::vector<std::uint8_t> longer = ball.bytes;
  longer.push_back(0);
  expect_sentence(ask(Kind::kChunk, protocol::Chunk{0, longer}), "does not follow");
  ASSERT_EQ(ask(Kind::kBegin, ball.promise).kind, Kind::kDone);
  speaker.say(Kind::kCommit);
  expect_sentence(speaker.hear(), "ended after 0 of " + std::to_string(ball.bytes.size()));
  ASSERT_EQ(ask(Kind::kBegin, ball.promise).kind, Kind::kDone);
  speaker.say(Kind::kAbort);
  EXPECT_EQ(speaker.hear().kind, Kind::kDone);
  speaker.say(Kind::kCommit);
  expect_sentence(speaker.hear(), "no upload is under way");
  speaker.say(Kind::kBegin);
  expect_sentence(speaker.hear(), "too short for its kind");
  speaker.say(static_cast<Kind>(100));
  expect_sentence(speaker.hear(), "does not know the request");
  EXPECT_EQ(rig.tick.generation(), 0U);
  EXPECT_EQ(upload(speaker, ball).kind, Kind::kAccepted) << "and the connection is as good as before";
}

TEST(ControlServer, AnUploadThatIsPackedTooLargeIsToldBothSizes) {
  ControlRig rig(1 << 16);
  Speaker speaker(rig.settings.path);
  speaker.greet();
  protocol::Begin promise;
  promise.image_bytes = 5;
  promise.packed_bytes = 1 << 20;
  speaker.say(Kind::kBegin, promise);
  expect_sentence(speaker.hear(), "the packed field takes 1048576 bytes");
}

TEST(ControlServer, TwoSendersDoNotMixTheirFields) {
  ControlRig rig;
  const store::PackedField one = store::packed_ball(1), two = store::packed_ball(2);
  Speaker first(rig.settings.path), second(rig.settings.path);
  first.greet(), second.greet();
  first.say(Kind::kBegin, one.promise);
  ASSERT_EQ(first.hear().kind, Kind::kDone);
  second.say(Kind::kBegin, two.promise);
  expect_sentence(second.hear(), "another client is sending");
  second.say(Kind::kSelect, protocol::Select{1});
  expect_sentence(second.hear(), "another client is sending");
  first.hang_up();
  Heard heard;
  for (int tries = 0; tries < 100 && heard.kind != Kind::kAccepted; ++tries) heard = upload(second, two);
  EXPECT_EQ(heard.kind, Kind::kAccepted) << heard.refusal();
}

/// The frames of a patch, without a greeting.
std::vector<std::vector<std::uint8_t>> patch_frames(const std::vector<std::uint8_t>& patch, std::size_t chunk) {
  auto frames = frames_of({patch, {}}, chunk);
  frames[1].resize(protocol::kMaxFrame);
  frames[1].resize(protocol::encode(Kind::kBeginPatch, protocol::BeginPatch{patch.size()}, frames[1]));
  frames.erase(frames.begin());
  return frames;
}

Heard send_patch(Speaker& speaker, const std::vector<std::uint8_t>& patch, std::size_t chunk = 4096) {
  Heard heard;
  for (const auto& frame : patch_frames(patch, chunk)) {
    speaker.send(frame);
    heard = speaker.hear();
    if (heard.kind == Kind::kRefused) break;
  }
  return heard;
}

std::vector<std::uint8_t> patch_of_balls(int before, int after) {
  return test::make_patch(store::ball_image(before).view(), store::ball_image(after).view());
}

TEST(ControlServer, PatchesAreFeltOneAfterTheOther) {
  ControlRig rig;
  Speaker speaker(rig.settings.path);
  ASSERT_EQ(upload(speaker, store::packed_ball(1)).kind, Kind::kAccepted);
  for (int which = 2; which < 8; ++which) {
    const Heard heard = send_patch(speaker, patch_of_balls(which - 1, which), 700);
    ASSERT_EQ(heard.kind, Kind::kAccepted) << heard.refusal();
    const auto accepted = protocol::decode<protocol::Accepted>(heard.body);
    EXPECT_EQ(accepted->image_hash, store::ball_image(which).view().hash());
    EXPECT_EQ(rig.tick.felt(), accepted->image_hash);
    EXPECT_EQ(rig.tick.generation(), accepted->generation);
  }
  expect_sentence(send_patch(speaker, patch_of_balls(2, 3)), "this patch is for the field ");
  EXPECT_EQ(rig.tick.felt(), store::ball_image(7).view().hash());
  EXPECT_EQ(send_patch(speaker, patch_of_balls(7, 1)).kind, Kind::kAccepted);
}

TEST(ControlServer, APatchCutAtAnyFrameLeavesTheFieldBefore) {
  ControlRig rig;
  const std::uint64_t before = store::ball_image(1).view().hash();
  {
    Speaker speaker(rig.settings.path);
    ASSERT_EQ(upload(speaker, store::packed_ball(1)).kind, Kind::kAccepted);
  }
  const auto frames = patch_frames(patch_of_balls(1, 2), 700);
  ASSERT_GT(frames.size(), 4U);
  for (std::size_t whole = 0; whole < frames.size(); ++whole) {
    Speaker speaker(rig.settings.path);
    speaker.greet();
    for (std::size_t i = 0; i < whole; ++i) speaker.send(frames[i]);
    speaker.send(std::span(frames[whole]).first(frames[whole].size() / 2));
    EXPECT_TRUE(whole == 0 || speaker.hear().kind == Kind::kDone);
    ASSERT_EQ(rig.tick.felt(), before) << "cut after " << whole << " frames";
  }
  Speaker speaker(rig.settings.path);
  speaker.greet();
  EXPECT_EQ(send_patch(speaker, patch_of_balls(1, 2)).kind, Kind::kAccepted);
}

TEST(ControlServer, TwoSendersOfPatchesDoNotMixThem) {
  ControlRig rig;
  Speaker one(rig.settings.path), other(rig.settings.path);
  ASSERT_EQ(upload(one, store::packed_ball(1)).kind, Kind::kAccepted);
  other.greet();
  const auto frames = patch_frames(patch_of_balls(1, 2), 700);
  for (std::size_t i = 0; i + 1 < frames.size(); ++i) one.send(frames[i]), one.hear();
  expect_sentence(send_patch(other, patch_of_balls(1, 3)), "another client is sending a field");
  one.send(frames.back());
  EXPECT_EQ(one.hear().kind, Kind::kAccepted);
  expect_sentence(send_patch(other, patch_of_balls(1, 3)), "this patch is for the field ");
  EXPECT_EQ(send_patch(other, patch_of_balls(2, 3)).kind, Kind::kAccepted);
}

TEST(ControlServer, ARecordingOfAClientEndsAtAPatch) {
  ControlRig rig;
  Speaker speaker(rig.settings.path), recorder(rig.settings.path);
  ASSERT_EQ(upload(speaker, store::packed_ball(1)).kind, Kind::kAccepted);
  recorder.greet();
  recorder.say(Kind::kRecord);
  ASSERT_EQ(recorder.hear().kind, Kind::kRecording);
  ASSERT_EQ(send_patch(speaker, patch_of_balls(1, 2)).kind, Kind::kAccepted);
  Heard heard;
  do heard = recorder.hear();
  while (heard.kind == Kind::kRecords);
  expect_sentence(heard, "the recording ended: the field was patched");
}

TEST(ControlServer, IsInUseWhileAClientRecordsOrSends) {
  ControlRig rig;
  Speaker recorder(rig.settings.path), sender(rig.settings.path);
  recorder.greet();
  const auto comes_to_be_in_use = [&rig](bool wanted) {
    for (int tries = 0; tries < 10'000 && rig.server->is_in_use() != wanted; ++tries)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return rig.server->is_in_use() == wanted;
  };
  EXPECT_TRUE(comes_to_be_in_use(false));
  recorder.say(Kind::kRecord);
  EXPECT_TRUE(comes_to_be_in_use(true));
  recorder.say(Kind::kRecordEnd);
  EXPECT_TRUE(comes_to_be_in_use(false));
  const auto frames = frames_of(store::packed_ball(1), 4096);
  for (std::size_t i = 0; i + 1 < frames.size(); ++i) sender.send(frames[i]), sender.hear();
  EXPECT_TRUE(comes_to_be_in_use(true));
  sender.send(frames.back());
  EXPECT_EQ(sender.hear().kind, Kind::kAccepted);
  EXPECT_TRUE(comes_to_be_in_use(false));
}

TEST(ControlServer, ATooLargePatchIsRefused) {
  ControlRig rig;
  Speaker speaker(rig.settings.path);
  speaker.greet();
  speaker.say(Kind::kBeginPatch, protocol::BeginPatch{UINT64_MAX});
  expect_sentence(speaker.hear(), "the patch takes");
}

/// Of an image that is read; the bytes of its next part are appended.
Heard read_part(Speaker& speaker, std::vector<std::uint8_t>& read) {
  speaker.say(Kind::kReadImage, protocol::ReadImage{read.size(), 500});
  Heard heard = speaker.hear();
  if (heard.kind != Kind::kImagePart) return heard;
  const auto part = protocol::decode<protocol::ImagePart>(heard.body);
  EXPECT_EQ(part->offset, read.size());
  read.insert(read.end(), part->bytes.begin(), part->bytes.end());
  return heard;
}

std::vector<std::uint8_t> bytes_of_ball(int which) {
  const test::FieldImage ball = store::ball_image(which);
  const auto image = ball.view().image;
  return {image.begin(), image.end()};
}

TEST(ControlServer, AFieldIsReadWholeWhilePatchesChangeIt) {
  ControlRig rig;
  Speaker sender(rig.settings.path), reader(rig.settings.path), other(rig.settings.path);
  reader.greet(), other.greet();
  std::vector<std::uint8_t> read, others;
  expect_sentence(read_part(reader, read), "no field is loaded");
  expect_sentence(read_part(other, others), "no field is loaded");  // whoever was refused keeps nobody waiting
  ASSERT_EQ(upload(sender, store::packed_ball(1)).kind, Kind::kAccepted);
  const std::vector<std::uint8_t> first = bytes_of_ball(1), last = bytes_of_ball(3);
  ASSERT_GT(first.size(), 1500U);
  while (read.size() < first.size()) {
    const Heard heard = read_part(reader, read);
    ASSERT_EQ(heard.kind, Kind::kImagePart) << heard.refusal();
    EXPECT_EQ(protocol::decode<protocol::ImagePart>(heard.body)->image_hash, store::ball_image(1).view().hash());
    EXPECT_EQ(protocol::decode<protocol::ImagePart>(heard.body)->image_bytes, first.size());
    if (read.size() > 500) continue;
    expect_sentence(read_part(other, others), "another client is reading the field");
    ASSERT_EQ(send_patch(sender, patch_of_balls(1, 2)).kind, Kind::kAccepted);
    ASSERT_EQ(send_patch(sender, patch_of_balls(2, 3)).kind, Kind::kAccepted);
  }
  EXPECT_EQ(read, first);
  while (others.size() < last.size()) ASSERT_EQ(read_part(other, others).kind, Kind::kImagePart);
  EXPECT_EQ(others, last);
}

TEST(ControlServer, AReadingEndsWhenItsFieldIsReplaced) {
  ControlRig rig;
  Speaker sender(rig.settings.path), reader(rig.settings.path);
  reader.greet();
  ASSERT_EQ(upload(sender, store::packed_ball(1)).kind, Kind::kAccepted);
  std::vector<std::uint8_t> read(7);
  expect_sentence(read_part(reader, read), "no field is being read on this connection");
  read.clear();
  ASSERT_EQ(read_part(reader, read).kind, Kind::kImagePart);
  reader.say(Kind::kReadImage, protocol::ReadImage{bytes_of_ball(1).size(), 500});
  expect_sentence(reader.hear(), "the field has fewer bytes");
  ASSERT_EQ(upload(sender, store::packed_ball(2)).kind, Kind::kAccepted);
  expect_sentence(read_part(reader, read), "another one was loaded");
  read.clear();
  while (read.size() < bytes_of_ball(2).size()) ASSERT_EQ(read_part(reader, read).kind, Kind::kImagePart);
  EXPECT_EQ(read, bytes_of_ball(2));
}

TEST(ControlServer, AnotherVersionIsToldWhatToDo) {
  ControlRig rig;
  Speaker speaker(rig.settings.path);
  expect_sentence(speaker.greet(1), "speaks version 2 of the protocol and the tool 1; install the same release");
  EXPECT_EQ(speaker.hear().kind, Kind{}) << "and the connection ends";
  Speaker newer(rig.settings.path);
  newer.say(Kind::kHello, protocol::Hello{protocol::kMajor, 99});
  EXPECT_EQ(newer.hear().kind, Kind::kWelcome) << "a newer minor version only adds";
  Speaker rude(rig.settings.path);
  rude.say(Kind::kStop);
  expect_sentence(rude.hear(), "begins with a greeting");
  EXPECT_EQ(rig.tick.obeyed, 0) << "what it asked for was not done";
  Speaker other(rig.settings.path);
  const std::string request = "GET / HTTP/1.1\r\n\r\n";
  other.send({reinterpret_cast<const std::uint8_t*>(request.data()), request.size()});
  expect_sentence(other.hear(), "no message of the protocol");
}

TEST(ControlServer, StopAndResumeReachTheTick) {
  ControlRig rig;
  Speaker speaker(rig.settings.path);
  speaker.greet();
  const auto obeyed_in_time = [&](std::uint8_t bit) {
    for (int tries = 0; tries < 60'000 && (rig.tick.obeyed & bit) == 0; ++tries) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return rig.tick.obeyed.load();
  };
  speaker.say(Kind::kStop);
  EXPECT_EQ(speaker.hear().kind, Kind::kDone);
  EXPECT_EQ(obeyed_in_time(kRequestStop), kRequestStop);
  speaker.say(Kind::kResume);
  EXPECT_EQ(speaker.hear().kind, Kind::kDone);
  EXPECT_EQ(obeyed_in_time(kRequestResume), kRequestStop | kRequestResume);
}

TEST(ControlServer, ASettingIsSetOrRefusedInOneSentence) {
  ControlRig rig;
  Speaker speaker(rig.settings.path);
  speaker.greet();
  speaker.say(Kind::kSet, protocol::Set{protocol::Text::of("friction"), protocol::Text::of("0.4")});
  EXPECT_EQ(speaker.hear().kind, Kind::kDone);
  EXPECT_EQ(rig.set_to, "friction=0.4");
  speaker.say(Kind::kSet, protocol::Set{protocol::Text::of("friction"), protocol::Text::of("no")});
  EXPECT_EQ(speaker.hear().refusal(), "that cannot be");
  speaker.say(Kind::kSet);
  EXPECT_NE(speaker.hear().refusal(), "");
}

TEST(ControlServer, StatusAndHistogramsAreTheTicks) {
  ControlRig rig;
  Speaker speaker(rig.settings.path);
  const Heard welcome = speaker.greet();
  ASSERT_EQ(welcome.kind, Kind::kWelcome);
  EXPECT_EQ(protocol::decode<protocol::Welcome>(welcome.body)->program.view(), "a test");
  EXPECT_EQ(protocol::decode<protocol::Welcome>(welcome.body)->image_limit, 1U << 20);
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  speaker.say(Kind::kStatus);
  const Heard heard = speaker.hear();
  const auto status = protocol::decode<protocol::StatusReport>(heard.body);
  ASSERT_TRUE(status);
  EXPECT_EQ(status->state, static_cast<std::uint16_t>(SupervisorState::kIdle));
  EXPECT_GT(status->ticks, 0U);
  const protocol::Quantiles tick = status->measures[static_cast<std::size_t>(protocol::Measure::kTick)];
  EXPECT_GE(tick.p999, tick.p50);
  EXPECT_GT(tick.max, 0U);
  speaker.say(Kind::kHistogram, protocol::HistogramRequest{static_cast<std::uint8_t>(protocol::Measure::kTick)});
  const Heard answer = speaker.hear();
  const auto histogram = protocol::decode<protocol::HistogramReport>(answer.body);
  ASSERT_TRUE(histogram);
  std::uint64_t sum = 0;
  ASSERT_EQ(histogram->bins.size() % protocol::kBinBytes, 0U);
  for (std::size_t at = 0; at < histogram->bins.size(); at += protocol::kBinBytes) {
    sum += protocol::decode<protocol::Bin>(histogram->bins.subspan(at, protocol::kBinBytes))->count;
  }
  EXPECT_EQ(sum, histogram->count);
  EXPECT_GE(sum, status->ticks - 1);
  speaker.say(Kind::kHistogram, protocol::HistogramRequest{4});
  expect_sentence(speaker.hear(), "does not measure that");
}

/// The records of one frame, or none with what was said instead.
std::vector<TraceRecord> records_of(const Heard& heard) {
  std::vector<TraceRecord> records;
  const auto said =
      heard.kind == Kind::kRecords ? protocol::decode<protocol::Records>(heard.body) : Result<protocol::Records>(Error::kBadMessage);
  if (!said) return records;
  constexpr std::size_t kBytes = trace_layout::kRecordBytes;
  EXPECT_EQ(said->record_bytes, kBytes);
  for (std::size_t at = 0; at + kBytes <= said->bytes.size(); at += kBytes) {
    const auto record = decode_record(said->bytes.subspan(at).first<kBytes>());
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
    speaker.say(Kind::kSubscribe, protocol::Subscribe{every});
    Heard heard = speaker.hear();
    while (heard.kind == Kind::kRecords) heard = speaker.hear();  // of the subscription before
    ASSERT_EQ(heard.kind, Kind::kDone);
    std::size_t seen = 0;
    for (int frames = 0; frames < 20; ++frames) {
      heard = speaker.hear();
      ASSERT_EQ(heard.kind, Kind::kRecords);
      const auto said = protocol::decode<protocol::Records>(heard.body);
      ASSERT_TRUE(said);
      EXPECT_EQ(said->every, every);
      EXPECT_EQ(said->first_tick % every, 0U);
      seen += records_of(heard).size();
    }
    EXPECT_GE(seen, 20U) << "a frame has a tick at least";
  }
  speaker.say(Kind::kSubscribe, protocol::Subscribe{0});
  Heard heard = speaker.hear();
  while (heard.kind == Kind::kRecords) heard = speaker.hear();
  EXPECT_EQ(heard.kind, Kind::kDone);
}

TEST(ControlServer, WhoDoesNotTakeTheTicksIsToldSoAfterThoseThatWereSent) {
  ControlRig rig(1 << 20, [](ControlSettings& settings) { settings.patience_ns = kLong; });
  Speaker speaker(rig.settings.path);
  speaker.greet();
  speaker.say(Kind::kRecord);
  ASSERT_EQ(speaker.hear().kind, Kind::kRecording);
  const auto begun = rig.tick.stats.ticks.value();
  while (rig.tick.stats.ticks.value() < begun + 10'000) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  std::size_t ticks = 0;
  Heard heard = speaker.hear();
  for (; heard.kind == Kind::kRecords; heard = speaker.hear()) ticks += records_of(heard).size();
  expect_sentence(heard, "too slow for this tick rate");
  EXPECT_LT(ticks, 10'000U);
  speaker.say(Kind::kStatus);
  EXPECT_EQ(speaker.hear().kind, Kind::kStatusReport) << "the connection stays";
}

TEST(ControlServer, ARecordingBeginsAnewAndItsChainHolds) {
  ControlRig rig;
  Speaker speaker(rig.settings.path), other(rig.settings.path);
  speaker.greet(), other.greet();
  speaker.say(Kind::kRecord);
  Heard heard = speaker.hear();
  ASSERT_EQ(heard.kind, Kind::kRecording);
  const auto header = decode_header(protocol::decode<protocol::Recording>(heard.body)->header, trace_layout::kHeaderBytes);
  ASSERT_TRUE(header);
  EXPECT_EQ(header->device, rig.settings.recordings.device);
  other.say(Kind::kRecord);
  expect_sentence(other.hear(), "another client is recording");
  Chain chain(*header);
  std::size_t ticks = 0;
  while (ticks < 500) {
    heard = speaker.hear();
    const std::vector<TraceRecord> records = records_of(heard);
    ASSERT_FALSE(records.empty()) << heard.refusal();
    for (const TraceRecord& record : records) {
      EXPECT_EQ((record.input.requests & kRequestRestart) != 0, ticks == 0);
      EXPECT_EQ(chain.extend(record.input, record.output), record.chain);
      ++ticks;
    }
  }
  // Another field would be another trace.
  ASSERT_EQ(upload(other, store::packed_ball(1)).kind, Kind::kAccepted);
  while (heard.kind == Kind::kRecords) heard = speaker.hear();
  expect_sentence(heard, "another field was loaded");
  other.say(Kind::kRecord);
  EXPECT_EQ(other.hear().kind, Kind::kRecording) << "the next may record";
  other.say(Kind::kRecordEnd);
  do heard = other.hear();
  while (heard.kind == Kind::kRecords);
  EXPECT_EQ(heard.kind, Kind::kDone);
}

}  // namespace
}  // namespace isotouch::control
