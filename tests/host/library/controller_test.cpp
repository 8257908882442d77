#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "host/library/isotouch.h"
#include "shared/trace.h"
#include "tests/host/library/golden.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/scripted_controller.h"

namespace isotouch {
namespace {

/// A socket at which nobody ever answers.
class Silence {
 public:
  explicit Silence(const std::string& path) : socket_(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    sockaddr_un name{};
    name.sun_family = AF_UNIX;
    std::copy(path.begin(), path.end(), name.sun_path);
    EXPECT_EQ(::bind(socket_, reinterpret_cast<const sockaddr*>(&name), sizeof name), 0);
    EXPECT_EQ(::listen(socket_, 1), 0);
  }
  ~Silence() { ::close(socket_); }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

 private:
  int socket_;
};

TEST(LibraryController, WhoDoesNotAnswerIsNotWaitedForLongerThanAllowed) {
  const ScratchFolder folder;
  const std::string path = (folder.path() / "control").string();
  const Silence silence(path);
  const auto begin = std::chrono::steady_clock::now();
  isotouch_controller controller = 0;
  EXPECT_REFUSED(isotouch_controller_connect(("unix:" + path).c_str(), 200, &controller), ISOTOUCH_CONTROLLER, "does not answer");
  const auto waited = std::chrono::steady_clock::now() - begin;
  EXPECT_GE(waited, std::chrono::milliseconds(190));
  EXPECT_LT(waited, std::chrono::seconds(5));
  EXPECT_EQ(controller, 0U);
}

/// A program that catches Ctrl-C, such as Python, still wants to stop the force then.
TEST(LibraryController, CtrlCDoesNotEndTheSsh) {
  using test::frame, protocol::Kind;
  ::signal(SIGINT, SIG_DFL);  // a shell's background ignores it
  const ScratchFolder folder;
  test::Bytes answers = frame(Kind::kWelcome, protocol::Welcome{});
  const test::Bytes done = frame(Kind::kDone);
  answers.insert(answers.end(), done.begin(), done.end());
  const std::filesystem::path said = folder.write("answers", std::string(answers.begin(), answers.end()));
  const std::filesystem::path ssh =
      folder.write("ssh", "#!/bin/sh\nexec sh -c 'kill -INT $$; cat " + said.string() + "; exec cat >/dev/null'\n");
  std::filesystem::permissions(ssh, std::filesystem::perms::owner_all);
  ::setenv("ISOTOUCH_SSH", ssh.c_str(), 1);
  isotouch_controller controller = 0;
  EXPECT_DONE(isotouch_controller_connect("ssh://user@host", 10'000, &controller));
  ::unsetenv("ISOTOUCH_SSH");
  EXPECT_DONE(isotouch_controller_stop(controller));
  EXPECT_DONE(isotouch_free(controller));
}

/// With one connection for both, each could take the other's answers.
TEST(LibraryController, AForkConnectsAnew) {
  std::array<std::atomic<int>, 2> asked{};
  const auto serves = [](std::atomic<int>& count) {
    return [&count](int client) {
      test::Bytes in, piece(4096);
      for (ssize_t got = 0; (got = ::recv(client, piece.data(), piece.size(), 0)) > 0;) {
        in.insert(in.end(), piece.begin(), piece.begin() + got);
        for (auto next = protocol::read_frame(in); next && next->size > 0; next = protocol::read_frame(in)) {
          const bool greets = next->kind == protocol::Kind::kHello;
          const test::Bytes said = greets ? test::frame(protocol::Kind::kWelcome, protocol::Welcome{}) : test::frame(protocol::Kind::kDone);
          count += greets ? 0 : 1;
          (void)::send(client, said.data(), said.size(), MSG_NOSIGNAL);
          in.erase(in.begin(), in.begin() + static_cast<std::ptrdiff_t>(next->size));
        }
      }
    };
  };
  const test::Scripted scripted({serves(asked[0]), serves(asked[1])});
  isotouch_controller controller = 0;
  ASSERT_DONE(isotouch_controller_connect(scripted.address().c_str(), 10'000, &controller));
  const pid_t copy = ::fork();
  if (copy == 0) {
    const bool works = isotouch_controller_stop(controller) == ISOTOUCH_OK && isotouch_controller_resume(controller) == ISOTOUCH_OK;
    ::_exit(works ? 0 : 1);
  }
  int status = -1;
  ASSERT_EQ(::waitpid(copy, &status, 0), copy);
  EXPECT_EQ(status, 0);
  EXPECT_DONE(isotouch_controller_stop(controller));
  EXPECT_DONE(isotouch_free(controller));
  EXPECT_EQ(asked[0], 1) << "of the original";
  EXPECT_EQ(asked[1], 2) << "of the copy";
}

TEST(LibraryController, AFileThatCannotBeCompletedIsNoFaultOfTheController) {
  using test::frame, protocol::Kind;
  TraceHeader header;
  header.device = libnifalcon_model();
  header.period_ns = 1'000'000;
  header.has_outputs = true;
  const TraceHeaderBytes head = encode(header);
  const TraceRecordBytes record = encode(TraceRecord{});
  test::Bytes answers = frame(Kind::kWelcome, protocol::Welcome{});
  for (const test::Bytes& next : {frame(Kind::kRecording, protocol::Recording{head}),
                                  frame(Kind::kRecords, protocol::Records{1, 1, static_cast<std::uint32_t>(record.size()), 0, record})}) {
    answers.insert(answers.end(), next.begin(), next.end());
  }
  const test::Scripted scripted({test::Scripted::says(frame(Kind::kWelcome, protocol::Welcome{})), test::Scripted::says(answers)});
  isotouch_controller controller = 0;
  ASSERT_DONE(isotouch_controller_connect(scripted.address().c_str(), 10'000, &controller));
  std::string path = std::filesystem::path(scripted.address().substr(5)).replace_filename("felt.trace").string();
  const auto in_the_way = [](void* at, const isotouch_felt*) {
    std::filesystem::create_directory(*static_cast<std::string*>(at));
    return 0;
  };
  std::uint64_t recorded = 7;
  EXPECT_REFUSED(isotouch_controller_record(controller, 1, path.c_str(), in_the_way, &path, &recorded), ISOTOUCH_BAD_DATA,
                 "cannot be completed");
  EXPECT_EQ(recorded, 0U);
  EXPECT_DONE(isotouch_free(controller));
}

TEST(LibraryController, WrongAddressesAndArgumentsAreSentences) {
  isotouch_controller controller = 0;
  EXPECT_REFUSED(isotouch_controller_connect("unix:/nowhere/control", 1000, &controller), ISOTOUCH_CONTROLLER, "start isotouchd");
  EXPECT_REFUSED(isotouch_controller_connect("http://here", 1000, &controller), ISOTOUCH_CONTROLLER, "is no address of a controller");
  EXPECT_REFUSED(isotouch_controller_connect(nullptr, 1000, &controller), ISOTOUCH_BAD_ARGUMENT, "address");
  EXPECT_REFUSED(isotouch_controller_connect("unix:/nowhere", 0, &controller), ISOTOUCH_BAD_ARGUMENT, "timeout_ms");
  EXPECT_REFUSED(isotouch_controller_connect("unix:/nowhere", 1000, nullptr), ISOTOUCH_BAD_ARGUMENT, "controller");
  EXPECT_REFUSED(isotouch_controller_set(0, "friction", nullptr), ISOTOUCH_BAD_ARGUMENT, "value");
  EXPECT_REFUSED(isotouch_controller_set(0, std::string(64, 'a').c_str(), "1"), ISOTOUCH_BAD_ARGUMENT, "64 bytes");
  EXPECT_REFUSED(isotouch_controller_watch(0, 1, 1, nullptr, nullptr, nullptr), ISOTOUCH_BAD_ARGUMENT, "on_tick");
  EXPECT_REFUSED(isotouch_controller_record(0, 0, "x.trace", nullptr, nullptr, nullptr), ISOTOUCH_BAD_ARGUMENT, "ticks");
  for (const char* path : {static_cast<const char*>(nullptr), ""}) {
    std::uint64_t recorded = 777;
    EXPECT_REFUSED(isotouch_controller_record(0, 1, path, nullptr, nullptr, &recorded), ISOTOUCH_BAD_ARGUMENT, "path");
    EXPECT_EQ(recorded, 0U);
  }
  EXPECT_REFUSED(isotouch_controller_status(0, nullptr, 0, nullptr), ISOTOUCH_BAD_HANDLE, "the handle is 0");
  EXPECT_EQ(controller, 0U);
}

}  // namespace
}  // namespace isotouch
