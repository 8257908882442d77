#include "hil/falcon_model/angle.h"

#include <cmath>
#include <cstdint>

namespace isotouch::falcon_model {

namespace {

/// Taylor series around 0 for |x| <= pi/4: the first term left out is 3e-19 of x.
double sine_near_zero(double x) {
  const double s = x * x;
  double sum = 0;
  for (int n = 17; n >= 3; n -= 2) sum = (1 - sum) * s / (n * (n - 1));
  return x - x * sum;
}

double cosine_near_zero(double x) {
  const double s = x * x;
  double sum = 0;
  for (int n = 18; n >= 2; n -= 2) sum = (1 - sum) * s / (n * (n - 1));
  return 1 - sum;
}

/// Quarter turns plus a remainder within pi/4; pi/2 in two parts, so that the remainder keeps its digits.
struct Quarters {
  std::int64_t count;
  double rest;
};

Quarters quarters(double angle) {
  constexpr double kHalfPiHigh = 1.5707963267341256;  // 33 bits: its product with a count below 2^20 is exact
  constexpr double kHalfPiLow = 6.077100506506192e-11;
  const double turns = angle * (2 / kPi);
  const auto count = static_cast<std::int64_t>(turns < 0 ? turns - 0.5 : turns + 0.5);
  const auto n = static_cast<double>(count);
  return {count, (angle - n * kHalfPiHigh) - n * kHalfPiLow};
}

double sine_after(std::int64_t count, double rest) {
  switch (count & 3) {
    case 0: return sine_near_zero(rest);
    case 1: return cosine_near_zero(rest);
    case 2: return -sine_near_zero(rest);
    default: return -cosine_near_zero(rest);
  }
}

/// Arc tangent of t in [0, 1]: halved twice by tan(a/2) = t / (1 + sqrt(1 + t²)), then the series; t <= 0.199, the first term left out is 2e-18.
double arc_tangent_of(double t) {
  for (int i = 0; i < 2; ++i) t = t / (1 + std::sqrt(1 + t * t));
  const double s = t * t;
  double sum = 0;
  for (int n = 23; n >= 3; n -= 2) sum = s * (1.0 / n - sum);
  return 4 * (t - t * sum);
}

}  // namespace

double sine(double angle) {
  const Quarters q = quarters(angle);
  return sine_after(q.count, q.rest);
}

double cosine(double angle) {
  const Quarters q = quarters(angle);
  return sine_after(q.count + 1, q.rest);
}

double arc_tangent(double y, double x) {
  const double across = y < 0 ? -y : y;
  const double along = x < 0 ? -x : x;
  if (across == 0 && along == 0) return 0;
  double angle = across <= along ? arc_tangent_of(across / along) : kPi / 2 - arc_tangent_of(along / across);
  if (x < 0) angle = kPi - angle;
  return y < 0 ? -angle : angle;
}

}  // namespace isotouch::falcon_model
