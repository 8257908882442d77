#include "host/evaluate/truth_comparison.h"

#include "host/error.h"
#include "host/evaluate/wrong_side.h"
#include "host/field/triangle_tree.h"
#include "host/to_double.h"

namespace isotouch::evaluate {

TruthComparison compare_surfaces(const FieldView& field, const cloud::TriangleMesh& surface, const cloud::TriangleMesh& mesh) {
  if (surface.faces.empty()) throw InputError("the field has no surface: nothing in it is inside; build it again");
  TruthComparison found;
  found.voxel_mm = to_double(field.edge);
  const field::TriangleTree ours(surface);
  const field::TriangleTree truth(mesh);
  found.from_mesh = farthest(truth, ours, kFineness * found.voxel_mm);
  found.from_field = farthest(ours, truth, kFineness * found.voxel_mm);

  const double mesh_volume = cloud::signed_volume(mesh);
  const WrongSide wrong = wrong_side(ours, truth, found.voxel_mm * found.voxel_mm / kLinesPerVoxel);
  found.wrong_side_pct = 100 * wrong.volume / mesh_volume;
  found.too_much_pct = 100 * wrong.too_much / mesh_volume;
  found.pieces = pieces(surface);
  found.volume_ratio = volume(found.pieces) / mesh_volume;
  return found;
}

}  // namespace isotouch::evaluate
