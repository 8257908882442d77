#include "firmware/core/surface_step.h"

#include <algorithm>
#include <bit>
#include <cstdlib>

#include "shared/roots.h"

namespace isotouch::core {

namespace {

// Raw numbers of 16 fraction bits, Narrow where they are known to fit 32 bits. A checked field may hold any coefficients within ±8 voxels, so |g| <= 16 a
// component (2^20) and |H| <= 32 an entry (2^21) are the worst a sample can be; real fields stay below 2^17. Places are within ±8191 voxels (2^29).
constexpr Narrow kOne = 1 << 16;
constexpr Narrow kMaxTangentStep = kOne * 5 / 4;  // a step along the surface: the spline bends over about one voxel
constexpr Narrow kRestoreFirst = 32;              // a step along the surface gets shorter by this many times the depth: out first
constexpr Narrow kStill = kOne / 256;             // shorter steps are rounding, not motion
constexpr Narrow kMinSlopeSquare = kOne / 64;     // |g|² is taken as at least this: the field flattens in the middle of thin parts
constexpr Narrow kPullLimit = 64 * kOne;          // a pull along the surface beyond this acts like this
constexpr Narrow kDepthLimit = 1024 * kOne;       // the same for the depth where it multiplies curvature
constexpr Narrow kTraceLimit = 8 * kOne;          // curvatures beyond 8 and 16 a voxel are no surface's
constexpr Narrow kDeterminantLimit = 16 * kOne;
constexpr std::int64_t kDividendLimit = std::int64_t{1} << 31;  // what a reciprocal may be multiplied with
constexpr Narrow kLengthLimit = 1 << 30;                        // of a component whose square is taken: three of them fit 63 bits
constexpr Narrow kMinEigenvalue = kOne / 2;  // smallest eigenvalue of the Newton matrix: a step is at most twice the pull
constexpr int kTameBits = 42;                // of a product of two lengths: 1024 square voxels; beyond, wider numbers are needed
constexpr Narrow kMinSpread = kOne / 512;    // half of the least distance that two eigenvalues count with

struct Raw3 {
  Narrow x, y, z;
};

template <class Q>
Raw3 raw(const Vec3<Q>& v) {
  return {v.x.raw(), v.y.raw(), v.z.raw()};
}
Vec3<Voxel> to_voxel(const Raw3& v) {
  const auto voxel = [](Narrow q) { return Voxel::from_raw(static_cast<std::int32_t>(q)); };
  return {voxel(v.x), voxel(v.y), voxel(v.z)};
}

Raw3 operator+(const Raw3& a, const Raw3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Raw3 operator-(const Raw3& a, const Raw3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
std::int64_t sum_of_products(const Raw3& a, const Raw3& b) { return product(a.x, b.x) + product(a.y, b.y) + product(a.z, b.z); }
std::int64_t dot(const Raw3& a, const Raw3& b) { return sum_of_products(a, b) >> 16; }
/// a b with 16 fraction bits, where it is known to fit 32 bits.
Narrow scaled(Narrow a, Narrow b) { return static_cast<Narrow>(product(a, b) >> 16); }
Raw3 scale(const Raw3& v, Narrow factor) { return {scaled(v.x, factor), scaled(v.y, factor), scaled(v.z, factor)}; }
using isotouch::within;
Raw3 within(const Raw3& v, Narrow limit) { return {within(v.x, limit), within(v.y, limit), within(v.z, limit)}; }

/// value / divisor, 16 fraction bits, for |value| < 2^24 and a divisor from 1/64 on, whose shift is 41 at least: raised, so that the upper word is the quotient.
constexpr int kNearBits = 24;
Narrow divide_near(Narrow value, const Reciprocal& divisor) {
  return upper_word(product(value * (1 << (31 - kNearBits)), divisor.mantissa)) >> (divisor.shift - 16 - (1 + kNearBits));
}
/// The same for any value; what does not fit 32 bits acts like the nearest that does, before and after.
[[gnu::noinline]] Narrow divide_far(std::int64_t value, const Reciprocal& divisor) {
  return saturate32(product(saturate32(value), divisor.mantissa) >> (divisor.shift - 16));
}
Narrow divide(std::int64_t value, const Reciprocal& divisor) {
  return is_within_bits<kNearBits>(value) ? divide_near(static_cast<Narrow>(value), divisor) : divide_far(value, divisor);
}

/// part / whole, 16 fraction bits, where |part| <= whole and `over` is 1 / whole: its shift, 59 at most, tells how far the part may be raised.
Narrow ratio(Narrow part, const Reciprocal& over) { return upper_word(product(part << (60 - over.shift), over.mantissa)) >> 12; }

/// The squares of three numbers of 32 bits fit 64 without a sign.
std::uint64_t square_of(const Raw3& v) {
  const auto square = [](Narrow q) { return static_cast<std::uint64_t>(product(q, q)); };
  return square(v.x) + square(v.y) + square(v.z);
}

/// The vector, shortened to `limit` (16 voxels at most) where it is longer. Components beyond 2^30 act like 2^30.
inline Raw3 shorten(const Raw3& any, Narrow limit) {
  std::uint64_t square = square_of(any);
  if (square <= static_cast<std::uint64_t>(product(limit, limit))) return any;
  Raw3 v = any;
  if (square >> 60 != 0) [[unlikely]] {
    v = within(any, kLengthLimit);
    square = square_of(v);
  }
  const Reciprocal inverse_length = inverse_root_of_positive(square);
  const Narrow ratio = share_of_root(limit, inverse_length);  // below 1, 30 fraction bits
  const auto part = [ratio](Narrow q) { return static_cast<Narrow>(product(q, ratio) >> 30); };
  return {part(v.x), part(v.y), part(v.z)};
}

/// The field around the sampled point, φ(p + δ) ≈ φ + g·δ + ½ δᵀHδ.
struct LocalField {
  Narrow distance;
  Raw3 gradient, second, mixed;
  Reciprocal slope_square;  // 1 / |g|²

  explicit LocalField(const FieldSample& s)
      : distance(s.distance.raw()),
        gradient(raw(s.gradient)),
        second(raw(s.second)),
        mixed(raw(s.mixed)),
        slope_square(
            reciprocal32_of_positive(static_cast<std::uint32_t>(std::max(static_cast<Narrow>(dot(gradient, gradient)), kMinSlopeSquare)))) {
  }

  /// H v. |v| components below 2^26: sums below 2^49, the result below 2^31 up to 2^24.
  Raw3 hessian_times(const Raw3& v) const {
    const auto row = [&v](Narrow x, Narrow y, Narrow z) { return static_cast<Narrow>(dot({x, y, z}, v)); };
    return {row(second.x, mixed.z, mixed.y), row(mixed.z, second.y, mixed.x), row(mixed.y, mixed.x, second.z)};
  }
  /// adj(H) v, the cofactors of H; entries up to 2^27.
  Raw3 cofactors(const Raw3& v) const {
    const auto entry = [](Narrow a, Narrow b, Narrow c, Narrow d) { return static_cast<Narrow>((product(a, b) - product(c, d)) >> 16); };
    const Narrow xx = entry(second.y, second.z, mixed.x, mixed.x), yz = entry(mixed.y, mixed.z, mixed.x, second.x);
    const Narrow yy = entry(second.z, second.x, mixed.y, mixed.y), zx = entry(mixed.z, mixed.x, mixed.y, second.y);
    const Narrow zz = entry(second.x, second.y, mixed.z, mixed.z), xy = entry(mixed.x, mixed.y, mixed.z, second.z);
    const auto row = [&v](Narrow x, Narrow y, Narrow z) { return Narrow{saturate32(dot({x, y, z}, v))}; };
    return {row(xx, xy, zx), row(xy, yy, yz), row(zx, yz, zz)};
  }
  /// The part of v along the surface: no longer than v, which is below 2^31.
  Raw3 tangential(const Raw3& v) const { return v - scale(gradient, divide(dot(gradient, v), slope_square)); }
  /// How far a point at `offset` lies above the plane that the sample predicts for the surface.
  std::int64_t clearance(const Raw3& offset) const { return distance + dot(gradient, offset); }
  /// -φ g / |g|², below 2^30
  Raw3 onto_surface() const { return scale(gradient, -divide_near(distance, slope_square)); }
};

/// The step along the surface towards the point closest to the HIP: Newton's on the Lagrangian, within the tangent plane.
///
/// It solves (I - M) δ = pull with M = depth · PHP, P the projection on the plane and depth the multiplier of the constraint. M's eigenvalues
/// μ₁ <= μ₂ come from its trace and determinant within the plane, tr H - gᵀHg/|g|² and gᵀ adj(H) g/|g|² times depth and depth². Near or past a
/// centre of curvature 1 - μ is small or negative; it counts by its size, and as kMinEigenvalue at least, so that the step goes down the distance there
/// too and its length stays bounded (saddle-free Newton). With b = max(|1 - μ|, kMinEigenvalue) and the second eigenvector's projection written through M,
///   step = ( pull + (b₁ - b₂) / ((μ₂ - μ₁) b₂) · (M pull - μ₁ pull) ) / b₁.
Raw3 slide(const LocalField& at, const Raw3& pull, Narrow depth) {
  const Narrow along_normal = within(divide(dot(at.gradient, at.hessian_times(at.gradient)), at.slope_square), kLengthLimit);
  const Narrow plane_trace = within(at.second.x + at.second.y + at.second.z - along_normal, kTraceLimit);
  const Narrow plane_determinant = within(divide(dot(at.gradient, at.cofactors(at.gradient)), at.slope_square), kDeterminantLimit);
  const auto half_trace = static_cast<Narrow>(product(depth, plane_trace) >> 17);                          // below 2^28
  const std::int64_t determinant = product(scaled(depth, plane_determinant), depth) & ~((1LL << 16) - 1);  // 32 fraction bits, below 2^56
  const std::int64_t square = std::max(product(half_trace, half_trace) - determinant, product(kMinSpread, kMinSpread));
  const auto [over_spread, spread] = roots_of(static_cast<std::uint64_t>(square));  // spread: half of μ₂ - μ₁

  const Narrow mu1 = half_trace - spread, mu2 = half_trace + spread;
  const Narrow b1 = std::max<Narrow>(std::abs(kOne - mu1), kMinEigenvalue), b2 = std::max<Narrow>(std::abs(kOne - mu2), kMinEigenvalue);
  const Reciprocal over_b1 = reciprocal32_of_positive(static_cast<std::uint32_t>(b1));
  const Reciprocal over_b2 = reciprocal32_of_positive(static_cast<std::uint32_t>(b2));
  const Narrow share = ratio((b1 - b2) >> 1, over_spread);  // |b₁ - b₂| <= μ₂ - μ₁, so within ±1
  const Narrow factor = upper_word(product(share * (1 << 14), over_b2.mantissa)) >> (over_b2.shift - 34);  // share / b₂, within ±2

  const Raw3 curved = at.tangential(at.hessian_times(pull));
  const auto solved = [&](Narrow pulled, Narrow curved_part) {
    const std::int64_t bent = product(curved_part, depth), straight = product(pulled, mu1);  // M pull and μ₁ pull, below 2^57
    if (is_within_bits<kTameBits>(bent) && is_within_bits<kTameBits>(straight)) [[likely]] {
      const Narrow sum = pulled + scaled(static_cast<Narrow>(bent >> 16) - static_cast<Narrow>(straight >> 16), factor);  // below 2^29
      return upper_word(product(sum * 4, over_b1.mantissa)) >> (over_b1.shift - 46);
    }
    const std::int64_t beyond = (bent >> 16) - (straight >> 16);
    const std::int64_t sum = std::clamp(pulled + ((beyond * factor) >> 16), -kDividendLimit, kDividendLimit);
    return Narrow{saturate32((sum * over_b1.mantissa) >> (over_b1.shift - 16))};
  };
  return {solved(pull.x, curved.x), solved(pull.y, curved.y), solved(pull.z, curved.z)};
}

/// The largest component: a length that needs no root.
Narrow size_of(const Raw3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

/// Halves a step that turns back against the one before it, and trusts none longer beyond the free way until the hand moves or steps agree again.
inline Raw3 without_turning_back(const Raw3& way, StepMemory& memory) {
  const bool turns_back = dot(way, raw(memory.last)) < 0 && size_of(way) > kStill;
  const int halved = turns_back ? 1 : 0;
  const Raw3 taken = {way.x >> halved, way.y >> halved, way.z >> halved};
  const Narrow radius = turns_back ? size_of(taken) : std::min<Narrow>((memory.trust_radius.raw() * 17 + 15) >> 4, memory.ceiling.raw());
  memory.trust_radius = Voxel::from_raw(static_cast<std::int32_t>(radius));
  memory.last = to_voxel(taken);
  return taken;
}

}  // namespace

void project_on_surface(const Vec3<Voxel>& hip, const Vec3<Voxel>& point, const FieldSample& sample, SurfaceProjection& projection) {
  const LocalField at(sample);
  projection.step = to_voxel(at.onto_surface());
  projection.hip_behind = at.clearance(raw(hip) - raw(point)) < 0;
}

void renew_trust_radius(const Vec3<Voxel>& motion, StepMemory& memory) {
  const Narrow moved = size_of(raw(motion));
  if (moved > kStill) memory.last = {};  // turning with the hand is no cycle
  const Narrow radius =
      std::min<Narrow>(std::max<Narrow>(2 * std::min(moved, kMaxTangentStep), memory.trust_radius.raw()), memory.ceiling.raw());
  memory.trust_radius = Voxel::from_raw(static_cast<std::int32_t>(radius));
}

void lower_trust(StepMemory& memory) {
  memory.ceiling = Voxel::from_raw(memory.ceiling.raw() >> 1);
  memory.trust_radius = memory.ceiling;
  memory.last = {};
}

void raise_trust(StepMemory& memory) {
  memory.ceiling = Voxel::from_raw(static_cast<std::int32_t>(std::min<Narrow>(2 * memory.ceiling.raw() + 1, kMaxTangentStep)));
}

void step_towards(const Vec3<Voxel>& hip, const FieldSample& sample, Ratio inverse_slope, StepMemory& memory, Vec3<Voxel>& point) {
  const LocalField at(sample);
  const Raw3 pull = raw(hip) - raw(point);
  const auto free_way = static_cast<Narrow>(product(std::max<Narrow>(at.distance, 0), inverse_slope.raw()) >> Ratio::kFractionBits);
  const Narrow buried = std::max<Narrow>(-at.distance, 0);
  const Narrow safe = free_way + kMaxTangentStep;  // a surface may be this far away, and one step may end that deep
  const std::int64_t clearance = at.clearance(pull);
  const bool in_front = clearance >= 0;

  Raw3 wanted = pull;
  if (!in_front) {
    const Narrow depth = -std::max(divide(clearance, at.slope_square), -kDepthLimit);
    wanted = slide(at, within(at.tangential(pull), kPullLimit), depth);
  }
  const Narrow allowed = memory.trust_radius.raw() + (in_front ? free_way : free_way / 2) - kRestoreFirst * buried;
  const Raw3 way = without_turning_back(shorten(wanted, std::max<Narrow>(0, allowed)), memory);
  if (in_front && buried == 0) {
    point = to_voxel(raw(point) + way);
    return;
  }
  const Raw3 onto = at.onto_surface();
  const Raw3 step = in_front ? way + shorten(onto, safe) : shorten(onto + way, safe);
  point = to_voxel(raw(point) + step);
}

}  // namespace isotouch::core
