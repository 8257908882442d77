/// The door for frames on standard input: whatever the pieces in which bytes come, the same frames, and never more bytes than came.
#include <optional>
#include <string>
#include <vector>

#include "host/cloud/source_file.h"
#include "host/error.h"
#include "host/stream/frame_reader.h"
#include "tests/fuzz/input.h"

using namespace isotouch;

namespace {

using Frames = std::vector<std::vector<std::uint8_t>>;

/// returns   the sentence of what was refused; none: it was read to its end
std::optional<std::string> read(std::span<const std::uint8_t> bytes, std::size_t piece, Frames& frames) {
  const auto give = [&bytes, piece](std::span<std::uint8_t> into) {
    const std::size_t count = std::min({piece, into.size(), bytes.size()});
    std::copy_n(bytes.begin(), count, into.begin());
    bytes = bytes.subspan(count);
    return count;
  };
  stream::FrameReader reader("in", give);
  try {
    while (auto frame = reader.next()) frames.push_back(std::move(*frame));
  } catch (const InputError& error) {
    return error.what();
  }
  return std::nullopt;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 1) return 0;
  const std::span<const std::uint8_t> bytes(data + 1, size - 1);
  Frames whole, cut;
  const auto refused = read(bytes, size, whole), refused_cut = read(bytes, 1 + data[0] % 16, cut);
  fuzz::hold(whole == cut && refused == refused_cut, "the pieces do not matter");
  std::size_t sum = 0;
  for (const auto& frame : whole) sum += frame.size();
  fuzz::hold(sum + 8 * whole.size() <= bytes.size(), "frames hold what came");
  for (auto& frame : whole) {
    if (frame.empty()) continue;
    try {
      const cloud::Model model = cloud::SourceFile("in: frame 1", std::move(frame)).points();
      fuzz::hold(model.normals.empty() || model.normals.size() == model.positions.size(), "normals are of positions");
    } catch (const InputError&) {  // refused with a sentence
    }
  }
  return 0;
}
