#include "host/bag/trace_to_mcap.h"

#include <nlohmann/json.hpp>

#include "host/bag/bag_motion.h"
#include "host/to_double.h"
#include "host/trace/recorded_patches.h"

namespace isotouch::bag {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::uint64_t kNsPerS = 1'000'000'000;
constexpr double kMetresPerMm = 1e-3;

Bytes bytes_of(const Json& json) {
  const std::string text = json.dump();
  return {text.begin(), text.end()};
}

std::string schema_of(const Json& row) {
  Json properties = Json::object();
  for (const auto& [name, value] : row.items())
    properties[name] = {{"type", value.is_string() ? Json("string")
                                 : value.is_null() ? Json({"number", "string", "null"})
                                                   : Json({"number", "null"})}};
  return Json{{"title", "isotouch.Tick"}, {"type", "object"}, {"properties", properties}}.dump();
}

/// source    foxglove.PoseInFrame of Foxglove's schemas
std::string pose_schema() {
  const Json number = {{"type", "number"}}, whole = {{"type", "integer"}};
  const auto object = [](Json properties) { return Json{{"type", "object"}, {"properties", std::move(properties)}}; };
  const Json place = object({{"x", number}, {"y", number}, {"z", number}});
  const Json turn = object({{"x", number}, {"y", number}, {"z", number}, {"w", number}});
  Json all = object({{"timestamp", object({{"sec", whole}, {"nsec", whole}})},
                     {"frame_id", {{"type", "string"}}},
                     {"pose", object({{"position", place}, {"orientation", turn}})}});
  all["title"] = "foxglove.PoseInFrame";
  return all.dump();
}

Json pose_at(const Vec3<Mm>& place, std::uint64_t time_ns) {
  const Eigen::Vector3d metres = kMetresPerMm * to_double(place);
  return {{"timestamp", {{"sec", time_ns / kNsPerS}, {"nsec", time_ns % kNsPerS}}},
          {"frame_id", "workspace"},
          {"pose",
           {{"position", {{"x", metres.x()}, {"y", metres.y()}, {"z", metres.z()}}},
            {"orientation", {{"x", 0}, {"y", 0}, {"z", 0}, {"w", 1}}}}}};
}

}  // namespace

Bytes trace_to_mcap(const files::TraceFile& trace, const std::string& name, std::span<const std::uint8_t> whole,
                    const std::optional<std::vector<std::uint8_t>>& patches, const std::string& library,
                    const std::function<Json(std::size_t)>& row) {
  McapWriter writer(library);
  writer.attach(name, kTraceMediaType, whole);
  if (patches) writer.attach(trace::patches_of(name).string(), kPatchesMediaType, *patches);
  const std::uint16_t pose = writer.schema("foxglove.PoseInFrame", "jsonschema", pose_schema());
  const std::uint16_t tick_schema = writer.schema("isotouch.Tick", "jsonschema", schema_of(trace.size() > 0 ? row(0) : Json::object()));
  const std::uint16_t ticks = writer.channel(tick_schema, "/isotouch/tick", "json");
  const std::uint16_t hips = writer.channel(pose, "/isotouch/hip", "json");
  const std::uint16_t proxies = writer.channel(pose, "/isotouch/proxy", "json");
  const bool has_outputs = trace.header().has_outputs, has_hip = has_outputs || trace.kind() == InputKind::kPosition;
  for (std::size_t tick = 0; tick < trace.size(); ++tick) {
    const std::uint64_t now = tick * trace.header().period_ns;
    const TraceRecord record = trace.record(tick);
    writer.message(ticks, now, bytes_of(row(tick)));
    if (has_hip) writer.message(hips, now, bytes_of(pose_at(has_outputs ? record.output.hip : record.input.hip, now)));
    if (has_outputs) writer.message(proxies, now, bytes_of(pose_at(record.output.proxy, now)));
  }
  return writer.finish();
}

}  // namespace isotouch::bag
