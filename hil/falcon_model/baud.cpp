#include "hil/falcon_model/baud.h"

#include <array>

namespace isotouch::falcon_model {

double baud_rate(std::uint16_t value, std::uint16_t index) {
  constexpr std::array<double, 8> kFraction = {0, 0.5, 0.25, 0.125, 0.375, 0.625, 0.75, 0.875};
  const std::uint32_t code = value | static_cast<std::uint32_t>(index & 1U) << 16;
  if (code == 0) return 3e6;
  if (code == 1) return 2e6;
  const double divisor = (code & 0x3FFFU) + kFraction[code >> 14 & 7U];
  return 3e6 / divisor;
}

bool same_rate(double a, double b) { return a <= 1.03 * b && b <= 1.03 * a; }

}  // namespace isotouch::falcon_model
