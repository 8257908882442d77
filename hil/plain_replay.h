/// A replay with nothing but shared/ and firmware/core, as SPEC.md states it: for processors and compilers that have no host tool, and for machines that
/// have no operating system.
#pragma once

#include <cstdint>
#include <span>

#include "firmware/core/device_tick.h"
#include "firmware/core/tick.h"
#include "shared/blob.h"
#include "shared/device_trace.h"
#include "shared/trace.h"

namespace isotouch::replay {

struct Report {
  std::uint64_t ticks = 0;
  std::uint64_t hash = 0;
  bool equal = true;                   ///< to what was recorded, every bit
  std::uint64_t first_difference = 0;  ///< where it is not: the tick
};

/// How each major version is read and run; see SPEC.md, sections 3 and 5.
struct Hip {
  static constexpr std::size_t kHeaderBytes = trace_layout::kHeaderBytes;
  static constexpr std::size_t kRecordBytes = trace_layout::kRecordBytes;
  static Result<TraceHeader> decode(std::span<const std::uint8_t> trace) { return decode_header(trace, trace.size()); }
  static Result<TraceRecord> decode(std::span<const std::uint8_t, kRecordBytes> bytes) { return decode_record(bytes); }
  static const TraceHeader& run(const TraceHeader& header) { return header; }
  static bool may_be_of(const TraceHeader& run, std::uint64_t blob) { return run.blob_hash == blob; }

  Hip(const BlobView& blob, const TraceHeader& header)
      : field(blob), model(core::make_model(header.settings, header.period_ns, blob)), chain(header, header.blob_hash) {}
  TickOutput step(const TickInput& in) { return core::tick(in, field, model, state); }

  const BlobView& field;
  core::TickModel model;
  core::TickState state;
  Chain chain;
};

struct Wire {
  static constexpr std::size_t kHeaderBytes = device_trace_layout::kHeaderBytes;
  static constexpr std::size_t kRecordBytes = device_trace_layout::kRecordBytes;
  static Result<DeviceTraceHeader> decode(std::span<const std::uint8_t> trace) { return decode_device_header(trace, trace.size()); }
  static Result<DeviceTraceRecord> decode(std::span<const std::uint8_t, kRecordBytes> bytes) { return decode_device_record(bytes); }
  static const TraceHeader& run(const DeviceTraceHeader& header) { return header.run; }
  static bool may_be_of(const TraceHeader& run, std::uint64_t blob) { return run.blob_hash == blob || run.blob_hash == 0; }

  Wire(const BlobView& blob, const DeviceTraceHeader& header)
      : field(blob), model(core::make_device_model(header.device, header.run.settings, header.run.period_ns)), chain(header) {}
  DeviceOutput step(const DeviceInput& in) { return core::device_tick(in, in.field_generation == 0 ? nullptr : &field, model, state); }

  const BlobView& field;
  core::DeviceTickModel model;
  core::DeviceState state;
  DeviceChain chain;
};

template <class Kind>
Result<Report> run(const BlobView& field, std::span<const std::uint8_t> trace) {
  const auto header = Kind::decode(trace);
  if (!header) return header.error();
  const TraceHeader& recorded = Kind::run(*header);
  if (!recorded.has_outputs()) return Error::kNoOutputs;
  if (!Kind::may_be_of(recorded, field.hash())) return Error::kWrongBlob;

  Kind kind(field, *header);
  Report report;
  const std::uint8_t* at = trace.data() + Kind::kHeaderBytes;
  for (; report.ticks < recorded.record_count; ++report.ticks, at += Kind::kRecordBytes) {
    const auto record = Kind::decode(std::span<const std::uint8_t, Kind::kRecordBytes>(at, Kind::kRecordBytes));
    if (!record) return record.error();
    const auto output = kind.step(record->input);
    const bool equal = kind.chain.extend(record->input, output) == record->chain && output == record->output;
    if (!equal && report.equal) report.first_difference = report.ticks;
    report.equal = report.equal && equal;
  }
  report.hash = kind.chain.value();
  return report;
}

/// Runs a trace's inputs and compares with its outputs.
///
/// trace     a whole file
/// fails     as the decoders of its version; kNoOutputs, kWrongBlob
inline Result<Report> run(const BlobView& field, std::span<const std::uint8_t> trace) {
  const Result<std::uint16_t> major = trace_major(trace);
  if (!major) return major.error();
  return *major == device_trace_layout::kMajor ? run<Wire>(field, trace) : run<Hip>(field, trace);
}

}  // namespace isotouch::replay
