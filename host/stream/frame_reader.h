/// Frames in a stream of bytes, as a camera's program writes them: a line `frame BYTES`, then that many bytes, which are a file as on a disk.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace isotouch::stream {

/// Of one frame: a range image of 8 megapixels with coordinates of 4 bytes takes 96 MiB.
inline constexpr std::size_t kMaxFrameBytes = std::size_t{128} << 20;

class FrameReader {
 public:
  /// Fills the front of a buffer. Returns how many bytes it wrote; none: there are no more.
  using Read = std::function<std::size_t(std::span<std::uint8_t>)>;

  /// name      of the stream, for the sentences
  FrameReader(std::string name, Read read) : name_(std::move(name)), read_(std::move(read)) {}

  /// The bytes of the next frame; there may be none in it. Takes no more memory than twice what has come of it.
  ///
  /// returns   nothing: the stream ended behind a frame
  /// fails     InputError: no line of a frame, more than kMaxFrameBytes, the stream ends within a frame; what `read` throws
  std::optional<std::vector<std::uint8_t>> next();

  /// Frames until now.
  std::size_t count() const { return count_; }

 private:
  static constexpr std::size_t kMaxLine = 32;

  bool read_more();
  std::size_t read_line();
  std::string this_frame() const { return name_ + ": frame " + std::to_string(count_ + 1); }

  std::string name_;
  Read read_;
  std::array<std::uint8_t, 4096> buffer_{};  ///< read and not used: from `used_` to `filled_`
  std::size_t used_ = 0, filled_ = 0;
  std::size_t count_ = 0;
};

}  // namespace isotouch::stream
