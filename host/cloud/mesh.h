/// Triangle meshes: true surfaces, to build fields from and to compare them with.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "host/cloud/oriented_points.h"

namespace isotouch::cloud {

struct TriangleMesh {
  std::vector<Eigen::Vector3d> vertices;            ///< in the file's units; no two at one place
  std::vector<std::array<std::uint32_t, 3>> faces;  ///< three different vertices each, counter-clockwise seen from outside
};

/// Does the mesh bound a body: is every edge in exactly two faces that run it in opposite directions, and do the faces turn outward?
///
/// fails     InputError naming the file, how many edges are not closed, and where the first one is
void require_closed(const TriangleMesh& mesh, const std::string& name);

/// The mesh in the workspace, mm. A scale is never negative, so faces stay.
TriangleMesh placed(TriangleMesh mesh, const Placement& placement);

/// A sixth of the sum of the faces' determinants: positive when the faces of a closed mesh turn outward.
double signed_volume(const TriangleMesh& mesh);

/// Of every vertex the first one of the piece that it belongs to; faces that share a vertex are of one piece.
std::vector<std::uint32_t> pieces_of_vertices(const TriangleMesh& mesh);

/// The unit normal of a face; zero when its three corners lie on a line.
Eigen::Vector3d face_normal(const TriangleMesh& mesh, std::size_t face);

/// Area-uniform points, each with the normal of its face and independent of the others; the same for a seed on every machine.
///
/// fails     InputError when the mesh has no area
OrientedPoints scatter_on_mesh(const TriangleMesh& mesh, std::size_t count, std::uint64_t seed);

}  // namespace isotouch::cloud
