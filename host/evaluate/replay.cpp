#include "host/evaluate/replay.h"

#include <chrono>
#include <cstddef>
#include <string>

#include "host/error.h"

namespace isotouch::evaluate {

namespace {

void check_inputs(const Trace& trace) {
  if (trace.header().model_hash != 0 || (trace.header().flags & trace_layout::kEncoderCounts) != 0) {
    throw InputError(trace.file().string() + ": its inputs are encoder counts of a device; replay needs HIP positions");
  }
}

/// A trace names one blob, so it ends where another field was loaded.
void check_inputs(const DeviceTrace& trace) {
  std::uint32_t generation = 0;
  for (std::size_t tick = 0; tick < trace.size(); ++tick) {
    const std::uint32_t loaded = trace.record(tick).input.field_generation;
    if (generation != 0 && loaded != 0 && loaded != generation) {
      throw InputError(trace.file().string() + ": another field was loaded at record " + std::to_string(tick) +
                       ", but a trace names one blob; record it in two parts");
    }
    if (loaded != 0) generation = loaded;
  }
}

bool may_be_of(const Trace& trace, std::uint64_t blob) { return trace.header().blob_hash == blob; }
/// A recording that ended before a field was loaded names none; its chain knows no blob.
bool may_be_of(const DeviceTrace& trace, std::uint64_t blob) {
  return trace.header().run.blob_hash == blob || trace.header().run.blob_hash == 0;
}

template <class Format>
void check_usable(const BlobView& field, const TraceFile<Format>& trace, bool check) {
  const std::string name = trace.file().string() + ": ";
  check_inputs(trace);
  if (!check) return;
  if (!trace.header().has_outputs()) throw InputError(name + describe(Error::kNoOutputs) + "; replay it with -o first");
  if (trace.size() == 0) throw InputError(name + "holds no records, there is nothing to compare");
  if (!may_be_of(trace, field.hash())) {
    throw InputError(name + describe(Error::kWrongBlob) + "; give the blob it was recorded on, or replay without --check");
  }
}

/// Why a recorded tick is not the one that was computed, given that the ticks before it are. What was stored is told from what was computed
/// by asking which of the two the stored chain belongs to.
template <class Format>
std::optional<std::string> difference_at(const TraceFile<Format>& trace, std::size_t tick, const typename Format::Record& computed) {
  const auto stored = trace.record(tick);
  const char* output = differing_output(stored.output, computed.output);
  if (output == nullptr && stored.chain == computed.chain) return std::nullopt;
  if (stored.chain == computed.chain || trace.chain_follows(tick)) return output;
  const bool chain_goes_on = output == nullptr && tick + 1 < trace.size() && !trace.chain_follows(tick + 1);
  return chain_goes_on ? "chain" : "input";
}

template <class Run, class Format>
ReplayReport replay_with(const BlobView& field, const TraceFile<Format>& trace, bool check, TraceFileWriter<Format>* out) {
  check_usable(field, trace, check);
  Run run(field, trace.header());
  ReplayReport report;
  const auto start = std::chrono::steady_clock::now();
  for (std::size_t tick = 0; tick < trace.size(); ++tick) {
    const auto recorded = trace.record(tick);
    auto computed = run.step(recorded.input);
    if (check && !report.first_difference) {
      if (const auto field_name = difference_at(trace, tick, computed)) report.first_difference = Difference{tick, *field_name};
    }
    if (out != nullptr) {
      computed.arrival_ns = recorded.arrival_ns;
      out->append(computed);
    }
  }
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  report.ticks = trace.size();
  report.hash = run.hash();
  return report;
}

}  // namespace

TraceHeader replay_header(const BlobView& field, const TraceHeader& inputs) {
  TraceHeader header = inputs;
  header.blob_hash = field.hash();
  header.flags |= trace_layout::kHasOutputs;
  return header;
}

DeviceTraceHeader replay_header(const BlobView& field, const DeviceTraceHeader& inputs) {
  return {replay_header(field, inputs.run), inputs.device};
}

Run::Run(const BlobView& field, const TraceHeader& header)
    : field_(field),
      header_(replay_header(field, header)),
      model_(core::make_model(header.settings, header.period_ns, field)),
      chain_(header_, header_.blob_hash) {}

TraceRecord Run::step(const TickInput& input) {
  TraceRecord record;
  record.input = input;
  record.output = core::tick(input, field_, model_, state_);
  record.chain = chain_.extend(record.input, record.output);
  return record;
}

DeviceRun::DeviceRun(const BlobView& field, const DeviceTraceHeader& header)
    : field_(field),
      header_(replay_header(field, header)),
      model_(core::make_device_model(header.device, header.run.settings, header.run.period_ns)),
      chain_(header_) {}

DeviceTraceRecord DeviceRun::step(const DeviceInput& input) {
  DeviceTraceRecord record;
  record.input = input;
  record.output = core::device_tick(input, input.field_generation == 0 ? nullptr : &field_, model_, state_);
  record.chain = chain_.extend(record.input, record.output);
  return record;
}

ReplayReport replay(const BlobView& field, const Trace& trace, bool check, TraceWriter* out) {
  return replay_with<Run>(field, trace, check, out);
}

ReplayReport replay(const BlobView& field, const DeviceTrace& trace, bool check, DeviceTraceWriter* out) {
  return replay_with<DeviceRun>(field, trace, check, out);
}

}  // namespace isotouch::evaluate
