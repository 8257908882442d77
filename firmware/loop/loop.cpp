#include "firmware/loop/loop.h"

#include <algorithm>
#include <limits>

#include "firmware/loop/realtime.h"

namespace isotouch::loop {

namespace {

/// As the histograms clamp it.
std::uint32_t short_ns(std::int64_t ns) { return static_cast<std::uint32_t>(std::clamp<std::int64_t>(ns, 0, UINT32_MAX)); }

}  // namespace

Loop::Loop(const LoopSettings& settings, Device& device, Clock& clock, const Neighbours& neighbours)
    : settings_(settings),
      model_(core::make_tick_model(settings.device, settings.tick, settings.period_ns)),
      spare_(model_),
      device_(device),
      clock_(clock),
      neighbours_(neighbours),
      faults_(settings.faults),
      pace_(settings.period_ns, clock.now_ns()),
      suspended_(clock.suspended_ns()) {
  state_.heat = core::heat_from(settings.heat);
  model_seal_.close(model_);
  state_seal_.close(state_);
  view_seal_.close(view_);
}

bool Loop::step() {
  pace_.stay_near(clock_.now_ns());
  const Wake wake = device_.wait(settings_.lockstep ? kNever : pace_.due_ns());
  if (wake == Wake::kEnd) return false;
  pace_.stay_near(clock_.now_ns());
  const bool replied = wake == Wake::kReply;
  Sample sample = device_.newest();
  const std::int64_t arrival = sample.arrival_ns;
  const std::int64_t wanted = settings_.lockstep ? clock_.now_ns() : replied ? pace_.start_ns(arrival) : pace_.due_ns();
  if (wanted > clock_.now_ns()) {
    clock_.sleep_until_ns(wanted);
    sample = device_.newest();
  }
  const std::int64_t start = clock_.now_ns();
  const std::uint32_t missed = settings_.lockstep ? 0 : pace_.begin(replied ? arrival : Pace::kNoReply, start) + slept_periods();

  TickRecord record;
  record.number = ++ticks_;
  record.start_ns = start;
  record.arrival_ns = sample.arrival_ns;
  record.in = look(sample, missed);
  const std::uint32_t generation_before = generation_;
  const ActiveField field = take_field();
  const Damage damage = this->damage();
  if (damage != Damage::kNone) found_.store(damage, std::memory_order_relaxed);
  hear(field.generation != generation_before ? field : ActiveField{}, generation_before, damage == Damage::kState, record.in);
  record.in.lines = neighbours_.lines != nullptr ? neighbours_.lines->get() : std::uint8_t{0};
  if (damage != Damage::kNone) record.in.lines |= kLineMemory;
  record.in.field_generation = field.generation;
  record.out = core::tick(record.in, field.view, damage == Damage::kPrepared ? spare_ : model_, state_);
  device_.leave({{record.out.commands, record.out.packet_flags},
                 record.number,
                 sample.number,
                 sample.number == 0 ? -1 : sample.arrival_ns,
                 field.generation});
  state_seal_.close(state_);

  // Only a person ends a fault; a restart in one begins with a stop and would leave no other name of it.
  const bool in_fault = record.out.state == static_cast<std::uint16_t>(SupervisorState::kFault);
  record.faults = in_fault ? static_cast<std::uint16_t>(faults() | record.out.faults) : std::uint16_t{0};
  faults_.store(record.faults, std::memory_order_relaxed);
  if (neighbours_.lines != nullptr) neighbours_.lines->tell(record.out.state);
  record.wake_ns = short_ns(start - wanted);
  record.tick_ns = short_ns(clock_.now_ns() - start);
  TickStats& stats = neighbours_.stats;
  stats.tick_time.add(record.tick_ns);
  stats.wake_delay.add(record.wake_ns);
  stats.ticks.add();
  stats.by_reply.add(replied && wanted == arrival ? 1 : 0);
  stats.late.add(missed > 0 ? 1 : 0);
  stats.missed.add(missed);
  neighbours_.trace.push(record);
  neighbours_.shown.put(record);
  count_own_costs();
  if (field.view != nullptr) field_is_whole_ = field_is_whole_ && felt_.are_whole(view_, *field.sums, state_.render.proxy.point);
  return true;
}

void Loop::run(const std::atomic<bool>& stop, std::uint64_t most) {
  pace_ = Pace(settings_.period_ns, clock_.now_ns());  // what was before the first tick made nothing late
  suspended_ = std::max(suspended_, clock_.suspended_ns());
  while (ticks_ < most && !stop.load(std::memory_order_relaxed) && step()) {
  }
}

/// The field of this tick, by the loop's own view of it.
ActiveField Loop::take_field() {
  ActiveField field = neighbours_.fields.field();
  if (field.generation != generation_) {
    neighbours_.stats.field_swaps.add();
    generation_ = field.generation;
    view_ = field.view != nullptr ? *field.view : FieldView{};
    view_seal_.close(view_);
    field_is_whole_ = true;
    felt_.forget();
  }
  if (field.view != nullptr) field.view = &view_;
  return field;
}

/// What has changed since the last tick.
Damage Loop::damage() const {
  if (!model_seal_.holds(model_)) return Damage::kPrepared;
  if (!state_seal_.holds(state_)) return Damage::kState;
  return view_seal_.holds(view_) && field_is_whole_ ? Damage::kNone : Damage::kField;
}

/// What people want of this tick. A restart is no way out of a fault, nor out of a pause that is one: there it comes with a stop. A tick has one author: a
/// change waits for the next tick where somebody asks for something else.
///
/// taken         the field, where this tick takes one over. A patched one is the same surface, unless the tick forgets what it felt or has left out a patch
/// before        the generation of the tick before
/// begins_anew   the state is damaged: the tick is told by its lines, and nobody knows what state it was
void Loop::hear(const ActiveField& taken, std::uint32_t before, bool begins_anew, Input& in) {
  const Asked asked = neighbours_.requests.take();
  in.requests |= asked.bits;
  in.author = asked.author != kNobody ? asked.author : taken.author;
  if (begins_anew) {
    in.requests |= kRequestRestart;
  } else if ((asked.bits & kRequestRestart) != 0) {
    const bool gave_force = state_.supervisor.state == SupervisorState::kActive || state_.supervisor.state == SupervisorState::kHold;
    const bool paused = (in.requests & kRequestPaused) != 0 && gave_force;
    if (core::is_in_fault(state_.supervisor) || paused) in.requests |= kRequestStop;
    in.heat = core::heat_input(state_.heat);
  }
  if ((in.requests & kRequestRestart) != 0) {
    neighbours_.requests.repeat_changes();
  } else if (taken.patched_from != 0 && taken.patched_from == before) {
    in.requests |= kRequestMoved;
    in.moved_to = static_cast<std::uint32_t>(taken.hash);
  } else if (in.author == kNobody) {
    const AskedChange set = neighbours_.requests.take_change();
    in.change = set.change;
    in.author = set.author;
  }
}

/// What the device has sent for this tick, and how old it is.
Input Loop::look(const Sample& sample, std::uint32_t missed) {
  TickStats& stats = neighbours_.stats;
  Input in;
  in.packet = sample.packet;
  in.fresh = sample.number != seen_;
  if (in.fresh) {
    stats.samples_lost.add(sample.number - seen_ - 1);
    stats.round_trip.add(sample.arrival_ns - sample.sent_ns);
    if (sample.word_delay_ns >= 0) stats.word_delay.add(sample.word_delay_ns);
    age_ = 0;
  } else {
    age_ = std::min<std::uint32_t>(age_ + 1 + std::min(missed, 0xFFFFU), 0xFFFF);
  }
  (in.fresh ? stats.fresh : stats.stale).add();
  seen_ = sample.number;
  in.age = static_cast<std::uint16_t>(age_);
  in.late = static_cast<std::uint8_t>(std::min<std::uint32_t>(missed, kMaxLate));
  if (is_too_long(missed)) in.requests = kRequestPaused;
  if (seen_ != 0 && age_ > stats.largest_age.value()) stats.largest_age.set(age_);
  return in;
}

/// Whole periods that the machine has slept since the tick before: the clock of the ticks stood still, the hand did not.
std::uint32_t Loop::slept_periods() {
  const std::int64_t before = suspended_;
  suspended_ = std::max(before, clock_.suspended_ns());
  return static_cast<std::uint32_t>(std::min<std::int64_t>((suspended_ - before) / settings_.period_ns, Pace::kMax));
}

/// Is it longer than a hold may last, what was left out before this tick, or a hold with all that was left out in it? Of a long pause the supervisor knows
/// kMaxLate periods.
bool Loop::is_too_long(std::uint32_t missed) {
  const std::uint64_t most = settings_.device.fault_age_ns / settings_.period_ns;
  const bool holds = state_.supervisor.state == SupervisorState::kHold;
  const std::uint32_t told = std::min<std::uint32_t>(missed, kMaxLate);
  untold_ = (holds ? untold_ : 0) + (missed - told);
  return missed > most || (untold_ > 0 && (holds ? state_.supervisor.held_ticks : 0) + told + untold_ > most);
}

/// Page faults and allocations of this thread since its first tick. The system is asked rarely; the question does not block.
void Loop::count_own_costs() {
  if (ticks_ == 1) {
    faults_before_ = page_faults_of_thread();
    allocations_before_ = allocations_of_thread;
  } else if (ticks_ % kFaultsEvery == 0) {
    neighbours_.stats.page_faults.set(page_faults_of_thread() - faults_before_);
  }
  neighbours_.stats.allocations.set(allocations_of_thread - allocations_before_);
}

}  // namespace isotouch::loop
