#include "firmware/control/control_socket.h"

#include <fcntl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/time.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <utility>

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

/// returns   why no socket may take this name; none: the name is free, or a socket has it that nobody listens at
Refusal refusal_of_taken(const std::string& path) {
  struct stat about {};
  sockaddr_un address{};
  if (::lstat(path.c_str(), &about) != 0 || !make_address(path, address)) return {};
  if (!S_ISSOCK(about.st_mode)) return path + ": is a file already, and no socket; choose another path or remove it";
  const std::string owner = owner_of(address);
  return owner.empty() ? Refusal() : path + ": " + owner + "; stop it or choose another path";
}

/// A folder by its number, so that names in it may be as long as they like.
class Folder {
 public:
  explicit Folder(const std::string& path) : number_(::open(path.empty() ? "." : path.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC)) {}
  ~Folder() {
    if (number_ >= 0) ::close(number_);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  bool is_open() const { return number_ >= 0; }
  /// Of a file that no tool knows, and that nobody else makes.
  std::string path_of_own() const {
    const std::string number = std::to_string(number_);
    return "/proc/self/fd/" + number + "/.isotouchd." + std::to_string(::getpid()) + '.' + number;
  }

 private:
  int number_;
};

/// Gives a listening socket its name. One that nobody listens at gives way.
///
/// returns   why not; none with `errno` set: the system does not let it
std::optional<Refusal> refusal_to_name(const std::string& own, const std::string& path) {
  const std::string old = own + ".old";
  while (::link(own.c_str(), path.c_str()) != 0) {
    if (errno != EEXIST) return std::nullopt;
    if (Refusal taken = refusal_of_taken(path)) return taken;
    if (::rename(path.c_str(), old.c_str()) != 0) {
      if (errno == ENOENT) continue;
      return std::nullopt;
    }
    if (refusal_of_taken(old)) (void)!::link(old.c_str(), path.c_str());  // of somebody who came in between
    ::unlink(old.c_str());
  }
  return Refusal();
}

}  // namespace

Refusal ControlSocket::open(const std::string& path, mode_t mode, std::optional<gid_t> group) {
  close();
  sockaddr_un address{};
  if (!make_address(path, address)) return path + ": is no path for a socket (1 to 107 characters); choose a shorter one";
  if (Refusal missing = files::refusal_of_missing_folder(path)) return missing;
  if (Refusal taken = refusal_of_taken(path)) return taken;
  const Folder folder(path.substr(0, path.rfind('/') + 1));
  const std::string own = folder.path_of_own();
  std::optional<Refusal> refusal;
  if (folder.is_open() && listen(own, mode, group)) refusal = refusal_to_name(own, path);
  if (!refusal) refusal = path + ": cannot listen there (" + reason() + "); check the folder, its permissions and the group";
  ::unlink(own.c_str());
  if (*refusal)
    close();
  else
    path_ = path;
  return *refusal;
}

/// At a name that no tool knows: whoever finds the socket under its own name finds somebody behind it.
bool ControlSocket::listen(const std::string& path, mode_t mode, std::optional<gid_t> group) {
  sockaddr_un address{};
  struct stat about {};
  ::unlink(path.c_str());  // of a program that had this number and was killed here
  socket_ = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  const mode_t before = ::umask(0777);  // nobody comes in between bind and chmod
  const bool bound =
      socket_ >= 0 && make_address(path, address) && ::bind(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
  ::umask(before);
  if (!bound || ::lstat(path.c_str(), &about) != 0) return false;
  device_ = about.st_dev;
  inode_ = about.st_ino;
  return (!group || ::chown(path.c_str(), static_cast<uid_t>(-1), *group) == 0) && ::chmod(path.c_str(), mode) == 0 &&
         ::listen(socket_, kQueue) == 0;
}

void ControlSocket::close() {
  struct stat about {};  // somebody may have removed ours, and put another one there
  if (!path_.empty() && ::lstat(path_.c_str(), &about) == 0 && about.st_dev == device_ && about.st_ino == inode_) ::unlink(path_.c_str());
  path_.clear();  // before nobody listens: then the name is anybody's
  if (socket_ >= 0) ::close(socket_);
  socket_ = -1;
}

int ControlSocket::accept() const { return ::accept4(socket_, nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK); }

int connect_to_socket(const std::string& path, int patience_ms) {
  sockaddr_un address{};
  if (!make_address(path, address)) {
    errno = ENAMETOOLONG;
    return -1;
  }
  const int socket = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  if (socket < 0) return -1;
  const timeval patience{patience_ms / 1000, patience_ms % 1000 * 1000}, for_ever{};
  (void)::setsockopt(socket, SOL_SOCKET, SO_SNDTIMEO, &patience, sizeof patience);
  int failed = 0;
  do {
    failed = ::connect(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0 ? 0 : errno;
  } while (failed == EINTR);  // it was stopped for a while, and waits anew
  if (failed != 0) {
    ::close(socket);
    errno = failed;
    return -1;
  }
  (void)::setsockopt(socket, SOL_SOCKET, SO_SNDTIMEO, &for_ever, sizeof for_ever);
  return socket;
}

}  // namespace isotouch::control
