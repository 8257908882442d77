/// Noise, fine detail and bad normals of a scan told apart: each measure sees only some of them.
#pragma once

#include "host/field/scan.h"

namespace isotouch::field {

/// How far samples lie off what their neighbours expect, and normals off what positions say.
struct Roughness {
  double of_positions = 0;  ///< standard deviation from paraboloids through positions alone: noise, or detail finer than the spacing
  double of_pairs = 0;      ///< standard deviation from the circles that two samples' normals describe: noise of positions, or of normals
  double of_no_step = 0;    ///< of pairs, extrapolated to a distance of zero: noise of positions alone
  /// Deviation of a normal from its direction, radians: from pairs, extrapolated to a distance of zero. At most what the circles of near pairs show:
  /// normals that agree are right, however far they turn from one sample to the next.
  double of_normals = 0;
  double tilt = 0;     ///< sine of the angle between normals and those of the paraboloids, the median
  double spacing = 0;  ///< median distance to the nearest sample
  /// Mean size over root mean square of the samples' heights over their paraboloids, each in standard deviations: 0.82 in normal noise, 0.84 where every
  /// height is as likely, 0.88 to 0.99 where the samples are those of two sheets closer to each other than the samples are.
  double layered = 0;

  /// `of_pairs` without what bad normals add: they are tilted more than detail of that size lets paraboloids err.
  double of_pairs_untilted() const;
  /// At most so much: detail contradicts no normal, and a wrong normal no position.
  double noise() const;
  /// Noise is as rough for pairs as for positions; detail is smoother for pairs. Where detail makes positions rough too, noise shows in near pairs as
  /// much as in far ones, and what bad normals or detail add grows with the step.
  bool is_noise() const;
};

/// scan      at least 2 samples; asks about 4,096 of them
/// spacing   the median distance to the nearest sample, above 0
Roughness roughness(const Scan& scan, double spacing);

}  // namespace isotouch::field
