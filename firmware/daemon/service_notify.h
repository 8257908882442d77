/// What a service tells systemd: that it is ready, that it lives, that it ends. One datagram each to the socket that $NOTIFY_SOCKET names; without one,
/// nothing.
///
/// source    sd_notify(3), "Notes": the protocol is stable and may be spoken without libsystemd
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace isotouch::daemon {

class ServiceNotify {
 public:
  /// socket          as $NOTIFY_SOCKET: a path, or '@' and an abstract name; empty: nobody listens
  /// watchdog_usec   as $WATCHDOG_USEC: the unit's WatchdogSec in microseconds; empty: it has none
  explicit ServiceNotify(const std::string& socket, std::string watchdog_usec = {});
  ~ServiceNotify();
  ServiceNotify(const ServiceNotify&) = delete;
  ServiceNotify& operator=(const ServiceNotify&) = delete;

  void ready() {
    say(is_ready_ && !watchdog_usec_.empty() ? "READY=1\nWATCHDOG_USEC=" + watchdog_usec_ : "READY=1");
    is_ready_ = true;
  }
  void ending() const { say("STOPPING=1"); }
  /// A line for people, shown by `systemctl status`.
  void status(const std::string& line) const { say("STATUS=" + line); }

  /// Tells that the service lives, when ticks have come since the last time. Without a tick for as long as the unit's WatchdogSec, systemd ends the
  /// service and starts it anew.
  void alive(std::uint64_t ticks);

  /// Tells that no ticks can come until it is `ready` again: a run follows another. Taking memory and reading a field from a slow card may take longer than
  /// WatchdogSec, so systemd waits for two minutes. Before the first run it tells nothing: nothing is counted yet.
  void busy() const {
    if (is_ready_ && !watchdog_usec_.empty()) say("WATCHDOG_USEC=120000000\nWATCHDOG=1");
  }

 private:
  void say(std::string_view message) const;

  int socket_ = -1;
  std::string watchdog_usec_;
  std::uint64_t ticks_ = 0;
  bool is_ready_ = false;
};

}  // namespace isotouch::daemon
