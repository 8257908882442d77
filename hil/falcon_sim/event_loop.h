/// Serves frontends until a signal asks for the end.
#pragma once

#include <memory>
#include <vector>

#include "hil/falcon_sim/frontend.h"

namespace isotouch::falcon_sim {

/// From now on SIGINT and SIGTERM end `serve_frontends` instead of the program; call it before other threads begin.
void catch_end_signals();

/// Returns after SIGINT or SIGTERM.
void serve_frontends(const std::vector<std::unique_ptr<Frontend>>& frontends);

}  // namespace isotouch::falcon_sim
