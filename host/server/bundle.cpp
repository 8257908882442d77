#include "host/server/bundle.h"

#include <algorithm>
#include <array>
#include <cstddef>

// The files of the page, byte for byte. The assembler reads them; CMakeLists.txt names the folder, and compiles this again when one of them changes.
#define ISOTOUCH_EMBED(name, file)                                                         \
  __asm__(                                                                                 \
      ".pushsection .rodata\n"                                                             \
      ".global isotouch_" #name "\nisotouch_" #name ":\n.incbin \"" ISOTOUCH_PAGE "/" file \
      "\"\n"                                                                               \
      ".global isotouch_" #name "_end\nisotouch_" #name                                    \
      "_end:\n.byte 0\n"                                                                   \
      ".popsection\n");                                                                    \
  extern "C" const char isotouch_##name[], isotouch_##name##_end[]

ISOTOUCH_EMBED(index, "index.html");
ISOTOUCH_EMBED(script, "page.js");
ISOTOUCH_EMBED(style, "page.css");
ISOTOUCH_EMBED(worker, "touch_worker.js");
ISOTOUCH_EMBED(policy, "policy.txt");
ISOTOUCH_EMBED(core, "../public/touch.wasm");

namespace isotouch::server {

const BundleFile* bundle_file(std::string_view name) {
  const auto between = [](const char* begin, const char* end) { return std::string_view(begin, static_cast<std::size_t>(end - begin)); };
  static const std::array<BundleFile, 6> files = {{
      {"", "text/html; charset=utf-8", between(isotouch_index, isotouch_index_end)},
      {"page.js", "text/javascript; charset=utf-8", between(isotouch_script, isotouch_script_end)},
      {"page.css", "text/css; charset=utf-8", between(isotouch_style, isotouch_style_end)},
      {"touch_worker.js", "text/javascript; charset=utf-8", between(isotouch_worker, isotouch_worker_end)},
      {"policy.txt", "text/plain; charset=utf-8", between(isotouch_policy, isotouch_policy_end)},
      {"touch.wasm", "application/wasm", between(isotouch_core, isotouch_core_end)},
  }};
  const auto found = std::find_if(files.begin(), files.end(), [&](const BundleFile& file) { return file.name == name; });
  return found == files.end() ? nullptr : &*found;
}

}  // namespace isotouch::server
