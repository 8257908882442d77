/// isotouch trace show.
#pragma once

#include <CLI/CLI.hpp>
#include <cstddef>
#include <nlohmann/json_fwd.hpp>

#include "host/trace/trace_file.h"

namespace isotouch::commands {

void add_show(CLI::App& trace);

/// A tick as an object: the columns that are shown where none are named.
///
/// tick      0 to size() - 1
nlohmann::ordered_json tick_json(const trace::Trace& trace, std::size_t tick);

}  // namespace isotouch::commands
