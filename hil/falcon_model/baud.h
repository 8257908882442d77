/// Which rate a divisor asks of an FT232R.
#pragma once

#include <cstdint>

namespace isotouch::falcon_model {

/// Symbols a second for the wValue and wIndex of the request "set baud rate": 3 MHz over a divisor in eighths; codes 0 and 1 are 3 and 2 MHz.
double baud_rate(std::uint16_t value, std::uint16_t index);

/// Whether a receiver at one rate reads what was sent at the other: within 3 %.
bool same_rate(double a, double b);

}  // namespace isotouch::falcon_model
