/// A recorded hand felt with the exact god-object on the true surface instead of the field's proxy.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "host/evaluate/god_object.h"
#include "host/field/triangle_tree.h"
#include "host/trace/replay.h"

namespace isotouch::evaluate {

/// The god-object gives the proxy; everything after it is the core's: stiffness there, friction, damping, ramp and limit of the force.
///
/// A hand that begins inside the mesh feels nothing until it has left, as in the core. Of a device's packets the core itself finds where the hand is and
/// whether there may be force. There are no motor commands.
class GodObjectRun final : public trace::Renderer {
 public:
  /// field     gives the stiffness, and index coordinates to the core; alive as long as this
  /// tree      the true surface: closed, workspace, mm; alive as long as this
  /// header    of the trace
  /// patches   of its field, as in trace::Run: they change what the device's tick decides, and the mesh stays as it is
  GodObjectRun(const FieldView& field, const field::TriangleTree& tree, const TraceHeader& header,
               const trace::RecordedPatches* patches = nullptr);

  TraceRecord step(const Input& input) override;
  std::uint64_t hash() const override { return chain_.value(); }
  /// It names no field, because no field gives these outputs.
  const TraceHeader& header() const override { return header_; }

 private:
  bool begins_anew(const Input& input, const Output& core);
  core::Contact follow(const Vec3<Mm>& hip);
  Output felt(const Input& input, Output out);

  const FieldView& field_;
  const field::TriangleTree& tree_;
  TraceHeader header_;
  trace::Run core_;
  core::MotionModel motion_model_;
  std::uint32_t generation_ = 0;
  core::MotionState motion_;
  core::RenderState render_;
  std::optional<GodObject> object_;  ///< from the first tick outside the mesh on
  Chain chain_;
};

}  // namespace isotouch::evaluate
