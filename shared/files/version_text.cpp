#include "shared/files/version_text.h"

#include <isotouch_version.h>

#include "shared/field_view.h"
#include "shared/packed_field.h"
#include "shared/protocol.h"
#include "shared/trace.h"

namespace isotouch::files {

namespace {

std::string format(const char* name, unsigned major, unsigned minor) {
  return std::string(name) + " " + std::to_string(major) + "." + std::to_string(minor);
}

}  // namespace

std::string short_version_text(const std::string& program) { return program + " " ISOTOUCH_VERSION ", commit " ISOTOUCH_COMMIT; }

std::string version_text(const std::string& program) {
  return short_version_text(program) + "; formats: " + format("field", image_layout::kMajor, image_layout::kMinorTrilinear) + ", " +
         format("packed field", packed_layout::kForm.major, packed_layout::kForm.minor) + ", " +
         format("trace", trace_layout::kMajor, trace_layout::kMinor) + ", " + format("protocol", protocol::kMajor, protocol::kMinor) +
         "; " ISOTOUCH_COMPILER;
}

}  // namespace isotouch::files
