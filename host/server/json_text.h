/// JSON as it is sent.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace isotouch::server {

/// Names of files and what stands in them may be anything: what is no UTF-8 becomes U+FFFD.
inline std::string text_of(const nlohmann::ordered_json& json) {
  return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace isotouch::server
