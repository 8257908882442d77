#include "host/commands/output_name.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

#include "host/error.h"

namespace isotouch::commands {

namespace {

constexpr std::array<std::string_view, 22> kKnown = {".itf", ".itfi", ".trace", ".vdb",  ".ply", ".obj",  ".stl",  ".pcd",
                                                     ".e57", ".xyz",  ".pwn",   ".npts", ".csv", ".json", ".html", ".png",
                                                     ".jpg", ".jpeg", ".svg",   ".pdf",  ".gif", ".bmp"};

}  // namespace

void require_form(const std::filesystem::path& out, const std::string& written, const std::string& what, const std::string& instead) {
  std::string ending = out.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (ending == written || std::find(kKnown.begin(), kKnown.end(), ending) == kKnown.end()) return;
  throw InputError(out.string() + ": this command writes " + what + ", whose name ends in " + written + ", and not in " + ending +
                   (instead.empty() ? "" : "; " + instead));
}

}  // namespace isotouch::commands
