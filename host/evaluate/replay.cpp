#include "host/evaluate/replay.h"

#include <chrono>
#include <cstddef>
#include <string>

#include "host/error.h"

namespace isotouch::evaluate {

namespace {

void check_usable(const BlobView& field, const Trace& trace, bool check) {
  const std::string name = trace.file().string() + ": ";
  if (trace.header().model_hash != 0 || (trace.header().flags & trace_layout::kEncoderCounts) != 0) {
    throw InputError(name + "its inputs are encoder counts of a device; replay needs HIP positions");
  }
  if (!check) return;
  if (!trace.header().has_outputs()) throw InputError(name + describe(Error::kNoOutputs) + "; replay it with -o first");
  if (trace.size() == 0) throw InputError(name + "holds no records, there is nothing to compare");
  if (trace.header().blob_hash != field.hash()) {
    throw InputError(name + describe(Error::kWrongBlob) + "; give the blob it was recorded on, or replay without --check");
  }
}

/// Why a recorded tick is not the one that was computed, given that the ticks before it are. What was stored is told from what was computed
/// by asking which of the two the stored chain belongs to.
std::optional<std::string> difference_at(const Trace& trace, std::size_t tick, const TraceRecord& computed) {
  const TraceRecord stored = trace.record(tick);
  const char* output = differing_output(stored.output, computed.output);
  if (output == nullptr && stored.chain == computed.chain) return std::nullopt;
  if (stored.chain == computed.chain || trace.chain_follows(tick)) return output;
  const bool chain_goes_on = output == nullptr && tick + 1 < trace.size() && !trace.chain_follows(tick + 1);
  return chain_goes_on ? "chain" : "input";
}

}  // namespace

TraceHeader replay_header(const BlobView& field, const TraceHeader& inputs) {
  TraceHeader header = inputs;
  header.blob_hash = field.hash();
  header.flags |= trace_layout::kHasOutputs;
  return header;
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

ReplayReport replay(const BlobView& field, const Trace& trace, bool check, TraceWriter* out) {
  check_usable(field, trace, check);
  Run run(field, trace.header());
  ReplayReport report;
  const auto start = std::chrono::steady_clock::now();
  for (std::size_t tick = 0; tick < trace.size(); ++tick) {
    const TraceRecord recorded = trace.record(tick);
    TraceRecord computed = run.step(recorded.input);
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

}  // namespace isotouch::evaluate
