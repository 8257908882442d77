/// A tick of the core as C gets it.
#pragma once

#include <cstddef>

#include "host/library/isotouch.h"
#include "host/to_double.h"
#include "shared/tick_io.h"

namespace isotouch::library {

/// real time   yes
inline isotouch_felt felt_of(std::uint64_t tick, const Output& output) {
  const Eigen::Vector3d hip = to_double(output.hip), proxy = to_double(output.proxy), force = to_double(output.force);
  isotouch_felt felt{};
  felt.tick = tick;
  Eigen::Map<Eigen::Vector3d>(felt.hip_mm) = hip;
  Eigen::Map<Eigen::Vector3d>(felt.proxy_mm) = proxy;
  Eigen::Map<Eigen::Vector3d>(felt.force_n) = force;
  felt.contact = (output.status & kContact) != 0 ? 1 : 0;
  felt.penetration_mm = felt.contact != 0 ? (proxy - hip).norm() : 0.0;
  felt.status = output.status;
  felt.state = output.state;
  felt.faults = output.faults;
  felt.buttons = output.buttons;
  for (std::size_t leg = 0; leg < output.commands.size(); ++leg) felt.commands[leg] = output.commands[leg];
  return felt;
}

}  // namespace isotouch::library
