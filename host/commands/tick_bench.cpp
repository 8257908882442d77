#include "host/commands/tick_bench.h"

#include <algorithm>
#include <chrono>

#include "firmware/core/render.h"
#include "firmware/core/tick.h"
#include "host/error.h"
#include "host/evaluate/descent_tick.h"
#include "host/motion/device_in_hand.h"
#include "host/to_double.h"
#include "shared/tick_io.h"

namespace isotouch::commands {

namespace {

using Clock = std::chrono::steady_clock;

double nanoseconds(Clock::duration d) { return std::chrono::duration<double, std::nano>(d).count(); }

/// The value below which `share` of the times lie.
double quantile(std::vector<double>& times, double share) {
  const auto at = times.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(times.size() - 1));
  std::nth_element(times.begin(), at, times.end());
  return *at;
}

double clock_cost() {
  std::vector<double> times(10'000);
  for (double& time : times) {
    const auto start = Clock::now();
    time = nanoseconds(Clock::now() - start);
  }
  return quantile(times, 0.5);
}

/// walk(report)   goes through the whole motion from its start; report(time, touching) for each tick
template <class Walk>
TickTimes measure(const Walk& walk) {
  walk([](Clock::duration, bool) {});
  const double empty = clock_cost();
  std::vector<double> times;
  walk([&](Clock::duration time, bool touching) {
    if (touching) times.push_back(std::max(nanoseconds(time) - empty, 0.0));
  });
  if (times.empty()) throw InputError("the motion never touches the object: there is nothing to time");
  return {quantile(times, 0.5), quantile(times, 0.99), quantile(times, 0.999), times.size()};
}

}  // namespace

TickSettings every_feature() {
  TickSettings settings;
  settings.damping = Damping::of(0.0005);
  settings.friction = Ratio::of(0.3);
  settings.friction_damping = Damping::of(0.001);
  settings.hand_damping = Damping::of(0.002);
  settings.passivity = Damping::of(0.012);
  settings.device_damping = Damping::of(0.003);
  settings.weight = Newton::of(0.8);
  settings.delay_ticks = 1;
  return settings;
}

TickTimes time_core(const FieldView& field, const Motion& motion, const TickSettings& settings) {
  std::vector<Input> inputs(motion.size());
  std::transform(motion.begin(), motion.end(), inputs.begin(),
                 [](const Eigen::Vector3d& hip) { return position_input(to_fixed<Mm>(hip)); });
  const core::PositionModel model = core::make_position_model(libnifalcon_model(), settings, 1'000'000, field);
  return measure([&](const auto& report) {
    core::PositionState state;
    for (const Input& input : inputs) {
      const auto start = Clock::now();
      const Output out = core::render_position(input, field, model, state);
      report(Clock::now() - start, (out.status & kContact) != 0);
    }
  });
}

TickTimes time_device(const FieldView& field, const Motion& motion, const TickSettings& settings) {
  DeviceModel device = libnifalcon_model();
  device.speed_limit = MmPerS::of(10'000);  // a motion's start is a leap
  motion::DeviceInHand hand(device);
  std::vector<Input> inputs(motion.size());
  std::transform(motion.begin(), motion.end(), inputs.begin(),
                 [&](const Eigen::Vector3d& hip) { return hand(position_input(to_fixed<Mm>(hip))); });
  const core::TickModel model = core::make_tick_model(device, settings, 1'000'000);
  return measure([&](const auto& report) {
    core::TickState state;
    for (const Input& input : inputs) {
      const auto start = Clock::now();
      const Output out = core::tick(input, &field, model, state);
      report(Clock::now() - start, (out.status & kContact) != 0);
    }
  });
}

TickTimes time_published(const published::LevelField& levels, double stiffness, const Motion& motion) {
  return measure([&](const auto& report) {
    evaluate::DescentTick tick(levels, static_cast<float>(stiffness));
    for (const Eigen::Vector3d& hip : motion) {
      const Eigen::Vector3f point = hip.cast<float>();
      const auto start = Clock::now();
      const Eigen::Vector3f force = tick.force(point);
      report(Clock::now() - start, force != Eigen::Vector3f::Zero());
    }
  });
}

}  // namespace isotouch::commands
