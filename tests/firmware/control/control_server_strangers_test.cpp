/// Who is let in by the control server, and what crowds, strangers and noise can do to it: nothing.
#include "firmware/control/control_server.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/ioctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "tests/firmware/control/control_rig.h"
#include "tests/firmware/store/packed_field.h"
#include "tests/support/random.h"

namespace isotouch::control {
namespace {

using testing::HasSubstr;

using protocol::Kind;

TEST(ControlServer, AUserWhoIsNotListedIsRefusedWithASentence) {
  Peer stranger{true, 4711, {4711, 4712}};
  ControlRig rig(1 << 20, [&](ControlSettings& settings) {
    settings.peer = [&](int) { return stranger; };
    settings.admission.watch = {{1234}, {77}};
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
  EXPECT_THAT(second.start().sentence(), HasSubstr("another program listens there"));
  rig.server->stop();
  EXPECT_NE(::stat(rig.settings.path.c_str(), &about), 0);
  EXPECT_EQ(rig.server->start().sentence(), "");
  rig.server->stop();
  std::ofstream(rig.settings.path) << "a file";
  EXPECT_THAT(rig.server->start().sentence(), HasSubstr("is a file already"));
}

TEST(ControlServer, ASocketThatNobodyListensAtIsReplaced) {
  ControlRig rig;
  rig.server->stop();
  {
    ControlSocket left;
    ASSERT_EQ(left.open(rig.settings.path, 0600, std::nullopt).sentence(), "");
    const std::string moved = rig.settings.path + ".old";
    ASSERT_EQ(::rename(rig.settings.path.c_str(), moved.c_str()), 0);
    left.close();
    ASSERT_EQ(::rename(moved.c_str(), rig.settings.path.c_str()), 0);
  }
  EXPECT_EQ(rig.server->start().sentence(), "");
  Speaker speaker(rig.settings.path);
  EXPECT_EQ(speaker.greet().kind, Kind::kWelcome);
}

TEST(ControlServer, MoreClientsThanPlacesAreToldSo) {
  ControlRig rig(1 << 20, [](ControlSettings& settings) { settings.clients = 2; });
  Speaker one(rig.settings.path), two(rig.settings.path);
  one.greet(), two.greet();
  Speaker three(rig.settings.path);
  three.greet();
  three.say(Kind::kFields);
  expect_sentence(three.hear(), "2 clients are connected");
  EXPECT_EQ(three.hear().kind, Kind{});
}

TEST(ControlServer, WhoeverIsConnectedAStopGetsThrough) {
  ControlRig rig(1 << 20, [](ControlSettings& settings) { settings.clients = 2; });
  Speaker one(rig.settings.path), two(rig.settings.path);
  one.greet(), two.greet();
  Speaker idle(rig.settings.path), silent(rig.settings.path);  // they want the place for the stop, too
  Speaker stop(rig.settings.path);
  EXPECT_EQ(stop.greet().kind, Kind::kWelcome);
  stop.say(Kind::kStop);
  EXPECT_EQ(stop.hear().kind, Kind::kDone);
  stop.say(Kind::kStatus);
  EXPECT_EQ(stop.hear().kind, Kind::kStatusReport) << "whether it has stopped";
  stop.say(Kind::kDevice);
  EXPECT_EQ(stop.hear().kind, Kind::kDeviceReport) << "what 'isotouch stop' asks at its end";
  stop.say(Kind::kSettings);
  EXPECT_EQ(stop.hear().kind, Kind::kSettingsReport) << "as 'isotouch status'";
  for (int tries = 0; tries < 60'000 && (rig.tick.obeyed & kRequestStop) == 0; ++tries)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  EXPECT_TRUE(rig.tick.obeyed & kRequestStop);
  expect_sentence(idle.hear(), "2 clients are connected");
}

TEST(ControlServer, AStopGetsThroughWhileOthersConnectWithoutPause) {
  ControlRig rig(1 << 20, [](ControlSettings& settings) { settings.clients = 2; });
  Speaker one(rig.settings.path), two(rig.settings.path);
  one.greet(), two.greet();
  std::atomic<bool> over{false};
  std::vector<std::thread> crowd;
  for (int i = 0; i < 2; ++i) {
    crowd.emplace_back([&] {
      while (!over) {
        const Speaker silent(rig.settings.path);
        std::this_thread::sleep_for(std::chrono::microseconds(50));
      }
    });
  }
  for (int times = 0; times < 20; ++times) {
    Speaker stop(rig.settings.path);
    EXPECT_EQ(stop.greet().kind, Kind::kWelcome);
    stop.say(Kind::kStop);
    EXPECT_EQ(stop.hear().kind, Kind::kDone);
  }
  over = true;
  for (std::thread& member : crowd) member.join();
}

/// The poll of a server with two places and one for a stop.
class Door {
 public:
  /// Whoever holds it can let several things come at once.
  std::mutex mutex;
  bool is_open = false;       ///< all places are taken, and yet the next one may come in
  int longest_closed_ms = 0;  ///< for how long it was to be closed at most

  int poll(std::span<pollfd> polled, int wait_ms) {
    for (int waited_ms = 0;; ++waited_ms) {
      {
        const std::lock_guard lock(mutex);
        const bool is_crowded = polled.size() == 3 + 3;
        is_open = is_crowded && polled[2].fd >= 0;
        if (is_crowded && !is_open) longest_closed_ms = std::max(longest_closed_ms, wait_ms);
        const int events = ::poll(polled.data(), polled.size(), 0);
        if (events != 0 || waited_ms >= wait_ms) return events;
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }
  void wait_until_open(bool wanted = true) {
    for (bool open = !wanted; open != wanted; std::this_thread::sleep_for(std::chrono::milliseconds(1))) {
      const std::lock_guard lock(mutex);
      open = is_open;
    }
  }
};

/// A server whose two places are taken.
struct Crowded {
  Door door;
  ControlRig rig{1 << 20, [this](ControlSettings& settings) {
                   settings.clients = 2;
                   settings.poll = [this](std::span<pollfd> polled, int wait_ms) { return door.poll(polled, wait_ms); };
                 }};
  const std::string& path = rig.settings.path;
  Speaker one{path}, two{path};

  Crowded() { one.greet(), two.greet(); }
};

TEST(ControlServer, WhoeverSaysNothingHasThePlaceForAStopForAHundredthOfASecond) {
  Crowded crowded;
  Speaker silent(crowded.path);
  crowded.door.wait_until_open();
  const std::lock_guard lock(crowded.door.mutex);
  EXPECT_LE(crowded.door.longest_closed_ms, 11);
}

TEST(ControlServer, AStopThatComesWithTheNextClientGetsThrough) {
  Crowded crowded;
  Speaker stop(crowded.path);
  EXPECT_EQ(stop.greet().kind, Kind::kWelcome);
  crowded.door.wait_until_open();
  std::unique_lock lock(crowded.door.mutex);
  stop.say(Kind::kStop);
  Speaker next(crowded.path);
  lock.unlock();
  EXPECT_EQ(stop.hear().kind, Kind::kDone);
  expect_sentence(stop.hear(), "2 clients are connected");
  EXPECT_EQ(next.greet().kind, Kind::kWelcome);
}

TEST(ControlServer, WhoeverGreetsBesideTheNextClientMayStillStop) {
  Crowded crowded;
  const std::vector<std::uint8_t> hello = frames_of(store::packed_ball(1), 512).front();
  bool has_stopped = false;
  for (int tries = 0; tries < 20 && !has_stopped; ++tries) {  // on a busy machine the tenth of a second may be over before the stop is said
    crowded.door.wait_until_open(false);
    Speaker stop(crowded.path);
    crowded.door.wait_until_open();
    std::unique_lock lock(crowded.door.mutex);
    ASSERT_TRUE(stop.send(hello));
    Speaker next(crowded.path);
    lock.unlock();
    ASSERT_EQ(stop.hear().kind, Kind::kWelcome);
    stop.say(Kind::kStop);
    has_stopped = stop.hear().kind == Kind::kDone;
  }
  EXPECT_TRUE(has_stopped);
}

TEST(ControlServer, AGreetingHasOneDeadlineHoweverSlowlyItComes) {
  ControlRig rig(1 << 20, [](ControlSettings& settings) { settings.patience_ns = 200'000'000; });
  Speaker slow(rig.settings.path);
  const std::vector<std::uint8_t> hello = frames_of(store::packed_ball(1), 512).front();
  std::size_t sent = 0;
  while (sent < hello.size() - 1 && slow.send(std::span(hello).subspan(sent, 1))) {
    ++sent;
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  EXPECT_LT(sent, hello.size() - 1) << "a byte at a time held the place";
}

TEST(ControlServer, ARequestHasOneDeadlineHoweverSlowlyItComes) {
  ControlRig rig(1 << 20, [](ControlSettings& settings) { settings.patience_ns = 200'000'000; });
  Speaker slow(rig.settings.path);
  slow.greet();
  const std::vector<std::uint8_t> begin = frames_of(store::packed_ball(1), 512)[1];
  std::size_t sent = 0;
  while (sent < begin.size() - 1 && slow.send(std::span(begin).subspan(sent, 1))) {
    ++sent;
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  EXPECT_LT(sent, begin.size() - 1) << "a byte at a time held the place";
}

TEST(ControlServer, AnUploadThatHardlyGetsOnGivesItsPlaceUp) {
  ControlRig rig(1 << 20, [](ControlSettings& settings) { settings.patience_ns = 200'000'000; });
  const store::PackedField ball = store::packed_ball(1);
  Speaker slow(rig.settings.path), next(rig.settings.path);
  slow.greet(), next.greet();
  slow.say(Kind::kBegin, ball.promise);
  ASSERT_EQ(slow.hear().kind, Kind::kDone);
  std::size_t sent = 0;
  for (; sent < 100; ++sent) {
    slow.say(Kind::kChunk, protocol::Chunk{sent, std::span(ball.bytes).subspan(sent, 1)});
    if (slow.hear().kind != Kind::kDone) break;
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  EXPECT_LT(sent, 100U) << "a byte at a time kept everybody else from sending a field";
  EXPECT_EQ(upload(next, ball).kind, Kind::kAccepted);
}

TEST(ControlServer, ToBeginAgainAndAgainOrAfterAFastStartKeepsNoPlace) {
  ControlRig rig(1 << 20, [](ControlSettings& settings) { settings.patience_ns = 200'000'000; });
  const store::PackedField ball = store::packed_ball(1);
  for (const bool anew : {true, false}) {
    Speaker slow(rig.settings.path);
    slow.greet();
    slow.say(Kind::kBegin, ball.promise);
    ASSERT_EQ(slow.hear().kind, Kind::kDone);
    std::size_t at = anew ? 0 : ball.bytes.size() / 2;
    if (!anew) {
      slow.say(Kind::kChunk, protocol::Chunk{0, std::span(ball.bytes).first(at)});
      ASSERT_EQ(slow.hear().kind, Kind::kDone);
    }
    int times = 0;
    for (; times < 100; ++times, ++at) {
      if (anew) {
        slow.say(Kind::kBegin, ball.promise);
      } else {
        slow.say(Kind::kChunk, protocol::Chunk{at, std::span(ball.bytes).subspan(at, 1)});
      }
      if (slow.hear().kind != Kind::kDone) break;
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    EXPECT_LT(times, 100) << (anew ? "begun anew" : "after a fast half");
  }
}

/// Processor time of this process, seconds.
double used_s() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& time) { return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec); };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

TEST(ControlServer, WithoutFileHandlesItWaitsInsteadOfSpinning) {
  ControlRig rig(1 << 18, [](ControlSettings& settings) { settings.clients = 100; });  // more than there are handles
  rig.tick.rests = true;
  Speaker let_in(rig.settings.path);
  let_in.greet();
  rlimit before{};
  ::getrlimit(RLIMIT_NOFILE, &before);
  const int last = ::dup(let_in.socket());
  ::close(last);
  const rlimit one_more{static_cast<rlim_t>(last) + 1, before.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &one_more), 0);
  Speaker knocking(rig.settings.path);  // has the last handle that there may be
  const double began = used_s();
  std::this_thread::sleep_for(std::chrono::seconds(2));
  EXPECT_LT(used_s() - began, 0.2);
  let_in.say(Kind::kStatus);
  EXPECT_EQ(let_in.hear().kind, Kind::kStatusReport);
  ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &before), 0);
  EXPECT_EQ(knocking.greet().kind, Kind::kWelcome) << "as soon as there are some again";
}

TEST(ControlServer, WhoeverAsksAndAsksKeepsTheWorkerFromNobody) {
  ControlRig rig;
  Speaker greedy(rig.settings.path), other(rig.settings.path);
  greedy.greet();
  ASSERT_EQ(upload(other, store::packed_ball(1)).kind, Kind::kAccepted);
  std::vector<std::uint8_t> once(protocol::kMaxFrame), many;
  once.resize(protocol::encode(Kind::kReadImage, protocol::ReadImage{0, 1}, once));
  constexpr std::size_t kTimes = 1000;
  for (std::size_t n = 0; n < kTimes; ++n) many.insert(many.end(), once.begin(), once.end());
  greedy.send(many);
  pollfd one{greedy.socket(), POLLIN, 0};
  ASSERT_EQ(::poll(&one, 1, 60'000), 1) << "the first is answered";
  other.say(Kind::kFields);
  EXPECT_EQ(other.hear().kind, Kind::kFieldList);
  int bytes = 0;
  ASSERT_EQ(::ioctl(greedy.socket(), FIONREAD, &bytes), 0);
  const std::size_t answered = static_cast<std::size_t>(bytes) / (protocol::kHeaderBytes + greedy.hear().body.size());
  EXPECT_LT(answered, kTimes / 10) << "the other one had to wait until these were answered";
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
  ControlRig rig(1 << 20, [](ControlSettings& settings) { settings.patience_ns = kLong; });
  Speaker deaf(rig.settings.path), other(rig.settings.path);
  deaf.greet(), other.greet();
  const int small = 4096;
  ::setsockopt(deaf.socket(), SOL_SOCKET, SO_RCVBUF, &small, sizeof small);
  for (int i = 0; i < 200; ++i) deaf.say(Kind::kSubscribe, protocol::Subscribe{1});
  const std::uint64_t before = rig.tick.stats.ticks.value();
  while (rig.tick.stats.ticks.value() < before + 10'000) {
    other.say(Kind::kStatus);
    ASSERT_EQ(other.hear().kind, Kind::kStatusReport);
  }
  std::uint64_t lost = 0;
  for (int frames = 0; lost == 0 && frames < 20'000; ++frames) {
    const Heard heard = deaf.hear();
    ASSERT_NE(heard.kind, Kind{});
    if (heard.kind == Kind::kRecords) lost = protocol::decode<protocol::Records>(heard.body)->lost;
  }
  EXPECT_GT(lost, 0U) << "and it is told so";
}

std::ptrdiff_t open_files() {
  return std::distance(std::filesystem::directory_iterator("/proc/self/fd"), std::filesystem::directory_iterator());
}

TEST(ControlServer, TenThousandRandomConnectionsDisturbNobody) {
  ControlRig rig(1 << 18, [](ControlSettings& settings) { settings.patience_ns = 20'000'000; });
  const store::PackedField old = store::packed_ball(1), other = store::packed_ball(2);
  {
    Speaker speaker(rig.settings.path);
    ASSERT_EQ(upload(speaker, old).kind, Kind::kAccepted);
  }
  auto frames = frames_of(other, 700);
  frames.pop_back();  // never a commit
  for (const Kind kind : {Kind::kStatus, Kind::kFields, Kind::kAbort, Kind::kStop, Kind::kRecord, Kind::kRecordEnd}) {
    std::vector<std::uint8_t> frame(protocol::kHeaderBytes);
    protocol::seal_frame(kind, 0, frame);
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
  EXPECT_EQ(rig.tick.felt(), old.promise.image_hash);
  Heard heard;
  for (int tries = 0; tries < 100 && heard.kind != Kind::kAccepted; ++tries) {
    Speaker speaker(rig.settings.path);
    heard = upload(speaker, other);
  }
  EXPECT_EQ(heard.kind, Kind::kAccepted) << heard.refusal();
  for (int tries = 0; tries < 20'000 && open_files() > files; ++tries) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  EXPECT_LE(open_files(), files) << "no connection is left behind";
}

}  // namespace
}  // namespace isotouch::control
