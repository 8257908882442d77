#include "host/stream/frame_reader.h"

#include <algorithm>
#include <charconv>
#include <string_view>

#include "host/error.h"

namespace isotouch::stream {

namespace {

constexpr std::string_view kWord = "frame ";
constexpr std::size_t kFirstPart = std::size_t{1} << 20;  // of a frame, before more memory is taken for it

/// What the bytes at the begin of a stream look like, for whoever forgot the line.
const char* looks_like(std::string_view begin) {
  if (begin.starts_with("ply")) return "a PLY file";
  if (begin.starts_with("# .PCD")) return "a PCD file";
  return nullptr;
}

}  // namespace

bool FrameReader::read_more() {
  used_ = 0;
  filled_ = read_(buffer_);
  return filled_ > 0;
}

/// The number in the line of the next frame.
std::size_t FrameReader::read_line() {
  std::string line;
  bool has_ended = false;
  while (!has_ended && line.size() < kMaxLine && !(line.size() == kWord.size() && line != kWord)) {
    if (used_ == filled_ && !read_more()) throw InputError(this_frame() + ": the stream ends within its first line");
    line += static_cast<char>(buffer_[used_++]);
    has_ended = line.back() == '\n';
  }
  if (has_ended) line.pop_back();
  if (line.ends_with('\r')) line.pop_back();
  std::size_t bytes = 0;
  const std::string_view number = std::string_view(line).substr(std::min(kWord.size(), line.size()));
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), bytes);
  if (!has_ended || !line.starts_with(kWord) || number.empty() || end != number.data() + number.size() ||
      error == std::errc::invalid_argument) {
    const char* file = looks_like(line);
    throw InputError(this_frame() + (file != nullptr ? std::string(" begins as ") + file + " does" : " does not begin as a frame") +
                     "; write a line 'frame BYTES' before the bytes of each frame");
  }
  if (error != std::errc{} || bytes > kMaxFrameBytes)
    throw InputError(this_frame() + ": its first line announces more than " + std::to_string(kMaxFrameBytes >> 20) +
                     " MiB, the largest frame that is taken; send a smaller image, or only the part with the object");
  return bytes;
}

std::optional<std::vector<std::uint8_t>> FrameReader::next() {
  if (used_ == filled_ && !read_more()) return std::nullopt;
  const std::size_t bytes = read_line();
  std::vector<std::uint8_t> frame;
  while (frame.size() < bytes) {
    const std::size_t have = frame.size(), wanted = std::min(bytes - have, std::max(have, kFirstPart));
    frame.resize(have + wanted);
    std::size_t got = std::min(wanted, filled_ - used_);
    std::copy_n(buffer_.begin() + static_cast<std::ptrdiff_t>(used_), got, frame.begin() + static_cast<std::ptrdiff_t>(have));
    used_ += got;
    while (got < wanted) {
      const std::size_t more = read_(std::span(frame).subspan(have + got));
      if (more == 0)
        throw InputError(this_frame() + ": the stream ends after " + std::to_string(have + got) + " of its " + std::to_string(bytes) +
                         " bytes; the program that writes it was stopped, or announces too many");
      got += more;
    }
  }
  ++count_;
  return frame;
}

}  // namespace isotouch::stream
