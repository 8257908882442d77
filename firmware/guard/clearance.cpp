#include "firmware/guard/clearance.h"

#include <algorithm>
#include <cmath>

#include "firmware/guard/to_double.h"

namespace isotouch::guard {

namespace {

/// mm: how far the surface is at least from a place with this number.
double free_way(const FieldView& field, const Distance& number) {
  const double distance = to_double(number) * to_double(field.edge);
  return distance > 0 ? distance * to_double(field.inverse_slope) : distance;
}

}  // namespace

double clearance(const FieldView& field, const Point& at) {
  const double edge = to_double(field.edge);
  const Point origin = to_point(field.origin);
  std::array<std::int32_t, 3> first{}, last{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double index = (at[axis] - origin[axis]) / edge;
    if (!(index >= 1 && index <= field.size[axis] - 2)) return free_way(field, field.band);  // the grid's border is far outside
    const bool linear = field.interpolation == Interpolation::kTrilinear;
    first[axis] = static_cast<std::int32_t>(linear ? std::floor(index) : std::floor(index + 0.5) - 1);
    last[axis] = first[axis] + (linear ? 1 : 2);
  }
  std::int32_t least = INT32_MAX;
  for (std::int32_t k = first[2]; k <= last[2]; ++k) {
    for (std::int32_t j = first[1]; j <= last[1]; ++j) {
      for (std::int32_t i = first[0]; i <= last[0]; ++i) least = std::min<std::int32_t>(least, field.coefficient(i, j, k));
    }
  }
  return free_way(field, Distance::from_raw(least));
}

}  // namespace isotouch::guard
