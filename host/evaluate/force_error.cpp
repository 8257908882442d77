#include "host/evaluate/force_error.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "firmware/core/render.h"
#include "host/error.h"
#include "host/motion/hand.h"
#include "host/to_double.h"

namespace isotouch::evaluate {

using Eigen::Vector3d;

namespace {

constexpr double kRise = 0.1;                       // s, until the full speed
constexpr double kTurnOfCircle = 0.05;              // radians by which the great circle's axis turns for each radian of the way
const Vector3d kStart = Vector3d(0.36, 0.48, 0.8);  // unit; no axis, plane or diagonal of the grid

}  // namespace

std::vector<ForceSample> slide_on_sphere(const SphereSlide& slide, const ForceTick& tick) {
  const double inner = slide.radius - slide.depth;
  motion::Hand hand({.period_s = slide.period_s}, [&](const Input& input) { tick(to_double(input.hip)); });
  hand.step(slide.centre + (slide.radius + 2) * kStart);
  hand.move(slide.centre + inner * kStart, 25);
  hand.hold(0.1);

  std::vector<ForceSample> samples;
  Vector3d out = kStart;
  Vector3d axis = kStart.cross(Vector3d(0.8, -0.5, 0.3)).normalized();
  const double whole = slide.turns * 2 * std::numbers::pi;
  for (double angle = 0, time = 0; angle < whole; time += slide.period_s) {
    const double step = motion::minimum_jerk((time + slide.period_s) / kRise) * slide.speed * slide.period_s / inner;
    angle += step;
    out = (out + step * axis.cross(out)).normalized();
    axis = (axis + kTurnOfCircle * step * out.cross(axis)).normalized();
    axis = (axis - axis.dot(out) * out).normalized();
    const Vector3d hip = to_double(to_fixed<Mm>(Vector3d(slide.centre + inner * out)));
    const Vector3d arm = hip - slide.centre;
    const double depth = slide.radius - arm.norm();
    samples.push_back({time, tick(hip), slide.stiffness * depth * arm.normalized()});
  }
  return samples;
}

ForceError force_error(const std::vector<ForceSample>& samples) {
  if (samples.empty()) throw InputError("no tick of contact: nothing was compared");
  ForceError error;
  error.ticks = samples.size();
  double squares = 0;
  for (const ForceSample& sample : samples) {
    const double relative = (sample.felt.norm() - sample.exact.norm()) / sample.exact.norm();
    squares += relative * relative;
    const bool none = sample.felt.squaredNorm() == 0;
    const double angle = none ? std::numbers::pi : std::atan2(sample.felt.cross(sample.exact).norm(), sample.felt.dot(sample.exact));
    error.direction_max_deg = std::max(error.direction_max_deg, angle * 180 / std::numbers::pi);
  }
  error.magnitude_rms_pct = 100 * std::sqrt(squares / static_cast<double>(samples.size()));
  return error;
}

ForceTick core_force(const FieldView& field, double period_s) {
  TickSettings settings;
  settings.force_limit = Newton::of(100);
  const auto period_ns = static_cast<std::uint32_t>(period_s * 1e9 + 0.5);
  return [&field, model = core::make_position_model(libnifalcon_model(), settings, period_ns, field),
          state = core::PositionState{}](const Vector3d& hip) mutable {
    return to_double(core::render_position(position_input(to_fixed<Mm>(hip)), field, model, state).force);
  };
}

}  // namespace isotouch::evaluate
