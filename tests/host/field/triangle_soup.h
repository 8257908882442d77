/// A mesh without any order, for tests that ask a tree and a plain loop the same.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>

#include "host/cloud/mesh.h"
#include "host/cloud/random.h"
#include "tests/host/field/random_places.h"

namespace isotouch::field {

/// Triangles of all sizes anywhere, some of them without area.
inline cloud::TriangleMesh soup(std::size_t count) {
  cloud::Random random(7);
  cloud::TriangleMesh mesh;
  for (std::uint32_t i = 0; i < count; ++i) {
    const Eigen::Vector3d middle = draw(random, 10);
    const double size = random.uniform() * random.uniform() * 4;
    for (int corner = 0; corner < 3; ++corner) mesh.vertices.push_back(middle + size * draw(random, 1));
    if (i % 17 == 0) mesh.vertices.back() = mesh.vertices[mesh.vertices.size() - 2];
    mesh.faces.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return mesh;
}

}  // namespace isotouch::field
