#include "firmware/daemon/service_notify.h"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cstddef>

#include "tests/support/scratch_folder.h"

namespace isotouch::daemon {
namespace {

/// Listens as systemd does.
struct Listener {
  explicit Listener(const std::string& path) : socket(::socket(AF_UNIX, SOCK_DGRAM | SOCK_NONBLOCK, 0)) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::copy(path.begin(), path.end(), address.sun_path);
    if (path[0] == '@') address.sun_path[0] = 0;
    const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + path.size() + (path[0] == '@' ? 0 : 1));
    EXPECT_EQ(::bind(socket, reinterpret_cast<const sockaddr*>(&address), size), 0);
  }
  ~Listener() { ::close(socket); }
  std::string hear() const {
    char text[200];
    const ssize_t size = ::recv(socket, text, sizeof text, 0);
    return size > 0 ? std::string(text, static_cast<std::size_t>(size)) : std::string();
  }
  int socket;
};

TEST(ServiceNotify, SaysWhatSystemdWantsToHear) {
  const ScratchFolder folder;
  for (const std::string& name : {(folder.path() / "notify").string(), "@isotouch-test-" + std::to_string(::getpid())}) {
    const Listener listener(name);
    ServiceNotify notify(name, "2000000");
    notify.busy();
    EXPECT_EQ(listener.hear(), "") << "from the first word on, systemd counts the time until the next one";
    notify.ready();
    EXPECT_EQ(listener.hear(), "READY=1");
    notify.status("state: active");
    EXPECT_EQ(listener.hear(), "STATUS=state: active");
    notify.busy();
    EXPECT_EQ(listener.hear(), "WATCHDOG_USEC=120000000\nWATCHDOG=1") << "a run that follows another may take its time";
    notify.ready();
    EXPECT_EQ(listener.hear(), "READY=1\nWATCHDOG_USEC=2000000");
    notify.ending();
    EXPECT_EQ(listener.hear(), "STOPPING=1");
    EXPECT_EQ(listener.hear(), "");
  }
}

TEST(ServiceNotify, WithoutAWatchdogNobodyIsAskedToWait) {
  const ScratchFolder folder;
  const std::string name = (folder.path() / "notify").string();
  const Listener listener(name);
  ServiceNotify notify(name);
  notify.ready();
  notify.busy();
  notify.ready();
  EXPECT_EQ(listener.hear() + listener.hear(), "READY=1READY=1");
  EXPECT_EQ(listener.hear(), "");
}

TEST(ServiceNotify, LivesAsLongAsTicksCome) {
  const ScratchFolder folder;
  const std::string name = (folder.path() / "notify").string();
  const Listener listener(name);
  ServiceNotify notify(name);
  for (const std::uint64_t ticks : {5U, 6U, 300U}) {
    notify.alive(ticks);
    EXPECT_EQ(listener.hear(), "WATCHDOG=1");
    notify.alive(ticks);
    EXPECT_EQ(listener.hear(), "");
  }
}

TEST(ServiceNotify, WithoutAListenerNothingHappens) {
  for (const std::string& name : {std::string(), std::string("nonsense"), std::string("/nobody/listens"), std::string(500, '/')}) {
    ServiceNotify notify(name);
    notify.ready();
    notify.alive(1);
  }
}

}  // namespace
}  // namespace isotouch::daemon
