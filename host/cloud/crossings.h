/// Area-uniform points on the surface of a shape: where random lines cross it.
#pragma once

#include <cstddef>
#include <cstdint>

#include "host/cloud/oriented_points.h"
#include "host/cloud/shapes.h"

namespace isotouch::cloud {

struct Crossings {
  OrientedPoints points;  ///< in the order in which they were found; the order along one line carries its direction
  double area = 0.0;      ///< of the whole surface, estimated from the share of crossings; relative error about 1 / sqrt(count)
};

/// Shoots lines from everywhere in every direction through the ball round the box until `count` crossings are found. By the Cauchy-Crofton
/// formula each piece of surface is hit in proportion to its area, whatever its direction. Each crossing is bisected to the last bits, and its
/// normal is the shape's there. Crossings of one line less than 1e-5 of the ball's radius apart may be taken for none.
///
/// fails     InputError when the lines meet no surface
/// source    Cauchy-Crofton: L. A. Santalo, Integral Geometry and Geometric Probability, 1976; the walk along a line by safe steps: J. C. Hart,
///           "Sphere tracing", The Visual Computer 12, 1996
Crossings crossings(const Shape& shape, std::size_t count, std::uint64_t seed);

}  // namespace isotouch::cloud
