#include "host/bag/bag_motion.h"

#include <algorithm>
#include <cstdio>
#include <functional>
#include <limits>
#include <numeric>
#include <set>
#include <utility>

#include "host/bag/mcap_reader.h"
#include "host/bag/ros2_bag.h"
#include "host/bag/ros_message.h"
#include "host/error.h"
#include "host/files/whole_file.h"
#include "host/motion/resample.h"

namespace isotouch::bag {

namespace {

using Use = std::function<void(const Channel&, std::uint64_t, std::span<const std::uint8_t>)>;

void each_message(const std::filesystem::path& file, const Use& use) {
  if (is_sqlite(first_bytes(file))) return read_ros2_bag(file, use);
  if (!read_mcap(read_file(file), file.string(), {use, {}}))
    std::fprintf(stderr, "isotouch: %s: its end is missing; what is whole was read\n", file.string().c_str());
}

constexpr double kNever = std::numeric_limits<double>::infinity();

std::string text_of(double seconds) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", seconds);
  return text;
}

/// What one topic says. Nanoseconds since 1970 need 61 bits, more than a double has.
struct Series {
  std::vector<std::int64_t> stamps_ns, recorded_ns;
  std::vector<Eigen::Vector3d> values;
  std::string frame, body;  ///< of the first message, and so of all
};

class Collector {
 public:
  Collector(const std::string& file, const BagTopics& topics) : file_(file), topics_(topics) {}

  void operator()(const Channel& channel, std::uint64_t time_ns, std::span<const std::uint8_t> data) {
    const Content what = content_of(channel);
    const std::string topic(channel.topic);
    if (what == Content::kNothing || (what == Content::kAnyVector && topic != topics_.positions))
      return;  // a vector may be a velocity as well
    const bool is_force = what == Content::kForce;
    const std::string& wanted = is_force ? topics_.forces : topics_.positions;
    if (is_force && !topics_.with_forces) return;
    (is_force ? force_topics_ : position_topics_).insert(topic);
    if (!wanted.empty() && wanted != topic) return;
    const std::optional<Measured> measured = read_message(channel, data);
    Series& series = is_force ? forces_ : positions_;
    if (!measured) {
      throw InputError(file_ + ": message " + std::to_string(series.values.size()) + " of " + topic + " cannot be read as " +
                       std::string(channel.schema) + "; record the topic again, or choose another one with --topic");
    }
    if (series.values.empty()) series.frame = measured->frame, series.body = measured->body;
    if (measured->body != series.body) {
      throw InputError(file_ + ": " + topic + " has positions of several bodies, '" + series.body + "' and '" + measured->body +
                       "'; record the hand's on a topic of its own, and name it with --topic");
    }
    if (measured->frame != series.frame) {
      throw InputError(file_ + ": " + topic + " is in several coordinate frames, '" + series.frame + "' and '" + measured->frame +
                       "'; transform its messages into one frame, and record them again");
    }
    if (measured->stamp_ns) series.stamps_ns.push_back(*measured->stamp_ns);
    series.recorded_ns.push_back(static_cast<std::int64_t>(time_ns));
    series.values.push_back(measured->value);
  }

  std::vector<motion::TimedPoint> points() {
    require_one(position_topics_, topics_.positions, "a position", "--topic");
    if (topics_.with_forces) require_one(force_topics_, topics_.forces, "a force", "--force-topic");
    if (topics_.with_forces) require_same_frame();
    const bool stamped = is_stamped(positions_) && (!topics_.with_forces || is_stamped(forces_));
    for (Series* series : {&positions_, &forces_}) sort_by_time(*series, stamped);
    const std::vector<std::int64_t>& all = stamped ? positions_.stamps_ns : positions_.recorded_ns;
    const std::int64_t first = all.empty() ? 0 : all.front();
    const std::vector<double> times = times_of(positions_, stamped, first), force_times = times_of(forces_, stamped, first);
    if (times.size() < 2)
      throw InputError(file_ + ": the topic has fewer than two positions; record for longer, or choose another topic with --topic");
    std::vector<motion::TimedPoint> points;
    for (std::size_t i = 0; i < times.size(); ++i) {
      motion::TimedPoint point{times[i], topics_.mm_per_unit * positions_.values[i]};
      if (topics_.with_forces) point.force = force_at(times[i], force_times);
      points.push_back(point);
    }
    return points;
  }

 private:
  void require_one(const std::set<std::string>& topics, const std::string& wanted, const char* what, const char* option) const {
    std::string all;
    for (const std::string& topic : topics) all += (all.empty() ? "" : ", ") + topic;
    if (topics.empty())
      throw InputError(file_ + ": none of its topics has " + what + "; these types of messages are read: " + std::string(known_types()));
    if (!wanted.empty() && topics.count(wanted) == 0)
      throw InputError(file_ + ": the topic " + wanted + " does not have " + what + "; choose one of " + all);
    if (wanted.empty() && topics.size() > 1)
      throw InputError(file_ + ": several topics have " + what + "; choose one with " + option + ": " + all);
  }

  /// A force along other axes would turn every normal that is made of it.
  void require_same_frame() const {
    if (positions_.frame.empty() || forces_.frame.empty() || positions_.frame == forces_.frame) return;
    throw InputError(file_ + ": the positions are in the coordinate frame '" + positions_.frame + "' and the forces in '" + forces_.frame +
                     "'; transform the forces into the frame of the positions and record them again, or leave --forces out");
  }

  /// A clock that always says zero is none; one of a simulation may begin there.
  static bool is_stamped(const Series& series) {
    return series.stamps_ns.size() == series.values.size() &&
           std::any_of(series.stamps_ns.begin(), series.stamps_ns.end(), [](std::int64_t stamp) { return stamp != 0; });
  }

  /// By the time that counts: a message may have been overtaken on its way, and the chunks of an MCAP file need not follow each other in time.
  static void sort_by_time(Series& series, bool stamped) {
    std::vector<std::int64_t>& times = stamped ? series.stamps_ns : series.recorded_ns;
    if (std::is_sorted(times.begin(), times.end())) return;
    std::vector<std::size_t> order(series.values.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return times[a] < times[b]; });
    const auto reorder = [&](auto& list) {
      auto sorted = list;
      for (std::size_t i = 0; i < order.size(); ++i) sorted[i] = list[order[i]];
      list = std::move(sorted);
    };
    reorder(times);
    reorder(series.values);
  }

  /// Seconds since the first position.
  std::vector<double> times_of(const Series& series, bool stamped, std::int64_t first_ns) const {
    std::vector<double> times;
    for (const std::int64_t ns : stamped ? series.stamps_ns : series.recorded_ns)
      times.push_back(
          1e-9 * static_cast<double>(static_cast<std::int64_t>(static_cast<std::uint64_t>(ns) - static_cast<std::uint64_t>(first_ns))));
    for (std::size_t i = 1; i < times.size(); ++i) {
      if (!(times[i] > times[i - 1]))
        throw InputError(file_ + ": message " + std::to_string(i) + " of the topic is not later than the message before; record it again");
    }
    return times;
  }

  Eigen::Vector3d force_at(double time, const std::vector<double>& times) const {
    const auto after = std::lower_bound(times.begin(), times.end(), time);
    const double since = after == times.begin() ? kNever : time - *(after - 1), until = after == times.end() ? kNever : *after - time;
    if (std::min(since, until) > motion::kMaxGap) {
      throw InputError(file_ + ": no force within " + text_of(motion::kMaxGap) + " s of the position at " + text_of(time) +
                       " s; the forces are from " + text_of(times.front()) + " to " + text_of(times.back()) +
                       " s. Record both topics all the time and by one clock, or leave --forces out");
    }
    if (after == times.begin()) return forces_.values.front();
    if (after == times.end()) return forces_.values.back();
    const auto i = static_cast<std::size_t>(after - times.begin());
    const double t = (time - times[i - 1]) / (times[i] - times[i - 1]);
    return (1 - t) * forces_.values[i - 1] + t * forces_.values[i];
  }

  const std::string& file_;
  const BagTopics& topics_;
  std::set<std::string> position_topics_, force_topics_;
  Series positions_, forces_;
};

}  // namespace

bool is_bag(const std::filesystem::path& file) {
  if (is_standard(file)) return false;
  const auto begin = first_bytes(file);
  return is_mcap(begin) || is_sqlite(begin);
}

std::vector<motion::TimedPoint> read_bag_motion(const std::filesystem::path& file, const BagTopics& topics) {
  const std::string name = file.string();
  Collector collector(name, topics);
  each_message(file, std::ref(collector));
  return collector.points();
}

std::optional<AttachedTrace> attached_trace(const std::filesystem::path& file) {
  if (!is_mcap(first_bytes(file))) return std::nullopt;
  std::optional<Bytes> trace, patches;
  read_mcap(read_file(file), file.string(), {{}, [&](std::string_view, std::string_view media_type, std::span<const std::uint8_t> data) {
                                               if (media_type == kTraceMediaType) trace.emplace(data.begin(), data.end());
                                               if (media_type == kPatchesMediaType) patches.emplace(data.begin(), data.end());
                                             }});
  if (!trace) return std::nullopt;
  return AttachedTrace{std::move(*trace), std::move(patches)};
}

}  // namespace isotouch::bag
