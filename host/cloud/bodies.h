/// Solid bodies as implicit functions: primitives, and how they are put together.
///
/// A body gives, for any point, a distance (negative inside, zero exactly on the surface) and its gradient. Every body here keeps two promises:
/// |distance| is at most the Euclidean distance to the surface, so a step of that length cannot cross it; and on the surface the gradient
/// points along the outward normal. Only square roots are used, so a body is the same to the last bit on every machine.
///
/// source    distances to boxes, tori, capsules, round cones and cone stumps are elementary geometry, collected by I. Quilez,
///           https://iquilezles.org/articles/distfunctions/
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

namespace isotouch::cloud {

/// What a body knows about one point.
struct Probe {
  double distance = 0.0;
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();  ///< the way in which the distance grows, unit length
};

/// A body, and a ball that holds all of it, so that a union need not ask parts that are too far away to matter.
struct Body {
  std::function<Probe(const Eigen::Vector3d&)> probe;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  double radius = 0.0;  ///< infinite for a half space

  Probe operator()(const Eigen::Vector3d& p) const { return probe(p); }
};

// Primitives. Their distances are Euclidean on both sides, but for the ellipsoid's, which is too small.

Body sphere(const Eigen::Vector3d& centre, double radius);
/// Everything within `radius` of the segment from a to b.
Body capsule(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double radius);
/// The hull of two spheres. Neither may hold the other.
Body round_cone(const Eigen::Vector3d& a, double radius_a, const Eigen::Vector3d& b, double radius_b);
/// A disc of radius a about a, one of radius b about b, and the straight mantle between them.
Body cone_stump(const Eigen::Vector3d& a, double radius_a, const Eigen::Vector3d& b, double radius_b);
Body cylinder(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double radius);
/// The ring of radius `ring` about `axis` (any length), with a tube of radius `tube`.
Body torus(const Eigen::Vector3d& centre, const Eigen::Vector3d& axis, double ring, double tube);
/// Along the axes; edges and corners rounded with `rounding`, which the half extents include.
Body box(const Eigen::Vector3d& centre, const Eigen::Vector3d& half_extents, double rounding = 0.0);
/// `first` is the direction (any length) of the first semi-axis, `second` lies in the plane of the first two.
Body ellipsoid(const Eigen::Vector3d& centre, const Eigen::Vector3d& semi_axes, const Eigen::Vector3d& first = Eigen::Vector3d::UnitX(),
               const Eigen::Vector3d& second = Eigen::Vector3d::UnitY());
/// Everything behind the plane through `point` with outward normal `normal` (any length).
Body half_space(const Eigen::Vector3d& point, const Eigen::Vector3d& normal);

// Combinations. Zero set and sign stay exact; a union stays Euclidean outside, an intersection inside, elsewhere the distance may be too small.

Body unite(std::vector<Body> parts);
Body intersect(std::vector<Body> parts);
Body subtract(const Body& from, const Body& what);
/// The part of the body with x >= 0, and its mirror image.
Body mirror_x(const Body& half);

}  // namespace isotouch::cloud
