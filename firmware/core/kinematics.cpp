#include "firmware/core/kinematics.h"

#include <algorithm>
#include <cstdlib>

#include "shared/roots.h"

namespace isotouch::core {

namespace {

constexpr int kMmBits = Mm::kFractionBits;
constexpr int kRatioBits = Ratio::kFractionBits;
constexpr int kGradientBits = 16;  // of G, mm
constexpr int kCofactorBits = 12;  // of its cofactors, mm²
constexpr int kDeterminantBits = kGradientBits + kCofactorBits;
constexpr int kResidualBits = 16;  // of half a closure's residual, mm²

constexpr Mm kWidest = Mm::of(160);   // of x and y: G stays below 512 mm
constexpr Mm kLongest = Mm::of(300);  // of z
constexpr Mm kLongestStep = Mm::of(20);
constexpr Mm kConfirmed = Mm::of(0.001);
constexpr std::uint32_t kPatience = 16;
constexpr std::int64_t kSmallestDeterminant = std::int64_t{50'000} << kDeterminantBits;
constexpr std::int64_t kLargestResidual = std::int64_t{2048} << kResidualBits;  // about 20 mm away; keeps a step's sum below 2^62

using Raw3 = std::array<std::int64_t, 3>;

/// One leg's closure at a place of the grip.
struct Closure {
  Raw3 gradient{};            // G, kGradientBits, below 2^25
  std::int64_t residual = 0;  // half of what is missing: (E² - X² - Z²) / 2, kResidualBits
  std::int64_t lever = 0;     // d, SquareMm
  bool outside = false;       // |q| was cut
};

/// Lengths carry kMmBits and are below 512 mm: 2^29. Products with ratios are below 2^60.
Closure closure_of(const Vec3<Mm>& hip, const SineCosine& azimuth, const SineCosine& theta, const Mechanism& m) {
  const std::int64_t x = hip.x.raw(), y = hip.y.raw(), z = hip.z.raw();
  const std::int64_t cos_phi = azimuth.cosine.raw(), sin_phi = azimuth.sine.raw();
  const std::int64_t cos_theta = theta.cosine.raw(), sin_theta = theta.sine.raw();
  const std::int64_t arm = m.arm.raw();

  const std::int64_t across = round_shift(y * cos_phi - x * sin_phi, kRatioBits) + m.tangential.raw();
  const std::int64_t q = std::clamp<std::int64_t>(across, -m.reach_across.raw(), m.reach_across.raw());
  const std::int64_t square = m.rod_square - q * q;  // 40 fraction bits, between 2^45 and 2^55
  const Reciprocal inverse = inverse_root(static_cast<std::uint64_t>(square));
  const std::int64_t root = ((square >> 24) * inverse.mantissa) >> (inverse.shift - 24);
  const std::int64_t slope = (q * inverse.mantissa) >> (inverse.shift - kRatioBits);  // q / root, below 8
  const std::int64_t reach = m.joint.raw() + root;                                    // E, below 200 mm

  const std::int64_t X = round_shift(x * cos_phi + y * sin_phi - arm * cos_theta, kRatioBits) + m.radial.raw();
  const std::int64_t Z = z - round_shift(arm * sin_theta, kRatioBits);
  const std::int64_t T = round_shift(reach * slope, kRatioBits);

  constexpr int kToGradient = kMmBits + kRatioBits - kGradientBits;
  Closure closure;
  closure.gradient = {round_shift(X * cos_phi - T * sin_phi, kToGradient), round_shift(X * sin_phi + T * cos_phi, kToGradient),
                      round_shift(Z, kMmBits - kGradientBits)};
  const std::int64_t missing = round_shift(reach * reach - X * X - Z * Z, 2 * kMmBits - kResidualBits + 1);
  closure.residual = std::clamp(missing, -kLargestResidual, kLargestResidual);
  closure.lever = round_shift(arm * round_shift(Z * cos_theta - X * sin_theta, kRatioBits), 2 * kMmBits - SquareMm::kFractionBits);
  closure.outside = q != across;
  return closure;
}

/// Products below 2^50, the difference below 2^51; the result below 2^31.
Raw3 cross(const Raw3& a, const Raw3& b) {
  constexpr int kShift = 2 * kGradientBits - kCofactorBits;
  return {round_shift(a[1] * b[2] - a[2] * b[1], kShift), round_shift(a[2] * b[0] - a[0] * b[2], kShift),
          round_shift(a[0] * b[1] - a[1] * b[0], kShift)};
}

/// The columns of the inverse: cofactors over the determinant.
void invert(const std::array<Closure, 3>& legs, Statics& statics) {
  const std::array<Raw3, 3> cofactors = {cross(legs[1].gradient, legs[2].gradient), cross(legs[2].gradient, legs[0].gradient),
                                         cross(legs[0].gradient, legs[1].gradient)};
  std::int64_t determinant = 0;  // three products below 2^25 * 2^31
  for (std::size_t axis = 0; axis < 3; ++axis) determinant += legs[0].gradient[axis] * cofactors[0][axis];
  const std::int64_t size = std::abs(determinant);
  statics.near_singular = size < kSmallestDeterminant;
  const Reciprocal inverse = reciprocal(static_cast<std::uint64_t>(std::max(size, kSmallestDeterminant)));
  const std::int64_t mantissa = determinant < 0 ? -inverse.mantissa : inverse.mantissa;
  const int shift = inverse.shift - (PerMm::kFractionBits + kDeterminantBits - kCofactorBits);  // at least 30
  for (std::size_t leg = 0; leg < 3; ++leg) {
    const auto entry = [&](std::size_t axis) { return PerMm::from_raw(saturate32((cofactors[leg][axis] * mantissa) >> shift)); };
    statics.inverse[leg] = {entry(0), entry(1), entry(2)};
    statics.levers[leg] = SquareMm::from_raw(saturate32(legs[leg].lever));
  }
}

Mm limited_step(std::int64_t sum) {
  constexpr int kShift = PerMm::kFractionBits + kResidualBits - kMmBits;
  return std::clamp(Mm::from_raw(saturate32(round_shift(sum, kShift))), -kLongestStep, kLongestStep);
}

bool is_short(const Vec3<Mm>& step) {
  const auto within = [](Mm v) { return v <= kConfirmed && v >= -kConfirmed; };
  return within(step.x) && within(step.y) && within(step.z);
}

}  // namespace

Mechanism make_mechanism(const DeviceModel& device) {
  Mechanism m;
  m.arm = device.arm;
  m.joint = device.joint;
  m.radial = device.radial;
  m.tangential = device.tangential;
  m.reach_across = mul<Mm>(device.rod, Ratio::of(0.99));
  m.rod_square = std::int64_t{device.rod.raw()} * device.rod.raw();
  for (std::size_t i = 0; i < 3; ++i) m.azimuths[i] = sine_cosine(device.legs[i].azimuth);
  return m;
}

Pose follow_pose(const JointAngles& angles, const Mechanism& mechanism, PoseState& state) {
  std::array<SineCosine, 3> thetas;
  for (std::size_t i = 0; i < 3; ++i) thetas[i] = sine_cosine(angles[i]);

  Pose pose;
  Vec3<Mm> hip = state.hip;
  Vec3<Mm> step;
  bool inside = true;
  for (int n = 0; n < kPoseSteps; ++n) {
    std::array<Closure, 3> legs;
    inside = true;
    for (std::size_t i = 0; i < 3; ++i) {
      legs[i] = closure_of(hip, mechanism.azimuths[i], thetas[i], mechanism);
      inside = inside && !legs[i].outside && legs[i].lever > 0;
    }
    invert(legs, pose.statics);
    const auto along = [&](auto axis) {  // three products below 2^31 * 2^27
      std::int64_t sum = 0;
      for (std::size_t i = 0; i < 3; ++i) sum += legs[i].residual * axis(pose.statics.inverse[i]).raw();
      return limited_step(sum);
    };
    step = {along([](const auto& v) { return v.x; }), along([](const auto& v) { return v.y; }), along([](const auto& v) { return v.z; })};
    hip = hip + step;
    hip = {std::clamp(hip.x, -kWidest, kWidest), std::clamp(hip.y, -kWidest, kWidest), std::clamp(hip.z, Mm{}, kLongest)};
  }

  const bool confirmed = inside && is_short(step);
  state.confirmed = confirmed ? std::min<std::uint32_t>(state.confirmed + 1, 2) : 0;
  state.lost = confirmed ? 0 : state.lost + 1;
  if (state.lost >= kPatience) {
    hip = kPoseStart;
    state.lost = 0;
  }
  state.hip = pose.hip = hip;
  pose.settled = state.confirmed == 2;
  return pose;
}

}  // namespace isotouch::core
