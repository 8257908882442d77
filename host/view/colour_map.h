/// From a signed distance to a colour: blue outside, white at the surface, orange inside; people with any colour vision tell the two sides apart.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "host/view/image.h"

namespace isotouch::view {

/// value     -1 inside to +1 outside, clamped
inline Colour distance_colour(double value) {
  // Equal steps of lightness on both sides; even steps look even because the mixing is done between coded values, not between lights.
  static constexpr std::array<std::array<float, 3>, 7> kSteps = {{{0.42F, 0.18F, 0.02F},
                                                                  {0.75F, 0.39F, 0.06F},
                                                                  {0.95F, 0.68F, 0.38F},
                                                                  {0.97F, 0.96F, 0.94F},
                                                                  {0.56F, 0.75F, 0.88F},
                                                                  {0.22F, 0.49F, 0.74F},
                                                                  {0.07F, 0.22F, 0.46F}}};
  const double place = (std::clamp(value, -1.0, 1.0) + 1) / 2 * (kSteps.size() - 1);
  const auto low = std::min(static_cast<std::size_t>(place), kSteps.size() - 2);
  const auto t = static_cast<float>(place - static_cast<double>(low));
  const auto light = [&](std::size_t channel) {
    const float coded = kSteps[low][channel] * (1 - t) + kSteps[low + 1][channel] * t;
    return coded <= 0.04045F ? coded / 12.92F : std::pow((coded + 0.055F) / 1.055F, 2.4F);
  };
  return {light(0), light(1), light(2)};
}

}  // namespace isotouch::view
