/// Serves faces until a signal asks for the end.
#pragma once

#include <memory>
#include <vector>

#include "hil/falcon_sim/face.h"

namespace isotouch::falcon_sim {

/// From now on SIGINT and SIGTERM end `serve_faces` instead of the program; call it before other threads begin.
void catch_end_signals();

/// Returns after SIGINT or SIGTERM.
void serve_faces(const std::vector<std::unique_ptr<Face>>& faces);

}  // namespace isotouch::falcon_sim
