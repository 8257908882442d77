#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "host/library/call.h"
#include "host/library/handles.h"
#include "host/trace/columns.h"
#include "shared/files/trace_file.h"

using namespace isotouch;
using namespace isotouch::library;

namespace {

struct TraceThing final : Thing {
  explicit TraceThing(files::TraceFile of) : Thing(Kind::kTrace), file(std::move(of)) {}
  const files::TraceFile file;
};

/// fails     CallError: nobody knows it, or this trace does not have it
const trace::Column& column_of(const files::TraceFile& file, const char* name) {
  const std::string wanted = required(name, "column");
  const auto all = trace::columns();
  const auto found = std::find_if(all.begin(), all.end(), [&](const trace::Column& column) { return wanted == column.name; });
  if (found == all.end()) {
    std::string known;
    for (const trace::Column& column : all) known += (known.empty() ? "" : ", ") + std::string(column.name);
    refuse(ISOTOUCH_BAD_ARGUMENT, "no column is named '" + wanted + "'; choose one of " + known);
  }
  if (!trace::has(*found, file.kind(), file.header().has_outputs)) {
    const bool would_have = trace::has(*found, file.kind(), true);
    refuse(ISOTOUCH_MISSING, file.path() + ": it has no " + wanted + ", because it holds " +
                                 (would_have ? "inputs only; compute its outputs with isotouch replay FIELD TRACE -o"
                                             : "positions of a hand; record a device for that"));
  }
  return *found;
}

/// Calls use(i, row) for each of the ticks.
template <class Use>
void each_row(const files::TraceFile& file, std::uint64_t first, std::size_t count, Use use) {
  if (first > file.size() || count > file.size() - first) {
    refuse(ISOTOUCH_BAD_ARGUMENT, file.path() + ": it has " + std::to_string(file.size()) + " ticks, so there are not " +
                                      std::to_string(count) + " from tick " + std::to_string(first) + " on; ask for those that are there");
  }
  for (std::size_t i = 0; i < count; ++i) use(i, trace::row_of(file, static_cast<std::size_t>(first) + i));
}

}  // namespace

isotouch_status isotouch_trace_load(const char* path, isotouch_trace* trace) {
  return guarded(ISOTOUCH_BAD_DATA, [&] {
    const std::string name = file_name(path);
    required(trace, "trace");
    files::TraceFile file;
    if (const Refusal refusal = files::read_trace(name, file)) throw InputError(refusal.sentence());
    if (!file.damage().empty()) throw InputError(file.damage());
    *trace = add(std::make_unique<TraceThing>(std::move(file)));
  });
}

isotouch_status isotouch_trace_describe(isotouch_trace trace, isotouch_trace_facts* facts, size_t size) {
  return guarded(ISOTOUCH_BAD_DATA, [&] {
    require_struct(facts, "facts", size, "isotouch_trace_facts");
    const Held held(trace, Kind::kTrace, Use::kShared);
    const files::TraceFile& file = held.as<TraceThing>().file;
    isotouch_trace_facts found{};
    found.ticks = file.size();
    found.field_hash = file.header().field_hash;
    found.has_outputs = file.header().has_outputs ? 1 : 0;
    if (file.header().has_outputs && file.size() > 0) found.replay_hash = file.chain(file.size() - 1);
    found.period_ns = file.header().period_ns;
    found.has_packets = file.kind() == InputKind::kPacket ? 1 : 0;
    found.is_cut_off = file.cut_off().empty() ? 0 : 1;
    *facts = found;
  });
}

size_t isotouch_trace_columns(void) { return trace::columns().size(); }

const char* isotouch_trace_column(size_t column, uint32_t* is_integer) {
  if (column >= trace::columns().size()) return nullptr;
  const trace::Column& found = trace::columns()[column];
  if (is_integer != nullptr) *is_integer = found.whole != nullptr ? 1 : 0;
  return found.name.data();  // a literal, so it ends with a zero
}

isotouch_status isotouch_trace_doubles(isotouch_trace trace, const char* column, uint64_t first, size_t count, double* values) {
  return guarded(ISOTOUCH_BAD_DATA, [&] {
    const Held held(trace, Kind::kTrace, Use::kShared);
    const files::TraceFile& file = held.as<TraceThing>().file;
    const trace::Column& of = column_of(file, column);
    if (count > 0) required(values, "values");
    each_row(file, first, count, [&](std::size_t i, const trace::Row& row) {
      if (of.real != nullptr) {
        values[i] = of.real(row);
        return;
      }
      const std::int64_t number = of.whole(row);
      values[i] = number == trace::kNone && trace::may_lack(of) ? std::numeric_limits<double>::quiet_NaN() : static_cast<double>(number);
    });
  });
}

isotouch_status isotouch_trace_integers(isotouch_trace trace, const char* column, uint64_t first, size_t count, int64_t* values) {
  return guarded(ISOTOUCH_BAD_DATA, [&] {
    const Held held(trace, Kind::kTrace, Use::kShared);
    const files::TraceFile& file = held.as<TraceThing>().file;
    const trace::Column& of = column_of(file, column);
    if (of.whole == nullptr)
      refuse(ISOTOUCH_BAD_ARGUMENT, "the column " + std::string(of.name) + " does not hold whole numbers; ask for doubles");
    if (count > 0) required(values, "values");
    each_row(file, first, count, [&](std::size_t i, const trace::Row& row) { values[i] = of.whole(row); });
  });
}
