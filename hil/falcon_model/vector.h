/// Three doubles of the simulated device's own mechanism: device frame, x right, y up, z out of the device towards the user, mm unless said otherwise.
#pragma once

#include <cmath>

namespace isotouch::falcon_model {

struct Vector {
  double x = 0, y = 0, z = 0;

  friend constexpr Vector operator+(const Vector& a, const Vector& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend constexpr Vector operator-(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend constexpr Vector operator*(double s, const Vector& a) { return {s * a.x, s * a.y, s * a.z}; }
  friend constexpr bool operator==(const Vector&, const Vector&) = default;
};

constexpr double dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
constexpr Vector cross(const Vector& a, const Vector& b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
inline double length(const Vector& a) { return std::sqrt(dot(a, a)); }

}  // namespace isotouch::falcon_model
