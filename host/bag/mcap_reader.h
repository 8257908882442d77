/// Reads an MCAP file of any program from front to back; indices are not needed.
///
/// source    MCAP format specification, version 0, mcap.dev/spec
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>

namespace isotouch::bag {

/// What a message means. The texts are valid only during the call that gets them.
struct Channel {
  std::string_view topic;
  std::string_view schema;    ///< its name, as "geometry_msgs/msg/PointStamped"
  std::string_view encoding;  ///< of its messages, as "cdr" or "json"
};

/// What is called for each message and each attachment, in their order.
///
/// time_ns   when the message was recorded (its log time), ns since 1970 or since an epoch of the recorder's
/// data      valid only during the call
struct McapUses {
  std::function<void(const Channel& channel, std::uint64_t time_ns, std::span<const std::uint8_t> data)> message;
  std::function<void(std::string_view name, std::string_view media_type, std::span<const std::uint8_t> data)> attachment;
};

bool is_mcap(std::span<const std::uint8_t> file);

/// Hands over every message and attachment in their order. A file without its end, as a recorder leaves it that was killed, is read as far as whole records
/// go.
///
/// name      of the file, for sentences
/// returns   is the file whole?
/// fails     InputError naming the file and the byte: a record is damaged, or compressed other than by zstd; something follows the end
bool read_mcap(std::span<const std::uint8_t> file, const std::string& name, const McapUses& uses);

}  // namespace isotouch::bag
