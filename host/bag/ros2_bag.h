/// Reads a recording of ROS 2 in its SQLite form (`.db3`).
///
/// source    rosbag2_storage_sqlite3, tables topics and messages
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>

#include "host/bag/mcap_reader.h"

namespace isotouch::bag {

bool is_sqlite(std::span<const std::uint8_t> begin);

/// Hands over every message by rising time of its recording.
///
/// time_ns   when the message was recorded, ns since 1970; channel and data are valid only during the call
/// fails     InputError naming the file: no such tables, damaged, in use by a recorder
void read_ros2_bag(const std::filesystem::path& file,
                   const std::function<void(const Channel& channel, std::uint64_t time_ns, std::span<const std::uint8_t> data)>& use);

}  // namespace isotouch::bag
