#include "host/evaluate/trace_diff.h"

#include <algorithm>
#include <cstddef>

#include "host/error.h"

namespace isotouch::evaluate {

namespace {

template <class Format>
void check_recording(const TraceFile<Format>& trace) {
  const std::string name = trace.file().string() + ": ";
  if (!trace.header().has_outputs()) throw InputError(name + describe(Error::kNoOutputs) + "; replay it with -o first");
  if (trace.size() == 0) throw InputError(name + "holds no records, there is nothing to compare");
  for (std::size_t tick = 0; tick < trace.size(); ++tick) {
    if (!trace.chain_follows(tick)) {
      throw InputError(name + "the chain breaks at record " + std::to_string(tick) +
                       ": its bytes were changed after they were recorded; use the original file");
    }
  }
}

const char* differing_run(const TraceHeader& a, const TraceHeader& b) {
  if (a.blob_hash != b.blob_hash) return "blob";
  if (a.model_hash != b.model_hash || a.flags != b.flags) return "model";
  if (a.period_ns != b.period_ns) return "period";
  if (a.settings != b.settings) return "settings";
  return nullptr;
}

}  // namespace

const char* differing_input(const TickInput& a, const TickInput& b) {
  if (a.hip.x != b.hip.x) return "hip.x";
  if (a.hip.y != b.hip.y) return "hip.y";
  if (a.hip.z != b.hip.z) return "hip.z";
  if (a.buttons != b.buttons) return "buttons";
  if (a.fresh != b.fresh) return "fresh";
  if (a.age != b.age) return "age";
  return nullptr;
}

const char* differing_output(const TickOutput& a, const TickOutput& b) {
  if (a.proxy.x != b.proxy.x) return "proxy.x";
  if (a.proxy.y != b.proxy.y) return "proxy.y";
  if (a.proxy.z != b.proxy.z) return "proxy.z";
  if (a.force.x != b.force.x) return "force.x";
  if (a.force.y != b.force.y) return "force.y";
  if (a.force.z != b.force.z) return "force.z";
  if (a.words[0] != b.words[0]) return "words[0]";
  if (a.words[1] != b.words[1]) return "words[1]";
  if (a.words[2] != b.words[2]) return "words[2]";
  if (a.state != b.state) return "state";
  if (a.status != b.status) return "status";
  return nullptr;
}

const char* differing_input(const DeviceInput& a, const DeviceInput& b) {
  if (a.packet != b.packet) return "packet";
  if (a.fresh != b.fresh) return "fresh";
  if (a.age != b.age) return "age";
  if (a.commands != b.commands) return "commands";
  if (a.field_generation != b.field_generation) return "field";
  return nullptr;
}

const char* differing_output(const DeviceOutput& a, const DeviceOutput& b) {
  if (a.hip.x != b.hip.x) return "hip.x";
  if (a.hip.y != b.hip.y) return "hip.y";
  if (a.hip.z != b.hip.z) return "hip.z";
  if (const char* field = differing_output(a.tick, b.tick)) return field;
  if (a.faults != b.faults) return "faults";
  if (a.packet_flags != b.packet_flags) return "flags";
  if (a.buttons != b.buttons) return "buttons";
  return nullptr;
}

template <class Format>
std::optional<Difference> first_difference(const TraceFile<Format>& a, const TraceFile<Format>& b) {
  check_recording(a);
  check_recording(b);
  if (const char* field = differing_run(Format::run(a.header()), Format::run(b.header()))) return Difference{0, field};

  const std::size_t common = std::min(a.size(), b.size());
  std::size_t equal_before = 0;       // every tick below is equal
  std::size_t differs_from = common;  // this tick, if it exists, differs
  while (equal_before < differs_from) {
    const std::size_t middle = equal_before + (differs_from - equal_before) / 2;
    if (a.chain(middle) == b.chain(middle)) {
      equal_before = middle + 1;
    } else {
      differs_from = middle;
    }
  }
  if (differs_from < common) {
    const auto left = a.record(differs_from);
    const auto right = b.record(differs_from);
    const char* input = differing_input(left.input, right.input);
    return Difference{differs_from, input != nullptr ? input : differing_output(left.output, right.output)};
  }
  if (a.size() != b.size()) return Difference{common, "length"};
  return std::nullopt;
}

template std::optional<Difference> first_difference(const Trace&, const Trace&);
template std::optional<Difference> first_difference(const DeviceTrace&, const DeviceTrace&);

}  // namespace isotouch::evaluate
