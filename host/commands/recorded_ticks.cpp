#include "host/commands/recorded_ticks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "host/error.h"
#include "host/to_double.h"
#include "host/trace/hash_text.h"
#include "host/trace/recorded_patches.h"
#include "host/trace/replay.h"
#include "host/view/touch_view.h"
#include "shared/patch_chain.h"
#include "shared/result.h"

namespace isotouch::commands {

namespace {

view::Touch touch_of(const trace::Trace& trace, std::size_t tick, const TraceRecord& record) {
  return {.proxy = to_double(record.output.proxy),
          .hip = to_double(record.output.hip),
          .force = to_double(record.output.force),
          .tick = tick,
          .time_s = static_cast<double>(tick) * trace.header().period_ns * 1e-9};
}

constexpr std::array kClearDepth = {1.2, 1.8};  // mm
constexpr double kOtherDepth = 1e6;             // more than any view costs: the depth comes first

/// The touch of least cost; of equal ones the first.
template <class Cost>
view::Touch least(const trace::Trace& trace, const FieldView& field, const Cost& cost) {
  std::optional<view::Touch> best;
  double best_cost = 0;
  for_each_tick(trace, &field, [&](std::size_t number, const TraceRecord& record) {
    if ((record.output.status & kContact) == 0) return;
    const view::Touch touch = touch_of(trace, number, record);
    const double this_cost = cost(touch);
    if (best && this_cost >= best_cost) return;
    best = touch;
    best_cost = this_cost;
  });
  if (!best) throw InputError(trace.path() + ": the hand never touches this field");
  return *best;
}

}  // namespace

void for_each_tick(const trace::Trace& trace, const FieldView* field, const std::function<void(std::size_t, const TraceRecord&)>& use) {
  std::optional<trace::RecordedPatches> patches;
  std::optional<trace::Run> run;
  if (!trace.header().has_outputs) {
    if (field == nullptr) throw InputError(trace.path() + ": it holds inputs only; name the field that they touch with --field");
    patches = trace::read_patches(trace, *field);
    run.emplace(*field, trace.header(), patches ? &*patches : nullptr);
  }
  for (std::size_t tick = 0; tick < trace.size(); ++tick) {
    const TraceRecord record = trace.record(tick);
    use(tick, run ? run->step(record.input) : record);
  }
}

void require_touched(const trace::Trace& trace, const FieldView& field) {
  const std::uint64_t named = trace.header().field_hash, hash = field.hash();
  if (!trace.header().has_outputs || named == 0 || named == hash) return;
  const std::vector<std::uint8_t> patches = trace::patch_bytes(trace).value_or(std::vector<std::uint8_t>());
  std::span<const std::uint8_t> left = patches;
  while (const auto patch = first_patch(left)) {
    if (patch->hash_after == hash) return;
    left = left.subspan(patch->patch_bytes());
  }
  throw InputError(trace.path() + ": " + describe(Error::kWrongField) + ", " + trace::hash_text(named) +
                   "; give that field, or first render this hand on yours: isotouch replay FIELD TRACE -o OTHER.trace");
}

view::Touch touch_at(const trace::Trace& trace, const FieldView& field, std::size_t tick) {
  std::optional<view::Touch> touch;
  for_each_tick(trace, &field, [&](std::size_t number, const TraceRecord& record) {
    if (number == tick && (record.output.status & kContact) != 0) touch = touch_of(trace, number, record);
  });
  if (!touch) throw InputError(trace.path() + ": nothing is touched at tick " + std::to_string(tick) + ", choose another, or --tick clear");
  return *touch;
}

view::Touch deepest_touch(const trace::Trace& trace, const FieldView& field) {
  return least(trace, field, [](const view::Touch& touch) { return -touch.depth_mm(); });
}

view::Touch clear_touch(const trace::Trace& trace, const FieldView& field, char up) {
  const view::FieldRays rays(field);
  return least(trace, field, [&](const view::Touch& touch) {
    const double off_depth = std::fabs(touch.depth_mm() - std::clamp(touch.depth_mm(), kClearDepth[0], kClearDepth[1]));
    return off_depth > 0 ? kOtherDepth + off_depth : view::view_cost(touch, {.up = up}, rays);
  });
}

}  // namespace isotouch::commands
