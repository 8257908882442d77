#include "hil/falcon_sim/listener.h"

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>

#include "shared/files/missing_folder.h"

namespace isotouch::falcon_sim {

namespace {

sockaddr_un address_of(const std::string& path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (path.empty() || path.size() >= sizeof address.sun_path) {
    throw std::runtime_error(path + ": a socket's path has 1 to " + std::to_string(sizeof address.sun_path - 1) +
                             " bytes; choose a shorter one");
  }
  std::memcpy(address.sun_path, path.c_str(), path.size() + 1);
  return address;
}

[[noreturn]] void refuse(const std::string& path, const char* what) {
  throw std::runtime_error(path + ": " + what + ": " + std::system_category().message(errno));
}

bool somebody_listens(const sockaddr_un& address, int type) {
  const Descriptor probe(::socket(AF_UNIX, type | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  const int failed = ::connect(probe.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address);
  return failed == 0 || errno != ECONNREFUSED;  // full, of another type, or not ours to ask: leave it alone
}

}  // namespace

Descriptor& Descriptor::operator=(Descriptor&& other) noexcept {
  const int old = std::exchange(fd_, other.release());
  if (old >= 0 && old != fd_) ::close(old);
  return *this;
}

Descriptor::~Descriptor() {
  if (fd_ >= 0) ::close(fd_);
}

int Descriptor::release() { return std::exchange(fd_, -1); }

Listener::Listener(std::filesystem::path path, int type)
    : path_(std::move(path)), socket_(::socket(AF_UNIX, type | SOCK_CLOEXEC | SOCK_NONBLOCK, 0)) {
  const std::string name = path_.string();
  const sockaddr_un address = address_of(name);
  if (!socket_) refuse(name, "no socket could be made");
  if (const Refusal missing = files::refusal_of_missing_folder(path_)) throw std::runtime_error(missing.sentence());
  std::error_code ignored;
  const auto kind = std::filesystem::symlink_status(path_, ignored).type();
  if (kind == std::filesystem::file_type::socket) {
    if (somebody_listens(address, type))
      throw std::runtime_error(name + ": another program listens there; choose another path or end that program");
    std::filesystem::remove(path_, ignored);
  }
  if (::bind(socket_.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0)
    refuse(name, "a socket cannot be made there");
  if (::listen(socket_.get(), 4) != 0) refuse(name, "nothing can listen there");
}

Listener::~Listener() {
  std::error_code ignored;
  std::filesystem::remove(path_, ignored);
}

Descriptor Listener::accept() const { return Descriptor(::accept4(socket_.get(), nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK)); }

}  // namespace isotouch::falcon_sim
