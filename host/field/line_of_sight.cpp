#include "host/field/line_of_sight.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstddef>
#include <vector>

namespace isotouch::field {

namespace {

using Eigen::Vector3d;

constexpr std::size_t kAsked = 8192;   // samples, about
constexpr std::size_t kHeard = 9;      // of a sample and its neighbours
constexpr std::size_t kWitnesses = 4;  // so many look where it does, or it is a stray
constexpr double kAlike = 0.5;         // cosine
constexpr std::size_t kOneOf = 100;    // samples may look away: noise, and hair that no view explains
constexpr double kWellSeen = 0.3;      // cosine from which on a direction is as good as any
constexpr double kFirstStep = 0.5;     // radians, about
constexpr double kLastStep = 0.01;

}  // namespace

Vector3d line_of_sight(const Scan& scan, const Vector3d& front, const std::optional<Vector3d>& sensor) {
  if (sensor) {
    Eigen::AlignedBox3d box;
    for (const Vector3d& p : scan.positions()) box.extend(p);
    const Vector3d way = *sensor - box.center();
    return way.isZero() ? front : way.normalized();
  }
  std::vector<Vector3d> asked;
  for (std::size_t i = 0, every = std::max<std::size_t>(1, scan.size() / kAsked); i < scan.size(); i += every) {
    std::size_t alike = 0;
    for (const Neighbour& n : scan.around(i, kHeard)) alike += scan.normals()[n.index].dot(scan.normals()[i]) > kAlike ? 1U : 0U;
    if (alike >= kWitnesses) asked.push_back(scan.normals()[i]);
  }
  if (asked.empty()) return front;
  std::vector<double> cosines(asked.size());
  // Of the normals that look away the most.
  const auto seen = [&](const Vector3d& sight) {
    for (std::size_t n = 0; n < cosines.size(); ++n) cosines[n] = asked[n].dot(sight);
    const auto last = cosines.begin() + static_cast<std::ptrdiff_t>(cosines.size() / kOneOf);
    std::nth_element(cosines.begin(), last, cosines.end());
    return std::min(*last, kWellSeen);
  };
  Vector3d best = front;
  double most = seen(best);
  for (double step = kFirstStep; step > kLastStep && most < kWellSeen;) {
    const Vector3d u = best.unitOrthogonal(), v = best.cross(u);
    Vector3d better = best;
    for (int n = 0; n < 9; ++n) {
      const Vector3d sight = (best + step * ((n % 3 - 1) * u + (n / 3 - 1) * v)).normalized();
      if (const double value = seen(sight); value > most) {
        most = value;
        better = sight;
      }
    }
    if (better == best)
      step /= 2.0;
    else
      best = better;
  }
  return best;
}

}  // namespace isotouch::field
