/// The motion of a hand from a recording of ROS 2 or Foxglove: MCAP, or SQLite.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "host/bag/mcap_writer.h"
#include "host/motion/motion_csv.h"

namespace isotouch::bag {

/// Which messages; empty: the only ones that can be meant.
struct BagTopics {
  std::string positions = {}, forces = {};
  bool with_forces = false;  ///< read them, N, straight between two of them
};

/// Is it a recording of one of the two forms? False for what cannot be read.
bool is_bag(const std::filesystem::path& file);

/// Positions in metres become mm. A message's own time counts where each has one, else the time of the recording.
///
/// returns   at least two samples, by rising time
/// fails     InputError naming the file and the topic: none or several can be meant, a message that cannot be read, time that does not rise, fewer than two
std::vector<motion::TimedPoint> read_bag_motion(const std::filesystem::path& file, const BagTopics& topics);

/// The trace within an MCAP file that `isotouch trace export` wrote, to the bit; nothing where there is none.
///
/// fails     InputError as `read_mcap`
std::optional<Bytes> attached_trace(const std::filesystem::path& file);

/// How the attachment is marked.
inline constexpr const char* kTraceMediaType = "application/vnd.isotouch.trace";

}  // namespace isotouch::bag
