/// A field's whole surface against the closed mesh of its object: the worst place on either, the volume between them, what it consists of.
#pragma once

#include <cstddef>
#include <vector>

#include "host/cloud/mesh.h"
#include "host/evaluate/farthest.h"
#include "host/evaluate/zero_surface.h"
#include "shared/field_view.h"

namespace isotouch::evaluate {

/// Distances from points spread evenly over one surface to the nearest place of the other.
struct Spread {
  double rms_voxel = 0;
  std::size_t far = 0;  ///< points more than kFarVoxels away
};
inline constexpr std::size_t kSpreadPoints = 20'000;
inline constexpr double kFarVoxels = 2;

/// By how many voxels the Hausdorff distance may be larger than what was found (farthest.h), and lines a square voxel for the volume (wrong_side.h).
inline constexpr double kFineness = 0.15;
inline constexpr double kLinesPerVoxel = 4;

/// The true surface of an object. Where parts of a mesh run through, touch or hold each other, the object is the union of what they enclose.
struct TrueSurface {
  cloud::TriangleMesh closed;  ///< all faces: what they turn round is inside
  cloud::TriangleMesh outer;   ///< those that bound the union
  bool is_simple = false;      ///< one sheet, which encloses nothing twice
};

/// mesh      closed, as field::closed_mesh leaves it
TrueSurface true_surface(cloud::TriangleMesh mesh);

struct TruthComparison {
  Farthest from_mesh;   ///< the place of the mesh farthest from the field's surface, mm: what the field misses or rounds off
  Farthest from_field;  ///< the place of the field's surface farthest from the mesh, mm: debris, bridges, bumps
  Spread mesh_to_field, field_to_mesh;
  double voxel_mm = 0;
  double wrong_side_pct = 0;  ///< volume that is inside exactly one of the two, per cent of the mesh's volume
  double too_much_pct = 0;    ///< of it, what is inside the field only
  double volume_ratio = 0;    ///< signed volume inside the field's surface over that of the mesh
  std::vector<Piece> pieces;  ///< of the field's surface

  double from_mesh_voxel() const { return from_mesh.distance / voxel_mm; }
  double from_field_voxel() const { return from_field.distance / voxel_mm; }
  double hausdorff_voxel() const { return from_mesh_voxel() > from_field_voxel() ? from_mesh_voxel() : from_field_voxel(); }
  double hausdorff_at_most_voxel() const { return hausdorff_voxel() + kFineness; }
  const Farthest& worst() const { return from_mesh.distance > from_field.distance ? from_mesh : from_field; }
};

/// surface   zero_surface(field): what is exact about it stands there. No place of either surface is farther from the other than the farthest that is
///           named by more than kFineness of a voxel, no corner by more than an eighth of it
/// mesh      workspace, mm
/// fails     InputError when the field has no surface
TruthComparison compare_surfaces(const FieldView& field, const cloud::TriangleMesh& surface, const TrueSurface& mesh);

}  // namespace isotouch::evaluate
