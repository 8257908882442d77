/// The page with an object in one file: it needs no server, and the object can be touched in it.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "host/server/scene.h"

namespace isotouch::server {

/// hello     what a viewer is told first
std::string exported_page(const Scene& scene, const nlohmann::ordered_json& hello);

}  // namespace isotouch::server
