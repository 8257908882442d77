/// Ready images from a distance function, made without the host: what core tests feel.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "shared/field_view.h"
#include "tests/support/random.h"

namespace isotouch::test {

/// Index coordinates → distance in voxels, negative inside.
using DistanceFunction = std::function<double(const Point&)>;

struct FieldOptions {
  double edge_mm = 0.34;
  double band = 4.0;
  double stiffness = 0.8;
  double largest_slope = 0.0;  ///< as a certificate tells it; 0 = no certificate
  Point origin_mm = {-20.0, -20.0, -20.0};
  std::function<int(const Point&)> stiffness_part = nullptr;  ///< 1 to 255 at a brick's centre, index coordinates; a table where given
  bool prefilter = true;  ///< coefficients whose spline passes near the samples, φ - (sum of second differences) / 8
  Interpolation interpolation = Interpolation::kSpline;  ///< kTrilinear wants no `prefilter`
};

/// Of a trilinear field with a band of 2 voxels: small images.
inline FieldOptions trilinear_options() { return {.band = 2.0, .prefilter = false, .interpolation = Interpolation::kTrilinear}; }

/// A canonical image and the checked view on it.
class FieldImage {
 public:
  /// size      samples along each axis; the body must stay away from the border by more than the band
  FieldImage(std::array<std::uint32_t, 3> size, const DistanceFunction& distance, const FieldOptions& options = {});
  const FieldView& view() const { return view_; }
  std::vector<std::uint8_t> bytes() const;

 private:
  std::vector<std::uint64_t> words_;
  FieldView view_;
};

}  // namespace isotouch::test
