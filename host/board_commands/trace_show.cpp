/// isotouch trace show: the records of a trace as a table, for spreadsheets and scripts.
#include "host/board_commands/trace_show.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "host/board_commands/choice.h"
#include "host/board_commands/controller_options.h"
#include "host/error.h"
#include "host/to_double.h"
#include "host/trace/hash_text.h"
#include "host/trace/trace_file.h"
#include "shared/tick_settings.h"
#include "shared/trace.h"

namespace isotouch::commands {

namespace {

using Json = nlohmann::ordered_json;

/// One row of the table, with what the header says about it.
struct Row {
  std::uint64_t tick = 0;
  TraceRecord record;
  bool has_outputs = false;

  bool is_packet() const { return record.input.kind == InputKind::kPacket; }
  /// A trace of inputs alone still says where its hand was.
  bool knows_hip() const { return has_outputs || !is_packet(); }
  Vec3<Mm> hip() const { return has_outputs ? record.output.hip : record.input.hip; }
};

struct Column {
  const char* name;
  Json (*value)(const Row&);  ///< null where this kind of trace has none
};

template <class T>
Json if_output(const Row& row, const T& value) {
  return row.has_outputs ? Json(value) : Json(nullptr);
}

template <class T>
Json if_packet(const Row& row, const T& value) {
  return row.has_outputs && row.is_packet() ? Json(value) : Json(nullptr);
}

/// The first thirteen are shown where none are named.
constexpr std::size_t kStandardColumns = 13;
constexpr std::array<Column, 34> kColumns = {{
    {"tick", [](const Row& r) { return Json(r.tick); }},
    {"hip_x_mm", [](const Row& r) { return r.knows_hip() ? Json(to_double(r.hip().x)) : Json(nullptr); }},
    {"hip_y_mm", [](const Row& r) { return r.knows_hip() ? Json(to_double(r.hip().y)) : Json(nullptr); }},
    {"hip_z_mm", [](const Row& r) { return r.knows_hip() ? Json(to_double(r.hip().z)) : Json(nullptr); }},
    {"proxy_x_mm", [](const Row& r) { return if_output(r, to_double(r.record.output.proxy.x)); }},
    {"proxy_y_mm", [](const Row& r) { return if_output(r, to_double(r.record.output.proxy.y)); }},
    {"proxy_z_mm", [](const Row& r) { return if_output(r, to_double(r.record.output.proxy.z)); }},
    {"force_x_n", [](const Row& r) { return if_output(r, to_double(r.record.output.force.x)); }},
    {"force_y_n", [](const Row& r) { return if_output(r, to_double(r.record.output.force.y)); }},
    {"force_z_n", [](const Row& r) { return if_output(r, to_double(r.record.output.force.z)); }},
    {"contact", [](const Row& r) { return if_output(r, (r.record.output.status & kContact) != 0 ? 1 : 0); }},
    {"status", [](const Row& r) { return if_output(r, r.record.output.status); }},
    {"state", [](const Row& r) { return if_packet(r, state_name(r.record.output.state)); }},
    {"command_1", [](const Row& r) { return if_packet(r, r.record.output.commands[0]); }},
    {"command_2", [](const Row& r) { return if_packet(r, r.record.output.commands[1]); }},
    {"command_3", [](const Row& r) { return if_packet(r, r.record.output.commands[2]); }},
    {"faults", [](const Row& r) { return if_packet(r, r.record.output.faults); }},
    {"packet_flags", [](const Row& r) { return if_packet(r, r.record.output.packet_flags); }},
    {"buttons", [](const Row& r) { return if_output(r, r.record.output.buttons); }},
    {"fresh", [](const Row& r) { return Json(r.record.input.fresh ? 1 : 0); }},
    {"age", [](const Row& r) { return Json(r.record.input.age); }},
    {"late", [](const Row& r) { return Json(r.record.input.late); }},
    {"lines", [](const Row& r) { return Json(r.record.input.lines); }},
    {"guard", [](const Row& r) { return if_packet(r, std::string(name_of(guard_verdict(r.record.input.lines)))); }},
    {"requests", [](const Row& r) { return Json(r.record.input.requests); }},
    {"author_user", [](const Row& r) { return r.record.input.author == kNobody ? Json(nullptr) : Json(user_of(r.record.input.author)); }},
    {"setting", [](const Row& r) { return Json(static_cast<int>(r.record.input.change.setting)); }},
    {"setting_raw", [](const Row& r) { return Json(r.record.input.change.raw); }},
    {"field_generation", [](const Row& r) { return Json(r.record.input.field_generation); }},
    {"chain", [](const Row& r) { return if_output(r, trace::hash_text(r.record.chain)); }},
    {"arrival_us", [](const Row& r) { return Json(static_cast<double>(r.record.arrival_ns) / 1000); }},
    {"input_kind", [](const Row& r) { return Json(r.is_packet() ? "packet" : "position"); }},
    {"homed",
     [](const Row& r) {
       const Result<FalconReply> reply = decode_reply(r.record.input.packet);
       return r.is_packet() && reply ? Json(reply->homed) : Json(nullptr);
     }},
    {"packet",
     [](const Row& r) {
       if (!r.is_packet()) return Json(nullptr);
       std::string text;
       for (const std::uint8_t byte : r.record.input.packet) {
         std::array<char, 3> hex{};
         std::snprintf(hex.data(), hex.size(), "%02x", byte);
         text += hex.data();
       }
       return Json(text);
     }},
}};

std::vector<std::string> column_names() {
  std::vector<std::string> names;
  for (const Column& column : kColumns) names.emplace_back(column.name);
  return names;
}

struct Options {
  std::filesystem::path trace;
  std::vector<std::string> columns;
  bool csv = false;
  bool json = false;
  bool header_only = false;
};

std::vector<Column> chosen(const Options& options) {
  if (options.columns.empty()) return {kColumns.begin(), kColumns.begin() + kStandardColumns};
  std::vector<Column> columns;
  for (const std::string& name : options.columns) {
    const auto* found = std::find_if(kColumns.begin(), kColumns.end(), [&](const Column& column) { return name == column.name; });
    columns.push_back(*found);
  }
  return columns;
}

Row row_of(const trace::Trace& trace, std::size_t tick) { return {tick, trace.record(tick), trace.header().has_outputs}; }

void print_csv(const trace::Trace& trace, const std::vector<Column>& columns) {
  std::string line;
  for (const Column& column : columns) line += (line.empty() ? "" : ",") + std::string(column.name);
  std::puts(line.c_str());
  for (std::size_t tick = 0; tick < trace.size(); ++tick) {
    const Row row = row_of(trace, tick);
    line.clear();
    for (const Column& column : columns) {
      const Json value = column.value(row);
      if (&column != &columns.front()) line += ',';
      line += value.is_null() ? "" : value.is_string() ? value.get<std::string>() : value.dump();
    }
    std::puts(line.c_str());
  }
}

Json header_json(const trace::Trace& trace) {
  const TraceHeader& header = trace.header();
  Json settings = Json::object();
  const RawSettings raw = raw_settings(header.settings);
  for (std::size_t i = 0; i < kTickSettings; ++i) settings[std::string(kTickSettingRows[i]->name)] = kTickSettingRows[i]->value(raw[i]);
  return {{"ticks", trace.size()},
          {"period_ns", header.period_ns},
          {"input_kind", trace.kind() == InputKind::kPacket ? "packet" : "position"},
          {"has_outputs", header.has_outputs},
          {"field_hash", trace::hash_text(header.field_hash)},
          {"settings", settings},
          {"settings_checksum", trace::hash_text(header.settings_checksum)},
          {"device_hash", trace::hash_text(hash(header.device))}};
}

/// One record a line, so that a long trace does not have to fit into memory twice.
void print_json(const trace::Trace& trace, const std::vector<Column>& columns) {
  std::printf("{\"header\": %s,\n\"records\": [", header_json(trace).dump().c_str());
  for (std::size_t tick = 0; tick < trace.size(); ++tick) {
    const Row row = row_of(trace, tick);
    Json record = Json::object();
    for (const Column& column : columns) record[column.name] = column.value(row);
    std::printf("%s%s", tick == 0 ? "\n" : ",\n", record.dump().c_str());
  }
  std::printf("\n]}\n");
}

void run(const Options& options) {
  const std::vector<Column> columns = chosen(options);
  const trace::Trace trace = trace::read_trace(options.trace);
  if (options.header_only) {
    std::printf("%s\n", Json{{"header", header_json(trace)}}.dump(2).c_str());
  } else {
    options.json ? print_json(trace, columns) : print_csv(trace, columns);
  }
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) throw InputError("standard output: could not be written whole");
}

}  // namespace

Json tick_json(const files::TraceFile& trace, std::size_t tick) {
  const Row row = row_of(trace, tick);
  Json object = Json::object();
  for (std::size_t i = 0; i < kStandardColumns; ++i) object[kColumns[i].name] = kColumns[i].value(row);
  return object;
}

void add_show(CLI::App& trace) {
  auto options = std::make_shared<Options>();
  CLI::App* command =
      trace.add_subcommand("show", "Print a trace as a table: one line per tick; values that the trace does not hold are empty, or null");
  command->add_option("TRACE", options->trace, "the trace to print (.trace)")->required();
  CLI::Option* csv = command->add_flag("--csv", options->csv, "comma-separated, the first line names the columns (without --json, this)");
  CLI::Option* json = command->add_flag("--json", options->json, "one JSON object: the header, and an object a tick")->excludes(csv);
  command->add_flag("--header", options->header_only, "with --json: the header alone")->needs(json);
  command->add_option("--columns", options->columns, "only these, in this order, separated by commas")
      ->delimiter(',')
      ->check(one_of(column_names()));
  command->callback([options] { run(*options); });
}

}  // namespace isotouch::commands
