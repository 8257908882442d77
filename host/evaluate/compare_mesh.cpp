#include "host/evaluate/compare_mesh.h"

#include <Eigen/Geometry>
#include <optional>

#include "host/encoding/write_image.h"
#include "host/error.h"
#include "host/field/make_grid.h"
#include "host/field/mesh_distance.h"
#include "host/field/mesh_field.h"
#include "host/to_double.h"
#include "host/trace/stated_placement.h"

namespace isotouch::evaluate {

namespace {

constexpr std::uint64_t kSeed = 20'000;

}  // namespace

cloud::Placement placement_of(const FieldView& field) {
  const std::optional<trace::StatedPlacement> stated = trace::stated_placement(field);
  if (!stated) throw InputError("the field does not say how its cloud was placed in the workspace; build it again");
  return {stated->scale, stated->offset};
}

SurfaceError compare_with_mesh(const FieldView& field, const cloud::TriangleMesh& mesh) {
  return surface_error(field, cloud::scatter_on_mesh(mesh, kComparePoints, kSeed));
}

field_file::OpenField floor_of_mesh(const FieldView& field, const cloud::TriangleMesh& mesh) {
  field::Grid grid;
  grid.origin = to_double(field.origin);
  grid.edge = to_double(field.edge);
  grid.size = Eigen::Vector3i(field.size[0], field.size[1], field.size[2]);
  const field::MeshDistance distance(mesh);
  encoding::FieldInfo info;
  info.stiffness_n_per_mm = to_double(field.stiffness);
  info.interpolation = field.interpolation;
  return field_file::open_field(encoding::write_image(field::mesh_field(distance, grid, to_double(field.band)), info),
                                "the mesh's exact distances");
}

field_file::OpenField field_of_mesh(const cloud::TriangleMesh& mesh, double edge, double band, Interpolation interpolation) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& vertex : mesh.vertices) box.extend(vertex);
  const field::Grid grid = field::make_grid(box.min(), box.max(), edge, field::mesh_margin(band));
  const field::MeshDistance distance(mesh);
  encoding::FieldInfo info;
  info.interpolation = interpolation;
  return field_file::open_field(encoding::write_image(field::mesh_field(distance, grid, band), info), "another mesh");
}

}  // namespace isotouch::evaluate
