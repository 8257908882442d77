/// What a file is that stands in another's place, by its first bytes. Scans and meshes are not among them: cloud/file_kind.h knows those.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>

namespace isotouch {

enum class FileNature : std::uint8_t {
  kUnknown,
  kField,    ///< an image or a packed field
  kPatches,  ///< of a field
  kTrace,
  kPointer,  ///< what Git leaves in the place of a file that Git LFS keeps
};

FileNature nature_of(std::span<const std::uint8_t> bytes);

/// Of what stands in a file; kUnknown where it cannot be read, or only once.
FileNature nature_of(const std::filesystem::path& file);

/// What to do about FileNature::kPointer, behind the file's name.
inline constexpr const char* kIsPointer = ": is a Git LFS pointer; fetch the file with git lfs pull";

}  // namespace isotouch
