#include "firmware/core/stiffness_at.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "shared/roots.h"

namespace isotouch::core {

namespace {

using namespace image_layout;

constexpr int kPlaceBits = Voxel::kFractionBits + kBrickShift;           // of a place in units of bricks
constexpr int kWeightBits = 11;                                          // a place to 1/512 voxel; sums along two axes fit 32 bits
constexpr std::int32_t kOne = 1 << kWeightBits;                          // a brick's length, and the sum of three weights
constexpr std::int32_t kFirstFace = -(1 << (Voxel::kFractionBits - 1));  // brick 0, samples 0 to 3, reaches from -0.5 to 3.5

/// One axis of the point: the brick that it lies in, its neighbours, how far it is past the brick's first face and before the last one, and the weights
/// of the neighbours.
struct AxisPlace {
  std::int32_t brick[3];
  std::int32_t past, left;
  std::int32_t before, after;
};

AxisPlace place(Voxel coordinate, std::int32_t size) {
  const std::int32_t last = (size - 1) >> kBrickShift;  // at least 1, at most 1023
  constexpr std::int32_t half = 1 << (kPlaceBits - 1);
  const std::int32_t along = std::clamp<std::int32_t>(coordinate.raw() - kFirstFace, half, (last << kPlaceBits) + half);
  const std::int32_t middle = along >> kPlaceBits;
  const std::int32_t past = (along & ((1 << kPlaceBits) - 1)) >> (kPlaceBits - kWeightBits), left = kOne - past;
  const auto weight = [](std::int32_t t) { return (t * t) >> (kWeightBits + 1); };  // t²/2
  return {
      {std::max<std::int32_t>(middle - 1, 0), middle, std::min<std::int32_t>(middle + 1, last)}, past, left, weight(left), weight(past)};
}

/// The spline through three numbers and its slope a brick: from differences, because the weights' sum is 1 and that of their slopes is 0.
struct Along {
  std::int64_t value, slope;
};
Along along(std::int64_t first, std::int64_t middle, std::int64_t last, const AxisPlace& at) {
  const std::int64_t rise = middle - first, next = last - middle;
  return {(middle << kWeightBits) - rise * at.before + next * at.after, rise * at.left + next * at.past};
}

/// The spline at a point and its slopes a brick, exact.
struct Spline {
  std::int64_t value, x, y, z;  // at most 255 · 2^33
};

/// Two numbers in one, so that the weights are multiplied once: the value of a brick in the lower word, and whether it has one in the upper word.
std::int64_t with_known(std::uint8_t part) { return part + (std::int64_t{part != 0} << 32); }
std::int64_t lower(std::int64_t both) { return static_cast<std::int32_t>(both); }
std::int64_t upper(std::int64_t both) { return (both - lower(both)) >> 32; }

/// What three planes across z give together; below 2^30 in each word, |slopes| too.
struct Planes {
  std::int64_t value[3], x[3], y[3];

  template <class Word>
  Spline along_z(const AxisPlace& z, Word word) const {
    const auto at = [&](const std::int64_t(&of)[3]) { return along(word(of[0]), word(of[1]), word(of[2]), z); };
    const Along values = at(value);
    return {values.value, at(x).value, at(y).value, values.slope};
  }
};

/// Slopes over the value, for one from 2^27 on.
Vec3<PerVoxel> logarithmic_slope(const Spline& s) {
  constexpr int kSpare = 11;                                                // a slope is then below 2^31
  const Reciprocal over = reciprocal(static_cast<std::uint64_t>(s.value));  // shift from 58 to 71
  const auto part = [&](std::int64_t slope) {
    const std::int64_t quotient = product(static_cast<Narrow>(slope >> kSpare), over.mantissa);
    return PerVoxel::from_raw(saturate32(quotient >> (over.shift - kSpare - PerVoxel::kFractionBits + kBrickShift)));
  };
  return {part(s.x), part(s.y), part(s.z)};
}

}  // namespace

StiffnessSample sample_stiffness(const Vec3<Voxel>& point, const FieldView& field) {
  const AxisPlace x = place(point.x, field.size[0]), y = place(point.y, field.size[1]), z = place(point.z, field.size[2]);
  Planes planes;
  for (std::size_t k = 0; k < 3; ++k) {
    Along rows[3];
    for (std::size_t j = 0; j < 3; ++j) {
      const std::int32_t brick_y = y.brick[j], brick_z = z.brick[k];
      const std::uint32_t* cells = field.root + ((brick_z >> 2) * field.root_size[1] + (brick_y >> 2)) * field.root_size[0];
      const std::uint32_t* slots = field.nodes + (((brick_z & 3) << 4) | ((brick_y & 3) << 2));
      const auto part = [&](std::int32_t brick_x) {
        return with_known(field.stiffness_parts[slots[cells[brick_x >> 2] * kBricksPerNode + static_cast<std::uint32_t>(brick_x & 3)]]);
      };
      rows[j] = along(part(x.brick[0]), part(x.brick[1]), part(x.brick[2]), x);
    }
    const Along plane = along(rows[0].value, rows[1].value, rows[2].value, y);
    planes.value[k] = plane.value;
    planes.x[k] = along(rows[0].slope, rows[1].slope, rows[2].slope, y).value;
    planes.y[k] = plane.slope;
  }
  const Spline sum = planes.along_z(z, lower), known = planes.along_z(z, upper);
  // A stored brick weighs 1/8 of the whole at every point within it; below 1/64 the quotient's bits would not suffice.
  constexpr std::int64_t kLeast = std::int64_t{1} << (3 * kWeightBits - 6);
  if (known.value < kLeast) return {};
  constexpr int kSpare = 10;  // the sum is then below 2^31, and from 2^20 on where known is 1/8
  const Reciprocal over_known = reciprocal(static_cast<std::uint64_t>(kFullStiffness * known.value));  // shift from 65 to 71
  const std::int64_t part = ((sum.value >> kSpare) * over_known.mantissa) >> (over_known.shift - kSpare - Ratio::kFractionBits);
  return {Ratio::from_raw(static_cast<std::int32_t>(part)), logarithmic_slope(sum) - logarithmic_slope(known)};
}

}  // namespace isotouch::core
