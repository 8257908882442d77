#include "host/field/sheets.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "host/field/face_edges.h"
#include "host/field/sets.h"

namespace isotouch::field {

namespace {

void join(Sets& sets, std::uint32_t a, std::uint32_t b) {
  const std::uint32_t root = sets.of(a), other = sets.of(b);
  if (root != other) sets.join(root, other);
}

/// Joins faces to sheets, and calls end_at(sheets) for every edge of more than two faces at which sheets end: each of them runs the edge more often
/// in one direction than in the other.
template <class End>
void each_end(const cloud::TriangleMesh& mesh, Sets& sheets, const End& end_at) {
  const std::vector<FaceEdge> edges = face_edges(mesh);
  std::vector<std::pair<std::size_t, std::size_t>> many;  // edges of more than two faces
  for (std::size_t begin = 0, end = 0; begin < edges.size(); begin = end) {
    while (end < edges.size() && edges[end].same_edge(edges[begin])) ++end;
    if (end - begin == 2) join(sheets, edges[begin].face, edges[begin + 1].face);
    if (end - begin > 2) many.emplace_back(begin, end);
  }
  std::vector<std::pair<std::uint32_t, int>> runs;  // a sheet, and one of its ways
  std::vector<std::uint32_t> ending;
  for (const auto& [begin, end] : many) {
    runs.clear();
    for (std::size_t i = begin; i < end; ++i) runs.emplace_back(sheets.of(edges[i].face), edges[i].is_back(mesh) ? -1 : 1);
    std::sort(runs.begin(), runs.end());
    ending.clear();
    for (std::size_t i = 0; i < runs.size();) {
      const std::uint32_t sheet = runs[i].first;
      int surplus = 0;
      for (; i < runs.size() && runs[i].first == sheet; ++i) surplus += runs[i].second;
      if (surplus != 0) ending.push_back(sheet);
    }
    if (!ending.empty()) end_at(ending);
  }
}

std::vector<std::uint32_t> roots(Sets& sets) {
  std::vector<std::uint32_t> of(sets.size());
  for (std::uint32_t face = 0; face < of.size(); ++face) of[face] = sets.of(face);
  return of;
}

}  // namespace

Sheets sheets_of(const cloud::TriangleMesh& mesh) {
  Sets sets(mesh.faces.size());
  Sheets sheets{{}, std::vector<std::uint8_t>(mesh.faces.size())};
  each_end(mesh, sets, [&](const std::vector<std::uint32_t>& ending) {
    for (const std::uint32_t sheet : ending) sheets.open[sheet] = 1;
  });
  sheets.of = roots(sets);
  return sheets;
}

std::vector<std::uint32_t> pieces_of_faces(const cloud::TriangleMesh& mesh) {
  Sets sets(mesh.faces.size());
  std::vector<std::pair<std::uint32_t, std::uint32_t>> together;
  each_end(mesh, sets, [&](const std::vector<std::uint32_t>& ending) {
    for (const std::uint32_t sheet : ending) together.emplace_back(ending.front(), sheet);
  });
  for (const auto& [a, b] : together) join(sets, a, b);
  return roots(sets);
}

}  // namespace isotouch::field
