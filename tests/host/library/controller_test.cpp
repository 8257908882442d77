#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <string>

#include "host/library/isotouch.h"
#include "tests/host/library/golden.h"
#include "tests/support/scratch_folder.h"

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
  EXPECT_REFUSED(isotouch_controller_status(0, nullptr, 0, nullptr), ISOTOUCH_BAD_HANDLE, "the handle is 0");
  EXPECT_EQ(controller, 0U);
}

}  // namespace
}  // namespace isotouch
