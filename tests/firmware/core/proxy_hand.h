/// A hand on a field with its proxy, and the two kinds of field that every property of the proxy is tested on.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "firmware/core/proxy.h"
#include "tests/support/field_image.h"
#include "tests/support/reference.h"

namespace isotouch::core {

inline constexpr double kMetreASecond = 1.0 / 0.34;  // voxels a tick at 1 kHz and 0.34 mm a voxel

/// A hand on a field: its proxy and what the properties ask of it.
class Hand {
 public:
  explicit Hand(const FieldView& field) : field_(field) {}
  Contact move_to(const test::Point& hip) {
    const Contact contact = step_proxy(test::to_voxel(hip), field_, state_);
    if (contact.touching) deepest_ = std::min(deepest_, test::to_double(sample_field(field_, contact.proxy).distance));
    return contact;
  }
  /// Ticks until `to` is reached at `speed` voxels a tick; calls `see` after each.
  template <class See>
  void move(const test::Point& from, const test::Point& to, double speed, See see) {
    const int ticks = std::max(1, static_cast<int>(std::ceil(test::length(to - from) / speed)));
    for (int t = 1; t <= ticks; ++t) {
      const test::Point hip = from + (to - from) * (static_cast<double>(t) / ticks);
      see(hip, move_to(hip));
    }
  }
  /// The state after many more ticks at one place, this hand untouched.
  Contact converged(const test::Point& hip, int ticks) const {
    Hand other = *this;
    Contact contact;
    for (int t = 0; t < ticks; ++t) contact = other.move_to(hip);
    return contact;
  }
  double deepest() const { return deepest_; }  // smallest φ(proxy) seen in contact

 private:
  const FieldView& field_;
  ProxyState state_;
  double deepest_ = 1.0;
};

/// A property of the proxy that holds for both interpolations.
class ProxyOn : public testing::TestWithParam<Interpolation> {
 protected:
  bool is_spline() const { return GetParam() == Interpolation::kSpline; }
  test::FieldOptions options() const { return {.prefilter = is_spline(), .interpolation = GetParam()}; }
  /// How far below the surface a proxy may be: a trilinear field turns at every cell, so that one more step may miss its zero by more.
  double deepest() const { return is_spline() ? -0.05 : -0.13; }
};

inline std::string name_of(const testing::TestParamInfo<Interpolation>& of) {
  return of.param == Interpolation::kSpline ? "Spline" : "Trilinear";
}

}  // namespace isotouch::core
