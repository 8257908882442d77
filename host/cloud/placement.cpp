#include "host/cloud/placement.h"

#include <array>
#include <locale>
#include <sstream>
#include <string>
#include <utility>

#include "host/error.h"

namespace isotouch::cloud {
namespace {

using Eigen::Vector3d;

constexpr double kSmallestMm = 1.0;
constexpr double kMaxMm = 1000.0;  // a field's origin lies within 512 mm

std::string text(double value) {
  std::ostringstream stream;
  stream.imbue(std::locale::classic());
  stream << value;
  return stream.str();
}

}  // namespace

double mm_per_unit(std::string_view units) {
  constexpr std::array<std::pair<std::string_view, double>, 4> kUnits = {{{"mm", 1.0}, {"cm", 10.0}, {"m", 1000.0}, {"in", 25.4}}};
  for (const auto& [name, mm] : kUnits) {
    if (units == name) return mm;
  }
  throw InputError("unit '" + std::string(units) + "' is unknown; it may be mm, cm, m or in");
}

Placement place(std::span<const Vector3d> positions, const PlacementOptions& options) {
  Vector3d low = positions[0];
  Vector3d high = positions[0];
  for (const Vector3d& p : positions) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const double longest = (high - low).maxCoeff();
  Placement placement;
  placement.scale = options.mm_per_unit.value_or(options.fit_mm / longest);
  if (!(placement.scale > 0.0))
    throw InputError("a size of " + text(options.mm_per_unit.value_or(options.fit_mm)) + " mm is not possible; it must be above 0");
  const double size = placement.scale * longest;
  if (!(size >= kSmallestMm && size <= kMaxMm)) {
    throw InputError("the object would be " + text(size) + " mm long, a workspace holds 1 mm to 1000 mm; state other --units or use --fit");
  }
  placement.offset = -placement.scale * (0.5 * (low + high));
  return placement;
}

OrientedPoints placed(const OrientedPoints& points, const Placement& placement) {
  OrientedPoints result = points;
  for (Vector3d& p : result.positions) p = placement.to_workspace(p);
  return result;
}

}  // namespace isotouch::cloud
