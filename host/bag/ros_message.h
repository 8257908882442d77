/// Positions and forces in the messages that ROS 2 and Foxglove have for them.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "host/bag/mcap_reader.h"

namespace isotouch::bag {

struct Measured {
  std::optional<std::int64_t> stamp_ns;  ///< of the message itself, ns since 1970; nothing: it has none, or it is 0
  Eigen::Vector3d value;                 ///< m, or N
  std::string frame;                     ///< whose coordinates these are; empty: it is not said
  std::string body;                      ///< of a transform: what is moved
};

/// What messages of a channel say.
enum class Content : std::uint8_t { kNothing, kPosition, kForce, kAnyVector };  ///< any vector may be a velocity, too

Content content_of(const Channel& channel);

/// The types that are read, for sentences.
std::string_view known_types();

/// returns   nothing where the message is too short, no JSON of this form, or not finite
/// source    OMG Common Data Representation (DDS-XTypes 1.3, 7.4), of the classic kind; schemas of common_interfaces and of Foxglove
std::optional<Measured> read_message(const Channel& channel, std::span<const std::uint8_t> data);

}  // namespace isotouch::bag
