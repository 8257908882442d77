#include "host/encoding/certificate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <tuple>

#include "host/encoding/apron.h"
#include "host/field/parallel.h"
#include "host/field/simd.h"
#include "shared/bytes.h"

namespace isotouch::encoding {

namespace {

using namespace image_layout;
using namespace field;  // numbers by four

constexpr std::size_t kGrain = 64;  // bricks a thread takes at once
constexpr std::size_t kStep[3] = {1, 6, 36};
constexpr float kThinnest = 1.0F / (1 << 16);  // that is told from none

/// Calls four(n) for every four places n to n + 3 of an apron that have both neighbours `step` away; the last ones may come twice.
template <class Action>
void for_each_four(std::size_t step, const Action& four) {
  const std::size_t end = std::tuple_size_v<Apron> - step;
  for (std::size_t n = step; n + 4 <= end; n += 4) four(n);
  four(end - 4);
}

float squared(float x) { return x * x; }

/// The largest step to a neighbour along one axis, of all that are known.
float largest_rise(const Apron& values, std::size_t step) {
  const std::size_t span = 6 * step;  // along x a row, along y a layer, along z all: no step leads from one to the next
  Four most{};
  const auto hear = [&](std::size_t n) { most = larger(magnitude(load(&values[n]) - load(&values[n - step])), most); };
  for (std::size_t first = 0; first < values.size(); first += span) {
    for (std::size_t n = first + step; n + 4 < first + span; n += 4) hear(n);
    hear(first + span - 4);
  }
  return largest(most);
}

/// The larger of the steps to the two neighbours of each value along one axis, zero where none is known (NaN).
Apron rises(const Apron& values, std::size_t step) {
  Apron rise{};
  for_each_four(step, [&](std::size_t n) {
    const Four back = magnitude(load(&values[n]) - load(&values[n - step])), ahead = magnitude(load(&values[n + step]) - load(&values[n]));
    store(larger(back, larger(ahead, Four{})), &rise[n]);
  });
  return rise;
}

/// The largest of each value and its two neighbours along one axis.
Apron spread(const Apron& values, std::size_t step) {
  Apron most{};
  for_each_four(
      step, [&](std::size_t n) { store(larger(larger(load(&values[n]), load(&values[n - step])), load(&values[n + step])), &most[n]); });
  return most;
}

/// At least |∇φ|² in the cells around the brick's samples: of each axis the largest step anywhere.
float steepest_at_most(const Apron& coefficients) {
  float at_most = 0.0F;
  for (const std::size_t step : kStep) at_most += squared(largest_rise(coefficients, step));
  return at_most;
}

/// The largest `squared_slope` of all bricks. Those that may be the steepest are asked first; few others can then be steeper.
float steepest_of_all(const std::vector<Samples>& splines, const std::vector<Neighbours>& around) {
  std::vector<float> at_most(splines.size());
  field::in_parallel(splines.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t b = begin; b < end; ++b) at_most[b] = steepest_at_most(gather(splines, around[b]));
  });
  std::vector<std::uint32_t> order(splines.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto first = order.begin() + static_cast<std::ptrdiff_t>(std::min(kGrain, order.size()));
  std::nth_element(order.begin(), first, order.end(), [&](std::uint32_t a, std::uint32_t b) { return at_most[a] > at_most[b]; });
  float known = 0.0F;
  for (auto brick = order.begin(); brick != first; ++brick) known = std::max(known, squared_slope(gather(splines, around[*brick])));

  const auto last = std::remove_if(first, order.end(), [&](std::uint32_t brick) { return at_most[brick] <= known; });
  std::vector<float> slopes(static_cast<std::size_t>(last - first), known);
  field::in_parallel(slopes.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) slopes[n] = squared_slope(gather(splines, around[first[static_cast<std::ptrdiff_t>(n)]]));
  });
  return std::accumulate(slopes.begin(), slopes.end(), known, [](float a, float b) { return std::max(a, b); });
}

constexpr std::ptrdiff_t surroundings_number(int x, int y, int z) { return ((z + 2) * 8 + y + 2) * 8 + x + 2; }

Surroundings surroundings(const std::vector<field::Brick>& bricks, const Neighbours& around) {
  Surroundings all;
  all.fill(NAN);
  float* out = all.data();
  for (int z = -2; z < 6; ++z) {
    for (int y = -2; y < 6; ++y, out += 8) {
      const std::uint32_t* row = &around[static_cast<std::size_t>(((z + 4) / 4 * 3 + (y + 4) / 4) * 3)];
      const std::size_t at = sample_number(0, y & 3, z & 3);
      if (row[0] != kAbsent) std::copy_n(&bricks[row[0]].distance[at + 2], 2, out);
      if (row[1] != kAbsent) std::copy_n(&bricks[row[1]].distance[at], 4, out + 2);
      if (row[2] != kAbsent) std::copy_n(&bricks[row[2]].distance[at], 2, out + 6);
    }
  }
  return all;
}

/// A step to one of the 26 neighbours.
struct Direction {
  std::ptrdiff_t step;
  float length;
};

std::array<Direction, 26> directions() {
  std::array<Direction, 26> all{};
  std::size_t next = 0;
  for (int n = 0; n < 27; ++n) {
    const int x = n % 3 - 1, y = n / 3 % 3 - 1, z = n / 9 - 1;
    if (n == 13) continue;
    all[next++] = {surroundings_number(x, y, z) - surroundings_number(0, 0, 0), std::sqrt(static_cast<float>(x * x + y * y + z * z))};
  }
  return all;
}

bool has_inside(const Samples& values) {
  return std::any_of(values.begin(), values.end(), [](float v) { return v < 0.0F; });
}

}  // namespace

/// A bound of |∇φ|² in the same cells: of each cell its own steps. A cell reaches half a sample to each side and knows 3x3x3 coefficients. It is never
/// above `steepest_at_most`.
float squared_slope(const Apron& coefficients) {
  std::array<Apron, 3> rise;
  for (std::size_t axis = 0; axis < 3; ++axis)
    rise[axis] = spread(spread(rises(coefficients, kStep[axis]), kStep[(axis + 1) % 3]), kStep[(axis + 2) % 3]);
  Four most{};
  for (int z = 0; z < 4; ++z) {
    for (int y = 0; y < 4; ++y) {
      Four sum{};
      for (const Apron& along : rise) {
        const Four row = load(&along[apron_number(0, y, z)]);
        sum += row * row;
      }
      most = larger(most, sum);
    }
  }
  return largest(most);
}

/// The least thickness of a wall whose middle lies beside one of the brick's samples, or what is given. Across a wall the distance falls by the
/// way, and behind its middle it rises by the way.
float thinnest_wall(const Surroundings& distance, const Samples& coefficients, float thickness) {
  static const std::array<Direction, 26> ways = directions();
  constexpr float kNear =
      0.3F;  // sum of two samples that are not inside: below it the spline between them is, above it by 0.05 voxel at most
  // Of the way: at the edge of a box it is 0.71, between sides 125 degrees apart 0.885. Across a flat wall one of the 26 ways has at least 0.887.
  constexpr float kOpposed = 0.885F;
  Four thin = all(thickness);
  for (int z = 0; z < 4; ++z) {
    for (int y = 0; y < 4; ++y) {
      const float* at = &distance[static_cast<std::size_t>(surroundings_number(0, y, z))];
      const Four here = load(at), coefficient = load(&coefficients[sample_number(0, y, z)]);
      if (!any(coefficient < 0.0F)) continue;
      for (const Direction& way : ways) {
        const float opposed = kOpposed * way.length;
        const Four fall = load(at - way.step) - here;
        if (!any(fall >= opposed)) continue;
        const Four next = load(at + way.step), rise = load(at + 2 * way.step) - next;
        const Four wall = (fall + rise) / 2.0F - (here + next);
        const auto has_inside = (coefficient < 0.0F) & ((here < 0.0F) | (here + next < kNear));
        const auto thinner = has_inside & (fall >= opposed) & (rise >= opposed) & (wall < thin);
        thin = thinner ? wall : thin;
      }
    }
  }
  return least(thin);
}

double advisable_stiffness(double damping_n_s_mm, std::uint32_t delay_ticks, std::uint32_t period_ns) {
  return 2.0 * damping_n_s_mm / ((2.0 * delay_ticks + 1.0) * 1e-9 * period_ns);
}

Certificate certify(const field::BandField& field, const std::vector<Neighbours>& around, const std::vector<Coefficients>& coefficients) {
  std::vector<Samples> splines(field.bricks.size());
  std::vector<float> walls(field.bricks.size());
  field::in_parallel(splines.size(), 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t b = begin; b < end; ++b) {
      std::transform(coefficients[b].begin(), coefficients[b].end(), splines[b].begin(),
                     [](std::int16_t c) { return static_cast<float>(c) / (1 << Distance::kFractionBits); });
    }
  });
  const float none = 2.0F * static_cast<float>(field.band);
  field::in_parallel(splines.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    float wall = none;
    for (std::size_t b = begin; b < end; ++b) {
      if (has_inside(splines[b])) wall = thinnest_wall(surroundings(field.bricks, around[b]), splines[b], wall);
      walls[b] = wall;
    }
  });
  if (walls.empty()) return certificate_from(0.0F, none, field.band);
  return certificate_from(steepest_of_all(splines, around), *std::min_element(walls.begin(), walls.end()), field.band);
}

Certificate certificate_from(float squared_slope, float wall, double band) {
  Certificate certificate;
  certificate.largest_slope = std::sqrt(static_cast<double>(squared_slope));
  certificate.thinnest_wall_voxel = wall < 2.0F * static_cast<float>(band) ? static_cast<double>(std::max(wall, kThinnest)) : 0.0;
  certificate.quantisation_voxel = 0.5 / (1 << Distance::kFractionBits);  // the spline is a mean of coefficients
  certificate.stiffness_n_per_mm = advisable_stiffness(certificate.damping_n_s_mm, certificate.delay_ticks, certificate.period_ns);
  return certificate;
}

Certificate certificate_of(const FieldView& view) {
  const std::uint8_t* at = view.image.data();
  const auto scaled = [at](std::size_t offset, int bits) {
    return std::ldexp(static_cast<double>(load_le<std::uint32_t>(at + offset)), -bits);
  };
  return {scaled(kMaxSlopeAt, 16),
          scaled(kQuantisationAt, 24),
          scaled(kThinnestWallAt, 16),
          scaled(kAdvisedStiffnessAt, Stiffness::kFractionBits),
          load_le<std::uint32_t>(at + kAdvisedPeriodAt),
          scaled(kAdvisedDampingAt, Damping::kFractionBits),
          load_le<std::uint32_t>(at + kAdvisedDelayAt)};
}

}  // namespace isotouch::encoding
