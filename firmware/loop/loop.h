/// The loop around the tick: waits for the device, computes the age of its sample, ticks, hands the commands over, counts. It does not allocate, lock, or block
/// but in `Device::wait` and in sleeping until the tick's time.
///
/// Between two ticks nobody may change what the tick remembers and relies on: its state, its model, its view of the field, and the part of the field that
/// it reads. Before a tick the loop looks whether it is so. If not, the tick is told by kLineMemory, and a damaged state begins anew.
#pragma once

#include <atomic>
#include <cstdint>
#include <span>

#include "firmware/core/tick.h"
#include "firmware/loop/clock.h"
#include "firmware/loop/device.h"
#include "firmware/loop/felt_blocks.h"
#include "firmware/loop/field_slots.h"
#include "firmware/loop/latest.h"
#include "firmware/loop/line_state.h"
#include "firmware/loop/memory_check.h"
#include "firmware/loop/pace.h"
#include "firmware/loop/requests.h"
#include "firmware/loop/seal.h"
#include "firmware/loop/tick_record.h"
#include "firmware/loop/tick_stats.h"

namespace isotouch::loop {

/// Everything that the tick exchanges with other threads. One static table, made before the first tick.
struct Neighbours {
  FieldSlots& fields;
  Requests& requests;
  TraceRing& trace;           ///< every tick; a full ring loses records, never time
  Latest<TickRecord>& shown;  ///< the newest tick, for one reader
  TickStats& stats;
  LineState* lines = nullptr;  ///< nullptr: nobody watches
};

struct LoopSettings {
  DeviceModel device = libnifalcon_model();
  TickSettings tick = {};
  std::uint32_t period_ns = 1'000'000;  ///< 100,000 to 4,000,000
  std::uint32_t heat = 0;               ///< as core::heat_input gives it, of an earlier loop; 0 = not known
  std::uint16_t faults = 0;             ///< that no person has resumed after, of an earlier loop: then this one must begin with a stop
  bool lockstep = false;                ///< wait for every reply without a due time: a run is then a pure function of the device's answers
};

class Loop {
 public:
  static constexpr std::uint64_t kFaultsEvery = 1024;

  /// device, clock and everything in `neighbours` live longer
  Loop(const LoopSettings& settings, Device& device, Clock& clock, const Neighbours& neighbours);

  /// Waits for the next tick's time, and ticks.
  ///
  /// returns   false: in lockstep, no reply will come any more, and there was no tick
  bool step();

  /// Ticks until told to stop, until `step` returns false, or so often. `stop` is read once a tick.
  void run(const std::atomic<bool>& stop, std::uint64_t most = UINT64_MAX);

  /// What does not change while it ticks, as it stands in memory; from construction on.
  std::span<const std::uint8_t> constants() const { return {reinterpret_cast<const std::uint8_t*>(&model_), sizeof model_}; }

  /// The newest damage that a tick was told of since the last call; kNone: there was none. Any thread.
  Damage take_damage() { return found_.exchange(Damage::kNone, std::memory_order_relaxed); }

  /// What the tick relies on and what it remembers, for tests. Not while it runs.
  const core::TickModel& model() const { return model_; }
  const core::TickState& state() const { return state_; }

  /// As core::heat_input gives it, for the loop that follows this one. Not while it runs.
  std::uint32_t heat() const { return core::heat_input(state_.heat); }

  /// TickRecord::faults of the newest tick. Any thread.
  std::uint16_t faults() const { return faults_.load(std::memory_order_relaxed); }

 private:
  ActiveField take_field();
  Damage damage() const;
  void hear(const ActiveField& taken, std::uint32_t before, bool begins_anew, Input& in);
  Input look(const Sample& sample, std::uint32_t missed);
  std::uint32_t slept_periods();
  bool is_too_long(std::uint32_t missed);
  void count_own_costs();

  LoopSettings settings_;
  const core::TickModel model_;
  const core::TickModel spare_;  ///< the same: what a tick computes with a damaged model, nobody can know
  Device& device_;
  Clock& clock_;
  Neighbours neighbours_;
  core::TickState state_;
  FieldView view_;              ///< of the field of `generation_`: the tick's own
  bool field_is_whole_ = true;  ///< as far as the ticks have read it
  FeltBlocks felt_;
  Seal model_seal_, state_seal_, view_seal_;
  std::atomic<Damage> found_{Damage::kNone};
  std::atomic<std::uint16_t> faults_;
  Pace pace_;
  std::int64_t suspended_ = 0;  ///< ns that the machine had slept at the tick before
  std::uint64_t ticks_ = 0;
  std::uint64_t seen_ = 0;    ///< number of the newest sample that a tick has had
  std::uint32_t age_ = 0;     ///< ticks since a sample was fresh, those that were left out included
  std::uint64_t untold_ = 0;  ///< periods left out in this hold, or before this tick, beyond those that records can tell
  std::uint32_t generation_ = 0;
  std::uint64_t faults_before_ = 0, allocations_before_ = 0;  ///< the first tick's
};

}  // namespace isotouch::loop
