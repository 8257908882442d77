#include "host/blob/certificate.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "host/blob/apron.h"
#include "host/field/parallel.h"
#include "shared/bytes.h"

namespace isotouch::blob {

namespace {

using namespace blob_layout;

constexpr std::size_t kGrain = 64;  // bricks a thread takes at once
constexpr std::size_t kStep[3] = {1, 6, 36};

/// The largest of each value and its two neighbours along one axis; unknown ones (NaN) do not count.
void spread(Apron& values, std::size_t step) {
  const Apron before = values;
  for (std::size_t n = step; n + step < values.size(); ++n) {
    values[n] = std::max(std::max(before[n], before[n - step]), before[n + step]);
  }
}

/// A bound of |∇φ|² in the cells around the brick's samples. A cell reaches half a sample to each side and knows 3x3x3 coefficients.
float steepest(const Apron& coefficients) {
  Apron sum{};
  for (int axis = 0; axis < 3; ++axis) {
    const std::size_t step = kStep[axis];
    Apron rise{};  // the larger of the differences to both neighbours
    for (std::size_t n = step; n + step < rise.size(); ++n) {
      const float back = std::abs(coefficients[n] - coefficients[n - step]), ahead = std::abs(coefficients[n + step] - coefficients[n]);
      const float known = back > ahead || !(ahead >= 0.0F) ? back : ahead;
      rise[n] = known >= 0.0F ? known : 0.0F;
    }
    spread(rise, kStep[(axis + 1) % 3]);
    spread(rise, kStep[(axis + 2) % 3]);
    for (std::size_t n = 0; n < sum.size(); ++n) sum[n] += rise[n] * rise[n];
  }
  float most = 0.0F;
  for (int z = 0; z < 4; ++z) {
    for (int y = 0; y < 4; ++y) {
      for (int x = 0; x < 4; ++x) most = std::max(most, sum[apron_number(x, y, z)]);
    }
  }
  return most;
}

/// A brick with two rings around it, 8 samples a side.
using Surroundings = std::array<float, 512>;

constexpr std::ptrdiff_t surroundings_number(int x, int y, int z) { return ((z + 2) * 8 + y + 2) * 8 + x + 2; }

Surroundings surroundings(const std::vector<Samples>& samples, const Neighbours& around) {
  Surroundings all;
  std::size_t n = 0;
  for (int z = -2; z < 6; ++z) {
    for (int y = -2; y < 6; ++y) {
      for (int x = -2; x < 6; ++x) {
        const std::uint32_t brick = around[static_cast<std::size_t>(((z + 4) / 4 * 3 + (y + 4) / 4) * 3 + (x + 4) / 4)];
        all[n++] = brick == kAbsent ? NAN : samples[brick][sample_number(x & 3, y & 3, z & 3)];
      }
    }
  }
  return all;
}

/// One of each pair of opposite steps to the 26 neighbours.
struct Direction {
  std::ptrdiff_t step;
  float length;
};

constexpr std::array<std::array<int, 3>, 13> kDirections = {{{1, 0, 0},
                                                             {0, 1, 0},
                                                             {0, 0, 1},
                                                             {1, 1, 0},
                                                             {1, -1, 0},
                                                             {1, 0, 1},
                                                             {1, 0, -1},
                                                             {0, 1, 1},
                                                             {0, 1, -1},
                                                             {1, 1, 1},
                                                             {1, 1, -1},
                                                             {1, -1, 1},
                                                             {-1, 1, 1}}};

std::array<Direction, 13> directions() {
  std::array<Direction, 13> all{};
  for (std::size_t d = 0; d < all.size(); ++d) {
    const auto& [x, y, z] = kDirections[d];
    all[d] = {surroundings_number(x, y, z) - surroundings_number(0, 0, 0), std::sqrt(static_cast<float>(x * x + y * y + z * z))};
  }
  return all;
}

/// The least thickness of a wall whose middle lies beside one of the brick's samples, or what is given. Across a wall the distance falls by the
/// way, and behind its middle it rises by the way.
float thinnest(const Surroundings& distance, const std::array<Direction, 13>& ways, float thickness) {
  constexpr float kOpposed = 0.9F;  // of the way: at the edge of a box it is 0.7, between sides 130 degrees apart 0.9
  for (int z = 0; z < 4; ++z) {
    for (int y = 0; y < 4; ++y) {
      for (int x = 0; x < 4; ++x) {
        const float* here = &distance[static_cast<std::size_t>(surroundings_number(x, y, z))];
        if (!(here[0] < 0.0F)) continue;
        for (const Direction& way : ways) {
          const float fall = here[-way.step] - here[0], rise = here[2 * way.step] - here[way.step];
          if (!(fall >= kOpposed * way.length && rise >= kOpposed * way.length)) continue;
          thickness = std::min(thickness, (fall + rise) / 2.0F - (here[0] + here[way.step]));
        }
      }
    }
  }
  return thickness;
}

}  // namespace

double advisable_stiffness(double damping_ns_per_mm, std::uint32_t delay_ticks, std::uint32_t period_ns) {
  return 2.0 * damping_ns_per_mm / ((2.0 * delay_ticks + 1.0) * 1e-9 * period_ns);
}

Certificate certify(const field::BandField& field, const std::vector<Coefficients>& coefficients) {
  const std::vector<Neighbours> around = neighbours(field);
  std::vector<Samples> distances(field.bricks.size()), splines(field.bricks.size());
  std::vector<float> slopes(field.bricks.size()), walls(field.bricks.size());
  for (std::size_t b = 0; b < distances.size(); ++b) {
    distances[b] = field.bricks[b].distance;
    std::transform(coefficients[b].begin(), coefficients[b].end(), splines[b].begin(),
                   [](std::int16_t c) { return static_cast<float>(c) / (1 << Distance::kFractionBits); });
  }
  const auto ways = directions();
  const float none = 2.0F * static_cast<float>(field.band);
  field::in_parallel(distances.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t b = begin; b < end; ++b) {
      slopes[b] = steepest(gather(splines, around[b]));
      walls[b] = thinnest(surroundings(distances, around[b]), ways, none);
    }
  });
  Certificate certificate;
  if (!slopes.empty()) {
    const float wall = *std::min_element(walls.begin(), walls.end());
    certificate.largest_slope = std::sqrt(static_cast<double>(*std::max_element(slopes.begin(), slopes.end())));
    certificate.thinnest_wall_voxel = wall < none ? static_cast<double>(std::max(wall, 0.0F)) : 0.0;
  }
  certificate.quantisation_voxel = 0.5 / (1 << Distance::kFractionBits);  // the spline is a mean of coefficients
  certificate.stiffness_n_per_mm = advisable_stiffness(certificate.damping_ns_per_mm, certificate.delay_ticks, certificate.period_ns);
  return certificate;
}

Certificate certificate_of(const BlobView& view) {
  const std::uint8_t* at = view.image.data();
  const auto scaled = [at](std::size_t offset, int bits) {
    return std::ldexp(static_cast<double>(load_le<std::uint32_t>(at + offset)), -bits);
  };
  return {scaled(kLargestSlopeAt, 16),
          scaled(kQuantisationAt, 24),
          scaled(kThinnestWallAt, 16),
          scaled(kAdvisedStiffnessAt, Stiffness::kFractionBits),
          load_le<std::uint32_t>(at + kAdvisedPeriodAt),
          scaled(kAdvisedDampingAt, Damping::kFractionBits),
          load_le<std::uint32_t>(at + kAdvisedDelayAt)};
}

}  // namespace isotouch::blob
