/// Prints what the controller says by a thread of its own, because a pipe, a terminal or a disk may block whoever writes to it. No other thread of the
/// program waits for whoever reads.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

namespace isotouch::daemon {

class Printer {
 public:
  static constexpr std::size_t kRoom = std::size_t{64} * 1024;  ///< bytes that may wait to be written

  /// descriptor    to write to, such as STDOUT_FILENO; stays open until the program ends
  explicit Printer(int descriptor);
  /// Waits until everything is written, or nothing could be written for half a second. The thread may then stay behind, blocked in its write.
  ~Printer();
  Printer(const Printer&) = delete;
  Printer& operator=(const Printer&) = delete;

  /// Prints a text and the end of a line. A text that finds no room is left out; as soon as there is room, one line says how many were. Any thread but the
  /// tick's: it may allocate, and waits for no reader.
  void say(std::string_view text);

 private:
  struct Queue;
  std::shared_ptr<Queue> queue_;  ///< the thread's, too
};

}  // namespace isotouch::daemon
