#include "host/evaluate/recorded_hand.h"

#include <cmath>
#include <cstddef>
#include <filesystem>

#include "host/error.h"
#include "host/to_double.h"

namespace isotouch::evaluate {

using Eigen::Vector3d;

RecordedHand recorded_hand(const trace::Trace& trace) {
  constexpr double kNsPerTick = 1e6;
  if (trace.size() < 2) throw InputError(trace.path() + ": it holds fewer than two ticks, so no hand moves in it");
  const bool positions = trace.kind() == InputKind::kPosition;
  if (!positions && !trace.header().has_outputs) {
    throw InputError(trace.path() + ": it holds packets of a device without outputs; replay it with -o first");
  }
  const auto at = [&](std::size_t tick) {
    const TraceRecord record = trace.record(tick);
    return to_double(positions ? record.input.hip : record.output.hip);
  };
  RecordedHand hand{std::filesystem::path(trace.path()).filename().string(), {}};
  const double step = kNsPerTick / trace.header().period_ns;  // ticks of the trace a millisecond
  const auto last = static_cast<double>(trace.size() - 1);
  for (std::size_t i = 0; static_cast<double>(i) * step <= last; ++i) {
    const double place = static_cast<double>(i) * step;
    const auto before = static_cast<std::size_t>(place);
    const double share = place - std::floor(place);
    const Vector3d from = at(before);
    hand.positions.emplace_back(share > 0 ? Vector3d(from + share * (at(before + 1) - from)) : from);
  }
  return hand;
}

}  // namespace isotouch::evaluate
