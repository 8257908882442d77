/// The core over a recorded run: the same inputs on the same field give the same answers, to the bit, on every machine.
#pragma once

#include <cstdint>
#include <optional>

#include "firmware/core/tick.h"
#include "host/trace/trace_diff.h"
#include "host/trace/trace_file.h"
#include "shared/field_view.h"

namespace isotouch::trace {

/// One run of the core with its chain: the device's tick for packets, rendering alone for positions. After construction nothing is allocated.
class Run {
 public:
  /// field     stays alive as long as the run; loaded in the ticks whose input names a field
  /// header    device, period and settings of the run
  Run(const FieldView& field, const TraceHeader& header);

  /// One tick: what a trace stores of it, arrival time apart.
  TraceRecord step(const Input& input);

  /// The replay hash: the chain after the last step.
  std::uint64_t hash() const { return chain_.value(); }
  /// The header of a trace of this run: with outputs, of this field.
  const TraceHeader& header() const { return header_; }

 private:
  const FieldView& field_;
  TraceHeader header_;
  core::TickModel tick_model_;
  core::PositionModel position_model_;
  core::TickState tick_state_;
  core::PositionState position_state_;
  Chain chain_;
};

struct ReplayReport {
  std::uint64_t ticks = 0;
  double seconds = 0.0;  ///< wall clock of all ticks with their chain
  std::uint64_t hash = 0;
  std::optional<Difference> first_difference;  ///< only looked for with `check`
};

/// Runs a trace's inputs.
///
/// check     compares every tick with the recorded outputs and chain. Looking stops at the first that differs, running goes on. Its field is an
///           output's name; "input" when the record's input was changed after recording, "chain" when only the stored chain was
/// out       nullptr, or takes every record, with the input's arrival times
/// fails     InputError: a second field where the trace names one; with `check`, no outputs or no records, or another field
ReplayReport replay(const FieldView& field, const Trace& trace, bool check, TraceWriter* out = nullptr);

/// The header that a trace of this replay has: for the writer.
TraceHeader replay_header(const FieldView& field, const TraceHeader& inputs);

}  // namespace isotouch::trace
