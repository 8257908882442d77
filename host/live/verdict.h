/// How far a live field can be relied on, counted sample by sample so that it is kept up to date with every batch.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace isotouch::live {

struct Verdict {
  std::size_t points = 0;   ///< present
  std::size_t samples = 0;  ///< buckets that hold points
  std::size_t lonely = 0;   ///< samples with too few neighbours within reach: they are not felt
  std::size_t unexplained =
      0;  ///< samples that no local surface explains together with their neighbours: normals that contradict each other, strays

  double lonely_share() const { return samples > 0 ? static_cast<double>(lonely) / static_cast<double>(samples) : 0.0; }
  double unexplained_share() const { return samples > 0 ? static_cast<double>(unexplained) / static_cast<double>(samples) : 0.0; }

  /// Why the field may be wrong, and what to do; one sentence each; empty = plausible.
  std::vector<std::string> reasons() const;
  bool operator==(const Verdict&) const = default;
};

}  // namespace isotouch::live
