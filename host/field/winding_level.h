/// Where samples are in doubt, the winding number tells how far a place may lie from the surface.
///
/// Let w be the winding number and s = 1 - 2w. Above a plane whose samples are softened by h, s = z / √(z² + h²) at the height z. So h s / √(1 - s²) is
/// the distance to the level w = 1/2 near it. This level is a mean over many samples: it is rounder than the models, and no single sample misleads it.
/// The more noise there is, the less may a distance differ from the level.
/// In a thin part it lies too deep, because both sides are smoothed into each other; so it is moved to where the median sample lies.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "host/field/nearest.h"
#include "host/field/scan.h"
#include "host/field/winding_sign.h"

namespace isotouch::field {

class WindingLevel {
 public:
  /// scan      at least 1 sample
  /// doubtful  one a sample, 0 or 1
  /// winding   of the same samples, borrowed
  WindingLevel(const Scan& scan, std::vector<std::uint8_t> doubtful, const WindingSign& winding);

  bool is_doubtful(std::size_t sample) const { return doubtful_[sample] != 0; }

  /// Holds a distance near the one to the level, as closely as the samples round the place are doubtful. It leaves a distance alone where none of them is.
  ///
  /// nearest   the samples nearest to the place, ascending, at least 2; those of a blend and the next one
  /// returns   a distance that moves gradually with the place; what the level adds is at most the way to the nearest sample
  /// fails     never
  double hold(double distance, const Eigen::Vector3d& place, std::span<const Neighbour> nearest) const;

 private:
  /// At a place where samples stand for that area.
  double level(const Eigen::Vector3d& place, double area) const;

  std::vector<std::uint8_t> doubtful_;
  const WindingSign& winding_;
  double slack_;         ///< spacings: how far a distance may differ from the level where all samples are doubtful
  double offset_ = 0.0;  ///< of the samples over the level, in the median
};

}  // namespace isotouch::field
