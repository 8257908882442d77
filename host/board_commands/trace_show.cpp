/// isotouch trace show: the records of a trace as a table, for spreadsheets and scripts.
#include "host/board_commands/trace_show.h"
#include "host/board_commands/print_json.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "host/board_commands/choice.h"
#include "host/board_commands/controller_options.h"
#include "host/error.h"
#include "host/trace/columns.h"
#include "host/trace/hash_text.h"
#include "host/trace/trace_file.h"
#include "shared/tick_settings.h"
#include "shared/trace.h"

namespace isotouch::commands {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kPacket = "packet";  ///< the one column that is no number

/// Columns whose numbers have a name, or are a hash.
Json in_words(std::string_view name, std::int64_t number) {
  if (name == "state") return state_name(static_cast<std::uint16_t>(number));
  if (name == "guard") return std::string(name_of(static_cast<GuardVerdict>(number)));
  if (name == "chain") return trace::hash_text(static_cast<std::uint64_t>(number));
  if (name == "input_kind") return number == static_cast<std::int64_t>(InputKind::kPacket) ? "packet" : "position";
  return number;
}

Json packet_text(const trace::Row& row) {
  if (!row.is_packet()) return nullptr;
  std::string text;
  for (const std::uint8_t byte : row.record.input.packet) {
    std::array<char, 3> hex{};
    std::snprintf(hex.data(), hex.size(), "%02x", byte);
    text += hex.data();
  }
  return text;
}

/// Null where the trace, or this row, has none.
Json value(const trace::Column* column, const trace::Row& row) {
  if (column == nullptr) return packet_text(row);
  if (!trace::has(*column, row.record.input.kind, row.has_outputs)) return nullptr;
  if (column->real != nullptr) return column->real(row);
  const std::int64_t number = column->whole(row);
  if (number == trace::kNone && trace::may_lack(*column)) return nullptr;
  return in_words(column->name, number);
}

std::string name_of_column(const trace::Column* column) { return std::string(column == nullptr ? kPacket : column->name); }

/// The first thirteen are shown where none are named.
constexpr std::size_t kStandardColumns = 13;

std::vector<std::string> column_names() {
  std::vector<std::string> names;
  for (const trace::Column& column : trace::columns()) names.emplace_back(column.name);
  names.emplace_back(kPacket);
  return names;
}

struct TraceShowOptions {
  std::filesystem::path trace;
  std::vector<std::string> columns;
  bool csv = false;
  bool json = false;
  bool header_only = false;
};

/// nullptr: the packet.
std::vector<const trace::Column*> chosen(const TraceShowOptions& options) {
  std::vector<const trace::Column*> columns;
  const std::span<const trace::Column> all = trace::columns();
  for (const trace::Column& column : all) {
    if (options.columns.empty() && columns.size() < kStandardColumns) columns.push_back(&column);
  }
  for (const std::string& name : options.columns) {
    const auto found = std::find_if(all.begin(), all.end(), [&](const trace::Column& column) { return name == column.name; });
    columns.push_back(found == all.end() ? nullptr : &*found);
  }
  return columns;
}

void print_csv(const trace::Trace& trace, const std::vector<const trace::Column*>& columns) {
  std::string line;
  for (const trace::Column* column : columns) line += (line.empty() ? "" : ",") + name_of_column(column);
  std::puts(line.c_str());
  for (std::size_t tick = 0; tick < trace.size(); ++tick) {
    const trace::Row row = trace::row_of(trace, tick);
    line.clear();
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const Json cell = value(columns[i], row);
      if (i > 0) line += ',';
      line += cell.is_null() ? "" : cell.is_string() ? cell.get<std::string>() : cell.dump();
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
void print_records(const trace::Trace& trace, const std::vector<const trace::Column*>& columns) {
  std::printf("{\"header\": %s,\n\"records\": [", header_json(trace).dump().c_str());
  for (std::size_t tick = 0; tick < trace.size(); ++tick) {
    const trace::Row row = trace::row_of(trace, tick);
    Json record = Json::object();
    for (const trace::Column* column : columns) record[name_of_column(column)] = value(column, row);
    std::printf("%s%s", tick == 0 ? "\n" : ",\n", record.dump().c_str());
  }
  std::printf("\n]}\n");
}

void run(const TraceShowOptions& options) {
  const std::vector<const trace::Column*> columns = chosen(options);
  const trace::Trace trace = trace::read_trace(options.trace, trace::Damaged::kReport);
  if (options.header_only) {
    print_json(Json{{"header", header_json(trace)}});
  } else {
    options.json ? print_records(trace, columns) : print_csv(trace, columns);
  }
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) throw InputError("standard output: could not be written whole");
}

}  // namespace

Json tick_json(const trace::Trace& trace, std::size_t tick) {
  const trace::Row row = trace::row_of(trace, tick);
  Json object = Json::object();
  for (const trace::Column& column : trace::columns().first(kStandardColumns)) object[std::string(column.name)] = value(&column, row);
  return object;
}

void add_show(CLI::App& trace) {
  auto options = std::make_shared<TraceShowOptions>();
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
