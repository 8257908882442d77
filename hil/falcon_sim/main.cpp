/// falcon-sim: a Falcon of numbers behind a local socket, on a virtual machine's USB, or on this machine's own.
#include <isotouch_version.h>
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "hil/falcon_sim/event_loop.h"
#include "hil/falcon_sim/socket_frontend.h"
#include "hil/falcon_sim/usbip_frontend.h"
#include "hil/falcon_sim/usbredir_frontend.h"
#include "host/board_commands/number_in.h"
#include "host/board_commands/number_list.h"
#include "packaging/manual/command_tree.h"

namespace {

using namespace isotouch::falcon_sim;
using namespace isotouch::falcon_model;
namespace fs = std::filesystem;

enum ExitCode : int { kDone = 0, kBadInput = 1, kWrongUsage = 2 };

struct Options {
  fs::path socket, usbredir, vhci, faults;
  std::string hand = "rest", pace = "real", geometry = "libnifalcon";
  std::vector<std::string> quirks;
  std::vector<double> angles;
  Settings device;
};

std::string list(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : " ") + name;
  return text;
}

/// Empty: it is one.
std::string refusal_of_quirk(const std::string& text) {
  try {
    Quirks none;
    set_quirk(none, text);
    return {};
  } catch (const std::invalid_argument& e) {
    return e.what();
  }
}

void add_options(CLI::App& app, Options& o) {
  app.add_option("--socket", o.socket, "listen at this local socket");
  app.add_option("--usbredir", o.usbredir, "listen at this local socket for QEMU's usb-redir");
  app.add_option(
      "--vhci", o.vhci,
      "connect to this machine's own USB through the virtual host controller in this folder, such as /sys/devices/platform/vhci_hcd.0");
  app.add_option("--hand", o.hand, "what the hand does once the device is homed: " + list(motion_names()) + ", none, or a trace file")
      ->capture_default_str();
  app.add_option("--faults", o.faults, "a file with faults, one a line: at PACKET FAULT [ARGUMENTS]");
  app.add_option("--quirk", o.quirks, "a deviation that was seen on real devices; may be given several times: " + list(quirk_names()))
      ->check(refusal_of_quirk);
  app.add_option("--pace", o.pace, "real: replies come at frames of 1 ms; lockstep: replies come at once")
      ->check(CLI::IsMember({"real", "lockstep"}))
      ->capture_default_str();
  app.add_option("--serial", o.device.strings.serial, "the serial number, letters and digits")->capture_default_str();
  app.add_option("--geometry", o.geometry, "which of the published geometries")
      ->check(CLI::IsMember({"libnifalcon", "martin-hillier"}))
      ->capture_default_str();
  isotouch::commands::take_numbers(
      app.add_option("--angle-at-zero", o.angles, "angles of the arms at count 0, degrees; by default the published ones"),
      "TOP,RIGHT,LEFT")
      ->check(isotouch::commands::number_in(0.0, 80.0));
  app.add_option("--mass", o.device.mechanism.mass_kg, "moving mass at the grip, kg")
      ->check(isotouch::commands::number_in(0.01, 10.0))
      ->capture_default_str();
  app.add_option("--damping", o.device.mechanism.damping_n_s_per_m, "damping at the grip, N s/m")
      ->check(isotouch::commands::number_in(0.0, 100.0))
      ->capture_default_str();
  app.add_option("--hand-stiffness", o.device.hand.stiffness_n_per_mm, "stiffness of the hand, N/mm")
      ->check(isotouch::commands::number_in(0.0, 5.0))
      ->capture_default_str();
  app.add_option("--step-ms", o.device.step_ms, "time that passes for the mechanism with each packet, ms")
      ->check(isotouch::commands::number_in(0.1, 10.0))
      ->capture_default_str();
  app.add_option("--hold-ms", o.device.hold_ms, "how long a torque lasts without a packet, ms")
      ->check(isotouch::commands::number_in(1.0, 10000.0))
      ->capture_default_str();
}

Path hand_path(const std::string& hand) {
  if (hand == "none") return {};
  for (const std::string& name : motion_names()) {
    if (hand == name) return scripted_path(name);
  }
  if (!fs::exists(hand))
    throw CLI::ValidationError("--hand " + hand + ": neither a motion (" + list(motion_names()) + ", none) nor a file");
  return recorded_path(hand);
}

Settings settings_of(const Options& o) {
  Settings settings = o.device;
  const std::string& serial = settings.strings.serial;
  const bool plain = std::all_of(serial.begin(), serial.end(),
                                 [](char c) { return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); });
  if (serial.empty() || serial.size() > 16 || !plain)
    throw CLI::ValidationError("--serial " + serial + ": write 1 to 16 letters and digits");
  if (o.geometry == "martin-hillier") {
    settings.mechanism.geometry = martin_hillier_geometry();
    settings.mechanism.transmission = martin_hillier_transmission();
  }
  for (std::size_t i = 0; i < o.angles.size(); ++i) settings.mechanism.transmission.angle_at_zero[i] = radians(o.angles[i]);
  for (const std::string& quirk : o.quirks) set_quirk(settings.quirks, quirk);
  settings.path = hand_path(o.hand);
  if (!o.faults.empty()) {
    std::ifstream in(o.faults);
    if (!in) throw std::runtime_error(o.faults.string() + ": cannot be opened");
    settings.faults = read_faults(in, o.faults.string());
  }
  settings.on_fault = [](const Fault& fault) {
    std::printf("falcon-sim: %s\n", line_of(fault).c_str());
    std::fflush(stdout);
  };
  return settings;
}

void run(const Options& o) {
  if (o.socket.empty() && o.usbredir.empty() && o.vhci.empty())
    throw CLI::ValidationError("nothing could connect to the device: give --socket PATH, --usbredir PATH or --vhci FOLDER");
  const Pace pace = o.pace == "real" ? Pace::kReal : Pace::kLockstep;
  if ((!o.usbredir.empty() || !o.vhci.empty()) && pace == Pace::kLockstep)
    throw CLI::ValidationError("--usbredir and --vhci need --pace real: a kernel's USB has frames of its own");
  PacedDevice device(SimulatedFalcon(settings_of(o)), pace);
  catch_end_signals();
  std::vector<std::unique_ptr<Frontend>> frontends;
  if (!o.socket.empty()) frontends.push_back(std::make_unique<SocketFrontend>(o.socket, device));
  if (!o.usbredir.empty()) frontends.push_back(make_usbredir_frontend(o.usbredir, device));
  if (!o.vhci.empty()) frontends.push_back(make_usbip_frontend(vhci_port(o.vhci), device));
  std::printf("falcon-sim: ready\n");
  std::fflush(stdout);
  serve_frontends(frontends);
  const SimulatedFalcon& falcon = device.falcon();
  const Vector p = falcon.mechanism().position_mm();
  std::printf("falcon-sim: %llu packets, torque until the %lluth, ran out %d times, ", static_cast<unsigned long long>(falcon.packets()),
              static_cast<unsigned long long>(falcon.last_torque_packet()), falcon.firmware().expired());
  std::printf("firmware uploaded %d times, board %s, grip at %.3f %.3f %.3f mm\n", falcon.uploads(), name_of(falcon.board().state()), p.x,
              p.y, p.z);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"A simulated Falcon: chip, boot loader, firmware, mechanism and the hand that holds it. Ends on SIGTERM."};
  Options options;
  app.set_version_flag("--version", "falcon-sim " ISOTOUCH_VERSION ", commit " ISOTOUCH_COMMIT ", " ISOTOUCH_COMPILER,
                       "print version, commit and compiler");
  add_options(app, options);
  if (isotouch::manual::is_asked_for(argc, argv)) return isotouch::manual::print_command(app, ""), kDone;
  try {
    app.parse(argc, argv);
    run(options);
    return kDone;
  } catch (const CLI::ParseError& e) {
    return app.exit(e) == 0 ? kDone : kWrongUsage;
  } catch (const std::exception& e) {
    std::fprintf(stderr, "falcon-sim: %s\n", e.what());
    return kBadInput;
  }
}
