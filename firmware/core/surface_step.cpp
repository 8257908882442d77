#include "firmware/core/surface_step.h"

#include <algorithm>
#include <bit>
#include <cstdlib>

#include "shared/roots.h"

namespace isotouch::core {

namespace {

// Raw numbers of 16 fraction bits in 64-bit integers. A checked blob may hold any coefficients within ±8 voxels, so |g| <= 16 a component (2^20) and
// |H| <= 32 an entry (2^21) are the worst a sample can be; real fields stay below 2^17.
constexpr std::int64_t kOne = 1 << 16;
constexpr std::int64_t kSlideLimit = kOne * 5 / 4;   // a step along the surface: the spline bends over about one voxel
constexpr std::int64_t kRestoreFirst = 32;           // a step along the surface gets shorter by this many times the depth: out first
constexpr std::int64_t kStill = kOne / 256;          // shorter steps are rounding, not motion
constexpr std::int64_t kMinSlopeSquare = kOne / 64;  // |g|² is taken as at least this: the field flattens in the middle of thin parts
constexpr std::int64_t kPullLimit = 64 * kOne;       // a pull along the surface beyond this acts like this
constexpr std::int64_t kDepthLimit = 1024 * kOne;    // the same for the depth where it multiplies curvature
constexpr std::int64_t kTraceLimit = 8 * kOne;       // curvatures beyond 8 and 16 a voxel are no surface's
constexpr std::int64_t kDeterminantLimit = 16 * kOne;
constexpr std::int64_t kDividendLimit = std::int64_t{1} << 31;  // what a reciprocal may be multiplied with
constexpr std::int64_t kMinBend = kOne / 2;      // smallest eigenvalue of the Newton matrix: a step is at most twice the pull
constexpr std::int64_t kMinSpread = kOne / 512;  // half of the least distance that two eigenvalues count with

struct Raw3 {
  std::int64_t x, y, z;
};

template <class Q>
Raw3 raw(const Vec3<Q>& v) {
  return {v.x.raw(), v.y.raw(), v.z.raw()};
}
Vec3<Voxel> to_voxel(const Raw3& v) {
  return {Voxel::from_raw(saturate32(v.x)), Voxel::from_raw(saturate32(v.y)), Voxel::from_raw(saturate32(v.z))};
}

Raw3 operator+(const Raw3& a, const Raw3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Raw3 operator-(const Raw3& a, const Raw3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
std::int64_t dot(const Raw3& a, const Raw3& b) { return (a.x * b.x + a.y * b.y + a.z * b.z) >> 16; }
Raw3 scale(const Raw3& v, std::int64_t factor) { return {(v.x * factor) >> 16, (v.y * factor) >> 16, (v.z * factor) >> 16}; }
std::int64_t within(std::int64_t value, std::int64_t limit) { return std::clamp(value, -limit, limit); }
Raw3 within(const Raw3& v, std::int64_t limit) { return {within(v.x, limit), within(v.y, limit), within(v.z, limit)}; }

/// value / divisor, 16 fraction bits; |value| beyond 2^31 acts like 2^31.
std::int64_t divide(std::int64_t value, const Reciprocal& divisor) {
  return times(within(value, kDividendLimit), {divisor.mantissa, divisor.shift - 16});
}

/// x / sqrt(x), the square root of a value with 32 fraction bits, with 16: the leading 31 bits of x times the mantissa. x from 1 to 2^62.
std::int64_t root(std::int64_t x, const Reciprocal& inverse_root) {
  const int spare = std::max(0, 33 - std::countl_zero(static_cast<std::uint64_t>(x)));
  return ((x >> spare) * inverse_root.mantissa) >> (inverse_root.shift - spare);
}

/// The vector, shortened to `limit` (16 voxels at most) where it is longer. Components beyond 2^30 act like 2^30: three squares fit 63 bits.
inline Raw3 shorten(const Raw3& any, std::int64_t limit) {
  const Raw3 v = within(any, std::int64_t{1} << 30);
  const std::int64_t square = v.x * v.x + v.y * v.y + v.z * v.z;
  if (square <= limit * limit) return v;
  const Reciprocal inverse_length = inverse_root(static_cast<std::uint64_t>(square));
  const std::int64_t ratio = (limit * inverse_length.mantissa) >> (inverse_length.shift - 30);  // limit / length, 30 fraction bits
  return {(v.x * ratio) >> 30, (v.y * ratio) >> 30, (v.z * ratio) >> 30};
}

/// The field around the sampled point, φ(p + δ) ≈ φ + g·δ + ½ δᵀHδ.
struct LocalField {
  std::int64_t distance;
  Raw3 gradient, second, mixed;
  Reciprocal slope_square;  // 1 / |g|²

  explicit LocalField(const FieldSample& s)
      : distance(s.distance.raw()),
        gradient(raw(s.gradient)),
        second(raw(s.second)),
        mixed(raw(s.mixed)),
        slope_square(reciprocal(static_cast<std::uint64_t>(std::max(dot(gradient, gradient), kMinSlopeSquare)))) {}

  /// H v. |v| components below 2^26: sums below 2^49.
  Raw3 bend(const Raw3& v) const {
    return {(second.x * v.x + mixed.z * v.y + mixed.y * v.z) >> 16, (mixed.z * v.x + second.y * v.y + mixed.x * v.z) >> 16,
            (mixed.y * v.x + mixed.x * v.y + second.z * v.z) >> 16};
  }
  /// adj(H) v, the cofactors of H; entries below 2^27.
  Raw3 cofactors(const Raw3& v) const {
    const std::int64_t xx = (second.y * second.z - mixed.x * mixed.x) >> 16, yz = (mixed.y * mixed.z - mixed.x * second.x) >> 16;
    const std::int64_t yy = (second.z * second.x - mixed.y * mixed.y) >> 16, zx = (mixed.z * mixed.x - mixed.y * second.y) >> 16;
    const std::int64_t zz = (second.x * second.y - mixed.z * mixed.z) >> 16, xy = (mixed.x * mixed.y - mixed.z * second.z) >> 16;
    return {(xx * v.x + xy * v.y + zx * v.z) >> 16, (xy * v.x + yy * v.y + yz * v.z) >> 16, (zx * v.x + yz * v.y + zz * v.z) >> 16};
  }
  /// The part of v along the surface.
  Raw3 tangential(const Raw3& v) const { return v - scale(gradient, divide(dot(gradient, v), slope_square)); }
  /// How far a point at `offset` lies above the plane that the sample predicts for the surface.
  std::int64_t clearance(const Raw3& offset) const { return distance + dot(gradient, offset); }
  /// -φ g / |g|²
  Raw3 onto_surface() const { return scale(gradient, -divide(distance, slope_square)); }
};

/// The step along the surface towards the point closest to the HIP: Newton's on the Lagrangian, within the tangent plane.
///
/// It solves (I - M) δ = pull with M = depth · PHP, P the projection on the plane and depth the multiplier of the constraint. M's eigenvalues
/// μ₁ <= μ₂ come from its trace and determinant within the plane, tr H - gᵀHg/|g|² and gᵀ adj(H) g/|g|² times depth and depth². Near or past a
/// centre of curvature 1 - μ is small or negative; it counts by its size, and as kMinBend at least, so that the step goes down the distance there
/// too and its length stays bounded (saddle-free Newton). With b = max(|1 - μ|, kMinBend) and the second eigenvector's projection written through M,
///   step = ( pull + (b₁ - b₂) / ((μ₂ - μ₁) b₂) · (M pull - μ₁ pull) ) / b₁.
Raw3 slide(const LocalField& at, const Raw3& pull, std::int64_t depth) {
  const std::int64_t plane_trace =
      at.second.x + at.second.y + at.second.z - divide(dot(at.gradient, at.bend(at.gradient)), at.slope_square);
  const std::int64_t plane_determinant = divide(dot(at.gradient, at.cofactors(at.gradient)), at.slope_square);
  const std::int64_t half_trace = (depth * within(plane_trace, kTraceLimit)) >> 17;                                 // below 2^28
  const std::int64_t determinant = (((depth * within(plane_determinant, kDeterminantLimit)) >> 16) * depth) >> 16;  // below 2^40
  const std::int64_t square = std::max(half_trace * half_trace - (determinant << 16), kMinSpread * kMinSpread);
  const Reciprocal over_spread = inverse_root(static_cast<std::uint64_t>(square));
  const std::int64_t spread = root(square, over_spread);  // half of μ₂ - μ₁

  const std::int64_t mu1 = half_trace - spread, mu2 = half_trace + spread;
  const std::int64_t b1 = std::max(std::abs(kOne - mu1), kMinBend), b2 = std::max(std::abs(kOne - mu2), kMinBend);
  const Reciprocal over_b1 = reciprocal(static_cast<std::uint64_t>(b1));
  const Reciprocal over_b2 = reciprocal(static_cast<std::uint64_t>(b2));
  const std::int64_t factor = divide(divide((b1 - b2) >> 1, over_spread), over_b2);  // |b₁ - b₂| <= μ₂ - μ₁, so within ±2

  const Raw3 bent = scale(at.tangential(at.bend(pull)), depth);
  const Raw3 beyond = bent - scale(pull, mu1);
  const Raw3 sum = within(pull + scale(beyond, factor), kDividendLimit);
  const std::int64_t inverse = over_b1.mantissa;
  const int shift = over_b1.shift - 16;
  return {(sum.x * inverse) >> shift, (sum.y * inverse) >> shift, (sum.z * inverse) >> shift};
}

/// The largest component: a length that needs no root.
std::int64_t size_of(const Raw3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

/// Halves a step that turns back against the one before it, and trusts none longer beyond the free way until the hand moves or steps agree again.
Raw3 without_turning_back(const Raw3& way, StepMemory& memory) {
  const bool turns_back = dot(way, raw(memory.last)) < 0 && size_of(way) > kStill;
  const Raw3 taken = turns_back ? Raw3{way.x >> 1, way.y >> 1, way.z >> 1} : way;
  memory.reach = Voxel::from_raw(
      static_cast<std::int32_t>(turns_back ? size_of(taken) : std::min((std::int64_t{memory.reach.raw()} * 17 + 15) >> 4, kSlideLimit)));
  memory.last = to_voxel(taken);
  return taken;
}

}  // namespace

void find_foothold(const Vec3<Voxel>& hip, const Vec3<Voxel>& point, const FieldSample& sample, Foothold& foothold) {
  const LocalField at(sample);
  foothold.step = to_voxel(at.onto_surface());
  foothold.hip_behind = at.clearance(raw(hip) - raw(point)) < 0;
}

void renew_reach(const Vec3<Voxel>& motion, StepMemory& memory) {
  if (size_of(raw(motion)) > kStill) memory.last = {};  // turning with the hand is no cycle
  memory.reach =
      Voxel::from_raw(static_cast<std::int32_t>(std::clamp(2 * size_of(raw(motion)), std::int64_t{memory.reach.raw()}, kSlideLimit)));
}

void step_towards(const Vec3<Voxel>& hip, const FieldSample& sample, Ratio free_share, StepMemory& memory, Vec3<Voxel>& point) {
  const LocalField at(sample);
  const Raw3 pull = raw(hip) - raw(point);
  const std::int64_t free_way = (std::max<std::int64_t>(at.distance, 0) * free_share.raw()) >> Ratio::kFractionBits;
  const std::int64_t buried = std::max<std::int64_t>(-at.distance, 0);
  const std::int64_t safe = free_way + kSlideLimit;  // a surface may be this far away, and one step may end that deep
  const std::int64_t clearance = at.clearance(pull);

  if (clearance >= 0) {
    const std::int64_t allowed = free_way + memory.reach.raw() - kRestoreFirst * buried;
    const Raw3 way = without_turning_back(shorten(pull, std::max<std::int64_t>(0, allowed)), memory);
    point = to_voxel(raw(point) + (buried > 0 ? way + shorten(at.onto_surface(), safe) : way));
    return;
  }
  const std::int64_t depth = std::min(-divide(clearance, at.slope_square), kDepthLimit);
  const Raw3 wanted = slide(at, within(at.tangential(pull), kPullLimit), depth);
  const std::int64_t allowed = memory.reach.raw() + free_way / 2 - kRestoreFirst * buried;
  const Raw3 way = without_turning_back(shorten(wanted, std::max<std::int64_t>(0, allowed)), memory);
  point = to_voxel(raw(point) + shorten(at.onto_surface() + way, safe));
}

}  // namespace isotouch::core
