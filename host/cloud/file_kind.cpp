#include "host/cloud/file_kind.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>

#include "host/cloud/content_kind.h"

namespace isotouch::cloud {

FileKind file_kind(const std::filesystem::path& file, std::span<const std::uint8_t> bytes) {
  constexpr std::array<std::string_view, 2> kPlyBegins = {"ply\n", "ply\r"};
  for (const std::string_view begin : kPlyBegins) {
    if (bytes.size() >= begin.size() && std::equal(begin.begin(), begin.end(), bytes.begin())) return FileKind::kPly;
  }
  std::string ending = file.extension().string();
  for (char& c : ending) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  constexpr std::array<std::pair<std::string_view, FileKind>, 11> kEndings = {{{".ply", FileKind::kPly},
                                                                               {".obj", FileKind::kObj},
                                                                               {".stl", FileKind::kStl},
                                                                               {".xyz", FileKind::kText},
                                                                               {".xyzn", FileKind::kText},
                                                                               {".pwn", FileKind::kText},
                                                                               {".npts", FileKind::kText},
                                                                               {".pts", FileKind::kText},
                                                                               {".asc", FileKind::kText},
                                                                               {".txt", FileKind::kText},
                                                                               {".csv", FileKind::kText}}};
  for (const auto& [known, kind] : kEndings) {
    if (ending == known) return kind;
  }
  return ending.empty() ? content_kind(bytes) : FileKind::kUnknown;
}

}  // namespace isotouch::cloud
