/// The other end of a local socket, for tests.
#pragma once

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <string>

#include "hil/falcon_sim/listener.h"

namespace isotouch::falcon_sim {

/// A path short enough for a socket, of this process alone.
inline std::filesystem::path socket_path(const std::string& name) {
  return std::filesystem::temp_directory_path() / ("isotouch-" + name + "-" + std::to_string(::getpid()) + ".sock");
}

/// A connected socket, or an empty one.
inline Descriptor connect_to(const std::filesystem::path& path, int type) {
  Descriptor socket(::socket(AF_UNIX, type | SOCK_NONBLOCK, 0));
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::strncpy(address.sun_path, path.c_str(), sizeof address.sun_path - 1);
  if (::connect(socket.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) socket.close();
  return socket;
}

}  // namespace isotouch::falcon_sim
