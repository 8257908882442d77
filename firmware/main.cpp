/// isotouchd: reads the command line and runs the controller, again whenever the device that answers has other angles than those in use.
#include <signal.h>  // NOLINT(modernize-deprecated-headers): pthread_sigmask
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <utility>

#include "firmware/daemon/controller.h"
#include "firmware/daemon/ending_signals.h"
#include "firmware/daemon/options.h"
#include "firmware/daemon/printer.h"
#include "firmware/loop/realtime.h"
#include "shared/files/standard_descriptors.h"

namespace isotouch::daemon {
namespace {

int refuse(const char* sentence) {
  std::fprintf(stderr, "isotouchd: %s\n", sentence);
  return 1;
}

/// As docs/stability.md names them.
int exit_code(const Controller& ended) {
  if (ended.ended_by() != 0 && !asks_for_the_end(ended.ended_by())) return 128 + ended.ended_by();
  switch (ended.recording()) {
    case recording::Recorder::Outcome::kAsAsked: return 0;
    case recording::Recorder::Outcome::kEndedEarly: return 4;
    case recording::Recorder::Outcome::kLost: break;
  }
  return 1;
}

int run(const Options& options) {
  settings::LiveSettings live(options.settings);
  const auto variable = [](const char* name) {
    const char* value = std::getenv(name);
    return std::string(value == nullptr ? "" : value);
  };
  Printer printer(STDOUT_FILENO);
  ServiceNotify systemd(variable("NOTIFY_SOCKET"), variable("WATCHDOG_USEC"));
  Controller::Legacy before;
  for (;;) {
    Controller controller(options, live, systemd, printer, std::move(before));
    if (const Refusal refusal = controller.build()) return refuse(refusal.sentence().c_str());
    controller.start();
    const Controller::End end = controller.supervise();
    controller.stop();
    if (end == Controller::End::kOver) {
      printer.say(controller.summary());
      return exit_code(controller);
    }
    before = controller.legacy();
    printer.say("device: the controller starts again with the angles of the device that answers");
  }
}

}  // namespace
}  // namespace isotouch::daemon

int main(int argc, char** argv) {
  using namespace isotouch::daemon;
  isotouch::files::occupy_standard_descriptors();
  isotouch::loop::limit_stacks();
  try {
    Options options;
    int exit_code = 0;
    if (!read_options(argc, argv, options, exit_code)) return exit_code;
    const sigset_t signals = blocked_signals();
    pthread_sigmask(SIG_BLOCK, &signals, nullptr);  // before any thread: they all inherit it, the controller takes them
    return run(options);
  } catch (const std::exception& error) {
    return refuse(error.what());
  }
}
