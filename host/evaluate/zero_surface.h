/// The whole zero surface of a field as triangles: all of it, also what no ray from outside and no point of a mesh would find.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "host/cloud/mesh.h"
#include "shared/field_view.h"

namespace isotouch::evaluate {

enum class Corners {
  kExact,
  kApart,  ///< for a file that other programs read
};

/// Walks every brick whose numbers, with those around it, have both signs; no other place of the field can be zero. There the field is
/// known exactly on a lattice of half voxels, each lattice cube is cut into six tetrahedra, and each tetrahedron with both signs gives one or two
/// triangles. Each corner of a triangle is put on the zero of the core's own samples, to 2^-15 voxel: about eighteen a square voxel of surface.
///
/// corners   kApart moves a corner that is nearer than 1/256 of its lattice edge to a lattice point that far away, by at most 0.0034 voxel. No two
///           corners are at one place then, and no triangle is without area
/// exact     the corners, unless moved; that the surface is closed; every sign at a lattice point
/// bounded   between the corners the triangles are chords: off by h²/8r with h below 0.87 voxel on a surface bent with radius r, 0.05 voxel at
///           r = 2. What fits between lattice points, bubbles and necks thinner than half a voxel, may be missed or joined
/// returns   closed, faces counter-clockwise seen from outside, workspace, mm; no vertices when nothing is inside. Exact vertices may lie at one
///           place where a lattice point is exactly on the surface
/// fails     InputError of `require_stored_surface`
/// source    marching tetrahedra on Kuhn's subdivision: A. Doi and A. Koide, IEICE Transactions E74(1), 1991
cloud::TriangleMesh zero_surface(const FieldView& field, Corners corners = Corners::kExact);

/// One connected piece of a surface.
struct Piece {
  double volume = 0;                                ///< mm³, signed: negative for a cavity, whose faces turn inward
  double area = 0;                                  ///< mm²
  Eigen::Vector3d place = Eigen::Vector3d::Zero();  ///< one of its vertices
};

/// The connected pieces of a closed surface, the one of largest volume first (by magnitude; of equals the one whose vertices come first).
std::vector<Piece> pieces(const cloud::TriangleMesh& surface);

/// Their volumes and their areas together.
double volume(const std::vector<Piece>& pieces);
double area(const std::vector<Piece>& pieces);

}  // namespace isotouch::evaluate
