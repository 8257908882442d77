/// A field's surface with as few triangles as show it, for files: eighteen corners a square voxel measure a surface, a file needs no more than the eye.
#pragma once

#include "host/cloud/mesh.h"
#include "shared/field_view.h"

namespace isotouch::evaluate {

/// How far a triangle's middle and the middles of its sides may lie from the field's surface, voxels, where corners were taken out.
inline constexpr double kSurfaceTolerance = 0.05;

/// Takes corners out, those of short sides first, by drawing a side together to one of its ends. A corner goes when what closes behind it lies within
/// kSurfaceTolerance of the field's surface, faces outwards, has no side above eight voxels and no new sliver, and when the surface stays a closed
/// manifold with all its handles. So edges and small features keep their triangles, and flat parts lose nearly all.
///
/// mesh      as `zero_surface` returns it, with its corners apart
/// returns   closed, faces counter-clockwise seen from outside; its corners are some of the mesh's, unmoved and in their order
/// same      for every number of threads and on every machine
/// source    link condition: T. Dey, H. Edelsbrunner, S. Guha, D. Nekhayev, "Topology preserving edge contraction", 1999
cloud::TriangleMesh fewer_triangles(const FieldView& field, cloud::TriangleMesh mesh);

}  // namespace isotouch::evaluate
