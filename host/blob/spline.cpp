#include "host/blob/spline.h"

#include <algorithm>
#include <cmath>

#include "host/blob/apron.h"
#include "host/field/four.h"
#include "host/field/parallel.h"

namespace isotouch::blob {

namespace {

using namespace field;  // numbers by four

/// B c at the brick's 64 samples: one axis after the other. NaN wherever one of the 27 coefficients is.
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

constexpr std::size_t kGrain = 64;  // bricks a thread takes at once

constexpr double kScale = 1 << 12;

double rounded(double value) { return std::floor(value * kScale + 0.5); }

/// The band as the blob will hold it: exact in a float, so that what is clamped to it is it.
float rounded_band(const field::BandField& field) { return static_cast<float>(rounded(field.band) / kScale); }

/// Per brick one bit a sample: may it be corrected, are it and all its 26 neighbours within the band?
std::vector<std::uint64_t> correctable(const field::BandField& field, const std::vector<Neighbours>& around) {
  const float band = rounded_band(field);
  std::vector<Samples> known(field.bricks.size());  // NaN beyond the band; it travels through the blur
  for (std::size_t b = 0; b < known.size(); ++b) {
    for (std::size_t n = 0; n < 64; ++n) known[b][n] = std::abs(field.bricks[b].distance[n]) <= band ? 0.0F : NAN;
  }
  std::vector<std::uint64_t> masks(known.size(), 0);
  field::in_parallel(known.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t b = begin; b < end; ++b) {
      const Samples blurred = blur(gather(known, around[b]));
      for (std::size_t n = 0; n < 64; ++n) masks[b] |= std::uint64_t{!std::isnan(blurred[n])} << n;
    }
  });
  return masks;
}

}  // namespace

std::vector<Coefficients> spline_coefficients(const field::BandField& field, int steps) {
  const float band = rounded_band(field);
  const std::vector<Neighbours> around = neighbours(field);
  const std::vector<std::uint64_t> masks = correctable(field, around);

  std::vector<Samples> now(field.bricks.size());
  for (std::size_t b = 0; b < now.size(); ++b) {
    for (std::size_t n = 0; n < 64; ++n) now[b][n] = std::clamp(field.bricks[b].distance[n], -band, band);
  }
  std::vector<Samples> next = now;
  for (int step = 0; step < steps; ++step) {
    field::in_parallel(now.size(), kGrain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t b = begin; b < end; ++b) {
        if (masks[b] == 0) continue;
        const Samples blurred = blur(gather(now, around[b]));
        for (std::size_t n = 0; n < 64; ++n) {
          const float corrected = now[b][n] + (field.bricks[b].distance[n] - blurred[n]);
          next[b][n] = (masks[b] >> n & 1U) != 0 ? corrected : now[b][n];
        }
      }
    });
    std::swap(now, next);
  }

  std::vector<Coefficients> coefficients(now.size());
  field::in_parallel(now.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t b = begin; b < end; ++b) {
      for (std::size_t n = 0; n < 64; ++n) {
        coefficients[b][n] = static_cast<std::int16_t>(rounded(static_cast<double>(std::clamp(now[b][n], -band, band))));
      }
    }
  });
  return coefficients;
}

}  // namespace isotouch::blob
