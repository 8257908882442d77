#include "host/field/face_tree.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>

namespace isotouch::field {

namespace {

using Eigen::Vector3d;

constexpr std::uint32_t kLeafFaces = 4;

std::uint32_t grow(FaceTree& tree, std::uint32_t first, std::uint32_t count) {
  const auto number = static_cast<std::uint32_t>(tree.nodes.size());
  FaceTree::Node node{Vector3d::Constant(std::numeric_limits<double>::max()), Vector3d::Constant(std::numeric_limits<double>::lowest()),
                      first, count, 0};
  for (std::uint32_t i = first; i < first + count; ++i) {
    for (const Vector3d& corner : tree.faces[i].corners) {
      node.low = node.low.cwiseMin(corner);
      node.high = node.high.cwiseMax(corner);
    }
  }
  tree.nodes.push_back(node);
  if (count <= kLeafFaces) return number;
  int axis = 0;
  (node.high - node.low).maxCoeff(&axis);
  const auto place = [axis](const FaceTree::Face& face) {
    return std::pair(face.corners[0][axis] + face.corners[1][axis] + face.corners[2][axis], face.number);
  };
  const auto at = [&](std::uint32_t face) { return tree.faces.begin() + static_cast<std::ptrdiff_t>(face); };
  const std::uint32_t half = count / 2;
  std::nth_element(at(first), at(first + half), at(first + count),
                   [&](const FaceTree::Face& a, const FaceTree::Face& b) { return place(a) < place(b); });
  grow(tree, first, half);
  tree.nodes[number].right = grow(tree, first + half, count - half);
  return number;
}

}  // namespace

FaceTree::FaceTree(const cloud::TriangleMesh& mesh) {
  faces.reserve(mesh.faces.size());
  for (const auto& [a, b, c] : mesh.faces)
    faces.push_back({{mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]}, static_cast<std::uint32_t>(faces.size())});
  nodes.reserve(mesh.faces.size());
  grow(*this, 0, static_cast<std::uint32_t>(faces.size()));
}

}  // namespace isotouch::field
