#include "host/live/point.h"

#include <cmath>

namespace isotouch::live {

namespace {
double rounded(double value) { return std::floor(value + 0.5); }
}  // namespace

std::optional<Point> point_in(const field::Grid& grid, const Eigen::Vector3d& position, const Eigen::Vector3d& normal) {
  const Eigen::Vector3d index = grid.to_index(position);
  const double length = normal.norm();
  if (!index.allFinite() || !(length > 0.0) || !std::isfinite(length)) return std::nullopt;
  Point point{};
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const double place = rounded(std::ldexp(index[axis], kPositionBits));
    if (!(place >= 0.0 && place < std::ldexp(grid.size[axis] - 1, kPositionBits))) return std::nullopt;
    const auto a = static_cast<std::size_t>(axis);
    point.position[a] = static_cast<std::int32_t>(place);
    point.normal[a] = static_cast<std::int16_t>(rounded(std::ldexp(normal[axis] / length, kNormalBits)));
  }
  return point;
}

std::uint64_t hash_of(const Point& point) {
  std::uint64_t hash = 0;
  const auto mix = [&hash](std::uint64_t value) {  // the finalizer of MurmurHash3
    hash = (hash ^ value) + 0x9E3779B97F4A7C15U;
    hash = (hash ^ hash >> 33) * 0xFF51AFD7ED558CCDU;
    hash = (hash ^ hash >> 33) * 0xC4CEB9FE1A85EC53U;
    hash ^= hash >> 33;
  };
  for (const std::int32_t x : point.position) mix(static_cast<std::uint32_t>(x));
  for (const std::int16_t x : point.normal) mix(static_cast<std::uint16_t>(x));
  return hash;
}

}  // namespace isotouch::live
