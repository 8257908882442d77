/// Positions and forces in the messages that ROS 2 and Foxglove have for them.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "host/bag/mcap_reader.h"

namespace isotouch::bag {

struct Measured {
  std::optional<double> stamp_s;  ///< of the message's own header; nothing: it has none, or it is 0
  Eigen::Vector3d value;          ///< m, or N
  bool is_force = false;
};

/// Can messages of this channel hold a position or a force?
bool is_known(const Channel& channel);

/// The types that are read, for sentences.
std::string_view known_types();

/// returns   nothing where the message is too short, no JSON of this form, or not finite
/// source    OMG Common Data Representation (DDS-XTypes 1.3, 7.4), of the classic kind; schemas of common_interfaces and of Foxglove
std::optional<Measured> read_message(const Channel& channel, std::span<const std::uint8_t> data);

}  // namespace isotouch::bag
