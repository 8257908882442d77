/// A sample's model from the nearest samples within reach.
#pragma once

#include "host/live/live_model.h"
#include "host/live/nodes.h"

namespace isotouch::live {

/// Voxels: neighbours farther away than that do not count.
inline constexpr double kModelReach = 12.0;

struct SampleFit {
  bool felt = false;         ///< it has enough neighbours for a model
  bool unexplained = false;  ///< no local surface explains it together with them
  double influence = 0.0;    ///< squared: a sample beyond that would not change the fit
};

/// entry     its `influence` is a guess of what it will be: it changes the time and not the result
/// live      is told the model, where the sample is felt
SampleFit fit_sample(const Entry& entry, const Nodes& nodes, const Reach& reach_of, LiveModel& live);

}  // namespace isotouch::live
