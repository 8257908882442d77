#include "host/trace/recorded_patches.h"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>
#include <utility>

#include "host/error.h"
#include "host/files/whole_file.h"
#include "host/trace/replay.h"
#include "shared/files/part_file.h"
#include "shared/files/refusal.h"
#include "shared/files/scoped_file.h"
#include "shared/files/sync_folder.h"
#include "shared/files/write_all.h"
#include "shared/patch_chain.h"

namespace isotouch::trace {

std::filesystem::path patches_of(const std::filesystem::path& trace) {
  if (trace.extension() == ".part") return patches_of(std::filesystem::path(trace).replace_extension()) += ".part";
  return std::filesystem::path(trace).replace_extension(".patches");
}

std::filesystem::path patches_of(const Trace& trace) {
  return trace.patches().empty() ? patches_of(trace.path()) : std::filesystem::path(trace.patches());
}

bool begins_patched(const Trace& trace) {
  if (trace.size() == 0) return false;
  const Input first = trace.record(0).input;
  return (first.requests & kRequestMoved) != 0 && first.moved_to == static_cast<std::uint32_t>(trace.header().field_hash);
}

namespace {

/// How many ticks take a patch over that must be known.
std::size_t moves_of(const Trace& trace) {
  std::size_t moves = 0;
  for (std::size_t tick = begins_patched(trace) ? 1 : 0; tick < trace.size(); ++tick) {
    if ((trace.record(tick).input.requests & kRequestMoved) != 0) ++moves;
  }
  return moves;
}

}  // namespace

std::optional<std::vector<std::uint8_t>> patch_bytes(const Trace& trace) {
  const bool is_named = !trace.patches().empty();
  if (moves_of(trace) == 0) {
    if (is_named)
      throw InputError(trace.path() + ": the field was not patched while it was recorded; leave out " + std::string(trace.patches()));
    return std::nullopt;
  }
  const std::filesystem::path file = patches_of(trace);
  if (!std::filesystem::exists(file)) {
    if (!has_beginning(trace)) {
      throw InputError(trace.path() +
                       ": the field was patched in the middle of it, and of the ticks that it saves at a fault or after a crash a " +
                       "controller keeps no patches; look at it with isotouch trace show");
    }
    throw InputError(trace.path() + ": the field was patched while it was recorded, and " + file.string() + " is not there; " +
                     (is_named ? "give the file that was written beside the trace" : "keep that file beside the trace"));
  }
  return read_file(file);
}

std::optional<std::vector<std::uint8_t>> patches_for(const std::filesystem::path& other, const Trace& trace) {
  std::optional<std::vector<std::uint8_t>> bytes = patch_bytes(trace);
  if (bytes && is_standard(other))
    throw InputError(trace.path() +
                     ": its field was patched, and the patches belong into a file beside the trace; write to a file, not to -");
  return bytes;
}

void finish_with_patches(const std::filesystem::path& trace, const std::optional<std::vector<std::uint8_t>>& patches,
                         const std::function<void()>& finish) {
  if (!patches) return finish();
  const std::string file = files::output_place(patches_of(trace)).path, part = file + ".part";
  const auto cannot = [&](const std::string& why) { return InputError(file + ": the patches of the trace cannot be written: " + why); };
  if (const Refusal why = files::may_replace(file)) throw cannot(why.sentence() + "; name the trace otherwise");
  const files::OpenPart opened = files::open_part(part, files::Leftover::kReplace);
  if (opened.refusal) throw cannot(opened.refusal.sentence());
  const ScopedFile open(opened.file);
  try {
    if (!files::write_all(open.number, *patches) || ::fsync(open.number) != 0) throw cannot(std::strerror(errno));
    finish();
    if (std::rename(part.c_str(), file.c_str()) == 0 && files::sync_folder_of(file)) return;
    throw cannot(std::strerror(errno));
  } catch (...) {
    std::remove(part.c_str());
    throw;
  }
}

std::optional<RecordedPatches> read_patches(const Trace& trace, const FieldView& field, std::size_t behind) {
  std::optional<std::vector<std::uint8_t>> bytes = patch_bytes(trace);
  if (!bytes) return std::nullopt;
  const std::size_t moves = moves_of(trace);
  const std::filesystem::path file = patches_of(trace);
  std::size_t begin = 0;
  for (std::size_t n = 0; n < behind; ++n) {
    const auto patch = first_patch(std::span(*bytes).subspan(begin));
    if (patch) begin += patch->patch_bytes();
  }
  RecordedPatches patches{{bytes->begin() + static_cast<std::ptrdiff_t>(begin), bytes->end()}, 0};
  const Result<Patches> found = check_patches(patches.bytes, field);
  if (!found) throw InputError(file.string() + ": " + describe(found.error()) + "; give the file that was written beside the trace");
  if (found->count + behind < moves) {
    throw InputError(file.string() + ": it holds " + std::to_string(found->count + behind) + " patches, and the trace takes " +
                     std::to_string(moves) + " over; give the file that was written beside the trace");
  }
  patches.largest_image = found->largest_image;
  return patches;
}

std::array<std::span<std::uint8_t>, 2> places(std::array<std::vector<std::uint64_t>, 2>& memory) {
  const auto of = [](std::vector<std::uint64_t>& words) {
    return std::span(reinterpret_cast<std::uint8_t*>(words.data()), 8 * words.size());
  };
  return {of(memory[0]), of(memory[1])};
}

void require_patch(const Result<void>& moved) {
  if (moved) return;
  throw InputError(std::string("a tick takes a patch over, and ") + describe(moved.error()) +
                   "; keep the file of patches that was written beside the trace with it");
}

}  // namespace isotouch::trace
