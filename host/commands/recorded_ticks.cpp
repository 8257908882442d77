#include "host/commands/recorded_ticks.h"

#include <optional>
#include <string>

#include "host/error.h"
#include "host/to_double.h"
#include "host/trace/replay.h"

namespace isotouch::commands {

namespace {

view::Touch touch_of(const trace::Trace& trace, std::size_t tick, const TraceRecord& record) {
  return {.proxy = to_double(record.output.proxy),
          .hip = to_double(record.output.hip),
          .force_n = to_double(record.output.force).norm(),
          .tick = tick,
          .time_s = static_cast<double>(tick) * trace.header().period_ns * 1e-9};
}

}  // namespace

void for_each_tick(const trace::Trace& trace, const FieldView* field, const std::function<void(std::size_t, const TraceRecord&)>& use) {
  std::optional<trace::Run> run;
  if (!trace.header().has_outputs) {
    if (field == nullptr) throw InputError(trace.path() + ": it holds inputs only; name the field that they touch with --field");
    run.emplace(*field, trace.header());
  }
  for (std::size_t tick = 0; tick < trace.size(); ++tick) {
    const TraceRecord record = trace.record(tick);
    use(tick, run ? run->step(record.input) : record);
  }
}

view::Touch touch_at(const trace::Trace& trace, const FieldView& field, std::size_t tick) {
  std::optional<view::Touch> touch;
  for_each_tick(trace, &field, [&](std::size_t number, const TraceRecord& record) {
    if (number == tick && (record.output.status & kContact) != 0) touch = touch_of(trace, number, record);
  });
  if (!touch)
    throw InputError(trace.path() + ": nothing is touched at tick " + std::to_string(tick) + ", choose another or --tick deepest");
  return *touch;
}

view::Touch deepest_touch(const trace::Trace& trace, const FieldView& field) {
  std::optional<view::Touch> deepest;
  for_each_tick(trace, &field, [&](std::size_t number, const TraceRecord& record) {
    if ((record.output.status & kContact) == 0) return;
    const view::Touch touch = touch_of(trace, number, record);
    if (!deepest || touch.depth_mm() > deepest->depth_mm()) deepest = touch;
  });
  if (!deepest) throw InputError(trace.path() + ": the hand never touches this field");
  return *deepest;
}

}  // namespace isotouch::commands
