#include "firmware/control/control_socket.h"

#include <fcntl.h>
#include <sys/file.h>
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

#include "shared/files/is_at.h"
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

/// Whoever holds a folder looks for a socket there and puts its own in the place; the next one waits, for microseconds. A program that is killed meanwhile
/// leaves a file that nobody holds.
class FolderLock {
 public:
  explicit FolderLock(std::string path) : path_(std::move(path)) {
    constexpr int kTries = 100;  // a file system may give one file several numbers
    for (int tries = 0; tries < kTries; ++tries) {
      if (file_ >= 0) ::close(file_);
      file_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0600);
      error_ = file_ < 0 ? errno : 0;
      if (file_ < 0 || ::flock(file_, LOCK_EX) != 0 || files::is_at(file_, path_)) return;  // where there are no locks, none is waited for
    }
  }
  ~FolderLock() {
    if (file_ < 0) return;
    ::unlink(path_.c_str());
    ::close(file_);
  }
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

  /// As `errno`: why its file cannot be made; 0: it can.
  int error() const { return error_; }

 private:
  std::string path_;
  int file_ = -1, error_ = 0;
};

}  // namespace

Refusal ControlSocket::open(const std::string& path, mode_t mode, std::optional<gid_t> group) {
  close();
  sockaddr_un address{};
  if (!make_address(path, address)) return path + ": is no path for a socket (1 to 107 characters); choose a shorter one";
  if (Refusal missing = files::refusal_of_missing_folder(path)) return missing;
  const std::string folder = path.substr(0, path.rfind('/') + 1);
  const std::string fresh = folder + '~';  // not longer than the path
  const FolderLock lock(folder + ".isotouchd.lock");
  for (const std::string& name : {path, fresh}) {
    if (Refusal taken = refusal_of_taken(name)) return taken;
  }
  errno = lock.error();
  if (errno == 0 && listen(fresh, mode, group) && ::rename(fresh.c_str(), path.c_str()) == 0) {
    path_ = path;
    return {};
  }
  const std::string why = reason();
  close();
  return path + ": cannot listen there (" + why + "); check the folder, its permissions and the group";
}

/// At a name that no tool knows: whoever finds the socket under its own name finds somebody behind it.
bool ControlSocket::listen(const std::string& path, mode_t mode, std::optional<gid_t> group) {
  sockaddr_un address{};
  struct stat about {};
  ::unlink(path.c_str());  // of a program that was killed here
  socket_ = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  const mode_t before = ::umask(0777);  // nobody comes in between bind and chmod
  const bool bound =
      socket_ >= 0 && make_address(path, address) && ::bind(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
  ::umask(before);
  if (!bound) return false;
  path_ = path;
  if (::lstat(path.c_str(), &about) != 0) return false;
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
  const timeval patience{patience_ms / 1000, patience_ms % 1000 * 1000}, for_ever{};
  (void)::setsockopt(socket, SOL_SOCKET, SO_SNDTIMEO, &patience, sizeof patience);
  if (socket >= 0 && ::connect(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
    const int why = errno;
    ::close(socket);
    errno = why;
    return -1;
  }
  (void)::setsockopt(socket, SOL_SOCKET, SO_SNDTIMEO, &for_ever, sizeof for_ever);
  return socket;
}

}  // namespace isotouch::control
