/// The host tool's link and the controller's server, together: over the local socket, and through programs that stand for ssh.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "host/error.h"
#include "host/field_file/packed.h"
#include "host/link/controller.h"
#include "shared/trace.h"
#include "tests/firmware/control/control_rig.h"
#include "tests/support/field_image.h"

namespace isotouch {
namespace {

using control::ControlRig;
using link::Controller;
using testing::HasSubstr;

struct Ball {
  explicit Ball(double radius)
      : image({64, 64, 64},
              [=](const test::Point& p) {
                return test::length(p - test::Point{32, 32, 32}) - radius;
              }),
        packed(field_file::pack(image.view())),
        promise{packed.size(), image.view().image.size(), image.view().hash(), protocol::Text::of("ball")} {}
  test::FieldImage image;
  std::vector<std::uint8_t> packed;
  protocol::Begin promise;
};

std::string refusal(const std::function<void()>& ask) {
  try {
    ask();
  } catch (const InputError& e) {
    return e.what();
  }
  return "it was done";
}

/// A program of a few lines.
void write_program(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path) << "#!/bin/sh\n" << text;
  std::filesystem::permissions(path, std::filesystem::perms::owner_all);
}

/// Set for one test.
struct Variable {
  Variable(const char* name, const std::string& value) : name_(name) {
    if (const char* old = std::getenv(name)) old_ = old;
    ::setenv(name, value.c_str(), 1);
  }
  ~Variable() { old_.empty() ? ::unsetenv(name_) : ::setenv(name_, old_.c_str(), 1); }
  const char* name_;
  std::string old_;
};

TEST(Upload, AFieldIsFeltListedAndSelected) {
  ControlRig rig;
  const Ball one(20), two(22);
  Controller controller("unix:" + rig.settings.path);
  EXPECT_EQ(controller.upload(one.promise, one.packed).image_hash, one.promise.image_hash);
  EXPECT_EQ(controller.upload(two.promise, two.packed).image_hash, two.promise.image_hash);
  EXPECT_EQ(rig.tick.felt(), two.promise.image_hash);
  const std::vector<protocol::FieldEntry> fields = controller.fields();
  ASSERT_EQ(fields.size(), 2U);
  EXPECT_EQ(fields[0].name.view(), "ball");
  EXPECT_EQ(fields[0].packed_bytes, one.packed.size());
  EXPECT_FALSE(fields[0].active != 0);
  EXPECT_TRUE(fields[1].active != 0);
  (void)controller.select(one.promise.image_hash);
  EXPECT_EQ(rig.tick.felt(), one.promise.image_hash);
  EXPECT_EQ(controller.status().field_hash, one.promise.image_hash);
  EXPECT_THAT(refusal([&] { (void)controller.select(1); }), HasSubstr("no field of this hash"));
}

TEST(Upload, WhatIsRefusedIsToldAndTheOldFieldStays) {
  ControlRig rig;
  const Ball old(20), other(22);
  Controller controller("unix:" + rig.settings.path);
  (void)controller.upload(old.promise, old.packed);
  std::vector<std::uint8_t> changed = other.packed;
  changed[changed.size() / 2] ^= 1;
  EXPECT_THAT(refusal([&] { (void)controller.upload(other.promise, changed); }), HasSubstr("checksum"));
  protocol::Begin large = other.promise;
  large.image_bytes = 1U << 30;
  EXPECT_THAT(refusal([&] { (void)controller.upload(large, other.packed); }), HasSubstr("larger --voxel"));
  EXPECT_EQ(rig.tick.felt(), old.promise.image_hash);
  (void)controller.upload(other.promise, other.packed);
  EXPECT_EQ(rig.tick.felt(), other.promise.image_hash);
}

TEST(Upload, ASenderThatIsKilledLeavesTheOldField) {
  ControlRig rig;
  const Ball old(20), other(22);
  {
    Controller controller("unix:" + rig.settings.path);
    (void)controller.upload(old.promise, old.packed);
  }
  for (int sent = 0; sent < 5; ++sent) {
    const pid_t child = ::fork();
    if (child == 0) {
      control::Speaker speaker(rig.settings.path);
      speaker.greet();
      speaker.say(protocol::Kind::kBegin, other.promise);
      for (std::size_t i = 0; i < static_cast<std::size_t>(sent); ++i) {
        speaker.say(protocol::Kind::kChunk, protocol::Chunk{i * 1000, std::span(other.packed).subspan(i * 1000, 1000)});
      }
      ::raise(SIGKILL);
    }
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status));
    EXPECT_EQ(rig.tick.felt(), old.promise.image_hash);
  }
  Controller controller("unix:" + rig.settings.path);
  (void)controller.upload(other.promise, other.packed);
  EXPECT_EQ(rig.tick.felt(), other.promise.image_hash);
}

/// What came of a recording, checked as it came.
struct Recorded {
  /// once      called when a hundred ticks have come
  Recorded(Controller& controller, std::uint64_t ticks, const std::function<void()>& once, const std::function<bool()>& enough) {
    ended = controller.record(
        ticks,
        [&](std::span<const std::uint8_t> bytes) {
          const auto read = decode_header(bytes, bytes.size());
          ASSERT_TRUE(read);
          chain.emplace(*read);
        },
        [&](std::span<const std::uint8_t> bytes) {
          const auto record = decode_record(bytes.first<trace_layout::kRecordBytes>());
          ASSERT_TRUE(record);
          EXPECT_EQ(chain->extend(record->input, record->output), record->chain) << records;
          if (++records == 100 && once) once();
        },
        enough);
  }
  std::optional<Chain> chain;
  std::uint64_t records = 0;
  std::string ended;
};

/// Somebody who follows the ticks, so that the server looks after them all the time.
struct Follower {
  explicit Follower(const ControlRig& rig) : speaker(rig.settings.path) {
    speaker.greet();
    speaker.say(protocol::Kind::kSubscribe, protocol::Subscribe{10'000});
    EXPECT_EQ(speaker.hear().kind, protocol::Kind::kDone);
  }
  control::Speaker speaker;
};

const auto kNeverEnough = [] { return false; };

TEST(Upload, ARecordingArrivesWithoutAGap) {
  ControlRig rig;
  Controller controller("unix:" + rig.settings.path);
  const Recorded recorded(controller, 1000, {}, kNeverEnough);
  EXPECT_EQ(recorded.records, 1000U);
  EXPECT_EQ(recorded.ended, "");
}

TEST(Upload, ARecordingThatIsEndedByAnotherFieldKeepsWhatCame) {
  ControlRig rig;
  const Follower follower(rig);
  const Ball ball(20);
  Controller controller("unix:" + rig.settings.path), another("unix:" + rig.settings.path);
  const Recorded recorded(
      controller, 1'000'000, [&] { (void)another.upload(ball.promise, ball.packed); }, kNeverEnough);
  EXPECT_GE(recorded.records, 100U);
  EXPECT_EQ(recorded.ended, "unix:" + rig.settings.path + ": the recording ended: another field was loaded; record again");
}

TEST(Upload, ARecordingThatIsCutKeepsWhatCame) {
  ControlRig rig;
  const Follower follower(rig);
  Controller controller("unix:" + rig.settings.path);
  const Recorded recorded(
      controller, 1'000'000, [&] { rig.server->stop(); }, kNeverEnough);
  EXPECT_GE(recorded.records, 100U);
  EXPECT_THAT(recorded.ended, HasSubstr("the controller closed the connection; check whether it still runs"));
}

TEST(Upload, ARecordingEndsWhenItIsEnoughAlsoWithoutTicks) {
  ControlRig rig;
  const Follower follower(rig);
  {
    Controller controller("unix:" + rig.settings.path);
    bool enough = false;
    const Recorded recorded(
        controller, 1'000'000, [&] { enough = true; }, [&] { return enough; });
    EXPECT_GE(recorded.records, 100U);
    EXPECT_LT(recorded.records, 1'000'000U);
    EXPECT_EQ(recorded.ended, "");
  }
  rig.tick.rests = true;
  int asked = 0;
  control::Speaker(rig.settings.path).greet();  // the server has heard that the one before has gone
  Controller controller("unix:" + rig.settings.path);
  const Recorded nothing(controller, 10, {}, [&] { return ++asked > 3; });
  EXPECT_EQ(nothing.records, 0U);
  EXPECT_EQ(nothing.ended, "");
}

TEST(Upload, WhatIsRefusedBeforeTheFirstTickIsThrown) {
  ControlRig rig;
  const Follower follower(rig);
  Controller controller("unix:" + rig.settings.path), another("unix:" + rig.settings.path);
  const Recorded recorded(
      controller, 1000,
      [&] { EXPECT_THAT(refusal([&] { const Recorded other(another, 10, {}, kNeverEnough); }), HasSubstr("another client is recording")); },
      kNeverEnough);
  EXPECT_EQ(recorded.records, 1000U);
}

TEST(Upload, TicksThatAreFollowedAndCutKeepWhatCame) {
  ControlRig rig;
  Controller controller("unix:" + rig.settings.path);
  std::uint64_t shown = 0;
  const auto show = [&](std::uint64_t, std::span<const std::uint8_t>) {
    if (++shown == 100) rig.server->stop();
  };
  EXPECT_THAT(controller.watch(1, 1'000'000, show, kNeverEnough).ended, HasSubstr("the controller closed the connection"));
  EXPECT_GE(shown, 100U);
}

/// A program that does what ssh would: it finds the words after "--" and runs the last one by a shell.
class Ssh : public testing::Test {
 protected:
  /// What `isotouchd relay SOCKET` is on the other machine.
  void SetUp() override {
    write_program(rig_.scratch.path() / "isotouchd", "exec '" ISOTOUCH_RELAY "' \"$2\"\n");
    write_program(rig_.scratch.path() / "fake-ssh", "echo \"$@\" > '" + (rig_.scratch.path() / "words").string() +
                                                        "'\nfor last; do :; done\nPATH='" + rig_.scratch.path().string() +
                                                        "':$PATH exec sh -c \"$last\"\n");
  }
  ControlRig rig_;
};

TEST_F(Ssh, AFieldGoesThroughAProgramThatStandsForIt) {
  const Variable ssh("ISOTOUCH_SSH", (rig_.scratch.path() / "fake-ssh").string());
  const Ball ball(20);
  Controller controller("ssh://me@board:2222" + rig_.settings.path);
  (void)controller.upload(ball.promise, ball.packed);
  EXPECT_EQ(rig_.tick.felt(), ball.promise.image_hash);
  std::ifstream words(rig_.scratch.path() / "words");
  std::string line;
  std::getline(words, line);
  EXPECT_EQ(line, "-T -p 2222 -l me -- board isotouchd relay '" + rig_.settings.path + "'");
}

TEST_F(Ssh, TheOneInThePathIsTakenByDefault) {
  std::filesystem::rename(rig_.scratch.path() / "fake-ssh", rig_.scratch.path() / "ssh");
  const Variable path("PATH", rig_.scratch.path().string() + ":" + std::getenv("PATH"));
  Controller controller("ssh://board" + rig_.settings.path);
  EXPECT_EQ(controller.welcome().program.view(), "a test");
}

TEST_F(Ssh, WhenItFailsTheSentenceSaysWhatToDo) {
  {
    const Variable ssh("ISOTOUCH_SSH", (rig_.scratch.path() / "none").string());
    EXPECT_THAT(refusal([&] { Controller controller("ssh://board"); }),
                HasSubstr("none cannot be run (No such file or directory); install it"));
  }
  const Variable ssh("ISOTOUCH_SSH", (rig_.scratch.path() / "fake-ssh").string());
  EXPECT_THAT(refusal([&] { Controller controller("ssh://board" + rig_.settings.path + ".none"); }), HasSubstr("ssh ended with status 1"));
  write_program(rig_.scratch.path() / "fake-ssh", "exit 255\n");
  EXPECT_THAT(refusal([&] { Controller controller("ssh://board"); }), HasSubstr("ssh ended with status 255"));
}

/// A server of this machine on a port of its own, with keys of its own.
TEST_F(Ssh, ARealOneOnThisMachine) {
  const std::string sshd = std::filesystem::exists("/usr/sbin/sshd") ? "/usr/sbin/sshd" : "";
  if (sshd.empty() || std::system("command -v ssh ssh-keygen >/dev/null") != 0) GTEST_SKIP() << "no sshd is installed";
  const std::string at = rig_.scratch.path().string();
  const auto run = [](const std::string& command) { return std::system(command.c_str()); };
  ASSERT_EQ(run("ssh-keygen -q -t ed25519 -N '' -f '" + at + "/host' && ssh-keygen -q -t ed25519 -N '' -f '" + at + "/mine'"), 0);
  ASSERT_EQ(run("cp '" + at + "/mine.pub' '" + at + "/allowed' && chmod 700 '" + at + "' && mkdir -p /run/sshd 2>/dev/null; true"), 0);
  const std::string port = std::to_string(20000 + ::getpid() % 20000);
  std::ofstream(at + "/config") << "Port " << port << "\nListenAddress 127.0.0.1\nHostKey " << at << "/host\nAuthorizedKeysFile " << at
                                << "/allowed\nPidFile " << at
                                << "/pid\nStrictModes no\nUsePAM no\nPasswordAuthentication no\nPermitRootLogin yes\nSetEnv PATH=" << at
                                << ":/usr/bin:/bin\n";
  if (run("'" + sshd + "' -f '" + at + "/config' -E '" + at + "/log'") != 0) GTEST_SKIP() << "sshd does not start here";
  write_program(at + "/my-ssh", "exec ssh -F none -i '" + at +
                                    "/mine' -o IdentitiesOnly=yes -o StrictHostKeyChecking=no -o UserKnownHostsFile='" + at +
                                    "/known' \"$@\"\n");
  {
    const Variable ssh("ISOTOUCH_SSH", at + "/my-ssh");
    const Ball ball(20);
    Controller controller("ssh://127.0.0.1:" + port + rig_.settings.path);
    (void)controller.upload(ball.promise, ball.packed);
    EXPECT_EQ(rig_.tick.felt(), ball.promise.image_hash);
  }
  std::ifstream pid_file(at + "/pid");
  pid_t pid = 0;
  if (pid_file >> pid) ::kill(pid, SIGTERM);
}

}  // namespace
}  // namespace isotouch
