/// Random places, and steps to them, for tests.
#pragma once

#include <Eigen/Core>

#include "host/cloud/random.h"

namespace isotouch::field {

/// Within ±half along each axis.
inline Eigen::Vector3d draw(cloud::Random& random, double half) {
  const double x = random.uniform(-half, half), y = random.uniform(-half, half);
  return {x, y, random.uniform(-half, half)};
}

/// Three nearly normal numbers of variance 1.
inline Eigen::Vector3d scatter(cloud::Random& random) {
  Eigen::Vector3d result;
  for (double& x : result) {
    x = -6;
    for (int k = 0; k < 12; ++k) x += random.uniform();
  }
  return result;
}

}  // namespace isotouch::field
