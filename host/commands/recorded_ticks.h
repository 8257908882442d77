/// The ticks of a trace with their outputs: as recorded, or computed where the trace holds inputs only.
#pragma once

#include <cstddef>
#include <functional>

#include "host/trace/trace_file.h"
#include "host/view/markers.h"
#include "shared/field_view.h"

namespace isotouch::commands {

/// field     nullptr: the outputs must be in the trace
/// fails     InputError: no outputs and no field; inputs are encoder counts
void for_each_tick(const trace::Trace& trace, const FieldView* field, const std::function<void(std::size_t, const TraceRecord&)>& use);

/// fails     InputError as above, and when there is no contact at that tick
view::Touch touch_at(const trace::Trace& trace, const FieldView& field, std::size_t tick);

/// The tick in contact whose HIP is furthest from its proxy; the first of equals.
///
/// fails     InputError as above, and when the object is never touched
view::Touch deepest_touch(const trace::Trace& trace, const FieldView& field);

}  // namespace isotouch::commands
