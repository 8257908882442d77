/// Which points of a cloud lie at one place?
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace isotouch::cloud {

/// Points are at one place if a scanner would not resolve them: rounding has moved them apart, as when one scan was saved in two frames.
///
/// positions  finite
/// at_least   points as near to each other as this are at one place, too
/// returns    of each point, the first point at its place; the point itself where no other is before it
std::vector<std::uint32_t> first_at_place(const std::vector<Eigen::Vector3d>& positions, double at_least = 0.0);

}  // namespace isotouch::cloud
