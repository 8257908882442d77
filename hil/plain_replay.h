/// A replay with nothing but shared/ and firmware/core, as SPEC.md states it: for processors and compilers that have no host tool, and for machines that
/// have no operating system.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "firmware/core/tick.h"
#include "shared/field_view.h"
#include "shared/patch_chain.h"
#include "shared/trace.h"

namespace isotouch::replay {

struct Report {
  std::uint64_t ticks = 0;
  std::uint64_t hash = 0;
  bool equal = true;                   ///< to what was recorded, every bit
  std::uint64_t first_difference = 0;  ///< where it is not: the tick
};

/// A recording of packets that ended before a field was loaded names none.
inline bool may_be_of(const TraceHeader& header, const TraceRecord& first, const FieldView& field) {
  return header.field_hash == field.hash() || (header.field_hash == 0 && first.input.kind == InputKind::kPacket);
}

/// The patches of a recording, and memory for the images that they lead to, as `PatchChain` takes them; none where the field was never patched.
struct Moves {
  std::span<const std::uint8_t> patches;
  std::array<std::span<std::uint8_t>, 2> memory;
};

/// Runs a trace's inputs and compares with its outputs.
///
/// trace     a whole file
/// fails     as the decoders of shared/trace.h and PatchChain::advance; kNoOutputs, kWrongField
inline Result<Report> run(const FieldView& field, std::span<const std::uint8_t> trace, const Moves& moves = {}) {
  using trace_layout::kHeaderBytes, trace_layout::kRecordBytes;
  const Result<TraceHeader> header = decode_header(trace, trace.size());
  if (!header) return header.error();
  if (!header->has_outputs) return Error::kNoOutputs;
  const core::TickModel tick_model = core::make_tick_model(header->device, header->settings, header->period_ns);
  const core::PositionModel position_model = core::make_position_model(header->device, header->settings, header->period_ns, field);
  core::TickState tick_state;
  core::PositionState position_state;
  Chain chain(*header);
  PatchChain felt(field, moves.patches, moves.memory);
  Report report;
  const std::uint8_t* at = trace.data() + kHeaderBytes;
  for (; report.ticks < header->record_count; ++report.ticks, at += kRecordBytes) {
    const Result<TraceRecord> record = decode_record(std::span<const std::uint8_t, kRecordBytes>(at, kRecordBytes));
    if (!record) return record.error();
    const Input& in = record->input;
    if (report.ticks == 0 && !may_be_of(*header, *record, field)) return Error::kWrongField;
    if ((in.requests & kRequestMoved) != 0) {
      if (const Result<void> moved = felt.advance(in.moved_to); !moved) return moved.error();
    }
    const Output output = in.kind == InputKind::kPosition
                              ? core::render_position(in, felt.field(), position_model, position_state)
                              : core::tick(in, in.field_generation == 0 ? nullptr : &felt.field(), tick_model, tick_state);
    const bool equal = chain.extend(in, output) == record->chain && output == record->output;
    if (!equal && report.equal) report.first_difference = report.ticks;
    report.equal = report.equal && equal;
  }
  report.hash = chain.value();
  return report;
}

}  // namespace isotouch::replay
