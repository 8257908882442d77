#include "host/field/winding_number.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "host/field/angle.h"

namespace isotouch::field {

namespace {

using Eigen::Vector3d;

constexpr double kFarRadii = 2;

/// Half the solid angle under which a face is seen, positive from behind.
double half_solid_angle(const Vector3d& point, const FaceTree::Face& face) {
  const Vector3d a = face.corners[0] - point;
  const Vector3d b = face.corners[1] - point;
  const Vector3d c = face.corners[2] - point;
  const double la = a.norm();
  const double lb = b.norm();
  const double lc = c.norm();
  return angle_of(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
}

}  // namespace

WindingNumber::WindingNumber(const FaceTree& tree) : tree_(tree) {
  dipoles_.reserve(tree.nodes.size());
  for (const FaceTree::Node& node : tree.nodes) {
    Dipole dipole{Vector3d::Zero(), Vector3d::Zero(), 0};
    double weights = 0;
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      const auto& [a, b, c] = tree.faces[i].corners;
      const Vector3d area = 0.5 * (b - a).cross(c - a);
      const double weight = area.norm();
      dipole.area += area;
      dipole.centre += weight / 3 * (a + b + c);
      weights += weight;
    }
    dipole.centre = weights > 0 ? Vector3d(dipole.centre / weights) : Vector3d((node.low + node.high) / 2);
    const Vector3d reach = (node.high - dipole.centre).cwiseMax(dipole.centre - node.low);
    dipole.far = kFarRadii * kFarRadii * reach.squaredNorm();
    dipoles_.push_back(dipole);
  }
}

double WindingNumber::operator()(const Vector3d& point) const {
  double sum = 0;  // of half solid angles
  std::array<std::uint32_t, 64> waiting;
  std::size_t count = 0;
  waiting[count++] = 0;
  while (count > 0) {
    const std::uint32_t number = waiting[--count];
    const FaceTree::Node& node = tree_.nodes[number];
    const Dipole& dipole = dipoles_[number];
    const Vector3d way = dipole.centre - point;
    const double square = way.squaredNorm();
    if (square > dipole.far) {
      sum += dipole.area.dot(way) / (2 * square * std::sqrt(square));
    } else if (node.right != 0) {
      waiting[count++] = node.right;
      waiting[count++] = number + 1;
    } else {
      for (std::uint32_t i = node.first; i < node.first + node.count; ++i) sum += half_solid_angle(point, tree_.faces[i]);
    }
  }
  return sum / (2 * std::numbers::pi);
}

}  // namespace isotouch::field
