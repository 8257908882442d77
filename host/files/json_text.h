/// JSON as it is printed, sent and written.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace isotouch {

/// Names of files and what stands in them may be anything: what is no UTF-8 becomes U+FFFD.
///
/// indent    spaces a level; -1: all on one line
template <class Json>
std::string json_text(const Json& json, int indent = -1) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

}  // namespace isotouch
