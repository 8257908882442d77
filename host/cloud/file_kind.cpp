#include "host/cloud/file_kind.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>

#include "host/cloud/content_kind.h"

namespace isotouch::cloud {
namespace {

using Known = std::pair<std::string_view, FileKind>;

constexpr std::array<Known, 16> kEndings = {{{".ply", FileKind::kPly},
                                             {".obj", FileKind::kObj},
                                             {".stl", FileKind::kStl},
                                             {".pcd", FileKind::kPcd},
                                             {".png", FileKind::kDepthImage},
                                             {".e57", FileKind::kLaserScan},
                                             {".las", FileKind::kLaserScan},
                                             {".laz", FileKind::kLaserScan},
                                             {".xyz", FileKind::kText},
                                             {".xyzn", FileKind::kText},
                                             {".pwn", FileKind::kText},
                                             {".npts", FileKind::kText},
                                             {".pts", FileKind::kText},
                                             {".asc", FileKind::kText},
                                             {".txt", FileKind::kText},
                                             {".csv", FileKind::kText}}};

}  // namespace

FileKind file_kind(const std::filesystem::path& file, std::span<const std::uint8_t> bytes) {
  constexpr std::array<Known, 6> kBegins = {{{"ply\n", FileKind::kPly},
                                             {"ply\r", FileKind::kPly},
                                             {"# .PCD ", FileKind::kPcd},
                                             {"\x89PNG\r\n\x1a\n", FileKind::kDepthImage},
                                             {"ASTM-E57", FileKind::kLaserScan},
                                             {"LASF", FileKind::kLaserScan}}};
  const auto same = [](char a, std::uint8_t b) { return static_cast<std::uint8_t>(a) == b; };
  for (const auto& [begin, kind] : kBegins) {
    if (bytes.size() >= begin.size() && std::equal(begin.begin(), begin.end(), bytes.begin(), same)) return kind;
  }
  std::string ending = file.extension().string();
  for (char& c : ending) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  for (const auto& [known, kind] : kEndings) {
    if (ending == known) return kind;
  }
  return ending.empty() ? content_kind(bytes) : FileKind::kUnknown;
}

std::string endings_of(FileKind kind) {
  std::string list;
  for (const auto& [ending, of] : kEndings) {
    if (of == kind) list += (list.empty() ? "" : ", ") + std::string(ending);
  }
  return list;
}

}  // namespace isotouch::cloud
