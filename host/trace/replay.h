/// The core over a recorded run: the same inputs on the same field give the same answers, to the bit, on every machine.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "firmware/core/tick.h"
#include "host/error.h"
#include "host/trace/recorded_patches.h"
#include "host/trace/rendering_difference.h"
#include "host/trace/trace_diff.h"
#include "host/trace/trace_file.h"
#include "shared/field_view.h"
#include "shared/patch_chain.h"

namespace isotouch::trace {

/// Computes the outputs of a trace's inputs, one tick after the other.
class Renderer {
 public:
  virtual ~Renderer() = default;

  /// One tick: what a trace stores of it, arrival time apart.
  virtual TraceRecord step(const Input& input) = 0;
  /// The replay hash: the chain after the last step.
  virtual std::uint64_t hash() const = 0;
  /// The header of a trace of these outputs.
  virtual const TraceHeader& header() const = 0;
};

/// One run of the core with its chain: the device's tick for packets, rendering alone for positions. After construction nothing is allocated.
class Run final : public Renderer {
 public:
  /// field     stays alive as long as the run; loaded in the ticks whose input names a field
  /// header    device, period and settings of the run
  /// patches   of a field that was patched meanwhile; they stay alive as long as the run
  Run(const FieldView& field, const TraceHeader& header, const RecordedPatches* patches = nullptr);
  Run(Run&&) = default;
  Run(const Run&) = delete;  // the patched images stand in its memory

  /// fails     InputError: the tick takes a patch over that is not there
  TraceRecord step(const Input& input) override;
  std::uint64_t hash() const override { return chain_.value(); }
  /// With outputs, of this field.
  const TraceHeader& header() const override { return header_; }

  /// What the last step felt with, in device or position alike.
  ///
  /// kind     of the run's inputs
  const core::RenderModel& felt(InputKind kind) const { return kind == InputKind::kPosition ? position_model_.render : tick_state_.felt; }
  /// Was nothing rendered yet since the run began, or since it forgot everything?
  bool is_unplaced(InputKind kind) const {
    const core::RenderState& state = kind == InputKind::kPosition ? position_state_.render : tick_state_.render;
    return state.proxy.mode == core::ProxyMode::kUnplaced;
  }

 private:
  std::array<std::vector<std::uint64_t>, 2> memory_;  ///< of patched images
  PatchChain field_;
  TraceHeader header_;
  core::TickModel tick_model_;
  core::PositionModel position_model_;
  core::TickState tick_state_;
  core::PositionState position_state_;
  Chain chain_;
};

struct ReplayReport {
  std::uint64_t ticks = 0;
  double seconds = 0.0;  ///< wall clock of all ticks with their chain
  std::uint64_t hash = 0;
  std::optional<Difference> first_difference;  ///< only looked for with `check`
};

/// Does a trace begin where its run begins? One of positions, and one without outputs, begin anywhere. Where it does not, the settings of its header may
/// be older than those of its first tick.
bool has_beginning(const Trace& trace);
/// fails     InputError: a trace of packets begins in the middle of a run, so nobody can compute its outputs
void require_a_beginning(const Trace& trace);

/// Runs a trace's inputs.
///
/// check       compares every tick with the recorded outputs and chain. Looking stops at the first that differs, running goes on. Its field is an
///             output's name; "input" when the record's input was changed after recording, "chain" when only the stored chain was
/// out         nullptr, or takes every record, with the input's arrival times
/// difference  nullptr, or takes in every tick beside the recorded one
/// The patches of a field that was patched are read from the file beside the trace.
///
/// fails       as require_a_beginning; InputError: patches that are not those of the trace, or are not there; a second field where the trace names one;
///             with `check`, no outputs or no records, or another field; with `difference`, no outputs
ReplayReport replay(const FieldView& field, const Trace& trace, bool check, TraceWriter* out = nullptr,
                    RenderingDifference* difference = nullptr);

/// The same by another renderer, whose bits nobody recorded.
///
/// renderer    at its beginning, with the trace's header
ReplayReport replay(Renderer& renderer, const Trace& trace, TraceWriter* out, RenderingDifference* difference);

/// The header that a trace of this replay has: for the writer.
TraceHeader replay_header(const FieldView& field, const TraceHeader& inputs);

}  // namespace isotouch::trace
