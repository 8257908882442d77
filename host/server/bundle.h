/// The built page, as `host/page` was built and as it lies in this program.
#pragma once

#include <string_view>

namespace isotouch::server {

struct BundleFile {
  std::string_view name;  ///< "page.js"
  std::string_view type;  ///< of its content
  std::string_view content;
};

/// nullptr where there is none of this name; the empty name is the page itself.
const BundleFile* bundle_file(std::string_view name);

}  // namespace isotouch::server
