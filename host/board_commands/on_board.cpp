#include "host/board_commands/commands.h"

namespace isotouch::commands {

void add_on_board(CLI::App& app, const MakeGodObject& god_object) {
  add_status(app);
  add_latency(app);
  add_watch(app);
  add_upload(app);
  add_fields(app);
  add_set(app);
  add_record(app);
  add_stop(app);
  add_resume(app);
  add_replay(app, god_object);
}

}  // namespace isotouch::commands
