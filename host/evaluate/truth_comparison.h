/// A blob's whole surface against the closed mesh of its object: the worst place on either, the volume between them, what it consists of.
#pragma once

#include <cstddef>
#include <vector>

#include "host/cloud/mesh.h"
#include "host/evaluate/farthest.h"
#include "host/evaluate/zero_surface.h"
#include "shared/blob.h"

namespace isotouch::evaluate {

/// How the Hausdorff distance is found out, voxels (farthest.h), and lines a square voxel for the volume (wrong_side.h).
inline constexpr double kFineness = 0.15;
inline constexpr double kLinesPerVoxel = 4;

struct TruthComparison {
  Farthest from_mesh;  ///< the place of the mesh farthest from the blob's surface, mm: what the blob misses or rounds off
  Farthest from_blob;  ///< the place of the blob's surface farthest from the mesh, mm: debris, bridges, bumps
  double voxel_mm = 0;
  double wrong_side_pct = 0;  ///< volume that is inside exactly one of the two, per cent of the mesh's volume
  double too_much_pct = 0;    ///< of it, what is inside the blob only
  double volume_ratio = 0;    ///< signed volume inside the blob's surface over that of the mesh
  std::vector<Piece> pieces;  ///< of the blob's surface

  double from_mesh_voxel() const { return from_mesh.distance / voxel_mm; }
  double from_blob_voxel() const { return from_blob.distance / voxel_mm; }
  double hausdorff_voxel() const { return from_mesh_voxel() > from_blob_voxel() ? from_mesh_voxel() : from_blob_voxel(); }
  const Farthest& worst() const { return from_mesh.distance > from_blob.distance ? from_mesh : from_blob; }
};

/// surface   zero_surface(field): what is exact about it stands there. Distances between the two surfaces add at most kFineness of a voxel to
///           what is reported, and nothing where a corner of the mesh is the worst place
/// mesh      closed, workspace, mm; the places where it runs through itself count as inside
/// fails     InputError when the blob has no surface
TruthComparison compare_surfaces(const BlobView& field, const cloud::TriangleMesh& surface, const cloud::TriangleMesh& mesh);

}  // namespace isotouch::evaluate
