#include "host/evaluate/compare_mesh.h"

#include <cmath>

#include "host/blob/write_blob.h"
#include "host/error.h"
#include "host/evaluate/real.h"
#include "host/field/mesh_distance.h"
#include "host/field/mesh_field.h"

namespace isotouch::evaluate {

namespace {

constexpr std::uint64_t kSeed = 20'000;

}  // namespace

cloud::Placement placement_of(const BlobView& field) {
  const cloud::Placement placement = blob::info_of(field).placement;
  if (!(placement.scale > 0) || !std::isfinite(placement.scale) || !placement.offset.allFinite()) {
    throw InputError("the blob does not say how its cloud was placed in the workspace; build it again");
  }
  return placement;
}

SurfaceError compare_with_mesh(const BlobView& field, const cloud::TriangleMesh& mesh) {
  return surface_error(field, cloud::scatter_on_mesh(mesh, kComparePoints, kSeed));
}

OpenBlob floor_of_mesh(const BlobView& field, const cloud::TriangleMesh& mesh) {
  field::Grid grid;
  grid.origin = real(field.origin);
  grid.edge = real(field.edge);
  grid.size = Eigen::Vector3i(field.size[0], field.size[1], field.size[2]);
  const field::MeshDistance distance(mesh);
  return open_blob(blob::write_blob(field::mesh_field(distance, grid, real(field.band)), {}), "the mesh's exact distances");
}

}  // namespace isotouch::evaluate
