/// Standard input as a source of frames.
#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "host/cloud/read_cloud.h"
#include "host/error.h"
#include "host/files/whole_file.h"
#include "host/stream/frame_reader.h"
#include "host/stream/sources.h"

namespace isotouch::stream {

namespace {

/// Waits for bytes as long as somebody takes frames.
std::size_t read_some(std::span<std::uint8_t> into, const Inbox& inbox) {
  constexpr int kAsksMs = 50;
  for (;;) {
    if (inbox.is_closed()) return 0;
    pollfd wanted{STDIN_FILENO, POLLIN, 0};
    if (poll(&wanted, 1, kAsksMs) <= 0) continue;  // a signal, too: is anybody still there?
    const ssize_t got = ::read(STDIN_FILENO, into.data(), into.size());
    if (got >= 0) return static_cast<std::size_t>(got);
    if (errno != EINTR && errno != EAGAIN) throw InputError(std::string("standard input: ") + std::strerror(errno));
  }
}

}  // namespace

Source standard_input(const cloud::SensorOptions& sensor, bool waits) {
  claim_standard_input();
  return [sensor, waits](Inbox& inbox) {
    FrameReader reader("standard input", [&inbox](std::span<std::uint8_t> into) { return read_some(into, inbox); });
    try {
      while (auto bytes = reader.next()) {
        const bool is_empty = bytes->empty();
        Frame frame{reader.count(),
                    [number = reader.count(), bytes = std::move(*bytes), sensor]() mutable {
                      if (bytes.empty()) return cloud::Model{};  // nothing was seen
                      return cloud::read_frame({"standard input: frame " + std::to_string(number), std::move(bytes), sensor});
                    },
                    {},
                    is_empty};
        if (!(waits ? inbox.hand_over(std::move(frame)) : inbox.offer(std::move(frame)))) return;
      }
    } catch (const InputError&) {
      if (!inbox.is_closed()) throw;  // else it was only left in the middle
    }
  };
}

}  // namespace isotouch::stream
