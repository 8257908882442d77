/// The settings that each tick of a recording felt with: those of its header, and what was set meanwhile.
#pragma once

#include <cstdint>

#include "firmware/core/coupling.h"
#include "firmware/core/settings_ramp.h"
#include "shared/trace.h"

namespace isotouch::trace {

class FeltSettings {
 public:
  /// header     of a recording that begins where its run begins (`has_beginning`)
  /// of_field   the field's stiffness, which holds where none is set; 0: not known
  FeltSettings(const TraceHeader& header, Stiffness of_field);

  /// Those of the next tick.
  ///
  /// record    with its outputs; all ticks come in order
  TickSettings next(const TraceRecord& record);

 private:
  TickSettings first_;
  core::Coupling coupling_;
  core::SettingsRamp ramp_;
  std::uint32_t generation_ = 0;
  bool active_ = false;  ///< there was force in the tick before, so that a setting moves to its new value by a ramp
};

}  // namespace isotouch::trace
