#include "host/trace/trace_diff.h"

#include <algorithm>
#include <cstddef>

#include "host/error.h"

namespace isotouch::trace {

namespace {

const char* differing_header(const TraceHeader& a, const TraceHeader& b) {
  if (a.field_hash != b.field_hash) return "field";
  if (a.device != b.device) return "model";
  if (a.period_ns != b.period_ns) return "period";
  if (a.settings != b.settings) return "settings";
  return nullptr;
}

bool is_sound(const Trace& trace) {
  for (std::size_t tick = 0; tick < trace.size(); ++tick) {
    if (!trace.chain_follows(tick)) return false;
  }
  return true;
}

/// Where two records differ, arrival times apart.
std::optional<std::string> difference_at(const Trace& a, const Trace& b, std::size_t tick) {
  const TraceRecord left = a.record(tick), right = b.record(tick);
  if (const FieldName input = differing_input(left.input, right.input)) return std::string(input.view());
  if (const FieldName output = differing_output(left.output, right.output)) return std::string(output.view());
  return left.chain != right.chain ? std::optional<std::string>("chain") : std::nullopt;
}

}  // namespace

void require_a_recording(const Trace& trace) {
  const std::string name = trace.path() + ": ";
  if (!trace.header().has_outputs) throw InputError(name + describe(Error::kNoOutputs) + "; replay it with -o first");
  if (trace.size() == 0) throw InputError(name + "holds no records, there is nothing to compare");
}

std::optional<Difference> first_difference(const Trace& a, const Trace& b) {
  require_a_recording(a);
  require_a_recording(b);
  if (const char* field = differing_header(a.header(), b.header())) return Difference{0, field};

  const std::size_t common = std::min(a.size(), b.size());
  const bool are_sound = is_sound(a) && is_sound(b);  // else equal chains mean nothing
  std::size_t equal_before = 0;                       // every tick below is equal
  std::size_t differs_from = common;                  // this tick, if it exists, differs
  while (equal_before < differs_from) {
    const std::size_t middle = are_sound ? equal_before + (differs_from - equal_before) / 2 : equal_before;
    if (are_sound ? a.chain(middle) == b.chain(middle) : !difference_at(a, b, middle)) {
      equal_before = middle + 1;
    } else {
      differs_from = middle;
    }
  }
  if (differs_from < common) return Difference{differs_from, difference_at(a, b, differs_from).value_or("")};
  if (a.size() != b.size()) return Difference{common, "length"};
  return std::nullopt;
}

}  // namespace isotouch::trace
