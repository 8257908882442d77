/// While the field worker is busy, whoever needs it waits, and then gets an answer of its own. Answers that are larger than a frame.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>

#include <chrono>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include "tests/firmware/control/control_rig.h"
#include "tests/firmware/store/packed_field.h"

namespace isotouch::control {
namespace {

using protocol::Kind;

protocol::Calibrate near_angles() {
  const std::uint32_t near = libnifalcon_model().legs[0].at_zero.raw();
  return {protocol::Text::of("A1"), {near + 5, near + 6, near + 7}};
}

/// Sends a field, and returns when the worker is busy with it; it stays so until the rig lets the check end.
void begin_to_load(ControlRig& rig, Speaker& sender, const store::PackedField& field) {
  rig.check_is_busy = true;
  const auto frames = frames_of(field, 4096);
  for (const auto& frame : frames) {
    sender.send(frame);
    if (&frame != &frames.back()) sender.hear();
  }
  while (rig.checked == 0) std::this_thread::yield();
}

/// Whether the server has said anything to the first by the time it has answered the other one, who asks later. Twice, for it answers many in one turn.
bool has_been_answered(const Speaker& speaker, Speaker& other) {
  for (int twice = 0; twice < 2; ++twice) EXPECT_EQ(ask(other, Kind::kStatus).kind, Kind::kStatusReport);
  pollfd one{speaker.socket(), POLLIN, 0};
  return ::poll(&one, 1, 0) != 0;
}

/// Stores angles on a disk that takes its time.
void begin_slow_work(ControlRig& rig, Speaker& measurer) {
  rig.disk_is_busy = true;
  const int before = rig.looked_up;
  measurer.say(Kind::kCalibrate, near_angles());
  while (rig.looked_up == before) std::this_thread::yield();
}

void end_slow_work(ControlRig& rig) {
  rig.disk_is_busy = false;
  rig.disk_is_busy.notify_all();
}

/// Sends so many of an upload's frames, each of which is answered.
void send_first(Speaker& sender, const std::vector<std::vector<std::uint8_t>>& frames, std::size_t count) {
  for (const auto& frame : std::span(frames).first(count)) {
    ASSERT_TRUE(sender.send(frame));
    sender.hear();
  }
}

TEST(ControlServerWorker, WhatNeedsItWaitsUntilItIsIdle) {
  const store::PackedField ball = store::packed_ball(1);
  const struct {
    std::function<void(Speaker&)> say;
    Kind answer;
  } requests[] = {{[](Speaker& s) { s.say(Kind::kBegin, store::packed_ball(2).promise); }, Kind::kDone},
                  {[](Speaker& s) { s.say(Kind::kBeginPatch, protocol::BeginPatch{10}); }, Kind::kDone},
                  {[](Speaker& s) { s.say(Kind::kCommit); }, Kind::kRefused},
                  {[](Speaker& s) { s.say(Kind::kFields); }, Kind::kFieldList},
                  {[&](Speaker& s) { s.say(Kind::kSelect, protocol::Select{ball.promise.image_hash}); }, Kind::kAccepted},
                  {[](Speaker& s) { s.say(Kind::kReadImage, protocol::ReadImage{.bytes = 1}); }, Kind::kImagePart},
                  {[](Speaker& s) { s.say(Kind::kCalibrate, near_angles()); }, Kind::kDone}};
  for (const auto& request : requests) {
    ControlRig rig;
    rig.calibration.answers("A1");
    Speaker sender(rig.settings.path), other(rig.settings.path), third(rig.settings.path);
    other.greet(), third.greet();
    begin_to_load(rig, sender, ball);
    request.say(other);
    ASSERT_FALSE(has_been_answered(other, third)) << &request - requests;
    rig.let_check_end();
    ASSERT_EQ(sender.hear().kind, Kind::kAccepted) << &request - requests;
    EXPECT_EQ(other.hear().kind, request.answer) << &request - requests;
  }
}

TEST(ControlServerWorker, NobodyMeasuresWhileAStoredFieldIsLoaded) {
  ControlRig rig;
  rig.calibration.answers("A1");
  Speaker sender(rig.settings.path), other(rig.settings.path);
  other.greet();
  const store::PackedField ball = store::packed_ball(1);
  ASSERT_EQ(upload(sender, ball).kind, Kind::kAccepted);
  rig.checked = 0;
  rig.check_is_busy = true;
  sender.say(Kind::kSelect, protocol::Select{ball.promise.image_hash});
  while (rig.checked == 0) std::this_thread::yield();
  expect_sentence(ask(other, Kind::kPosture), "another client is sending a field");
  rig.let_check_end();
  EXPECT_EQ(sender.hear().kind, Kind::kAccepted);
}

TEST(ControlServerWorker, WhoeverComesInPlaceOfOneThatHungUpGetsNoAnswerOfIts) {
  ControlRig rig;
  Speaker sender(rig.settings.path), other(rig.settings.path);
  begin_to_load(rig, sender, store::packed_ball(1));
  sender.hang_up();
  other.greet();
  Speaker next(rig.settings.path);
  EXPECT_EQ(next.greet().kind, Kind::kWelcome);
  rig.let_check_end();
  EXPECT_EQ(ask(other, Kind::kFields).kind, Kind::kFieldList) << "the worker has ended";
  EXPECT_EQ(ask(next, Kind::kStatus).kind, Kind::kStatusReport);
}

TEST(ControlServerWorker, WhoeverWaitsForASlowDiskIsNoIdler) {
  ControlRig rig(1 << 20, [](ControlSettings& settings) { settings.patience_ns = 500'000'000; });
  rig.calibration.answers("A1");
  Speaker measurer(rig.settings.path), other(rig.settings.path);
  measurer.greet(), other.greet();
  begin_slow_work(rig, measurer);
  other.say(Kind::kFields);
  std::this_thread::sleep_for(std::chrono::milliseconds(1500));
  end_slow_work(rig);
  EXPECT_EQ(measurer.hear().kind, Kind::kDone);
  EXPECT_EQ(other.hear().kind, Kind::kFieldList);
}

TEST(ControlServerWorker, AnUploadThatWaitsForItIsNotSlow) {
  ControlRig rig(1 << 20, [](ControlSettings& settings) { settings.patience_ns = kLong; });
  rig.calibration.answers("A1");
  Speaker sender(rig.settings.path), measurer(rig.settings.path), other(rig.settings.path);
  measurer.greet(), other.greet();
  const auto frames = frames_of(store::packed_ball(1), 4096);
  send_first(sender, frames, frames.size() - 1);
  begin_slow_work(rig, measurer);
  ASSERT_TRUE(sender.send(frames.back()));
  EXPECT_FALSE(has_been_answered(sender, other));
  rig.clock.ahead_ns = 2 * kLong;
  EXPECT_FALSE(has_been_answered(sender, other)) << "it was closed";
  end_slow_work(rig);
  EXPECT_EQ(measurer.hear().kind, Kind::kDone);
  EXPECT_EQ(sender.hear().kind, Kind::kRefused) << "the stored angles hold from the next start on, and no field before";
}

TEST(ControlServerWorker, AnUploadThatStoppedIsSlowAlsoWhileItWorks) {
  ControlRig rig(1 << 20, [](ControlSettings& settings) { settings.patience_ns = kLong; });
  rig.calibration.answers("A1");
  Speaker sender(rig.settings.path), measurer(rig.settings.path), other(rig.settings.path);
  measurer.greet(), other.greet();
  const auto frames = frames_of(store::packed_ball(1), 4096);
  send_first(sender, frames, 2);  // its greeting, and that it begins
  begin_slow_work(rig, measurer);
  rig.clock.ahead_ns = 2 * kLong;
  EXPECT_TRUE(has_been_answered(sender, other)) << "it keeps its place";
  end_slow_work(rig);
}

TEST(ControlServerAnswers, AListOfFieldsEndsWhereAFrameIsFull) {
  ControlRig rig;
  rig.server->stop();
  constexpr int kFields = 2000;
  const std::string name(store::FieldStore::kMaxName, 'n');
  for (int n = 1; n <= kFields; ++n) {
    const std::string number = std::to_string(10'000'000 + n);
    ASSERT_TRUE(rig.folder.write(number + "-00000000" + number + "-" + name + ".itf", {}));
  }
  ASSERT_EQ(rig.server->start().sentence(), "");
  Speaker speaker(rig.settings.path);
  speaker.greet();
  const Heard heard = ask(speaker, Kind::kFields);
  ASSERT_EQ(heard.kind, Kind::kFieldList);
  const auto list = *protocol::decode<protocol::FieldList>(heard.body);
  EXPECT_GT(list.count, 500);
  EXPECT_LT(list.count, kFields);
  protocol::BodyReader entries(list.entries);
  for (int n = 1; n <= list.count; ++n) {
    protocol::FieldEntry entry;
    protocol::FieldEntry::fields(entry, entries);
    ASSERT_TRUE(entries.is_good()) << n;
    EXPECT_EQ(entry.name.view(), name);
  }
}

TEST(ControlServerAnswers, OfSettingsThatFillMoreThanAFrameWholeLinesAreTold) {
  ControlRig rig;
  rig.server->stop();
  const std::string line = "feel.friction = 0.5\n";
  std::string all;
  while (all.size() < 100'000) all += line;
  ControlNeighbours neighbours{rig.intake, rig.tick.commands, rig.tick.stats, rig.tick.shown, rig.clock};
  neighbours.different = [&] { return all; };
  ControlServer server(rig.settings, neighbours);
  ASSERT_EQ(server.start().sentence(), "");
  Speaker speaker(rig.settings.path);
  speaker.greet();
  const Heard heard = ask(speaker, Kind::kSettings);
  ASSERT_EQ(heard.kind, Kind::kSettingsReport);
  const auto told = protocol::decode<protocol::SettingsReport>(heard.body)->different;
  EXPECT_GT(told.size(), 60'000U);
  EXPECT_EQ(told.size() % line.size(), 0U);
}

}  // namespace
}  // namespace isotouch::control
