#include "firmware/control/control_socket.h"

#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "shared/files/missing_folder.h"

namespace isotouch::control {

namespace {

constexpr int kQueue = 128;  ///< of those that wait to be let in: they come in turn, but whoever finds no place in it comes by chance

/// returns   false: the path is too long
bool make_address(const std::string& path, sockaddr_un& address) {
  address = {};
  address.sun_family = AF_UNIX;
  if (path.empty() || path.size() >= sizeof address.sun_path) return false;
  std::copy(path.begin(), path.end(), address.sun_path);
  return true;
}

std::string reason() { return std::string(std::strerror(errno)); }

/// Only a refused connection says that nobody listens there: a door that is full, of another type or closed to us is somebody's. Waits for nobody.
///
/// returns   whose it is, in words; empty: nobody's
std::string owner_of(const sockaddr_un& address) {
  const int probe = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  const bool connected = probe >= 0 && ::connect(probe, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
  const int why = errno;
  if (probe >= 0) ::close(probe);
  if (connected || why == EAGAIN) return "another program listens there";
  return why == ECONNREFUSED || why == ENOENT ? std::string()
                                              : std::string("another program may listen there (") + std::strerror(why) + ")";
}

}  // namespace

Refusal ControlSocket::open(const std::string& path, mode_t mode, std::optional<gid_t> group) {
  close();
  sockaddr_un address{};
  if (!make_address(path, address)) return path + ": is no path for a socket (1 to 107 characters); choose a shorter one";
  if (Refusal missing = files::refusal_of_missing_folder(path)) return missing;
  struct stat about {};
  if (::lstat(path.c_str(), &about) == 0) {
    if (!S_ISSOCK(about.st_mode)) return path + ": is a file already, and no socket; choose another path or remove it";
    const std::string owner = owner_of(address);
    if (!owner.empty()) return path + ": " + owner + "; stop it or choose another path";
    ::unlink(path.c_str());
  }
  socket_ = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  const mode_t before = ::umask(0777);  // nobody comes in between bind and chmod
  const bool bound = socket_ >= 0 && ::bind(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
  ::umask(before);
  if (bound) path_ = path;
  const bool listens = bound && (!group || ::chown(path.c_str(), static_cast<uid_t>(-1), *group) == 0) &&
                       ::chmod(path.c_str(), mode) == 0 && ::listen(socket_, kQueue) == 0;
  if (listens) return {};
  const std::string why = reason();
  close();
  return path + ": cannot listen there (" + why + "); check the folder, its permissions and the group";
}

void ControlSocket::close() {
  if (!path_.empty()) ::unlink(path_.c_str());  // while it is ours: who finds nobody behind it may take its place
  path_.clear();
  if (socket_ >= 0) ::close(socket_);
  socket_ = -1;
}

int ControlSocket::accept() const { return ::accept4(socket_, nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK); }

int connect_to_socket(const std::string& path) {
  sockaddr_un address{};
  if (!make_address(path, address)) {
    errno = ENAMETOOLONG;
    return -1;
  }
  const int socket = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  if (socket >= 0 && ::connect(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
    const int why = errno;
    ::close(socket);
    errno = why;
    return -1;
  }
  return socket;
}

}  // namespace isotouch::control
