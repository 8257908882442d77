#include "firmware/control/relay.h"

#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

#include "shared/files/write_all.h"

namespace isotouch::control {

namespace {

/// One read's worth. returns false at the end of `from`, or when `to` takes no more
bool pass_on(int from, int to) {
  std::array<std::uint8_t, 16384> bytes;
  ssize_t got = 0;
  do {
    got = ::read(from, bytes.data(), bytes.size());
  } while (got < 0 && errno == EINTR);
  return got > 0 && files::write_all(to, std::span(bytes).first(static_cast<std::size_t>(got)));
}

}  // namespace

Refusal relay(const std::string& socket_path, int input, int output, int patience_ms) {
  std::signal(SIGPIPE, SIG_IGN);
  const int socket = connect_to_socket(socket_path, patience_ms);
  if (socket < 0 && errno == EAGAIN)
    return socket_path + ": the controller lets nobody in; press the emergency stop if there is force, and start isotouchd again";
  if (socket < 0) {
    return socket_path + ": no controller answers there (" + std::strerror(errno) +
           "); start isotouchd, or name its socket, and check that this user may use it";
  }
  std::array<pollfd, 2> both = {{{input, POLLIN, 0}, {socket, POLLIN, 0}}};
  Refusal refusal;
  for (bool open = true; open;) {
    if (::poll(both.data(), both.size(), -1) < 0 && errno != EINTR) {
      refusal = socket_path + ": the connection cannot be watched: " + std::strerror(errno);
      break;
    }
    if (both[1].revents != 0) open = pass_on(socket, output);
    // A controller that refuses closes at once: what it said is still read, though it takes no more.
    if (open && both[0].fd >= 0 && both[0].revents != 0 && !pass_on(input, socket)) {
      both[0].fd = -1;
      ::shutdown(socket, SHUT_WR);
    }
    both[0].revents = both[1].revents = 0;
  }
  ::close(socket);
  if (!refusal && both[0].fd >= 0)  // nobody here has asked for the end
    refusal = socket_path + ": the controller ended the connection; see what isotouchd prints";
  return refusal;
}

}  // namespace isotouch::control
