#include "host/evaluate/stored_surface.h"

#include <cstddef>

#include "host/error.h"

namespace isotouch::evaluate {

namespace {

using Eigen::Vector3i;
using namespace image_layout;

constexpr std::size_t kJumps = 1 << 12;  // a surface in so many bricks takes a few hundred megabytes

std::uint32_t brick_at(const FieldView& field, const Vector3i& cell) {
  return field.brick_number(4 * cell.x(), 4 * cell.y(), 4 * cell.z());
}

}  // namespace

bool jumps_beside(const FieldView& field, const Vector3i& cell) {
  if (brick_at(field, cell) != kInside) return false;
  for (int axis = 0; axis < 3; ++axis) {  // no brick at the border is inside
    if (brick_at(field, cell + Vector3i::Unit(axis)) == kOutside || brick_at(field, cell - Vector3i::Unit(axis)) == kOutside) return true;
  }
  return false;
}

void require_stored_surface(const FieldView& field) {
  std::size_t jumps = 0;
  const Vector3i nodes(field.root_size[0], field.root_size[1], field.root_size[2]);
  Vector3i node;
  for (node.z() = 0; node.z() < nodes.z(); ++node.z()) {
    for (node.y() = 0; node.y() < nodes.y(); ++node.y()) {
      for (node.x() = 0; node.x() < nodes.x(); ++node.x()) {
        if (field.root[field.root_entry(16 * node.x(), 16 * node.y(), 16 * node.z())] == kOutside) continue;
        for (int n = 0; n < 64; ++n) {
          if (jumps_beside(field, 4 * node + Vector3i(n & 3, n >> 2 & 3, n >> 4))) ++jumps;
        }
        if (jumps > field.brick_count + kJumps)
          throw InputError("the field jumps from far inside to far outside nearly everywhere, as no build leaves it; build it again");
      }
    }
  }
}

}  // namespace isotouch::evaluate
