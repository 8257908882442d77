/// Samples whose surroundings no local model describes well: noise, strays beside the surface, turned normals, details finer than the spacing.
#pragma once

#include <cstdint>
#include <vector>

#include "host/field/local_model.h"
#include "host/field/scan.h"

namespace isotouch::field {

/// scan      voxels
/// models    one a sample
/// returns   of each sample: 1 if the models of its nearest four neighbours expect the surface more than 0.7 voxel beside it in the mean, or if it is
///           one of the eight nearest of such a sample; otherwise 0
/// fails     never
std::vector<std::uint8_t> doubtful_samples(const Scan& scan, const std::vector<LocalModel>& models);

}  // namespace isotouch::field
