#include "host/field/face_edges.h"

#include <algorithm>
#include <cstddef>

#include "host/field/parallel.h"

namespace isotouch::field {

std::vector<FaceEdge> face_edges(const cloud::TriangleMesh& mesh) {
  // A place for every lower vertex's edges first: what is left to sort are the few edges of one vertex.
  std::vector<std::uint32_t> begin(mesh.vertices.size() + 1, 0);
  const auto each_edge = [&](const auto& use) {
    for (std::uint32_t face = 0; face < mesh.faces.size(); ++face) {
      const auto& f = mesh.faces[face];
      for (std::uint32_t side = 0; side < 3; ++side) {
        const auto [low, high] = std::minmax(f[side], f[side == 2 ? 0 : side + 1]);
        use(FaceEdge{low, high, face, side});
      }
    }
  };
  each_edge([&](const FaceEdge& edge) { ++begin[edge.low + 1]; });
  for (std::size_t v = 1; v < begin.size(); ++v) begin[v] += begin[v - 1];
  std::vector<FaceEdge> edges(3 * mesh.faces.size());
  std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
  each_edge([&](const FaceEdge& edge) { edges[next[edge.low]++] = edge; });
  in_parallel(mesh.vertices.size(), 4096, [&](std::size_t first, std::size_t end) {
    for (std::size_t v = first; v < end; ++v) std::sort(edges.data() + begin[v], edges.data() + begin[v + 1]);
  });
  return edges;
}

}  // namespace isotouch::field
