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
  /// socket    as $NOTIFY_SOCKET: a path, or '@' and an abstract name; empty: nobody listens
  explicit ServiceNotify(const std::string& socket);
  ~ServiceNotify();
  ServiceNotify(const ServiceNotify&) = delete;
  ServiceNotify& operator=(const ServiceNotify&) = delete;

  void ready() {
    say("READY=1");
    is_ready_ = true;
  }
  void ending() const { say("STOPPING=1"); }
  /// A line for people, shown by `systemctl status`.
  void status(const std::string& line) const { say("STATUS=" + line); }

  /// Tells that the service lives, when ticks have come since the last time. Without a tick for as long as the unit's WatchdogSec, systemd ends the
  /// service and starts it anew.
  void alive(std::uint64_t ticks);

  /// Tells that the service lives, though no ticks can come: a run follows another. Before the first one it tells nothing: systemd would count its
  /// WatchdogSec from then on, and reading a field from a slow card may take longer.
  void busy() const {
    if (is_ready_) say("WATCHDOG=1");
  }

 private:
  void say(std::string_view message) const;

  int socket_ = -1;
  std::uint64_t ticks_ = 0;
  bool is_ready_ = false;
};

}  // namespace isotouch::daemon
