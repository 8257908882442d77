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

/// A type of message: what stands before its three numbers, and where they are in JSON.
struct Type {
  std::string_view name;  ///< without "/msg/"
  bool has_header;        ///< time and frame come first
  bool has_child_frame;   ///< then another frame
  bool is_force;
  std::array<const char*, 3> path;  ///< of x, y, z in JSON, from the outside in; nullptr: no more
};

constexpr std::array kTypes = {
    Type{"geometry_msgs/Point", false, false, false, {nullptr, nullptr, nullptr}},
    Type{"geometry_msgs/PointStamped", true, false, false, {"point", nullptr, nullptr}},
    Type{"geometry_msgs/Vector3", false, false, false, {nullptr, nullptr, nullptr}},
    Type{"geometry_msgs/Vector3Stamped", true, false, false, {"vector", nullptr, nullptr}},
    Type{"geometry_msgs/Pose", false, false, false, {"position", nullptr, nullptr}},
    Type{"geometry_msgs/PoseStamped", true, false, false, {"pose", "position", nullptr}},
    Type{"geometry_msgs/PoseWithCovarianceStamped", true, false, false, {"pose", "pose", "position"}},
    Type{"geometry_msgs/Transform", false, false, false, {"translation", nullptr, nullptr}},
    Type{"geometry_msgs/TransformStamped", true, true, false, {"transform", "translation", nullptr}},
    Type{"geometry_msgs/Wrench", false, false, true, {"force", nullptr, nullptr}},
    Type{"geometry_msgs/WrenchStamped", true, false, true, {"wrench", "force", nullptr}},
    Type{"foxglove.PoseInFrame", true, false, false, {"pose", "position", nullptr}},
    Type{"foxglove.Point3", false, false, false, {nullptr, nullptr, nullptr}},
    Type{"foxglove.Vector3", false, false, false, {nullptr, nullptr, nullptr}},
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
  void skip_text() {
    const auto size = number<std::uint32_t>();
    if (size > bytes_.size() - std::min(at_, bytes_.size())) {
      good_ = false;
    } else {
      at_ += size;
    }
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
  measured.is_force = type.is_force;
  if (type.has_header) {
    const auto seconds = static_cast<std::int32_t>(from.number<std::uint32_t>());
    const auto nanoseconds = from.number<std::uint32_t>();
    if (seconds != 0 || nanoseconds != 0) measured.stamp_s = seconds + 1e-9 * nanoseconds;
    from.skip_text();
    if (type.has_child_frame) from.skip_text();
  }
  for (Eigen::Index axis = 0; axis < 3; ++axis) measured.value[axis] = from.real();
  if (!from.is_good()) return std::nullopt;
  return measured;
}

double number_in(const nlohmann::json& object, const char* name) {
  return object.is_object() && object.contains(name) && object[name].is_number() ? object[name].get<double>() : std::nan("");
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
  measured.is_force = type.is_force;
  measured.value = {number_in(*place, "x"), number_in(*place, "y"), number_in(*place, "z")};
  return measured;
}

}  // namespace

bool is_known(const Channel& channel) { return type_of(channel) != nullptr && (channel.encoding == "cdr" || channel.encoding == "json"); }

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
