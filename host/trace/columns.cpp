#include "host/trace/columns.h"

#include <array>

#include "host/to_double.h"
#include "shared/falcon_packet.h"

namespace isotouch::trace {

namespace {

/// A trace of inputs alone still says where its hand was.
const Vec3<Mm>& hip(const Row& row) { return row.has_outputs ? row.record.output.hip : row.record.input.hip; }

constexpr std::array<Column, 33> kColumns = {{
    {"tick", Needs::kNothing, [](const Row& r) { return static_cast<std::int64_t>(r.tick); }},
    {"hip_x_mm", Needs::kHip, nullptr, [](const Row& r) { return to_double(hip(r).x); }},
    {"hip_y_mm", Needs::kHip, nullptr, [](const Row& r) { return to_double(hip(r).y); }},
    {"hip_z_mm", Needs::kHip, nullptr, [](const Row& r) { return to_double(hip(r).z); }},
    {"proxy_x_mm", Needs::kOutputs, nullptr, [](const Row& r) { return to_double(r.record.output.proxy.x); }},
    {"proxy_y_mm", Needs::kOutputs, nullptr, [](const Row& r) { return to_double(r.record.output.proxy.y); }},
    {"proxy_z_mm", Needs::kOutputs, nullptr, [](const Row& r) { return to_double(r.record.output.proxy.z); }},
    {"force_x_n", Needs::kOutputs, nullptr, [](const Row& r) { return to_double(r.record.output.force.x); }},
    {"force_y_n", Needs::kOutputs, nullptr, [](const Row& r) { return to_double(r.record.output.force.y); }},
    {"force_z_n", Needs::kOutputs, nullptr, [](const Row& r) { return to_double(r.record.output.force.z); }},
    {"contact", Needs::kOutputs, [](const Row& r) { return std::int64_t{(r.record.output.status & kContact) != 0 ? 1 : 0}; }},
    {"status", Needs::kOutputs, [](const Row& r) { return std::int64_t{r.record.output.status}; }},
    {"state", Needs::kDeviceOutputs, [](const Row& r) { return std::int64_t{r.record.output.state}; }},
    {"command_1", Needs::kDeviceOutputs, [](const Row& r) { return std::int64_t{r.record.output.commands[0]}; }},
    {"command_2", Needs::kDeviceOutputs, [](const Row& r) { return std::int64_t{r.record.output.commands[1]}; }},
    {"command_3", Needs::kDeviceOutputs, [](const Row& r) { return std::int64_t{r.record.output.commands[2]}; }},
    {"faults", Needs::kDeviceOutputs, [](const Row& r) { return std::int64_t{r.record.output.faults}; }},
    {"packet_flags", Needs::kDeviceOutputs, [](const Row& r) { return std::int64_t{r.record.output.packet_flags}; }},
    {"buttons", Needs::kOutputs, [](const Row& r) { return std::int64_t{r.record.output.buttons}; }},
    {"fresh", Needs::kNothing, [](const Row& r) { return std::int64_t{r.record.input.fresh ? 1 : 0}; }},
    {"age", Needs::kNothing, [](const Row& r) { return std::int64_t{r.record.input.age}; }},
    {"late", Needs::kNothing, [](const Row& r) { return std::int64_t{r.record.input.late}; }},
    {"lines", Needs::kNothing, [](const Row& r) { return std::int64_t{r.record.input.lines}; }},
    {"guard", Needs::kDeviceOutputs, [](const Row& r) { return static_cast<std::int64_t>(guard_verdict(r.record.input.lines)); }},
    {"requests", Needs::kNothing, [](const Row& r) { return std::int64_t{r.record.input.requests}; }},
    {"author_user", Needs::kNothing,
     [](const Row& r) { return r.record.input.author == kNobody ? kNone : std::int64_t{user_of(r.record.input.author)}; }},
    {"setting", Needs::kNothing, [](const Row& r) { return static_cast<std::int64_t>(r.record.input.change.setting); }},
    {"setting_raw", Needs::kNothing, [](const Row& r) { return std::int64_t{r.record.input.change.raw}; }},
    {"field_generation", Needs::kNothing, [](const Row& r) { return std::int64_t{r.record.input.field_generation}; }},
    {"chain", Needs::kOutputs, [](const Row& r) { return static_cast<std::int64_t>(r.record.chain); }},
    {"arrival_us", Needs::kNothing, nullptr, [](const Row& r) { return static_cast<double>(r.record.arrival_ns) / 1000; }},
    {"input_kind", Needs::kNothing, [](const Row& r) { return static_cast<std::int64_t>(r.record.input.kind); }},
    {"homed", Needs::kPackets,
     [](const Row& r) {
       const Result<FalconReply> reply = decode_reply(r.record.input.packet);
       return reply ? std::int64_t{reply->homed} : kNone;
     }},
}};

}  // namespace

Row row_of(const Trace& trace, std::size_t tick) { return {tick, trace.record(tick), trace.header().has_outputs}; }

std::span<const Column> columns() { return kColumns; }

bool may_lack(const Column& column) { return column.name == "author_user" || column.name == "homed"; }

bool has(const Column& column, InputKind kind, bool has_outputs) {
  const bool is_packet = kind == InputKind::kPacket;
  switch (column.needs) {
    case Needs::kNothing: return true;
    case Needs::kHip: return has_outputs || !is_packet;
    case Needs::kOutputs: return has_outputs;
    case Needs::kPackets: return is_packet;
    case Needs::kDeviceOutputs: return has_outputs && is_packet;
  }
  return false;
}

}  // namespace isotouch::trace
