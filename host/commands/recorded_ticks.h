/// The ticks of a trace with their outputs: as recorded, or computed where the trace holds inputs only.
#pragma once

#include <cstddef>
#include <functional>

#include "host/trace/felt_field.h"
#include "host/trace/trace_file.h"
#include "host/view/markers.h"
#include "shared/field_view.h"

namespace isotouch::commands {

/// field     nullptr: the outputs must be in the trace
/// fails     InputError: no outputs and no field; inputs are encoder counts
void for_each_tick(const trace::Trace& trace, const FieldView* field, const std::function<void(std::size_t, const TraceRecord&)>& use);

/// The field as that tick felt it.
///
/// field     as `trace::FeltField`
trace::FeltField felt_at(const trace::Trace& trace, const FieldView& field, std::size_t tick);

/// fails     InputError as above; the hand did not feel this field, or not yet at that tick; there is no contact at that tick
view::Touch touch_at(const trace::Trace& trace, const FieldView& field, std::size_t tick);

/// The tick in contact whose HIP is furthest from its proxy; the first of equals.
///
/// fails     InputError as above, and when the object is never touched
view::Touch deepest_touch(const trace::Trace& trace, const FieldView& field);

/// A touch that a person recognises on a picture: 1.2 to 1.8 mm deep, and seen well from the default direction; the first of equals. Where no touch is
/// that deep, the one that comes nearest to it.
///
/// up        the axis that points upwards on the picture
/// fails     as `deepest_touch`
view::Touch clear_touch(const trace::Trace& trace, const FieldView& field, char up);

}  // namespace isotouch::commands
