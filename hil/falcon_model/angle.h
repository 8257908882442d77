/// Sine, cosine and arc tangent from nothing but additions, products, quotients and roots, which every processor rounds alike:
/// a library's functions may differ in the last bit, and a closed loop would carry that bit on.
#pragma once

namespace isotouch::falcon_model {

inline constexpr double kPi = 3.14159265358979323846;

constexpr double radians(double degrees) { return degrees * (kPi / 180); }

/// angle     rad, magnitude up to 1e6
/// returns   within 1e-15 for magnitudes up to 10, and 2e-16 per radian beyond
double sine(double angle);
double cosine(double angle);

/// The angle of the direction (x, y), rad in (-pi, pi], within 5e-16; (0, 0) gives 0.
double arc_tangent(double y, double x);

}  // namespace isotouch::falcon_model
