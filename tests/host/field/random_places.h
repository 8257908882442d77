/// Places for tests that ask a structure and a plain loop the same.
#pragma once

#include <Eigen/Core>

#include "host/cloud/random.h"

namespace isotouch::field {

/// Within ±half along each axis.
inline Eigen::Vector3d draw(cloud::Random& random, double half) {
  const double x = random.uniform(-half, half), y = random.uniform(-half, half);
  return {x, y, random.uniform(-half, half)};
}

}  // namespace isotouch::field
