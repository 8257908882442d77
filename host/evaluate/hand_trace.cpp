#include "host/evaluate/hand_trace.h"

#include <vector>

#include "host/error.h"

namespace isotouch::evaluate {

Trace read_hand(const std::filesystem::path& file) {
  if (trace_major(file) != WireFormat::kMajor) return Trace::read(file);
  const DeviceTrace wire = DeviceTrace::read(file);
  if (!wire.header().has_outputs()) {
    throw InputError(file.string() + ": it holds what a device sent, not what was felt; replay it first with isotouch replay BLOB " +
                     file.string() + " -o OUT.trace");
  }
  TraceHeader header = wire.header().run;
  header.model_hash = 0;
  Chain chain(header, header.blob_hash);
  std::vector<TraceRecord> records;
  records.reserve(wire.size());
  for (std::size_t tick = 0; tick < wire.size(); ++tick) {
    const DeviceTraceRecord at = wire.record(tick);
    const TickInput input{at.output.hip, at.output.buttons, at.input.fresh, at.input.age};
    records.push_back({input, at.output.tick, chain.extend(input, at.output.tick), at.arrival_ns});
  }
  return {file, header, records};
}

}  // namespace isotouch::evaluate
