/// The motion of a hand from a recording of ROS 2 or Foxglove: MCAP, or SQLite.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "host/bag/mcap_writer.h"
#include "host/motion/motion_csv.h"

namespace isotouch::bag {

/// Topics of the messages that are read; an empty one means the only topic that can be meant.
struct BagTopics {
  std::string positions = {}, forces = {};
  bool with_forces = false;   ///< also read forces, N; between two of them a force is interpolated
  double mm_per_unit = 1000;  ///< of the positions; ROS 2 has metres
};

/// Whether the file is a recording of one of the two forms; false also where it cannot be read.
bool is_bag(const std::filesystem::path& file);

/// Positions become mm. A message's own time counts where each has one, and not all are zero; else the time of the recording.
///
/// returns   at least two samples, by rising time
/// fails     InputError naming the file and the topic: none or several can be meant, a message that cannot be read, several bodies or coordinate frames in
///           one topic, forces in another frame than the positions, time that does not rise, fewer than two positions, or a place of the motion that
///           is more than 0.1 s away from every force
std::vector<motion::TimedPoint> read_bag_motion(const std::filesystem::path& file, const BagTopics& topics);

struct AttachedTrace {
  Bytes trace;
  std::optional<Bytes> patches = {};  ///< of its field
};

/// The trace within an MCAP file that `isotouch trace export` wrote, to the bit; nothing where there is none.
///
/// fails     InputError as `read_mcap`
std::optional<AttachedTrace> attached_trace(const std::filesystem::path& file);

/// How the attachments are marked.
inline constexpr const char* kTraceMediaType = "application/vnd.isotouch.trace";
inline constexpr const char* kPatchesMediaType = "application/vnd.isotouch.patches";

}  // namespace isotouch::bag
