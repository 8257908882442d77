#include "host/field/mesh_field.h"

#include <cstddef>
#include <optional>
#include <vector>

#include "host/field/bricks.h"

namespace isotouch::field {

BandField mesh_field(const MeshDistance& mesh, const Grid& grid, double band) {
  const SampledDistance distance{[&](const Eigen::Vector3d& index) { return mesh(grid.origin + grid.edge * index) / grid.edge; },
                                 [&](const Eigen::Vector3i& cell, double reach) {
                                   const auto block = mesh.block(grid.position(4 * cell), grid.edge, reach);
                                   BrickDistances found{block.middle / grid.edge, std::nullopt};
                                   if (!block.points) return found;
                                   auto& samples = found.samples.emplace();
                                   for (std::size_t s = 0; s < samples.size(); ++s)
                                     samples[s] = static_cast<float>((*block.points)[s] / grid.edge);
                                   return found;
                                 },
                                 1.0 + 1e-6};
  std::vector<Eigen::Vector3i> seeds;
  seeds.reserve(mesh.outer().vertices.size());
  for (const auto& vertex : mesh.outer().vertices) seeds.emplace_back((grid.to_index(vertex) * 0.25).array().floor().cast<int>());
  BandField field{grid, band, {}};
  field.bricks = band_bricks(distance, (grid.size + Eigen::Vector3i::Constant(3)) / 4, band, seeds);
  return field;
}

}  // namespace isotouch::field
