/// isotouch stop and resume: forces off, and on again. Each says what has become of it.
#include <chrono>
#include <cstdio>
#include <memory>
#include <string>
#include <thread>

#include "host/board_commands/commands.h"
#include "host/board_commands/controller_options.h"
#include "host/error.h"
#include "host/link/controller.h"
#include "host/link/status.h"

namespace isotouch::commands {

namespace {

constexpr int kLooks = 50;  ///< one every 20 ms, so 1 s; a tick takes at most 4 ms

/// The state once it is as wanted, or after a second.
template <class Wanted>
protocol::StatusReport wait_for(link::Controller& controller, const Wanted& wanted) {
  protocol::StatusReport status = controller.status();
  for (int look = 0; look < kLooks && !wanted(status); ++look) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    status = controller.status();
  }
  return status;
}

bool has_stopped(const protocol::StatusReport& status) { return (status.faults & kFaultStopped) != 0; }
bool is_out_of_fault(const protocol::StatusReport& status) { return status.faults == 0; }

void stop(const std::string& to) {
  link::Controller controller(to);
  controller.stop();
  const std::uint64_t ticks = controller.status().ticks;
  const protocol::StatusReport status = wait_for(controller, has_stopped);
  if (!has_stopped(status) && status.ticks > ticks)
    throw InputError(to + ": the stop was taken back at once, by a button or another client; the state is " +
                     link::sentence(status, controller.device()));
  if (!has_stopped(status))
    throw InputError(to + ": the controller does not stop: its loop does not run; press the emergency stop, or switch the device off");
  if (const protocol::DeviceReport device = controller.device(); device.waits != 0) {
    std::printf("stopped; the state is %s\n", link::sentence(status, device).c_str());
  } else {
    std::printf("stopped: no force until a button of the grip is pressed or '%s resume --to %s'\n", link::tool_name().c_str(), to.c_str());
  }
}

void resume(const std::string& to) {
  link::Controller controller(to);
  const bool is_needed = !is_out_of_fault(controller.status());
  controller.resume();
  const protocol::StatusReport status = wait_for(controller, is_out_of_fault);
  const std::string sentence = link::sentence(status, controller.device());
  if (!is_out_of_fault(status)) throw InputError(to + ": still in " + sentence);
  std::printf(is_needed ? "resumed; the state is now %s\n" : "there was no fault to leave; the state is %s\n", sentence.c_str());
}

}  // namespace

void add_stop(CLI::App& app) {
  auto to = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand("stop", "Switch the force off from the next tick on, until " + link::tool_name() + " resume");
  add_address(*command, *to);
  command->callback([to] { stop(*to); });
}

void add_resume(CLI::App& app) {
  auto to = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand("resume", "Leave a fault, if its cause is gone; the force rises from zero");
  add_address(*command, *to);
  command->callback([to] { resume(*to); });
}

}  // namespace isotouch::commands
