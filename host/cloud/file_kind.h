/// Which reader a file is for.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

namespace isotouch::cloud {

enum class FileKind { kPly, kObj, kStl, kText, kPcd, kDepthImage, kLaserScan, kUnknown };

/// A file that begins as a PLY, PNG, E57 or LAS file or with PCL's first line is one, whatever its name; for all others the ending tells, in any case of
/// letters. Without an ending it is the content (content_kind.h).
FileKind file_kind(const std::filesystem::path& file, std::span<const std::uint8_t> bytes);

/// By which a file of this kind is known, for people: ".xyz, .csv".
std::string endings_of(FileKind kind);

}  // namespace isotouch::cloud
