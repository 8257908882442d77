/// The columns of a trace that are numbers: `isotouch trace show` prints them, and the library hands them out.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "host/trace/trace_file.h"
#include "shared/trace.h"

namespace isotouch::trace {

/// One row of the table, with what the header says about it.
struct Row {
  std::uint64_t tick = 0;
  TraceRecord record;
  bool has_outputs = false;

  bool is_packet() const { return record.input.kind == InputKind::kPacket; }
};

Row row_of(const Trace& trace, std::size_t tick);

/// What a trace must hold to have a column.
enum class Needs : std::uint8_t {
  kNothing,
  kHip,            ///< outputs or positions
  kOutputs,        ///< what was felt
  kPackets,        ///< of a device
  kDeviceOutputs,  ///< both
};

/// What stands for a value that a single row lacks and others have, see `may_lack`.
inline constexpr std::int64_t kNone = -1;

struct Column {
  std::string_view name;
  Needs needs = Needs::kNothing;
  std::int64_t (*whole)(const Row&) = nullptr;  ///< of a column of whole numbers; kNone where this row has none
  double (*real)(const Row&) = nullptr;         ///< of any other
};

/// In the order in which they are shown.
std::span<const Column> columns();

/// May a single row have kNone? In any other column -1 is a number.
bool may_lack(const Column& column);

bool has(const Column& column, InputKind kind, bool has_outputs);

}  // namespace isotouch::trace
