#include "host/link/controller.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include "host/error.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/scripted_controller.h"

namespace isotouch::link {
namespace {

using protocol::Kind;
using test::Bytes, test::frame, test::Scripted;
using testing::HasSubstr;
using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

Bytes refusal(const std::string& sentence) {
  return frame(Kind::kRefused, protocol::Refusal{2, {reinterpret_cast<const std::uint8_t*>(sentence.data()), sentence.size()}});
}
Bytes operator+(Bytes a, const Bytes& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}
const Bytes kWelcome = frame(Kind::kWelcome, protocol::Welcome{});

std::string sentence_of(const std::function<void()>& failing) {
  try {
    failing();
  } catch (const InputError& error) {
    return error.what();
  }
  return "it did not fail";
}

/// The sentence with which it ends.
std::string complaint(const Bytes& answers, const std::function<void(Controller&)>& ask) {
  const Scripted scripted(answers);
  try {
    Controller controller(scripted.address());
    ask(controller);
  } catch (const InputError& e) {
    EXPECT_THAT(e.what(), testing::StartsWith(scripted.address() + ": "));
    return e.what();
  }
  return {};
}

/// A socket that lets in as many as its queue holds, and never answers.
class Door {
 public:
  explicit Door(int queue) : path_((scratch_.path() / "socket").string()), door_(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    name_.sun_family = AF_UNIX;
    std::copy(path_.begin(), path_.end(), name_.sun_path);
    EXPECT_EQ(::bind(door_, reinterpret_cast<const sockaddr*>(&name_), sizeof name_), 0);
    EXPECT_EQ(::listen(door_, queue), 0);
  }
  Door(const Door&) = delete;
  Door& operator=(const Door&) = delete;
  ~Door() { ::close(door_); }

  std::string address() const { return "unix:" + path_; }
  bool lets_in(int client) const { return ::connect(client, reinterpret_cast<const sockaddr*>(&name_), sizeof name_) == 0; }

 private:
  ScratchFolder scratch_;
  std::string path_;
  sockaddr_un name_{};
  int door_;
};

TEST(Controller, ASettingThatAMessageWouldCutIsNotSent) {
  const std::string longest(63, '0');
  const auto set = [](const std::string& name, const std::string& value) {
    return complaint(kWelcome + frame(Kind::kDone), [&](Controller& controller) { controller.set(name, value); });
  };
  EXPECT_EQ(set("friction", longest), "");
  EXPECT_THAT(set("friction", longest + "e-1"), HasSubstr("the setting's value has more than 63 bytes"));
  EXPECT_THAT(set(longest + "0", "1"), HasSubstr("the setting's name has more than 63 bytes"));
  EXPECT_THAT(set("friction", "0.5\n1"), HasSubstr("cannot be printed, so nothing was set"));
}

TEST(Controller, NobodyWaitsForAnAnswerThatIsNotWantedAnyMore) {
  const Door door(1);
  int asked = 0;
  EXPECT_THAT(sentence_of([&] { const Controller controller(door.address(), {}, [&] { return ++asked == 3; }); }),
              HasSubstr("nobody waits"));
  EXPECT_EQ(asked, 3);
}

TEST(Controller, NobodyWaitsUntilItTakesWhatIsNotWantedAnyMore) {
  const Scripted scripted(kWelcome + frame(Kind::kDone), false);
  const Bytes field(2'000'000);
  int asked = 0;
  try {
    Controller controller(scripted.address(), {}, [&] { return ++asked >= 3; });
    (void)controller.upload({field.size(), 1, 2, {}}, field);
    ADD_FAILURE() << "it has taken it";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("nobody waits"));
  }
  EXPECT_LE(asked, 5);
}

/// Once the client waits, it gets the first bytes of the last answer, and no more.
Scripted::Talk says_later(const Bytes& answers, Bytes last) {
  last.resize(5);
  return [=](int client) {
    (void)::send(client, answers.data(), answers.size(), MSG_NOSIGNAL);
    std::this_thread::sleep_for(200ms);
    Scripted::says(last, false)(client);
  };
}

TEST(Controller, NobodyWaitsForTheRestOfAnAnswerThatIsNotWantedAnyMore) {
  const Scripted scripted({says_later(kWelcome, frame(Kind::kStatusReport, protocol::StatusReport{}))});
  int asked = 0;
  Controller controller(scripted.address(), {}, [&] { return ++asked >= 3; });
  EXPECT_THAT(sentence_of([&] { (void)controller.status(); }), HasSubstr("nobody waits"));
}

TEST(Controller, NobodyWaitsForTheRestOfARecordThatIsNotWantedAnyMore) {
  const Scripted scripted({says_later(kWelcome + frame(Kind::kDone), frame(Kind::kRecords, protocol::Records{}))});
  Controller controller(scripted.address());
  const Clock::time_point begin = Clock::now();
  const auto watched = controller.watch(
      1, 10, [](std::uint64_t, std::span<const std::uint8_t>) {}, [&] { return Clock::now() - begin > 1s; });
  EXPECT_EQ(watched.ended, "");
  EXPECT_LT(Clock::now() - begin, 5s);
}

TEST(Controller, WhoeverTakesALittleAtATimeIsNotWaitedForEither) {
  std::atomic<std::size_t> taken = 0;
  const Bytes field(40'000'000);
  Bytes answers = kWelcome;
  for (std::size_t i = 0; i <= field.size() / protocol::kMaxChunk + 1; ++i) answers = answers + frame(Kind::kDone);
  const Scripted scripted({[&](int client) {
    (void)::send(client, answers.data(), answers.size(), MSG_NOSIGNAL);
    Bytes heard(40'000);
    for (ssize_t got = 1; got > 0; taken += static_cast<std::size_t>(std::max<ssize_t>(got, 0))) {
      std::this_thread::sleep_for(5ms);
      got = ::recv(client, heard.data(), heard.size(), 0);
    }
  }});
  int asked = 0;
  Controller controller(scripted.address(), {}, [&] { return ++asked >= 3; });
  EXPECT_THAT(sentence_of([&] { (void)controller.upload({field.size(), 1, 2, {}}, field); }), HasSubstr("nobody waits"));
  EXPECT_LT(taken, field.size() / 2);
}

TEST(Controller, NobodyWaitsAtADoorWithAQueue) {
  const Door door(0);
  std::vector<int> queue;
  do queue.push_back(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  while (door.lets_in(queue.back()));
  int asked = 0;
  EXPECT_THAT(sentence_of([&] { const Controller controller(door.address(), {}, [&] { return ++asked == 3; }); }),
              HasSubstr("nobody waits"));
  EXPECT_THAT(sentence_of([&] { const Controller controller(door.address(), 300); }), HasSubstr("the controller lets nobody in"));
  for (const int waiting : queue) ::close(waiting);
}

TEST(Controller, ItsPatienceIsOverOnce) {
  for (const bool is_asked : {false, true}) {
    const auto never = is_asked ? std::function<bool()>([] { return false; }) : nullptr;
    const auto waited = [&](const Bytes& answers, const std::function<void(Controller&)>& ask) {
      const Scripted scripted(answers, false);
      Controller controller(scripted.address(), 1000, never);
      const Clock::time_point begin = Clock::now();
      EXPECT_THAT(sentence_of([&] { ask(controller); }), HasSubstr("does not answer"));
      return Clock::now() - begin;
    };
    EXPECT_LT(waited(kWelcome, [](Controller& c) { (void)c.status(); }), 1900ms) << is_asked;
    const Bytes field(2'000'000);
    const Bytes taken = kWelcome + frame(Kind::kDone);
    EXPECT_LT(waited(taken, [&](Controller& c) { (void)c.upload({field.size(), 1, 2, {}}, field); }), 1900ms) << is_asked;
  }
}

/// A late answer would pass for that to the next request: the state from before as the state of a controller that is gone.
TEST(Controller, WhateverIsAskedAfterAnAnswerThatDidNotComeFails) {
  protocol::StatusReport late;
  late.ticks = 7;
  const auto talk = [late = frame(Kind::kStatusReport, late)](int client) {
    (void)::send(client, kWelcome.data(), kWelcome.size(), MSG_NOSIGNAL);
    std::this_thread::sleep_for(500ms);
    Scripted::says(late, false)(client);
  };
  const Scripted scripted({talk});
  Controller controller(scripted.address(), 100);
  EXPECT_THAT(sentence_of([&] { (void)controller.status(); }), HasSubstr("does not answer"));
  std::this_thread::sleep_for(1s);
  EXPECT_THAT(sentence_of([&] { (void)controller.status(); }), HasSubstr("an answer before did not come"));
  EXPECT_THAT(sentence_of([&] { controller.stop(); }), HasSubstr("an answer before did not come"));
}

TEST(Controller, ARefusalLeavesTheConversationAsItIs) {
  protocol::StatusReport status;
  status.ticks = 7;
  const Scripted scripted(kWelcome + refusal("no") + frame(Kind::kStatusReport, status) + frame(Kind::kDone) + frame(Kind::kDone));
  Controller controller(scripted.address());
  EXPECT_THAT(sentence_of([&] { controller.stop(); }), HasSubstr("no"));
  EXPECT_EQ(controller.status().ticks, 7U);
  EXPECT_THAT(sentence_of([&] { (void)controller.status(); }), HasSubstr("does not fit the request"));
  EXPECT_THAT(sentence_of([&] { controller.stop(); }), HasSubstr("an answer before")) << "whose Done is it?";
}

/// What was sent ahead of its answers is refused, too, and none of that answers what is asked then.
TEST(Controller, ARefusalOfOnePartLeavesTheConversationAsItIs) {
  protocol::StatusReport status;
  status.ticks = 7;
  const auto talk = [report = frame(Kind::kStatusReport, status)](const Bytes& first, std::size_t heard_then, const Bytes& behind) {
    return Scripted({[=](int client) {
      const Bytes begin = kWelcome + first;
      (void)::send(client, begin.data(), begin.size(), MSG_NOSIGNAL);
      Bytes heard(1 << 16);
      ssize_t got = 1;
      for (std::size_t all = 0; all < heard_then && got > 0; all += static_cast<std::size_t>(std::max<ssize_t>(got, 0)))
        got = ::recv(client, heard.data(), heard.size(), 0);
      Scripted::says(refusal("no") + behind + behind + report)(client);
    }});
  };
  const Bytes field(3 * protocol::kMaxChunk), part(protocol::kMaxChunk);
  const Scripted takes = talk(frame(Kind::kDone), field.size(), refusal("nothing was begun"));
  Controller to(takes.address());
  EXPECT_THAT(sentence_of([&] { (void)to.upload({field.size(), 1, 2, {}}, field); }), HasSubstr(": no"));
  EXPECT_EQ(to.status().ticks, 7U);

  const Scripted gives = talk(frame(Kind::kImagePart, protocol::ImagePart{7, 4 * protocol::kMaxChunk, 0, part}), 0, refusal("another one"));
  Controller from(gives.address());
  EXPECT_THAT(sentence_of([&] { (void)from.image(); }), HasSubstr(": no"));
  EXPECT_EQ(from.status().ticks, 7U);
}

TEST(Controller, WhatTheControllerRefusesIsPassedOn) {
  const Bytes field(100'000);
  const auto upload = [&](Controller& c) { (void)c.upload({field.size(), 1, 2, {}}, field); };
  EXPECT_THAT(complaint(kWelcome + refusal("too large; make it smaller"), upload), HasSubstr("too large; make it smaller"));
  EXPECT_THAT(complaint(kWelcome + frame(Kind::kDone) + frame(Kind::kDone) + refusal("no more"), upload), HasSubstr("no more"));
  EXPECT_THAT(complaint(refusal("user 7 may not"), upload), HasSubstr("user 7 may not"));
  EXPECT_THAT(complaint(kWelcome + refusal("a\x1b[2Jb\nc"), upload), HasSubstr("a [2Jb c")) << "a terminal obeys none of it";
}

TEST(Controller, EveryEndAndEveryOddAnswerHasItsSentence) {
  const auto status = [](Controller& c) { (void)c.status(); };
  EXPECT_THAT(complaint({}, status), HasSubstr("closed the connection"));
  EXPECT_THAT(complaint(kWelcome, status), HasSubstr("closed the connection"));
  EXPECT_THAT(complaint(Bytes{'W', 'e', 'l', 'c', 'o', 'm', 'e'}, status), HasSubstr("the login there prints nothing"));
  EXPECT_THAT(complaint(kWelcome + frame(Kind::kDone), status), HasSubstr("does not fit the request"));
  EXPECT_THAT(complaint(kWelcome + frame(Kind::kStatusReport), status), HasSubstr("too short for its kind"));
  EXPECT_THAT(complaint(kWelcome + frame(Kind::kFieldList, protocol::FieldList{3, {}}), [](Controller& c) { (void)c.fields(); }),
              HasSubstr("shorter than it says"));
}

TEST(Controller, AnImageIsReadWholeOrNotAtAll) {
  Bytes image(3 * protocol::kMaxChunk / 2);
  for (std::size_t i = 0; i < image.size(); ++i) image[i] = static_cast<std::uint8_t>(i % 251);
  const auto part = [&](std::uint64_t hash, std::uint64_t bytes, std::size_t offset) {
    const std::span<const std::uint8_t> rest = std::span(image).subspan(offset);
    return frame(Kind::kImagePart, protocol::ImagePart{hash, bytes, offset, rest.first(std::min(rest.size(), protocol::kMaxChunk))});
  };
  Controller::Image read;
  const auto reads = [&](Controller& c) { read = c.image(); };
  const Bytes begin = kWelcome + part(7, image.size(), 0);
  EXPECT_EQ(complaint(begin + part(7, image.size(), protocol::kMaxChunk), reads), "");
  EXPECT_EQ(read.hash, 7U);
  EXPECT_EQ(read.bytes, image);
  for (const Bytes& wrong : {part(8, image.size(), protocol::kMaxChunk), part(7, image.size() + 1, protocol::kMaxChunk),
                             part(7, image.size(), protocol::kMaxChunk - 1), part(7, image.size(), 0)})
    EXPECT_THAT(complaint(begin + wrong, reads), HasSubstr("does not follow the one before"));
  EXPECT_THAT(complaint(kWelcome + part(7, 0, 0), reads), HasSubstr("does not follow the one before"));
  EXPECT_THAT(complaint(begin + refusal("another one was loaded; begin"), reads), HasSubstr("another one was loaded"));
  EXPECT_THAT(complaint(begin, reads), HasSubstr("closed the connection"));
}

TEST(Controller, ARecordingEndsWhereItHasAGapOrIsRefusedAndSaysWhy) {
  const Bytes records(20), header(4);
  std::size_t kept = 0;
  const auto ended = [&](const Bytes& said) {
    std::string why;
    kept = 0;
    const std::string thrown = complaint(said, [&](Controller& c) {
      why = c.record(
          5, [](std::span<const std::uint8_t>) {}, [&](std::span<const std::uint8_t>) { ++kept; }, [] { return false; });
    });
    EXPECT_EQ(thrown, "");
    return why;
  };
  const Bytes begin =
      kWelcome + frame(Kind::kRecording, protocol::Recording{header}) + frame(Kind::kRecords, protocol::Records{7, 1, 10, 0, records});
  EXPECT_EQ(ended(begin + frame(Kind::kRecords, protocol::Records{9, 1, 10, 0, records}) +
                  frame(Kind::kRecords, protocol::Records{11, 1, 10, 0, records})),
            "");
  EXPECT_EQ(kept, 5U);
  EXPECT_THAT(ended(begin + frame(Kind::kRecords, protocol::Records{10, 1, 10, 0, records})), HasSubstr("gap"));
  EXPECT_EQ(kept, 2U);
  EXPECT_THAT(ended(begin + refusal("the recording ended: another field")), HasSubstr("another field"));
  EXPECT_EQ(kept, 2U);
  EXPECT_THAT(ended(begin + frame(Kind::kRecords, protocol::Records{9, 1, 11, 0, records})), HasSubstr("cut"));
  EXPECT_EQ(kept, 2U);
  EXPECT_THAT(ended(begin),
              HasSubstr("closed the connection; check whether it still runs; it also closes a client that reads nothing for 10 s"));
  EXPECT_EQ(kept, 2U);
}

TEST(Controller, WhoeverWatchesHearsHowManyRecordsWereLost) {
  const Bytes records(20);
  const Scripted scripted(kWelcome + frame(Kind::kDone) + frame(Kind::kRecords, protocol::Records{7, 1, 10, 0, records}) +
                          frame(Kind::kRecords, protocol::Records{16, 1, 10, 7, records}));
  Controller controller(scripted.address());
  std::vector<std::uint64_t> ticks;
  const auto watched = controller.watch(
      1, 4, [&](std::uint64_t tick, std::span<const std::uint8_t>) { ticks.push_back(tick); }, [] { return false; });
  EXPECT_EQ(watched.lost, 7U);
  EXPECT_EQ(ticks, (std::vector<std::uint64_t>{7, 8, 16, 17}));
}

TEST(Controller, SettingsHoldNothingThatATerminalWouldObey) {
  const std::string different = "feel.stiffness = 0.5\nfeel.\x1b[2Jdamping = \x1b[2J1\n";
  const protocol::SettingsReport report{7, {reinterpret_cast<const std::uint8_t*>(different.data()), different.size()}};
  const Scripted scripted(kWelcome + frame(Kind::kSettingsReport, report));
  const Controller::Settings settings = Controller(scripted.address()).settings();
  EXPECT_EQ(settings.checksum, 7U);
  EXPECT_THAT(settings.different, testing::ElementsAre(testing::Pair("feel.stiffness", "0.5"), testing::Pair("feel. [2Jdamping", " [2J1")));
}

TEST(Controller, NobodyThereIsSaid) {
  EXPECT_THROW(Controller("unix:/nowhere/at/all"), InputError);
  EXPECT_THROW(Controller("unix:" + std::string(200, 'x')), InputError);
}

}  // namespace
}  // namespace isotouch::link
