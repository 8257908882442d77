#include "host/commands/recorded_ticks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "host/error.h"
#include "host/to_double.h"
#include "host/trace/hash_text.h"
#include "host/trace/recorded_patches.h"
#include "host/trace/replay.h"
#include "host/view/touch_view.h"

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
///
/// cost      also gets the field at that tick, and whether it is another one than in the call before
template <class Cost>
view::Touch least(const trace::Trace& trace, const FieldView& field, const Cost& cost) {
  std::optional<view::Touch> best;
  double best_cost = 0;
  bool is_other = true;
  trace::FeltField felt(trace, field);
  for_each_tick(trace, &field, [&](std::size_t number, const TraceRecord& record) {
    const FieldView* now = felt.next(record.input);
    is_other = is_other || (record.input.requests & kRequestMoved) != 0;
    if (now == nullptr || (record.output.status & kContact) == 0) return;
    const view::Touch touch = touch_of(trace, number, record);
    const double this_cost = cost(touch, *now, std::exchange(is_other, false));
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

trace::FeltField felt_at(const trace::Trace& trace, const FieldView& field, std::size_t tick) {
  trace::FeltField felt(trace, field);
  for (std::size_t number = 0; number <= tick; ++number) felt.next(trace.record(number).input);
  return felt;
}

view::Touch touch_at(const trace::Trace& trace, const FieldView& field, std::size_t tick) {
  if (felt_at(trace, field, tick).now() == nullptr)
    throw InputError(trace.path() + ": at tick " + std::to_string(tick) + " the hand felt what this field was before a patch; give " +
                     trace::hash_text(trace.header().field_hash) + ", with which the recording begins, or choose a later tick");
  std::optional<view::Touch> touch;
  for_each_tick(trace, &field, [&](std::size_t number, const TraceRecord& record) {
    if (number == tick && (record.output.status & kContact) != 0) touch = touch_of(trace, number, record);
  });
  if (!touch) throw InputError(trace.path() + ": nothing is touched at tick " + std::to_string(tick) + ", choose another, or --tick clear");
  return *touch;
}

view::Touch deepest_touch(const trace::Trace& trace, const FieldView& field) {
  return least(trace, field, [](const view::Touch& touch, const FieldView&, bool) { return -touch.depth_mm(); });
}

view::Touch clear_touch(const trace::Trace& trace, const FieldView& field, char up) {
  std::optional<view::FieldRays> rays;
  double best = kOtherDepth;
  return least(trace, field, [&](const view::Touch& touch, const FieldView& now, bool is_other) {
    if (is_other) rays.reset();
    const double off_depth = std::fabs(touch.depth_mm() - std::clamp(touch.depth_mm(), kClearDepth[0], kClearDepth[1]));
    if (off_depth > 0) return kOtherDepth + off_depth;
    const double slant = view::slant_cost(touch, {.up = up});
    if (slant >= best) return slant;  // it is not chosen, so the field, which each patch makes another one, need not be looked at
    if (!rays) rays.emplace(now);
    const double cost = view::view_cost(touch, {.up = up}, *rays);
    best = std::min(best, cost);
    return cost;
  });
}

}  // namespace isotouch::commands
