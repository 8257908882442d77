/// A replay for processors and compilers that have no host tool: hil/plain_replay.h on files.
///
///     replay_plain FIELD TRACE [PATCHES]
///
/// Prints {"ticks", "seconds", "hash", "first_difference"} as `isotouch replay --json` does, the difference as a tick number. Exit codes as the
/// tool's: 0 equal to what was recorded, 1 bad input, 2 wrong usage, 3 different.
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <span>
#include <string>
#include <vector>

#include "hil/plain_replay.h"
#include "shared/field_view.h"
#include "shared/patch_chain.h"

namespace {

using namespace isotouch;

/// Nothing where there is no file. No stream: Debian 13's library for WebAssembly has none for files.
std::vector<char> read_file(const char* name) {
  std::vector<char> bytes;
  std::FILE* file = std::fopen(name, "rb");
  if (file == nullptr) return bytes;
  std::array<char, 4096> part;
  for (std::size_t read = 0; (read = std::fread(part.data(), 1, part.size(), file)) > 0;) {
    bytes.insert(bytes.end(), part.begin(), part.begin() + static_cast<std::ptrdiff_t>(read));
  }
  std::fclose(file);
  return bytes;
}

/// The file's bytes behind an 8-byte boundary.
struct Image {
  explicit Image(const std::vector<char>& file) : words((file.size() + 7) / 8), bytes(file.size()) {
    if (!file.empty()) std::memcpy(words.data(), file.data(), file.size());
  }
  std::span<const std::uint8_t> span() const { return {reinterpret_cast<const std::uint8_t*>(words.data()), bytes}; }

  std::vector<std::uint64_t> words;
  std::size_t bytes;
};

int refuse(const char* file, Error why) {
  std::fprintf(stderr, "replay_plain: %s: %s\n", file, describe(why));
  return 1;
}

int replay_files(const char* field_name, const char* trace_name, const char* patches_name) {
  const Image image(read_file(field_name)), trace(read_file(trace_name));
  const Result<FieldView> field = FieldView::parse(image.span());
  if (!field) return refuse(field_name, field.error());
  const Image patches(patches_name != nullptr ? read_file(patches_name) : std::vector<char>{});
  const Result<Patches> checked = check_patches(patches.span(), *field);
  if (!checked) return refuse(patches_name, checked.error());
  std::array<std::vector<std::uint64_t>, 2> words;
  replay::Moves moves{patches.span(), {}};
  for (std::size_t place = 0; place < words.size(); ++place) {
    words[place].resize((checked->largest_image + 7) / 8);
    moves.memory[place] = {reinterpret_cast<std::uint8_t*>(words[place].data()), checked->largest_image};
  }

  const auto started = std::chrono::steady_clock::now();
  const Result<replay::Report> report = replay::run(*field, trace.span(), moves);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
  if (!report) return refuse(trace_name, report.error());
  const std::string first_difference = report->equal ? "null" : std::to_string(report->first_difference);
  std::printf("{\"ticks\": %llu, \"seconds\": %.6f, \"hash\": \"%016llx\", \"first_difference\": %s}\n",
              static_cast<unsigned long long>(report->ticks), seconds, static_cast<unsigned long long>(report->hash),
              first_difference.c_str());
  return report->equal ? 0 : 3;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3 && argc != 4) {
    std::fprintf(stderr, "usage: replay_plain FIELD TRACE [PATCHES]\n");
    return 2;
  }
  return replay_files(argv[1], argv[2], argc == 4 ? argv[3] : nullptr);
}
