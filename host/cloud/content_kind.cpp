#include "host/cloud/content_kind.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include "host/cloud/text_lines.h"
#include "shared/bytes.h"

namespace isotouch::cloud {
namespace {

bool is_binary_stl(std::span<const std::uint8_t> bytes) {
  constexpr std::size_t kHeader = 80;
  return bytes.size() >= kHeader + 4 && bytes.size() == kHeader + 4 + 50 * std::uint64_t{load_le<std::uint32_t>(bytes.data() + kHeader)};
}

}  // namespace

FileKind content_kind(std::span<const std::uint8_t> bytes) {
  if (is_binary_stl(bytes)) return FileKind::kStl;
  constexpr std::array<std::string_view, 11> kObjWords = {"v", "vn", "vt", "vp", "f", "o", "g", "s", "l", "mtllib", "usemtl"};
  TextLines lines("", bytes.first(std::min<std::size_t>(bytes.size(), 1U << 16)));
  for (int looked = 0; looked < 2 && lines.next();) {
    const std::optional<std::string_view> word = lines.field();
    if (!word || word->front() == '#') continue;
    if (*word == "solid" && looked == 0) return FileKind::kStl;
    if (std::find(kObjWords.begin(), kObjWords.end(), *word) != kObjWords.end()) return FileKind::kObj;
    if (as_number(*word)) return FileKind::kText;
    ++looked;  // a line of names, perhaps
  }
  return FileKind::kUnknown;
}

}  // namespace isotouch::cloud
