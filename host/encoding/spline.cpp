#include "host/encoding/spline.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "host/encoding/apron.h"
#include "host/field/brick_mask.h"
#include "host/field/parallel.h"
#include "host/field/sample_masks.h"
#include "host/field/simd.h"

namespace isotouch::encoding {

namespace {

using namespace field;  // numbers by four

using Numbers = int __attribute__((vector_size(16)));

/// B c at the brick's 64 samples: one axis after the other.
Samples blur(const Apron& apron) {
  const auto mean = [](const float* at, std::size_t stride) { return 0.75F * load(at) + 0.125F * (load(at - stride) + load(at + stride)); };
  std::array<float, 144> along_x;  // [z][y][x], 6 x 6 x 4
  for (std::size_t row = 0; row < 36; ++row) store(mean(&apron[6 * row + 1], 1), &along_x[4 * row]);
  std::array<float, 96> along_y;  // 6 x 4 x 4
  for (std::size_t z = 0; z < 6; ++z) {
    for (std::size_t y = 0; y < 4; ++y) store(mean(&along_x[24 * z + 4 * (y + 1)], 4), &along_y[16 * z + 4 * y]);
  }
  Samples inner;
  for (std::size_t n = 0; n < 64; n += 4) store(mean(&along_y[16 + n], 16), &inner[n]);
  return inner;
}

constexpr std::size_t kGrain = 64;        // bricks a thread takes at once
constexpr std::size_t kMaskGrain = 1024;  // the same, of light work

constexpr double kScale = 1 << 12;

double rounded(double value) { return std::floor(value * kScale + 0.5); }

/// The same of four coefficients. Whole part and rest are exact.
void store_rounded(Four value, std::int16_t* to) {
  using Shorts = std::int16_t __attribute__((vector_size(8)));
  const Four scaled = value * static_cast<float>(kScale);
  const auto whole = __builtin_convertvector(scaled, Numbers);  // towards zero
  const Four rest = scaled - __builtin_convertvector(whole, Four);
  const auto rounded = __builtin_convertvector(whole - (rest >= 0.5F) + (rest < -0.5F), Shorts);  // a true comparison is -1
  std::memcpy(to, &rounded, sizeof rounded);
}

Four clamped(Four value, float limit) { return lesser(all(limit), larger(all(-limit), value)); }

/// The band as the field will hold it: exact in a float, so that what is clamped to it is it.
float rounded_band(const field::BandField& field) { return static_cast<float>(rounded(field.band) / kScale); }

/// What is left of each brick's set where both neighbours along an axis must belong to the set, too.
std::vector<BrickMask> thinned(const std::vector<BrickMask>& sets, const std::vector<Neighbours>& around, std::size_t axis) {
  constexpr std::size_t kStep[3] = {1, 3, 9};  // from one neighbour to the next
  const BrickMask low = kLowFace[axis], high = low << kAcross[axis];
  const auto set_of = [&](std::uint32_t brick) { return brick == kAbsent ? 0 : sets[brick]; };
  std::vector<BrickMask> left(sets.size());
  field::in_parallel(sets.size(), kMaskGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t b = begin; b < end; ++b) {
      const BrickMask before = set_of(around[b][13 - kStep[axis]]), behind = set_of(around[b][13 + kStep[axis]]);
      left[b] = sets[b] & ((sets[b] & ~high) << kNext[axis] | face(before, axis, 1)) &
                ((sets[b] & ~low) >> kNext[axis] | face(behind, axis, 0) << kAcross[axis]);
    }
  });
  return left;
}

/// May a sample be corrected, are it and all its 26 neighbours within the band?
std::vector<BrickMask> correctable(const field::BandField& field, const std::vector<Neighbours>& around) {
  const float band = rounded_band(field);
  std::vector<BrickMask> known(field.bricks.size());
  field::in_parallel(known.size(), kMaskGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t b = begin; b < end; ++b) {
      known[b] = samples_that(field.bricks[b].distance, [=](Four d) { return magnitude(d) <= band; });
    }
  });
  return thinned(thinned(thinned(known, around, 0), around, 1), around, 2);
}

}  // namespace

std::vector<Coefficients> spline_coefficients(const field::BandField& field, const std::vector<Neighbours>& around, int steps) {
  const float band = rounded_band(field);
  const std::vector<BrickMask> masks = correctable(field, around);

  std::vector<Samples> now(field.bricks.size());
  field::in_parallel(now.size(), kMaskGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t b = begin; b < end; ++b) {
      for (std::size_t n = 0; n < 64; n += 4) store(clamped(load(&field.bricks[b].distance[n]), band), &now[b][n]);
    }
  });
  std::vector<Samples> next = now;
  for (int step = 0; step < steps; ++step) {
    field::in_parallel(now.size(), kGrain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t b = begin; b < end; ++b) {
        if (masks[b] == 0) continue;
        const Samples blurred = blur(gather(now, around[b]));
        for (std::size_t n = 0; n < 64; n += 4) {
          const Four here = load(&now[b][n]);
          const Four corrected = here + (load(&field.bricks[b].distance[n]) - load(&blurred[n]));
          const auto may = ((Numbers{} + static_cast<int>(masks[b] >> n & 15U)) & Numbers{1, 2, 4, 8}) != 0;
          store(may ? corrected : here, &next[b][n]);
        }
      }
    });
    std::swap(now, next);
  }

  std::vector<Coefficients> coefficients(now.size());
  field::in_parallel(now.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t b = begin; b < end; ++b) {
      for (std::size_t n = 0; n < 64; n += 4) store_rounded(clamped(load(&now[b][n]), band), &coefficients[b][n]);
    }
  });
  return coefficients;
}

}  // namespace isotouch::encoding
