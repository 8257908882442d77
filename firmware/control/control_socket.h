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
  /// known. The file appears when somebody listens at it, with its permissions; of several programs that open it at once, one does.
  ///
  /// mode      permission bits of the socket's file
  /// group     of the file; nothing = the program's
  /// returns   why it does not listen
  Refusal open(const std::string& path, mode_t mode, std::optional<gid_t> group);

  /// Takes the file away again, if it is still this one's.
  void close();

  int number() const { return socket_; }
  /// The next connection, non-blocking, or -1.
  int accept() const;

 private:
  bool listen(const std::string& path, mode_t mode, std::optional<gid_t> group);

  int socket_ = -1;
  std::string path_;
  dev_t device_ = 0;  ///< with the next: the file that is ours
  ino_t inode_ = 0;
};

constexpr int kLetInMs = 30'000;  ///< until a controller lets in: a queue that is full of those who say the least takes it 13 s

/// Connects to a local socket, blocking.
///
/// patience_ms   with a controller that lets nobody in
/// returns       its number, or -1 with `errno` set; EAGAIN: nobody was let in
int connect_to_socket(const std::string& path, int patience_ms = kLetInMs);

}  // namespace isotouch::control
