/// A field against the true surface of its object.
#pragma once

#include <cstddef>
#include <cstdint>

#include "host/cloud/mesh.h"
#include "host/cloud/oriented_points.h"
#include "host/evaluate/surface_error.h"
#include "host/field_file/open_field.h"

namespace isotouch::evaluate {

inline constexpr std::size_t kComparePoints = 20'000;

/// How the field's cloud was placed in the workspace.
///
/// fails     InputError when the header's numbers are not finite, the scale is not positive, or the field's box lies where no cloud can
cloud::Placement placement_of(const FieldView& field);

/// The error at kComparePoints area-uniform points of the mesh.
///
/// mesh      closed, workspace, mm
/// fails     InputError when not one point has a crossing
SurfaceError compare_with_mesh(const FieldView& field, const cloud::TriangleMesh& mesh);

/// The mesh's own exact distances on the field's grid and band: what no method can go below. It is interpolated and stiff as the field, everywhere as
/// stiff as the field is at most.
field_file::OpenField floor_of_mesh(const FieldView& field, const cloud::TriangleMesh& mesh);

/// Another closed mesh as a field of its own, to be measured like any other: on a grid that holds it.
///
/// mesh      closed, workspace, mm
/// edge      of a voxel, mm
/// band      half width, voxels
/// fails     InputError of `make_grid`
field_file::OpenField field_of_mesh(const cloud::TriangleMesh& mesh, double edge, double band, Interpolation interpolation);

}  // namespace isotouch::evaluate
