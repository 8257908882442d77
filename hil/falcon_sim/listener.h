/// A Unix socket that listens under a path, and takes its file away at the end.
#pragma once

#include <filesystem>

namespace isotouch::falcon_sim {

/// A file descriptor with one owner.
class Descriptor {
 public:
  explicit Descriptor(int fd = -1) : fd_(fd) {}
  Descriptor(Descriptor&& other) noexcept : fd_(other.release()) {}
  Descriptor& operator=(Descriptor&& other) noexcept;
  ~Descriptor();

  int get() const { return fd_; }
  explicit operator bool() const { return fd_ >= 0; }
  int release();
  void close() { *this = Descriptor(); }

 private:
  int fd_;
};

class Listener {
 public:
  /// type      SOCK_SEQPACKET or SOCK_STREAM
  /// fails     std::runtime_error, a sentence: path too long, somebody listens there, or it cannot be made. A socket file that nobody listens at is replaced.
  Listener(std::filesystem::path path, int type);
  Listener(const Listener&) = delete;
  Listener& operator=(const Listener&) = delete;
  ~Listener();

  int get() const { return socket_.get(); }
  /// Somebody who waits to be let in, without waiting for one; empty when nobody does.
  Descriptor accept() const;

 private:
  std::filesystem::path path_;
  Descriptor socket_;
};

}  // namespace isotouch::falcon_sim
