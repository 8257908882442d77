/// isotouch calibrate: a hand holds the grip at a known place, and the controller learns where its device's arms stand at count 0.
#include <array>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <tuple>
#include <vector>

#include "host/board_commands/controller_options.h"
#include "host/board_commands/number_in.h"
#include "host/board_commands/print_json.h"
#include "host/commands/commands.h"
#include "host/error.h"
#include "host/evaluate/calibrate.h"
#include "host/link/controller.h"
#include "host/link/status.h"
#include "host/to_double.h"
#include "shared/files/state_text.h"

namespace isotouch::commands {

namespace {

constexpr double kFarthestApartDeg = 1;  // some 1.2 mm at the grip

struct CalibrateOptions {
  std::string to;
  std::vector<std::tuple<double, double, double>> at;  ///< places, mm
  bool json = false;
};

/// Asks for a posture, waits for Enter (or for the end of the input), and lets the controller measure.
evaluate::Posture hold(link::Controller& controller, const CalibrateOptions& options, std::size_t number, DeviceModel& model,
                       protocol::Text& serial) {
  const auto [x, y, z] = options.at[number];
  std::fprintf(stderr, "%zu of %zu: hold the middle of the grip still at x %.2f, y %.2f, z %.2f mm, then press Enter ", number + 1,
               options.at.size(), x, y, z);
  std::string line;
  std::getline(std::cin, line);
  std::fprintf(stderr, "\nhold still ...\n");
  const protocol::PostureReport measured = controller.posture(model);
  serial = measured.serial;
  evaluate::Posture posture{{x, y, z}, {}};
  for (std::size_t i = 0; i < 3; ++i) posture.counts[i] = std::ldexp(measured.counts[i], -8);
  return posture;
}

void print(const CalibrateOptions& options, const protocol::Calibrate& calibration, const evaluate::AngleCalibration& found) {
  const std::string serial(calibration.serial.view());
  std::array<double, 3> degrees{};
  for (std::size_t i = 0; i < 3; ++i) degrees[i] = degrees_of(calibration.at_zero[i]);
  if (options.json) {
    const nlohmann::ordered_json json{
        {"serial", serial}, {"angle_at_zero_deg", degrees}, {"turned_deg", found.turned_deg}, {"apart_deg", found.apart_deg}};
    print_json(json);
    return;
  }
  std::printf("%s: arms at count 0 at %.3f, %.3f, %.3f degrees (top, right, left), %+.3f, %+.3f, %+.3f from before\n", serial.c_str(),
              degrees[0], degrees[1], degrees[2], found.turned_deg[0], found.turned_deg[1], found.turned_deg[2]);
  if (options.at.size() > 1) std::printf("the places contradict each other by at most %.3f degrees\n", found.apart_deg);
  std::printf("stored, but not in use yet: %s; only then home the device and run isotouch resume\n",
              std::string(files::angles_text(protocol::OtherAngles::kKept)).c_str());
}

/// Before a hand holds anything.
void require_ready(link::Controller& controller, const std::string& to) {
  if (static_cast<protocol::Role>(controller.welcome().role) < protocol::Role::kService)
    throw InputError(to + ": a calibration takes the role service; ask root, or somebody of [control] service_users or service_groups");
  const protocol::DeviceReport device = controller.device();
  if (const auto others = static_cast<protocol::OtherAngles>(device.waits); others != protocol::OtherAngles::kNone)
    throw InputError(to + ": " + std::string(files::angles_text(others)));
  const protocol::StatusReport status = controller.status();
  const auto state = static_cast<SupervisorState>(status.state);
  if (state == SupervisorState::kBoot || state == SupervisorState::kHoming)
    throw InputError(to + ": the device must be homed before it is measured; the state is " + link::sentence(status, device));
  if (state == SupervisorState::kActive) throw InputError(to + ": force is active; run isotouch stop first");
  try {
    (void)controller.fields();  // refused where there is no state folder, which keeps the angles, too
  } catch (const InputError& error) {
    throw InputError(std::string("angles could not be kept: ") + error.what());
  }
  if (device.serial.size == 0) throw InputError(to + ": no device with a serial answers; plug it in, and see what isotouchd prints");
  if (static_cast<protocol::AnglesFrom>(device.from) == protocol::AnglesFrom::kSettings) {
    throw InputError(
        to + ": the controller's settings have angles for this device, which are used instead of measured ones; remove [calibration." +
        std::string(device.serial.view()) + "] from the settings");
  }
}

void run(CalibrateOptions options) {
  link::Controller controller(options.to);
  require_ready(controller, options.to);
  if (options.at.empty()) options.at = {{0, 0, 125}};
  DeviceModel model;
  protocol::Calibrate calibration;
  std::vector<evaluate::Posture> postures;
  for (std::size_t i = 0; i < options.at.size(); ++i) postures.push_back(hold(controller, options, i, model, calibration.serial));
  const auto found = evaluate::calibrate(model, postures);
  if (!found) throw InputError(options.to + ": the device does not reach one of the places; measure from the middle of the motor axes");
  for (const double turned : found->turned_deg) {
    if (std::abs(turned) > kFarthestTurnDeg) {
      throw InputError(options.to + ": an arm would stand " + std::to_string(std::lround(turned)) +
                       " degrees away from its present angle; hold the grip where --at says, or home the device again");
    }
  }
  if (found->apart_deg > kFarthestApartDeg) {
    throw InputError(options.to + ": the places contradict each other; measure them again, or try the other [device] geometry");
  }
  for (std::size_t i = 0; i < 3; ++i) calibration.at_zero[i] = found->at_zero[i].raw();
  controller.calibrate(calibration);
  print(options, calibration, *found);
}

}  // namespace

void add_calibrate(CLI::App& app) {
  auto options = std::make_shared<CalibrateOptions>();
  CLI::App* command = app.add_subcommand(
      "calibrate", "Measure the angles of a device's arms while a hand holds the grip still at known places; no force is given");
  add_address(*command, options->to);
  command
      ->add_option("--at", options->at,
                   "a known place in mm: x right, y up, z towards the person, from the middle of the motor axes; may be given "
                   "several times. Default: 0,0,125")
      ->type_name("X,Y,Z")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(number_in(-300.0, 300.0));
  command->add_flag("--json", options->json, "print one JSON object");
  command->callback([options] { run(*options); });
}

}  // namespace isotouch::commands
