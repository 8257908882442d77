/// A scan as its field needs it: sound samples, as few as tell where all its points lie, and the model of each.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "host/cloud/oriented_points.h"
#include "host/field/local_model.h"
#include "host/field/scan.h"

namespace isotouch::field {

struct AdaptiveSamples {
  std::unique_ptr<Scan> scan;
  std::vector<LocalModel> models;    ///< one a sample
  std::vector<std::uint32_t> point;  ///< which of the points each sample is
  std::size_t isolated = 0;          ///< samples far from all others, left out
  std::size_t turned = 0;            ///< normals that nearly all neighbours contradicted
};

/// A small cloud is taken as it is. A large one is described by one sample a cell of many voxels first; a cell whose points lie off the models of their
/// samples is cut into eight, and so on, down to one voxel: more samples than a grid has places teach nothing. So a scan costs as much as the shape
/// it shows, not as its points are many.
///
/// points    index coordinates, voxels; unit normals, most of them outward; at least 2
/// source    adaptive refinement by held-out points: Ohtake, Belyaev, Alexa, Turk, Seidel, Multi-level partition of unity implicits, 2003
AdaptiveSamples adaptive_samples(cloud::OrientedPoints points);

}  // namespace isotouch::field
