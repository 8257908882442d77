#include "firmware/daemon/options.h"

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

#include "firmware/control/relay.h"
#include "firmware/falcon/falcon_list.h"
#include "firmware/settings/apply.h"
#include "firmware/settings/read_settings.h"
#include "firmware/settings/table.h"
#include "packaging/manual/command_tree.h"
#include "shared/files/option_values.h"
#include "shared/files/version_text.h"

namespace isotouch::daemon {

namespace {

constexpr int kRefused = 1, kWrongUsage = 2;
constexpr std::uint64_t kMaxTicks = 1'000'000'000'000;

int complain(const std::string& sentence) {
  std::fprintf(stderr, "isotouchd: %s\n", sentence.c_str());
  return kRefused;
}

/// "usb", "usb:SERIAL", "sim:SOCKET", "replay:FILE"
bool read_device(const std::string& text, Options& options) {
  const std::size_t colon = text.find(':');
  const std::string kind = text.substr(0, colon);
  options.name = colon == std::string::npos ? "" : text.substr(colon + 1);
  if (kind == "usb") {
    options.device = Options::Device::kUsb;
    return colon == std::string::npos || !options.name.empty();
  }
  options.device = kind == "sim" ? Options::Device::kSimulated : Options::Device::kRecorded;
  return (kind == "sim" || kind == "replay") && !options.name.empty();
}

/// What takes the place of a run stands alone.
Refusal refusal_of_company(const CLI::App& app) {
  for (const char* alone : {"--check-config", "--print-config", "--list"}) {
    if (app.count(alone) == 0) continue;
    const std::string refusal = std::string(alone) + " stands alone; leave ";
    for (const CLI::Option* other : app.get_options({})) {
      if (other->count() > 0 && !other->check_name(alone)) return refusal + other->get_name() + " out";
    }
    if (const std::vector<CLI::App*> commands = app.get_subcommands(); !commands.empty()) return refusal + commands[0]->get_name() + " out";
  }
  return {};
}

}  // namespace

bool read_options(int argc, char** argv, Options& options, int& exit_code) {
  CLI::App app("The controller: lets a hand feel a field through a force-feedback device", "isotouchd");
  std::string config, check, device = "usb", control, field, record, relay_socket = "/run/isotouch/control";
  bool print = false, list = false;
  app.set_version_flag("--version", files::version_text("isotouchd"), "print version, commit, formats and compiler");
  app.add_option("--config", config, "file with the settings (TOML); see --print-config");
  app.add_option("--check-config", check, "check this settings file and exit");
  app.add_flag("--print-config", print, "print every setting with its default and exit");
  app.add_flag("--list", list, "list the devices that are plugged in and exit");
  app.add_option("--device", device, "the device: usb, usb:SERIAL, sim:SOCKET (a simulated Falcon) or replay:FILE (a recording)")
      ->capture_default_str();
  app.add_option("--control", control, "listen for the host tool at this local socket");
  app.add_option("--field", field, "load this field at the start");
  app.add_option("--record", record, "record to this file from the first tick on");
  app.add_flag("--lockstep", options.lockstep,
               "start one tick for every packet and use no clock, so that a run depends only on the device's answers");
  const auto refusal_of_ticks = [](const std::string& text) { return files::refusal_of_other_number(text, 0, kMaxTicks); };
  app.add_option("--ticks", options.ticks, "end after this many ticks")
      ->transform(CLI::Validator(refusal_of_ticks, "0 to " + std::to_string(kMaxTicks)));
  CLI::App* relay = app.add_subcommand("relay", "copy standard input and output to and from the control socket of a running controller");
  relay->add_option("socket", relay_socket, "its path")->capture_default_str();
  app.footer(
      "Exit codes: 0 done, 1 bad input or a lost recording, 2 wrong usage, 4 the recording ended early; what came until then is kept; "
      "128 + N ended by signal N, which nobody sends on purpose.");  // behind the sub-command, which would take it over
  for (CLI::App* command : {&app, relay}) {
    for (CLI::Option* option : command->get_options({})) {
      if (option->get_expected_max() > 0) option->transform(CLI::Validator(files::refusal_of_empty, ""));
    }
  }
  if (manual::is_asked_for(argc, argv)) return manual::print_command(app, ""), exit_code = 0, false;
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    exit_code = app.exit(error) == 0 ? 0 : kWrongUsage;
    return false;
  }

  if (const Refusal refusal = refusal_of_company(app)) {
    complain(refusal.sentence());
    return exit_code = kWrongUsage, false;
  }
  exit_code = 0;
  if (relay->parsed()) {
    if (const Refusal refusal = control::relay(relay_socket, STDIN_FILENO, STDOUT_FILENO)) exit_code = complain(refusal.sentence());
    return false;
  }
  if (print) std::fputs(settings::default_file().c_str(), stdout);
  if (list) std::printf("%s\n", falcon::explain(falcon::list_falcons()).c_str());
  if (print || list) return false;
  const std::string& file = check.empty() ? config : check;
  if (!file.empty()) {
    Refusal refusal = settings::read_settings(file, options.settings);
    if (!refusal && !settings::device_model(options.settings, {}))
      refusal = file + ": the numbers contradict each other: no device can have them; check [device] and [limits]";
    if (!refusal) {
      if (const Refusal angles = settings::refusal_of_angles(options.settings)) refusal = file + ": " + angles.sentence();
    }
    if (refusal) return exit_code = complain(refusal.sentence()), false;
  }
  if (!check.empty()) return std::printf("%s: good\n", check.c_str()), false;
  if (!read_device(device, options)) {
    complain("--device " + device + ": write usb, usb:SERIAL, sim:SOCKET or replay:FILE");
    return exit_code = kWrongUsage, false;
  }
  if (!control.empty()) options.settings.control = control;
  if (!field.empty()) options.settings.field = field;
  if (!record.empty()) options.settings.record = record, options.numbers_recordings = false;
  if (options.settings.control.empty() && options.settings.field.empty() && options.settings.record.empty()) {
    complain(
        "there is no field to feel (--field or [files] field), and no socket to get one by (--control or [files] control); "
        "give one of them, or a settings file with --config");
    return exit_code = kWrongUsage, false;
  }
  if (options.lockstep && options.device == Options::Device::kUsb) {
    complain("--lockstep is for simulated and recorded devices");
    return exit_code = kWrongUsage, false;
  }
  return true;
}

}  // namespace isotouch::daemon
