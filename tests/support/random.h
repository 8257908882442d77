/// Random numbers that are the same on every machine (splitmix64), and the small vector maths that tests draw with them.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace isotouch::test {

struct Point {
  double x = 0, y = 0, z = 0;
  double& operator[](std::size_t axis) { return axis == 0 ? x : axis == 1 ? y : z; }
  double operator[](std::size_t axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
};

inline Point operator+(const Point& a, const Point& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Point operator-(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Point operator*(const Point& a, double s) { return {a[0] * s, a[1] * s, a[2] * s}; }
inline double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline double length(const Point& a) { return std::sqrt(dot(a, a)); }
inline Point unit(const Point& a) { return a * (1.0 / length(a)); }
inline Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  std::uint64_t bits() {
    std::uint64_t z = (state_ += 0x9E3779B97F4A7C15ULL);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
    return z ^ (z >> 31);
  }
  double uniform(double low, double high) { return low + (high - low) * static_cast<double>(bits() >> 11) / 9007199254740992.0; }
  Point in_box(double half) { return {uniform(-half, half), uniform(-half, half), uniform(-half, half)}; }
  Point in_ball(double radius) {
    for (;;) {
      const Point p = in_box(radius);
      if (length(p) <= radius) return p;
    }
  }
  Point direction() {
    for (;;) {
      const Point p = in_box(1.0);
      if (length(p) > 0.1 && length(p) <= 1.0) return unit(p);
    }
  }

 private:
  std::uint64_t state_;
};

/// An orthonormal frame with its first axis along `first`.
struct Frame {
  Point x, y, z;
  explicit Frame(const Point& first)
      : x(unit(first)), y(unit(cross(x, std::abs(x.x) < 0.7 ? Point{1, 0, 0} : Point{0, 1, 0}))), z(cross(x, y)) {}
};

}  // namespace isotouch::test
