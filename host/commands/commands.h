/// The sub-commands that only `isotouch` has, one file each, and the list of all; see `host/board_commands/commands.h`.
#pragma once

#include "host/board_commands/commands.h"

namespace isotouch::commands {

void add_build(CLI::App& app);
void add_info(CLI::App& app);
void add_export(CLI::App& app);
void add_sample(CLI::App& app);
void add_shape(CLI::App& app);
void add_scan(CLI::App& app);
void add_trace(CLI::App& app);
void add_compare(CLI::App& app);
void add_evaluate(CLI::App& app);
void add_bench(CLI::App& app);
void add_render(CLI::App& app);
void add_plot(CLI::App& app);
void add_demo(CLI::App& app);
void add_calibrate(CLI::App& app);
void add_qualify(CLI::App& app);
void add_view(CLI::App& app);
void add_farm(CLI::App& app);
void add_fleet(CLI::App& app);
void add_stream(CLI::App& app);

/// Those of `add_on_board`, with the renderer that only `isotouch` has.
void add_on_desk(CLI::App& app);

struct Command {
  const char* name;  ///< none for several at once
  void (*add)(CLI::App& app);
};

/// All of `isotouch`.
inline constexpr Command kCommands[] = {
    {"build", add_build},     {"info", add_info},   {"export", add_export},   {"sample", add_sample},     {"shape", add_shape},
    {"scan", add_scan},       {"trace", add_trace}, {"compare", add_compare}, {"evaluate", add_evaluate}, {"bench", add_bench},
    {"render", add_render},   {"plot", add_plot},   {"demo", add_demo},       {nullptr, add_on_desk},     {"calibrate", add_calibrate},
    {"qualify", add_qualify}, {"view", add_view},   {"farm", add_farm},       {"fleet", add_fleet},       {"stream", add_stream}};

inline void add_all(CLI::App& app) {
  for (const Command& command : kCommands) command.add(app);
}

}  // namespace isotouch::commands
