#include "host/commands/tick_bench.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>

#include "firmware/core/render.h"
#include "firmware/core/tick.h"
#include "host/error.h"
#include "host/evaluate/descent_tick.h"
#include "host/motion/device_in_hand.h"
#include "host/quantiles.h"
#include "host/to_double.h"
#include "shared/tick_io.h"

namespace isotouch::commands {

namespace {

using Clock = std::chrono::steady_clock;

double nanoseconds(Clock::duration d) { return std::chrono::duration<double, std::nano>(d).count(); }

/// The least time that `share` of them do not exceed.
double quantile(std::vector<double>& times, double share) {
  const auto at = times.begin() + static_cast<std::ptrdiff_t>(quantile_place(share, times.size()));
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

/// Memory that takes the place of everything else in the caches.
class Eviction {
 public:
  explicit Eviction(Caches caches) : bytes_(caches == Caches::kCold ? evicted_bytes() : 0) {}

  /// Writes every cache line of it.
  void evict() {
    for (std::size_t at = 0; at < bytes_.size(); at += kLine) {
      volatile unsigned char& line = bytes_[at];  // nobody reads what is written
      line = static_cast<unsigned char>(line + 1);
    }
  }

 private:
  static constexpr std::size_t kLine = 64;
  std::vector<unsigned char> bytes_;
};

/// How long a tick takes. The clock is read once before: its own code and data are not what is measured.
template <class Tick>
Clock::duration time_of(const Tick& tick) {
  const auto before = Clock::now();
  const auto start = std::max(before, Clock::now());
  tick();
  return Clock::now() - start;
}

/// walk(eviction, report)   goes through the whole motion from its start; report(time, touching) for each tick
template <class Walk>
TickTimes measure(Caches caches, const Walk& walk) {
  Eviction none(Caches::kWarm), wanted(caches);
  if (caches == Caches::kWarm) walk(none, [](Clock::duration, bool) {});
  const double empty = clock_cost();
  std::vector<double> times;
  walk(wanted, [&](Clock::duration time, bool touching) {
    if (touching) times.push_back(std::max(nanoseconds(time) - empty, 0.0));
  });
  if (times.empty()) throw InputError("the motion never touches the object: there is nothing to time");
  return {quantile(times, 0.5), quantile(times, 0.99), quantile(times, 0.999), times.size()};
}

}  // namespace

std::size_t evicted_bytes() {
  constexpr std::size_t kLeast = std::size_t{64} << 20;
  const long last_cache = sysconf(_SC_LEVEL3_CACHE_SIZE);  // 0 or below where the system does not know
  return last_cache <= 0 ? kLeast : std::max(kLeast, static_cast<std::size_t>(last_cache) * 5 / 4);
}

TickSettings every_feature() {
  TickSettings settings;
  settings.damping = Damping::of(0.0005);
  settings.friction = Ratio::of(0.3);
  settings.friction_damping = Damping::of(0.001);
  settings.hand_damping = Damping::of(0.002);
  settings.passivity = Damping::of(0.012);
  settings.device_damping = Damping::of(rows::kAssumedDamping);
  settings.weight = Newton::of(0.8);
  settings.delay_ticks = rows::kAssumedDelayTicks;
  return settings;
}

TickTimes time_core(const FieldView& field, const Motion& motion, const TickSettings& settings, Caches caches) {
  std::vector<Input> inputs(motion.size());
  std::transform(motion.begin(), motion.end(), inputs.begin(),
                 [](const Eigen::Vector3d& hip) { return position_input(to_fixed<Mm>(hip)); });
  const core::PositionModel model = core::make_position_model(libnifalcon_model(), settings, 1'000'000, field);
  return measure(caches, [&](Eviction& eviction, const auto& report) {
    core::PositionState state;
    Output out;
    for (const Input& arrived : inputs) {
      eviction.evict();
      const Input input = arrived;  // it has just come in, so it is never cold
      const Clock::duration time = time_of([&] { out = core::render_position(input, field, model, state); });
      report(time, (out.status & kContact) != 0);
    }
  });
}

TickTimes time_device(const FieldView& field, const Motion& motion, const TickSettings& settings, Caches caches) {
  DeviceModel device = libnifalcon_model();
  device.speed_limit = MmPerS::of(10'000);  // a motion's start is a leap
  motion::DeviceInHand hand(device);
  std::vector<Input> inputs(motion.size());
  std::transform(motion.begin(), motion.end(), inputs.begin(),
                 [&](const Eigen::Vector3d& hip) { return hand(position_input(to_fixed<Mm>(hip))); });
  const core::TickModel model = core::make_tick_model(device, settings, 1'000'000);
  return measure(caches, [&](Eviction& eviction, const auto& report) {
    core::TickState state;
    Output out;
    for (const Input& arrived : inputs) {
      eviction.evict();
      const Input input = arrived;  // it has just come in, so it is never cold
      const Clock::duration time = time_of([&] { out = core::tick(input, &field, model, state); });
      report(time, (out.status & kContact) != 0);
    }
  });
}

TickTimes time_published(const published::LevelField& levels, double stiffness, const Motion& motion) {
  return measure(Caches::kWarm, [&](Eviction&, const auto& report) {
    evaluate::DescentTick tick(levels, static_cast<float>(stiffness));
    Eigen::Vector3f force;
    for (const Eigen::Vector3d& hip : motion) {
      const Eigen::Vector3f point = hip.cast<float>();
      const Clock::duration time = time_of([&] { force = tick.force(point); });
      report(time, force != Eigen::Vector3f::Zero());
    }
  });
}

}  // namespace isotouch::commands
