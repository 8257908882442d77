#include "host/field/doubtful_samples.h"

#include <cmath>
#include <cstddef>

#include "host/field/parallel.h"

namespace isotouch::field {

namespace {

constexpr std::size_t kWitnesses = 4;
// Voxels. Trial of 2026-11: at 0.5 a goat's head loses 3 % from truth to surface, at 1 a hydrant with 5 % strays 5 % from surface to truth.
constexpr double kOff = 0.7;
constexpr std::size_t kBeside = 9;  // a sample and as many others as a blend has models

}  // namespace

std::vector<std::uint8_t> doubtful_samples(const Scan& scan, const std::vector<LocalModel>& models) {
  std::vector<std::uint8_t> unexpected(scan.size(), 0);
  in_parallel(scan.size(), 256, [&](std::size_t begin, std::size_t end) {
    for (const std::uint32_t i : scan.together(begin, end)) {
      const auto near = scan.around(i, kWitnesses + 1);
      double sum = 0.0;
      for (const Neighbour& n : near) {
        if (n.index != i) sum += std::abs(models[n.index].distance(scan.positions()[i]));
      }
      unexpected[i] = sum > kOff * static_cast<double>(near.size() - 1) ? 1 : 0;
    }
  });
  std::vector<std::uint8_t> doubtful = unexpected;
  for (std::size_t i = 0; i < scan.size(); ++i) {
    if (unexpected[i] == 0) continue;
    for (const Neighbour& n : scan.around(i, kBeside)) doubtful[n.index] = 1;
  }
  return doubtful;
}

}  // namespace isotouch::field
