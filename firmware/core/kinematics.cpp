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

constexpr Mm kWidest = Mm::of(160);  // of x and y: G stays below 512 mm
constexpr Mm kMax = Mm::of(300);     // of z
constexpr Mm kMaxStep = Mm::of(20);
constexpr Mm kConfirmed = Mm::of(0.001);
constexpr std::uint32_t kPatience = 16;
constexpr std::int64_t kSmallestDeterminant = std::int64_t{50'000} << kDeterminantBits;
constexpr int kMaxResidualBits = 11 + kResidualBits;  // 2048 mm², about 20 mm away; keeps a step's sum below 2^62

constexpr Narrow kMaxGradient = 1 << 25;  // 512 mm: the difference of two products fits a cofactor

using Raw3 = std::array<Narrow, 3>;

/// A length with two more fraction bits than Mm, below 512 mm: its product with a ratio has the Mm in the upper word.
constexpr int kFineBits = 2;
constexpr Narrow fine(Mm length) { return length.raw() * (1 << kFineBits); }
constexpr std::int64_t kHalf = std::int64_t{1} << 31;  // added to such products, it rounds the upper word

/// An arm at its angle: what a closure needs of it wherever the grip is.
struct Arm {
  SineCosine theta;
  std::int64_t along;  // radial - a cosθ, as Mechanism has the first
  Narrow height;       // a sinθ
};

Arm arm_at(Angle angle, const Mechanism& m) {
  const SineCosine theta = sine_cosine(angle);
  return {theta, m.radial - product(fine(m.arm), theta.cosine.raw()), upper_word(product(fine(m.arm), theta.sine.raw()) + kHalf)};
}

/// One leg's closure at a place of the grip.
struct Closure {
  Raw3 gradient;         // G, kGradientBits, below 2^25
  Narrow residual;       // half of what is missing: (E² - X² - Z²) / 2, kResidualBits
  Narrow along, height;  // X and Z
  bool outside;          // |q| was cut
};

/// Hardly ever out of bounds, so one comparison decides; here and below.
Narrow bounded(Narrow g) {
  if (static_cast<std::uint_fast32_t>(g + kMaxGradient) < 2 * kMaxGradient) [[likely]]
    return g;
  return g < 0 ? -kMaxGradient : kMaxGradient - 1;
}

/// missing   E² - X² - Z², mm²
Narrow bounded_residual(std::int64_t missing) {
  constexpr int kShift = 2 * kMmBits - kResidualBits + 1;
  const std::int64_t rounded = missing + (std::int64_t{1} << (kShift - 1));
  if (is_within_bits<kMaxResidualBits + kShift>(rounded)) [[likely]]
    return static_cast<Narrow>(rounded >> kShift);
  return rounded < 0 ? -(1 << kMaxResidualBits) : 1 << kMaxResidualBits;
}

/// Lengths carry kMmBits and are below 512 mm: 2^29. Products of fine ones with ratios are below 2^62.
Closure closure_of(const Vec3<Mm>& hip, const SineCosine& azimuth, const Arm& arm, const Mechanism& m) {
  const Narrow x = fine(hip.x), y = fine(hip.y);
  const Narrow cos_phi = azimuth.cosine.raw(), sin_phi = azimuth.sine.raw();

  const Narrow across = upper_word(m.tangential + product(y, cos_phi) + product(-x, sin_phi));
  const Narrow q = std::clamp<Narrow>(across, -m.reach_across.raw(), m.reach_across.raw());
  const std::int64_t square = m.rod_square - product(q, q);  // 40 fraction bits, between 2^45 and 2^55
  const Reciprocal inverse = inverse_root_of_long(static_cast<std::uint64_t>(square));
  const int zeros = 62 - inverse.shift;                                                   // half of those that lead the square, 4 to 9
  const auto leading = static_cast<std::uint_fast32_t>(square >> 24) << (2 * zeros - 8);  // below 2^32
  const auto root = static_cast<Narrow>(upper_product(leading, static_cast<std::uint_fast32_t>(inverse.mantissa)) >> (zeros - 2));
  const std::int64_t slope = product(q, inverse.mantissa) >> (inverse.shift - kRatioBits);  // q / root, below 8
  const Narrow reach = m.joint.raw() + root;                                                // E, below 200 mm

  const Narrow X = upper_word(arm.along + product(x, cos_phi) + product(y, sin_phi));
  const Narrow Z = hip.z.raw() - arm.height;
  const Narrow T = round_shift_narrow(reach * slope, kRatioBits);  // joint and rod within the model's ranges: below 500 mm

  constexpr int kToGradient = kMmBits + kRatioBits - kGradientBits;
  const std::int64_t missing = product(reach, reach) - (product(X, X) + product(Z, Z));
  return {{bounded(round_shift_narrow(product(X, cos_phi) + product(-T, sin_phi), kToGradient)),
           bounded(round_shift_narrow(product(X, sin_phi) + product(T, cos_phi), kToGradient)), (Z + (1 << 3)) >> 4},
          bounded_residual(missing),
          X,
          Z,
          q != across};
}

/// d
SquareMm lever_of(const Closure& leg, const Arm& arm, Mm length) {
  const Narrow turning =
      round_shift_narrow(product(leg.height, arm.theta.cosine.raw()) + product(-leg.along, arm.theta.sine.raw()), kRatioBits);
  return SquareMm::from_raw(
      static_cast<std::int32_t>(round_shift(product(length.raw(), turning), 2 * kMmBits - SquareMm::kFractionBits)));  // below 2^29
}

using Closures = std::array<Closure, 3>;

/// Factors are raised until the upper word is the result: products below 2^62, what is added to one less by 2^37; the result below 2^31.
Raw3 cross(const Raw3& a, const Raw3& b) {
  constexpr int kRaise = 32 - (2 * kGradientBits - kCofactorBits);
  static_assert(kRaise % 2 == 0);
  const auto raised = [](Narrow g) { return g * (1 << kRaise / 2); };
  const Narrow a0 = raised(a[0]), a1 = raised(a[1]), a2 = raised(a[2]);
  const Narrow b0 = raised(b[0]), b1 = raised(b[1]), b2 = raised(b[2]);
  return {upper_word(product(a1, b2) - product(a2, b1) + kHalf), upper_word(product(a2, b0) - product(a0, b2) + kHalf),
          upper_word(product(a0, b1) - product(a1, b0) + kHalf)};
}

/// The columns of the inverse of the three G, PerMm: cofactors over the determinant.
struct Inverse {
  std::array<Raw3, 3> columns;
  bool near_singular;
  bool negative;  // the determinant
};

Inverse inverse_of(const Closures& legs) {
  const std::array<Raw3, 3> cofactors = {cross(legs[1].gradient, legs[2].gradient), cross(legs[2].gradient, legs[0].gradient),
                                         cross(legs[0].gradient, legs[1].gradient)};
  const Raw3& first = legs[0].gradient;
  const std::int64_t determinant =  // three products below 2^25 * 2^31
      product(first[0], cofactors[0][0]) + product(first[1], cofactors[0][1]) + product(first[2], cofactors[0][2]);
  const std::int64_t size = std::abs(determinant);
  const Reciprocal inverse = reciprocal_of_long(static_cast<std::uint64_t>(std::max(size, kSmallestDeterminant)));
  const Narrow mantissa = determinant < 0 ? -inverse.mantissa : inverse.mantissa;
  constexpr int kFirstShift = 31;  // after it any product fits 32 bits; the whole shift is no less, because the determinant is no smaller
  const int shift = inverse.shift - (PerMm::kFractionBits + kDeterminantBits - kCofactorBits) - kFirstShift;
  const auto column = [&](const Raw3& c) -> Raw3 {
    const auto entry = [&](Narrow cofactor) { return static_cast<Narrow>(product(cofactor, mantissa) >> kFirstShift) >> shift; };
    return {entry(c[0]), entry(c[1]), entry(c[2])};
  };
  return {{column(cofactors[0]), column(cofactors[1]), column(cofactors[2])}, size < kSmallestDeterminant, determinant < 0};
}

/// Newton's step along an axis, no longer than kMaxStep: the sum's upper word tells, before anything is cut off.
Mm limited_step(std::int64_t sum) {
  constexpr int kShift = PerMm::kFractionBits + kResidualBits - kMmBits;
  constexpr Narrow kMaxUpper = kMaxStep.raw() >> (32 - kShift);
  static_assert(kMaxUpper << (32 - kShift) == kMaxStep.raw());
  const std::int64_t rounded = sum + (std::int64_t{1} << (kShift - 1));
  const Narrow upper = upper_word(rounded);
  if (upper >= kMaxUpper) return kMaxStep;
  return upper < -kMaxUpper ? -kMaxStep : Mm::from_raw(static_cast<std::int32_t>(rounded >> kShift));
}

bool is_short(const Vec3<Mm>& step) {
  const auto within = [](Mm v) { return v <= kConfirmed && v >= -kConfirmed; };
  return within(step.x) && within(step.y) && within(step.z);
}

}  // namespace

Mechanism make_mechanism(const DeviceModel& device) {
  const auto offset = [](Mm length) { return std::int64_t{length.raw()} * (std::int64_t{1} << 32) + kHalf; };
  Mechanism m;
  m.arm = device.arm;
  m.joint = device.joint;
  m.radial = offset(device.radial);
  m.tangential = offset(device.tangential);
  m.reach_across = mul<Mm>(device.rod, Ratio::of(0.99));
  m.rod_square = std::int64_t{device.rod.raw()} * device.rod.raw();
  std::int64_t turned = 0;  // sum of the sines from leg to leg, below 2^62
  for (std::size_t i = 0; i < 3; ++i) m.azimuths[i] = sine_cosine(device.legs[i].azimuth);
  for (std::size_t i = 0; i < 3; ++i) {
    const SineCosine &from = m.azimuths[i], &to = m.azimuths[(i + 1) % 3];
    turned += product(from.cosine.raw(), to.sine.raw()) - product(from.sine.raw(), to.cosine.raw());
  }
  m.clockwise = turned < 0;
  return m;
}

Pose follow_pose(const JointAngles& angles, const Mechanism& mechanism, PoseState& state) {
  const std::array<Arm, 3> arms = {arm_at(angles[0], mechanism), arm_at(angles[1], mechanism), arm_at(angles[2], mechanism)};

  Vec3<Mm> hip = state.hip;
  Vec3<Mm> step;
  Closures legs;
  Inverse inverse;
  for (int n = 0; n < kPoseSteps; ++n) {
    for (std::size_t i = 0; i < 3; ++i) legs[i] = closure_of(hip, mechanism.azimuths[i], arms[i], mechanism);
    inverse = inverse_of(legs);
    const auto along = [&](std::size_t axis) {  // three products below 2^31 * 2^27
      return limited_step(product(legs[0].residual, inverse.columns[0][axis]) + product(legs[1].residual, inverse.columns[1][axis]) +
                          product(legs[2].residual, inverse.columns[2][axis]));
    };
    step = {along(0), along(1), along(2)};
    const auto moved = [](Mm from, Mm by) { return Mm::from_raw(from.raw() + by.raw()); };  // both far from 2^31
    hip = {within(moved(hip.x, step.x), kWidest), within(moved(hip.y, step.y), kWidest), within(moved(hip.z, step.z), Mm{}, kMax)};
  }

  const std::array<SquareMm, 3> levers = {lever_of(legs[0], arms[0], mechanism.arm), lever_of(legs[1], arms[1], mechanism.arm),
                                          lever_of(legs[2], arms[2], mechanism.arm)};
  bool inside = inverse.negative == mechanism.clockwise;
  for (std::size_t i = 0; i < 3; ++i) inside = inside && !legs[i].outside && levers[i] > SquareMm{};
  const bool confirmed = inside && is_short(step);
  state.confirmed = confirmed ? std::min<std::uint32_t>(state.confirmed + 1, 2) : 0;
  state.lost = confirmed ? 0 : state.lost + 1;
  if (state.lost >= kPatience) {
    hip = kPoseStart;
    state.lost = 0;
  }
  state.hip = hip;
  const auto column = [&](std::size_t i) -> Vec3<PerMm> {
    const auto entry = [&](std::size_t axis) { return PerMm::from_raw(static_cast<std::int32_t>(inverse.columns[i][axis])); };
    return {entry(0), entry(1), entry(2)};
  };
  return {hip, {{column(0), column(1), column(2)}, levers, inverse.near_singular}, state.confirmed == 2};
}

}  // namespace isotouch::core
