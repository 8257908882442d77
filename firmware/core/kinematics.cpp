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

constexpr Narrow kLargestGradient = 1 << 25;  // 512 mm: the difference of two products fits a cofactor

using Raw3 = std::array<Narrow, 3>;

/// One leg's closure at a place of the grip.
struct Closure {
  Raw3 gradient;         // G, kGradientBits, below 2^25
  Narrow residual;       // half of what is missing: (E² - X² - Z²) / 2, kResidualBits
  Narrow along, height;  // X and Z
  bool outside;          // |q| was cut
};

/// Lengths carry kMmBits and are below 512 mm: 2^29. Products with ratios are below 2^60.
Closure closure_of(const Vec3<Mm>& hip, const SineCosine& azimuth, const SineCosine& theta, const Mechanism& m) {
  const Narrow x = hip.x.raw(), y = hip.y.raw(), z = hip.z.raw();
  const Narrow cos_phi = azimuth.cosine.raw(), sin_phi = azimuth.sine.raw();
  const Narrow cos_theta = theta.cosine.raw(), sin_theta = theta.sine.raw();
  const Narrow arm = m.arm.raw();

  const Narrow across = round_shift_narrow(product(y, cos_phi) - product(x, sin_phi), kRatioBits) + m.tangential.raw();
  const Narrow q = std::clamp<Narrow>(across, -m.reach_across.raw(), m.reach_across.raw());
  const std::int64_t square = m.rod_square - product(q, q);  // 40 fraction bits, between 2^45 and 2^55
  const Reciprocal inverse = inverse_root(static_cast<std::uint64_t>(square));
  const auto root = static_cast<Narrow>(product(static_cast<Narrow>(square >> 24), inverse.mantissa) >> (inverse.shift - 24));
  const std::int64_t slope = product(q, inverse.mantissa) >> (inverse.shift - kRatioBits);  // q / root, below 8
  const Narrow reach = m.joint.raw() + root;                                                // E, below 200 mm

  const Narrow X = round_shift_narrow(product(x, cos_phi) + product(y, sin_phi) - product(arm, cos_theta), kRatioBits) + m.radial.raw();
  const Narrow Z = z - round_shift_narrow(product(arm, sin_theta), kRatioBits);
  const Narrow T = round_shift_narrow(reach * slope, kRatioBits);  // joint and rod within the model's ranges: below 500 mm

  constexpr int kToGradient = kMmBits + kRatioBits - kGradientBits;
  const auto bounded = [](Narrow g) { return std::clamp<Narrow>(g, -kLargestGradient, kLargestGradient - 1); };
  const std::int64_t missing = round_shift(product(reach, reach) - product(X, X) - product(Z, Z), 2 * kMmBits - kResidualBits + 1);
  return {{bounded(round_shift_narrow(product(X, cos_phi) - product(T, sin_phi), kToGradient)),
           bounded(round_shift_narrow(product(X, sin_phi) + product(T, cos_phi), kToGradient)), (Z + (1 << 3)) >> 4},
          static_cast<Narrow>(std::clamp(missing, -kLargestResidual, kLargestResidual)),
          X,
          Z,
          q != across};
}

/// d
SquareMm lever_of(const Closure& leg, const SineCosine& theta, Mm arm) {
  const Narrow turning = round_shift_narrow(product(leg.height, theta.cosine.raw()) - product(leg.along, theta.sine.raw()), kRatioBits);
  return SquareMm::from_raw(
      static_cast<std::int32_t>(round_shift(product(arm.raw(), turning), 2 * kMmBits - SquareMm::kFractionBits)));  // below 2^29
}

using Closures = std::array<Closure, 3>;

/// Products below 2^50, the difference below 2^51; the result below 2^31.
Raw3 cross(const Raw3& a, const Raw3& b) {
  constexpr int kShift = 2 * kGradientBits - kCofactorBits;
  return {round_shift_narrow(product(a[1], b[2]) - product(a[2], b[1]), kShift),
          round_shift_narrow(product(a[2], b[0]) - product(a[0], b[2]), kShift),
          round_shift_narrow(product(a[0], b[1]) - product(a[1], b[0]), kShift)};
}

/// The columns of the inverse: cofactors over the determinant.
void invert(const Closures& legs, Statics& statics) {
  const std::array<Raw3, 3> cofactors = {cross(legs[1].gradient, legs[2].gradient), cross(legs[2].gradient, legs[0].gradient),
                                         cross(legs[0].gradient, legs[1].gradient)};
  const Raw3& first = legs[0].gradient;
  const std::int64_t determinant =  // three products below 2^25 * 2^31
      product(first[0], cofactors[0][0]) + product(first[1], cofactors[0][1]) + product(first[2], cofactors[0][2]);
  const std::int64_t size = std::abs(determinant);
  statics.near_singular = size < kSmallestDeterminant;
  const Reciprocal inverse = reciprocal(static_cast<std::uint64_t>(std::max(size, kSmallestDeterminant)));
  const Narrow mantissa = determinant < 0 ? -inverse.mantissa : inverse.mantissa;
  constexpr int kFirstShift = 31;  // after it any product fits 32 bits; the whole shift is no less, because the determinant is no smaller
  const int shift = inverse.shift - (PerMm::kFractionBits + kDeterminantBits - kCofactorBits) - kFirstShift;
  for (std::size_t leg = 0; leg < 3; ++leg) {
    const auto entry = [&](std::size_t axis) {
      return PerMm::from_raw(
          static_cast<std::int32_t>(static_cast<Narrow>(product(cofactors[leg][axis], mantissa) >> kFirstShift) >> shift));
    };
    statics.inverse[leg] = {entry(0), entry(1), entry(2)};
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
  const std::array<SineCosine, 3> thetas = {sine_cosine(angles[0]), sine_cosine(angles[1]), sine_cosine(angles[2])};

  Pose pose;
  Vec3<Mm> hip = state.hip;
  Vec3<Mm> step;
  Closures legs;
  for (int n = 0; n < kPoseSteps; ++n) {
    for (std::size_t i = 0; i < 3; ++i) legs[i] = closure_of(hip, mechanism.azimuths[i], thetas[i], mechanism);
    invert(legs, pose.statics);
    const auto along = [&](auto axis) {  // three products below 2^31 * 2^27
      std::int64_t sum = 0;
      for (std::size_t i = 0; i < 3; ++i) sum += product(legs[i].residual, axis(pose.statics.inverse[i]).raw());
      return limited_step(sum);
    };
    step = {along([](const auto& v) { return v.x; }), along([](const auto& v) { return v.y; }), along([](const auto& v) { return v.z; })};
    hip = hip + step;
    hip = {std::clamp(hip.x, -kWidest, kWidest), std::clamp(hip.y, -kWidest, kWidest), std::clamp(hip.z, Mm{}, kLongest)};
  }

  bool inside = true;
  for (std::size_t i = 0; i < 3; ++i) {
    pose.statics.levers[i] = lever_of(legs[i], thetas[i], mechanism.arm);
    inside = inside && !legs[i].outside && pose.statics.levers[i] > SquareMm{};
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
