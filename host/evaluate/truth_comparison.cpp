#include "host/evaluate/truth_comparison.h"

#include <cmath>
#include <limits>
#include <utility>

#include "host/cloud/oriented_points.h"
#include "host/error.h"
#include "host/evaluate/wrong_side.h"
#include "host/field/mesh_distance.h"
#include "host/field/triangle_tree.h"
#include "host/to_double.h"

namespace isotouch::evaluate {

namespace {

constexpr std::uint64_t kSeed = 20'001;

Spread spread(const field::TriangleTree& surface, const field::TriangleTree& other, double voxel_mm) {
  Spread found;
  double squares = 0;
  for (const Eigen::Vector3d& place : cloud::scatter_on_mesh(surface.mesh(), kSpreadPoints, kSeed).positions) {
    const double distance = other.nearest(place).distance / voxel_mm;
    squares += distance * distance;
    found.far += distance > kFarVoxels ? 1U : 0U;
  }
  found.rms_voxel = std::sqrt(squares / static_cast<double>(kSpreadPoints));
  return found;
}

}  // namespace

TrueSurface true_surface(cloud::TriangleMesh mesh) {
  const field::MeshDistance distance(std::move(mesh));
  return {distance.mesh(), distance.outer(), distance.is_simple()};
}

TruthComparison compare_surfaces(const FieldView& field, const cloud::TriangleMesh& surface, const TrueSurface& mesh) {
  if (surface.faces.empty()) throw InputError("the field has no surface: nothing in it is inside; build it again");
  TruthComparison found;
  found.voxel_mm = to_double(field.edge);
  const field::TriangleTree ours(surface);
  const field::TriangleTree truth(mesh.outer), all(mesh.closed);
  found.from_mesh = farthest(truth, ours, kFineness * found.voxel_mm);
  found.from_field = farthest(ours, truth, kFineness * found.voxel_mm);
  found.mesh_to_field = spread(truth, ours, found.voxel_mm);
  found.field_to_mesh = spread(ours, truth, found.voxel_mm);

  const WrongSide wrong = wrong_side(ours, all, found.voxel_mm * found.voxel_mm / kLinesPerVoxel);
  // The sum of what the parts enclose counts what they share twice.
  const double mesh_volume = mesh.is_simple ? cloud::signed_volume(mesh.closed) : wrong.truth;
  found.wrong_side_pct = 100 * wrong.volume / mesh_volume;
  found.too_much_pct = 100 * wrong.too_much / mesh_volume;
  found.pieces = pieces(surface);
  found.volume_ratio = volume(found.pieces) / mesh_volume;
  return found;
}

}  // namespace isotouch::evaluate
