#include "host/bag/ros_message.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

namespace isotouch::bag {

namespace {

using Span = std::span<const std::uint8_t>;

constexpr std::int64_t kNsPerS = 1'000'000'000;

/// A type of message: what stands before its three numbers, and where they are in JSON.
struct Type {
  std::string_view name;  ///< without "/msg/"
  bool has_header;        ///< time and frame come first
  bool has_child_frame;   ///< then another frame
  Content content;
  std::array<const char*, 3> path;  ///< of x, y, z in JSON, from the outside in; nullptr: no more
};

constexpr std::array kTypes = {
    Type{"geometry_msgs/Point", false, false, Content::kPosition, {nullptr, nullptr, nullptr}},
    Type{"geometry_msgs/PointStamped", true, false, Content::kPosition, {"point", nullptr, nullptr}},
    Type{"geometry_msgs/Vector3", false, false, Content::kAnyVector, {nullptr, nullptr, nullptr}},
    Type{"geometry_msgs/Vector3Stamped", true, false, Content::kAnyVector, {"vector", nullptr, nullptr}},
    Type{"geometry_msgs/Pose", false, false, Content::kPosition, {"position", nullptr, nullptr}},
    Type{"geometry_msgs/PoseStamped", true, false, Content::kPosition, {"pose", "position", nullptr}},
    Type{"geometry_msgs/PoseWithCovarianceStamped", true, false, Content::kPosition, {"pose", "pose", "position"}},
    Type{"geometry_msgs/Transform", false, false, Content::kPosition, {"translation", nullptr, nullptr}},
    Type{"geometry_msgs/TransformStamped", true, true, Content::kPosition, {"transform", "translation", nullptr}},
    Type{"geometry_msgs/Wrench", false, false, Content::kForce, {"force", nullptr, nullptr}},
    Type{"geometry_msgs/WrenchStamped", true, false, Content::kForce, {"wrench", "force", nullptr}},
    Type{"foxglove.PoseInFrame", true, false, Content::kPosition, {"pose", "position", nullptr}},
    Type{"foxglove.Point3", false, false, Content::kPosition, {nullptr, nullptr, nullptr}},
    Type{"foxglove.Vector3", false, false, Content::kAnyVector, {nullptr, nullptr, nullptr}},
};

const Type* type_of(const Channel& channel) {
  std::string name(channel.schema);
  if (const auto middle = name.find("/msg/"); middle != std::string::npos) name.erase(middle + 1, 4);
  const auto* found = std::find_if(kTypes.begin(), kTypes.end(), [&](const Type& type) { return type.name == name; });
  return found == kTypes.end() ? nullptr : &*found;
}

/// Numbers at multiples of their size, counted from behind the first four bytes, which say the order of bytes.
class Cdr {
 public:
  explicit Cdr(Span bytes) : good_(bytes.size() >= 4 && bytes[0] == 0 && bytes[1] <= 1), little_(good_ && bytes[1] == 1) {
    if (good_) bytes_ = bytes.subspan(4);
  }

  template <class T>
  T number() {
    at_ = (at_ + sizeof(T) - 1) / sizeof(T) * sizeof(T);
    if (at_ > bytes_.size() || bytes_.size() - at_ < sizeof(T)) {
      good_ = false;
      return T{};
    }
    T value{};
    for (std::size_t i = 0; i < sizeof(T); ++i)
      value = static_cast<T>(value | static_cast<T>(T{bytes_[at_ + (little_ ? i : sizeof(T) - 1 - i)]} << (8 * i)));
    at_ += sizeof(T);
    return value;
  }
  double real() { return std::bit_cast<double>(number<std::uint64_t>()); }
  std::string text() {
    const auto size = number<std::uint32_t>();
    if (!good_ || size > bytes_.size() - at_) {
      good_ = false;
      return {};
    }
    std::string text(bytes_.begin() + static_cast<std::ptrdiff_t>(at_), bytes_.begin() + static_cast<std::ptrdiff_t>(at_ + size));
    at_ += size;
    return text.substr(0, text.find('\0'));
  }
  bool is_good() const { return good_; }

 private:
  Span bytes_;
  bool good_, little_;
  std::size_t at_ = 0;
};

std::optional<Measured> from_cdr(const Type& type, Span data) {
  Cdr from(data);
  Measured measured;
  if (type.has_header) {
    const auto seconds = static_cast<std::int32_t>(from.number<std::uint32_t>());
    const auto nanoseconds = from.number<std::uint32_t>();
    measured.stamp_ns = seconds * kNsPerS + nanoseconds;
    measured.frame = from.text();
    if (type.has_child_frame) measured.body = from.text();
  }
  for (Eigen::Index axis = 0; axis < 3; ++axis) measured.value[axis] = from.real();
  if (!from.is_good()) return std::nullopt;
  return measured;
}

double number_in(const nlohmann::json& object, const char* name) {
  return object.is_object() && object.contains(name) && object[name].is_number() ? object[name].get<double>() : std::nan("");
}

std::string text_in(const nlohmann::json& object, const char* name) {
  return object.is_object() && object.contains(name) && object[name].is_string() ? object[name].get<std::string>() : "";
}

/// Seconds and nanoseconds under the names that ROS 2 or Foxglove has for them.
std::optional<std::int64_t> stamp_in(const nlohmann::json& whole) {
  const auto of = [](const nlohmann::json& stamp, const char* nanoseconds) -> std::optional<std::int64_t> {
    const double s = number_in(stamp, "sec"), ns = number_in(stamp, nanoseconds);
    if (!(std::fabs(s) < 4e9) || !(ns >= 0 && ns < 1e9)) return std::nullopt;
    return static_cast<std::int64_t>(s) * kNsPerS + static_cast<std::int64_t>(ns);
  };
  if (!whole.is_object()) return std::nullopt;
  if (whole.contains("timestamp")) return of(whole["timestamp"], "nsec");
  if (!whole.contains("header") || !whole["header"].is_object() || !whole["header"].contains("stamp")) return std::nullopt;
  return of(whole["header"]["stamp"], "nanosec");
}

std::optional<Measured> from_json(const Type& type, Span data) {
  const nlohmann::json whole = nlohmann::json::parse(data.begin(), data.end(), nullptr, false);
  const nlohmann::json* place = &whole;
  for (const char* step : type.path) {
    if (step == nullptr) break;
    if (!place->is_object() || !place->contains(step)) return std::nullopt;
    place = &(*place)[step];
  }
  Measured measured;
  measured.stamp_ns = stamp_in(whole);
  measured.frame = text_in(whole.is_object() && whole.contains("header") ? whole["header"] : whole, "frame_id");
  if (type.has_child_frame) measured.body = text_in(whole, "child_frame_id");
  measured.value = {number_in(*place, "x"), number_in(*place, "y"), number_in(*place, "z")};
  return measured;
}

}  // namespace

Content content_of(const Channel& channel) {
  const Type* type = type_of(channel);
  return type != nullptr && (channel.encoding == "cdr" || channel.encoding == "json") ? type->content : Content::kNothing;
}

std::string_view known_types() {
  static const std::string all = [] {
    std::string text;
    for (const Type& type : kTypes) text.append(text.empty() ? "" : ", ").append(type.name);
    return text;
  }();
  return all;
}

std::optional<Measured> read_message(const Channel& channel, Span data) {
  const Type* type = type_of(channel);
  if (type == nullptr) return std::nullopt;
  std::optional<Measured> measured = channel.encoding == "json" ? from_json(*type, data) : from_cdr(*type, data);
  if (measured && !measured->value.allFinite()) return std::nullopt;
  return measured;
}

}  // namespace isotouch::bag
