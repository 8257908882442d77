#include "host/evaluate/god_object_run.h"

#include "firmware/core/handle_weight.h"
#include "firmware/core/index_frame.h"
#include "host/field/line_crossings.h"
#include "host/to_double.h"

namespace isotouch::evaluate {

namespace {

/// The bits that say how the contact was rendered; all others are of the input and the device.
constexpr std::uint32_t kRendered = kContact | kFollowing | kHeldInside | kForceLimited | kDamped;

TraceHeader of_no_field(TraceHeader header) {
  header.field_hash = 0;
  header.has_outputs = true;
  return header;
}

}  // namespace

GodObjectRun::GodObjectRun(const FieldView& field, const field::TriangleTree& tree, const TraceHeader& header,
                           const trace::RecordedPatches* patches)
    : field_(field),
      tree_(tree),
      header_(of_no_field(header)),
      core_(field, header, patches),
      motion_model_(core::make_motion_model(header.device, header.period_ns)),
      chain_(header_) {}

TraceRecord GodObjectRun::step(const Input& input) {
  TraceRecord record = core_.step(input);
  if (begins_anew(input, record.output)) {
    motion_ = {};
    render_ = {};
    object_.reset();
  }
  record.output = felt(input, record.output);
  record.chain = chain_.extend(record.input, record.output);
  return record;
}

/// Did the core forget what it rendered before this tick?
bool GodObjectRun::begins_anew(const Input& input, const Output& core) {
  const bool patched = (input.requests & kRequestMoved) != 0 && generation_ != 0;
  const bool other_field = input.field_generation != generation_ && !patched;
  generation_ = input.field_generation;
  return other_field || (input.requests & kRequestRestart) != 0 || (core.status & kCountJump) != 0 || core_.is_unplaced(input.kind);
}

core::Contact GodObjectRun::follow(const Vec3<Mm>& hip) {
  core::Contact contact;
  contact.proxy = core::to_index(hip, field_);
  const Eigen::Vector3d hand = to_double(hip);
  if (!object_) {
    contact.held_inside = field::is_inside(tree_, hand);
    if (!contact.held_inside) object_.emplace(tree_, hand);
    return contact;
  }
  object_->settle(hand);
  if (!object_->touching()) return contact;
  const Vec3<Voxel> held = core::to_index(to_fixed<Mm>(object_->position()), field_);
  if (field_.stiffness_parts != nullptr) core::sample_field(field_, held, render_.proxy.sample);  // how the surface bends there
  contact.touching = true;
  contact.deflection = held - contact.proxy;
  contact.proxy = held;
  return contact;
}

/// out       of the core on its field
Output GodObjectRun::felt(const Input& input, Output out) {
  const bool device = input.kind == InputKind::kPacket;
  const bool active = may_give_force(input.kind, out);
  out.status &= ~(device ? kRendered : kRendered | kRamping);  // a device also ramps after a hold
  out.proxy = out.hip;
  out.force = {};
  out.commands = {};
  if (core_.is_unplaced(input.kind) || (out.status & kPoseUncertain) != 0) return out;
  const core::RenderModel& model = core_.felt(input.kind);
  const core::Motion motion = core::track_motion(out.hip, (out.status & kStale) == 0, model.damps(), motion_model_, motion_);
  if (device && (!active || (out.status & kRamping) != 0)) core::forget(render_.passivity);  // as the device's tick does
  core::Contact contact = follow(out.hip);
  const core::Rendering rendered = core::feel(contact, motion, field_, model, render_);
  out.status |= rendered.status;
  if (rendered.touching) out.proxy = rendered.proxy;
  if (active) out.force = device ? core::with_handle_held_up(rendered.force, model.settings.weight) : rendered.force;
  return out;
}

}  // namespace isotouch::evaluate
