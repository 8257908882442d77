/// Keeps the processors awake: while the kernel's file for it is open, no processor enters an idle state that it would leave late.
#pragma once

#include <string>
#include <utility>

namespace isotouch::loop {

class LatencyRequest {
 public:
  /// path      of the character device that takes the longest wake-up time, /dev/cpu_dma_latency; empty: nothing is ever asked for
  explicit LatencyRequest(std::string path) : path_(std::move(path)) {}
  /// As `hold(false)`.
  ~LatencyRequest() { hold(false); }
  LatencyRequest(const LatencyRequest&) = delete;
  LatencyRequest& operator=(const LatencyRequest&) = delete;

  /// Opens the file and asks for a wake-up time of 0 us, or closes it, which ends the request. The kernel does the same when the program ends.
  ///
  /// returns   errno of the last try where the wish is refused, ENOTTY where the path is no character device; 0: it is as wished. A refused wish
  ///           is tried again only after `hold(false)`
  /// tick      no: it opens a file
  int hold(bool wanted);

  bool is_held() const { return file_ >= 0; }

 private:
  std::string path_;
  int file_ = -1;
  int refused_ = 0;
};

}  // namespace isotouch::loop
