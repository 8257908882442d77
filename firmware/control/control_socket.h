/// The door: a listening local socket with an owner's group and permissions.
#pragma once

#include <sys/types.h>

#include <optional>
#include <string>

#include "shared/files/refusal.h"

namespace isotouch::control {

class ControlSocket {
 public:
  ControlSocket() = default;
  ~ControlSocket() { close(); }
  ControlSocket(const ControlSocket&) = delete;
  ControlSocket& operator=(const ControlSocket&) = delete;

  /// Listens at `path`. A socket there that nobody listens at is replaced; any other file is left alone, and so is a socket of which that is not
  /// known.
  ///
  /// mode      permission bits of the socket's file
  /// group     of the file; nothing = the program's
  /// returns   why it does not listen
  Refusal open(const std::string& path, mode_t mode, std::optional<gid_t> group);

  /// Takes the file away again.
  void close();

  int number() const { return socket_; }
  /// The next connection, non-blocking, or -1.
  int accept() const;

 private:
  int socket_ = -1;
  std::string path_;
};

/// Connects to a local socket, blocking.
///
/// returns   its number, or -1 with `errno` set
int connect_to_socket(const std::string& path);

}  // namespace isotouch::control
