#include "host/trace/felt_settings.h"

#include "firmware/core/motion.h"

namespace isotouch::trace {

FeltSettings::FeltSettings(const TraceHeader& header, Stiffness of_field)
    : first_(header.settings), coupling_(core::make_coupling(first_, core::make_motion_model(header.device, header.period_ns).rate)) {
  if (coupling_.stiffness == Stiffness{}) coupling_.stiffness = of_field;
  core::begin_settings(first_, ramp_);
}

TickSettings FeltSettings::next(const TraceRecord& record) {
  const Input& in = record.input;
  if (in.kind == InputKind::kPacket) {  // positions take no change
    if ((in.requests & kRequestRestart) != 0) {
      core::begin_settings(first_, ramp_);
      active_ = false;
    }
    core::advance_settings(in.change, !active_, coupling_, ramp_);
    const bool patched = (in.requests & kRequestMoved) != 0 && generation_ != 0;
    if (in.field_generation != generation_ && !patched) core::finish_settings(ramp_);
    generation_ = in.field_generation;
    active_ = SupervisorState{record.output.state} == SupervisorState::kActive;
  }
  TickSettings now = with_live(first_, ramp_.now);
  if (now.stiffness == Stiffness{}) now.stiffness = coupling_.stiffness;
  return now;
}

}  // namespace isotouch::trace
