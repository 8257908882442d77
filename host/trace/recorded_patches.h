/// The file of patches beside a trace of a field that was patched meanwhile (SPEC.md, section 3.2).
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "host/error.h"
#include "host/trace/trace_file.h"
#include "shared/field_view.h"
#include "shared/result.h"

namespace isotouch::trace {

struct RecordedPatches {
  std::vector<std::uint8_t> bytes;
  std::size_t largest_image = 0;

  /// For the images that they lead to.
  std::array<std::vector<std::uint64_t>, 2> memory() const {
    const std::size_t words = (largest_image + 7) / 8;
    return {std::vector<std::uint64_t>(words), std::vector<std::uint64_t>(words)};
  }
};

/// Where they are: the trace's name with the extension `.patches`; of an unfinished `NAME.trace.part`, `NAME.patches.part`.
std::filesystem::path patches_of(const std::filesystem::path& trace);
/// The same of a trace that was read; it may name another file.
std::filesystem::path patches_of(const Trace& trace);

/// Whether its first tick took a patch over, and the trace names the field after it. What a controller saves at a fault or after a crash may begin so.
bool begins_patched(const Trace& trace);

/// The bytes of that file, as they are. A trace without a tick that takes a patch over has none.
///
/// fails     InputError: the file is not there, nobody kept it, it cannot be read, or the trace names one and needs none
std::optional<std::vector<std::uint8_t>> patch_bytes(const Trace& trace);

/// The same, to be written beside another trace that needs them, too.
///
/// fails     also InputError: standard output has nothing beside it
std::optional<std::vector<std::uint8_t>> patches_for(const std::filesystem::path& other, const Trace& trace);

/// Completes that other trace with them beside it. Neither gets its name where the disk has no room for both.
///
/// patches   none: the trace alone is completed
/// finish    gives the trace its name
/// fails     InputError naming the file that cannot be written, and as `finish`
void finish_with_patches(const std::filesystem::path& trace, const std::optional<std::vector<std::uint8_t>>& patches,
                         const std::function<void()>& finish);

/// Reads and checks them. A trace without a tick that takes a patch over has none.
///
/// field     that the trace was recorded on, or that its patches led to
/// behind    how many of them led to it; only those behind them are returned
/// fails     InputError: the file is not there, or a patch in it is missing, cut, changed or out of order
std::optional<RecordedPatches> read_patches(const Trace& trace, const FieldView& field, std::size_t behind = 0);

/// The memory of patched images, as a `PatchChain` takes it.
std::array<std::span<std::uint8_t>, 2> places(std::array<std::vector<std::uint64_t>, 2>& memory);

/// Of a tick that takes a patch over.
///
/// fails     InputError: the patch is not there, or leads elsewhere
void require_patch(const Result<void>& moved);

}  // namespace isotouch::trace
