#include "host/evaluate/mesh_shape.h"

#include <Eigen/Geometry>
#include <memory>
#include <utility>

#include "host/evaluate/truth_comparison.h"
#include "host/evaluate/wrong_side.h"
#include "host/field/mesh_distance.h"
#include "host/field/triangle_tree.h"

namespace isotouch::evaluate {

namespace {

constexpr double kLongestSide = 186;
constexpr std::size_t kPoints = 4500;

/// What the shape's functions share; the tree borrows the mesh of the distance.
struct Body {
  explicit Body(cloud::TriangleMesh mesh) : distance(std::move(mesh)), tree(distance.mesh()) {}
  field::MeshDistance distance;
  field::TriangleTree tree;
};

}  // namespace

cloud::Shape mesh_shape(cloud::TriangleMesh mesh, const std::string& name) {
  cloud::require_closed(mesh, name);
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& vertex : mesh.vertices) box.extend(vertex);
  const double scale = kLongestSide / box.sizes().maxCoeff();
  for (Eigen::Vector3d& vertex : mesh.vertices) vertex = scale * (vertex - box.center());
  const auto body = std::make_shared<const Body>(std::move(mesh));

  cloud::Shape shape;
  shape.name = name;
  shape.sentence = "a mesh from a file";
  shape.default_points = kPoints;
  shape.exact_distance = true;
  shape.distance = [body](const Eigen::Vector3d& p) { return body->distance(p); };
  shape.normal = [body](const Eigen::Vector3d& p) { return cloud::face_normal(body->distance.mesh(), body->tree.nearest(p).face); };
  shape.volume = body->distance.is_simple() ? cloud::signed_volume(body->distance.mesh())
                                            : wrong_side(body->tree, body->tree, 1 / kLinesPerVoxel).truth;
  shape.high = 0.5 * scale * box.sizes();
  shape.low = -shape.high;
  return shape;
}

}  // namespace isotouch::evaluate
