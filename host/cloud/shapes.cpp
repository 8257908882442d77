#include "host/cloud/shapes.h"

#include <algorithm>
#include <utility>

#include "host/cloud/bodies.h"
#include "host/cloud/crossings.h"
#include "host/cloud/objects.h"
#include "host/cloud/poisson_disk.h"
#include "host/error.h"

namespace isotouch::cloud {
namespace {

using Eigen::Vector3d;

/// The five shapes that accuracy is measured on (lengths in voxels of a 300^3 grid), then the five characters.
std::vector<Object> all_objects() {
  std::vector<Object> objects = {
      {"sphere", "a sphere of radius 80", 3756, sphere({0, 0, 0}, 80), {-80, -80, -80}, {80, 80, 80}},
      {"torus",
       "a torus round z, ring of radius 70, tube of radius 25",
       3756,
       torus({0, 0, 0}, {0, 0, 1}, 70, 25),
       {-95, -95, -25},
       {95, 95, 25}},
      {"box", "a box of half extents 80, 60, 40", 3756, box({0, 0, 0}, {80, 60, 40}), {-80, -60, -40}, {80, 60, 40}},
      {"plate", "a plate of half extents 80, 60, 2", 3756, box({0, 0, 0}, {80, 60, 2}), {-80, -60, -2}, {80, 60, 2}},
      {"capsules",
       "two capsules, each 160 long, crossed at right angles: radius 20 along x, radius 12 along y",
       3756,
       unite({capsule({-60, 0, 0}, {60, 0, 0}, 20), capsule({0, -68, 0}, {0, 68, 0}, 12)}),
       {-80, -80, -20},
       {80, 80, 20}},
  };
  for (Object& character : characters()) objects.push_back(std::move(character));
  return objects;
}

constexpr std::size_t kExactShapes = 5;
constexpr std::size_t kCandidatesPerPoint = 8;

}  // namespace

const std::vector<std::string>& shape_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> list;
    for (const Object& object : all_objects()) list.push_back(object.name);
    return list;
  }();
  return names;
}

Shape shape(std::string_view name) {
  std::vector<Object> objects = all_objects();
  const auto found = std::find_if(objects.begin(), objects.end(), [&](const Object& object) { return object.name == name; });
  if (found == objects.end()) {
    std::string sentence = "there is no shape '" + std::string(name) + "'; choose one of";
    for (const std::string& known : shape_names()) sentence += ' ' + known;
    throw InputError(sentence);
  }
  Shape shape;
  shape.name = found->name;
  shape.sentence = found->sentence;
  shape.default_points = found->points;
  shape.exact_distance = static_cast<std::size_t>(found - objects.begin()) < kExactShapes;
  shape.distance = [body = found->body](const Vector3d& p) { return body(p).distance; };
  shape.normal = [body = found->body](const Vector3d& p) { return body(p).gradient; };
  shape.low = found->low;
  shape.high = found->high;
  return shape;
}

OrientedPoints sample_shape(const Shape& shape, std::size_t count, std::uint64_t seed) {
  const Crossings candidates = crossings(shape, kCandidatesPerPoint * count, seed);
  OrientedPoints points;
  for (const std::size_t i : spread_out(candidates.points, candidates.area, count)) {
    points.positions.push_back(candidates.points.positions[i]);
    points.normals.push_back(candidates.points.normals[i]);
  }
  return points;
}

OrientedPoints scatter_on_shape(const Shape& shape, std::size_t count, std::uint64_t seed) { return crossings(shape, count, seed).points; }

}  // namespace isotouch::cloud
