#include "firmware/guard/guard.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "firmware/guard/clearance.h"
#include "firmware/guard/to_double.h"
#include "shared/falcon_packet.h"

namespace isotouch::guard {

namespace {

using enum GuardVerdict;

// What a true command may differ by from what is computed here.
constexpr std::uint64_t kTicksToNotice = 3;                      // beyond the tick in which it should have been zero
constexpr std::int64_t kQuietNs = 100'000'000;                   // without a command until the guard believes the tick again
constexpr std::uint64_t kTicksToHear = 2;                        // after the one whose command was stopped: the first may have begun before
constexpr std::uint32_t kSteadyPackets = 4;                      // half as many as the tick waits for, which may miss one
constexpr std::uint32_t kReleaseTicks = 16;                      // twice as many as the tick waits for; it takes one packet at most in each
constexpr double kForceSlack = 0.1, kForcePart = 1.05;           // N; the arms a sample further
constexpr double kWaySlack = 0.5, kWayPart = 1.5;                // mm; a proxy that slides round an edge
constexpr double kStep = 0.2;                                    // mm: a hand that trembles less makes no way
constexpr double kFreeMargin = 0.5;                              // mm
constexpr double kLag = 4;                                       // of the hand's steps that a proxy may be behind
constexpr double kPullWay = 3, kPullSlack = 1, kPullPart = 0.5;  // mm; beyond this way an object may bend round the hand
constexpr double kRise = 4;                                      // voxels in a patch; the proxy keeps its place in front of 3
constexpr double kFollow = 0.075;                                // N a tick; the force follows by 0.05
constexpr std::uint64_t kRepeats = 5;
constexpr double kRepeatForce = 0.1;      // N: elsewhere the same commands are another force, which nobody asks for to the bit
constexpr std::int64_t kLongestGap = 16;  // ticks for which a hand's way is allowed to add up
constexpr double kSpeedPart = 1.5, kHeatPart = 1.2;
constexpr std::uint8_t kLights = kFalconGreen | kFalconBlue | kFalconRed;

/// How far the hand surely is from everything, mm; below 0: it may be inside.
double clear_way(const loop::Command& command, const Evidence& evidence, const Point& hip) {
  if (command.field_generation == 0) return std::numeric_limits<double>::infinity();
  const bool has_distances = evidence.field != nullptr && evidence.field->method != Method::kPublished;  // there the numbers are levels
  return has_distances ? clearance(*evidence.field, hip) : -std::numeric_limits<double>::infinity();
}

int largest(const MotorCommands& commands) { return std::max({std::abs(commands[0]), std::abs(commands[1]), std::abs(commands[2])}); }

int largest_change(const std::array<std::int16_t, 3>& from, const std::array<std::int16_t, 3>& to) {
  return std::max({std::abs(to[0] - from[0]), std::abs(to[1] - from[1]), std::abs(to[2] - from[2])});
}

/// Was it computed from this sample, or a later one?
bool knows(const loop::Command& command, std::uint64_t since) { return since != 0 && command.sample >= since; }

/// Either may have held.
double largest_stiffness(const Evidence& evidence) {
  return std::max(to_double(evidence.largest.stiffness), to_double(evidence.field->stiffness));
}

void be_free(Memory& memory) {
  memory.near = memory.moved = false;
  memory.risen = memory.may_rise = 0;
}

void mark(bool now, std::uint64_t sample, std::uint64_t& since) { since = !now ? 0 : since == 0 ? sample : since; }

}  // namespace

Guard::Guard(const DeviceModel& device, std::uint32_t period_ns) : device_(device), arms_(device), period_ns_(period_ns) {}

MotorCommands Guard::judge(const loop::Command& command, const Evidence& evidence, Memory& memory) const {
  const MotorCommands& asked = command.falcon.words;
  if (!is_zero(asked) || memory.quiet_ns == 0) memory.quiet_ns = evidence.now_ns;
  const bool heard = command.tick >= memory.verdict_tick + kTicksToHear;  // a pause of the tick is no answer
  if (memory.verdict != kNone && heard && evidence.now_ns - memory.quiet_ns > kQuietNs) memory.verdict = kNone;
  note(command, evidence, memory);
  place(command, evidence, memory);
  if (memory.verdict == kNone) {
    memory.verdict = contradiction(command, evidence, memory);
    memory.verdict_tick = command.tick;
  }

  memory.tick = command.tick;
  const bool passes = memory.verdict == kNone && evidence.lines == 0;
  memory.commands = passes ? asked : MotorCommands{};
  memory.sent_ns = evidence.now_ns;
  return memory.commands;
}

/// Since when there is what a command is judged by.
void Guard::note(const loop::Command& command, const Evidence& evidence, Memory& memory) const {
  const MotorCommands& asked = command.falcon.words;
  const std::uint64_t now = std::max<std::uint64_t>(command.tick, 1);  // before the first tick, too
  if (evidence.lines == 0) memory.lines_tick = 0;
  if (evidence.lines != 0 && memory.lines_tick == 0) memory.lines_tick = now;
  if (evidence.stops != memory.stops) memory.stop_tick = now;
  if (!evidence.stopped) memory.stop_tick = 0;
  memory.stops = evidence.stops;
  const std::uint64_t seen = command.sample >= memory.valid          ? memory.valid
                             : command.sample >= memory.valid_before ? memory.valid_before
                                                                     : 0;
  if (seen > memory.fresh) memory.fresh = seen, memory.fresh_tick = command.tick;
  if (asked != memory.commands || is_zero(asked)) memory.repeated_since = command.tick, memory.repeated_at = memory.grip;
  warm(evidence.now_ns, memory);
  if (memory.has_grip) follow_force(arms_.force(memory.commands, memory.grip), memory.encoders);
}

/// The first thing that this command must not be.
GuardVerdict Guard::contradiction(const loop::Command& command, const Evidence& evidence, const Memory& memory) const {
  const MotorCommands& asked = command.falcon.words;
  if (is_zero(asked)) return kNone;
  if (largest(asked) > device_.word_limit) return kLimit;
  if (memory.lines_tick != 0 && command.tick >= memory.lines_tick + kTicksToNotice) return kLine;
  if (memory.stop_tick != 0 && command.tick >= memory.stop_tick + kTicksToNotice) return kStopped;
  if ((command.falcon.flags & kLights) != (device_.led_active & kLights)) return kLight;
  if (!memory.referenced && command.sample >= memory.since.reference) return kReference;
  if (knows(command, memory.since.jump)) return kJump;
  if (command.tick > memory.fresh_tick + device_.hold_ticks) return kStale;
  if (knows(command, memory.since.button)) return kReleased;
  if (knows(command, memory.since.speed)) return kSpeed;
  if (knows(command, memory.since.pose)) return kPose;
  if (is_too_hot(memory)) return kHeat;
  if (is_stuck(memory.encoders)) return kStuck;
  if (const GuardVerdict found = of_contact(command, evidence, memory); found != kNone) return found;
  const bool repeats = memory.has_grip && command.tick >= memory.repeated_since + kRepeats;
  return repeats && length(arms_.force(asked, memory.grip) - arms_.force(asked, memory.repeated_at)) >
                        kRepeatForce + arms_.rounding(memory.grip)
             ? kRepeat
             : kNone;
}

/// Where the hand is in the field, once a sample.
void Guard::place(const loop::Command& command, const Evidence& evidence, Memory& memory) const {
  if (memory.field_generation != command.field_generation) {
    const bool moves = evidence.surface != 0 && evidence.surface == memory.surface;
    memory.field_generation = command.field_generation;
    memory.surface = evidence.surface;
    memory.placed = 0;
    if (moves) {
      memory.moved = true;
      memory.may_rise += kRise * to_double(evidence.field->edge) * largest_stiffness(evidence);
    } else {
      be_free(memory);
    }
  }
  const std::uint64_t ticks = std::min(command.tick - std::min(memory.tick, command.tick), std::uint64_t{kLongestGap});
  memory.risen = std::min(memory.risen + kFollow * static_cast<double>(ticks), memory.may_rise);
  if (!memory.has_grip || memory.placed == memory.replies) return;
  const Point& hip = memory.grip.at;
  const double clear = clear_way(command, evidence, hip);
  const bool free = clear > kFreeMargin + kLag * memory.step,
             felt = is_felt(arms_.force(command.falcon.words, memory.grip), evidence, memory);
  if (free && !felt) be_free(memory);
  if (!free && (!memory.near || (clear > 0 && !felt))) {  // it begins where the hand may be inside
    memory.near = true;
    memory.began = memory.last = hip;
    memory.outside = clear > 0;
    memory.way = memory.step;
  } else if (const double moved = length(hip - memory.last); memory.near && moved > kStep) {
    memory.way += moved;
    memory.last = hip;
  }
  mark(!memory.near, memory.replies, memory.since.free);
  memory.placed = memory.replies;
}

/// Is there more force than what holds the handle's weight?
bool Guard::is_felt(const Point& force, const Evidence& evidence, const Memory& memory) const {
  const double weight = std::abs(to_double(evidence.largest.weight));
  return length(force) > kForcePart * weight + kForceSlack + arms_.rounding(memory.grip);
}

GuardVerdict Guard::of_contact(const loop::Command& command, const Evidence& evidence, const Memory& memory) const {
  if (!memory.has_grip || command.tick == memory.tick) return kNone;
  const std::int64_t slew = static_cast<std::int64_t>(device_.word_slew) * period_ns_ / 1'000'000'000;
  const bool unseen = command.tick > memory.tick + 1;  // a tick's command that was never sent may have raised the force that fades now
  const std::int64_t step = unseen ? slew / 2 : slew;
  const bool at_slew = largest_change(memory.commands, command.falcon.words) + 1 >= step;
  const Point asked = arms_.force(command.falcon.words, memory.grip), before = arms_.force(memory.commands, memory.grip);
  // What is left of a force that falls, and cannot end at once, needs no reason; the rest does.
  const bool falls = at_slew && length(asked) < length(before);
  const double most_left = std::max(0.0, 1.0 - static_cast<double>(step - 1) / std::max(1, largest(memory.commands)));
  const double left = falls ? std::clamp(dot(asked, before) / dot(before, before), 0.0, most_left) : 0.0;
  const Point force = asked - Point{left * before[0], left * before[1], left * before[2]};
  const double strength = length(force);

  const TickSettings& most = evidence.largest;
  const double weight = std::abs(to_double(most.weight));
  const double damping = (2 * to_double(most.damping) + to_double(most.hand_damping) + to_double(most.passivity)) * memory.fastest;
  const double other = weight + damping + kForceSlack + arms_.rounding(memory.grip);  // all that is not the spring
  if (!memory.near) return knows(command, memory.since.free) && is_felt(force, evidence, memory) ? kFree : kNone;
  if (evidence.field == nullptr) return kNone;
  const double stiffness = largest_stiffness(evidence);
  const double way =
      std::min(kWayPart * (memory.way + length(memory.grip.at - memory.last)) + kWaySlack, to_double(device_.penetration_limit));
  const double spring = std::min(stiffness * way + memory.risen, to_double(most.force_limit));
  if (strength > kForcePart * (spring + other)) return kStrong;
  const Point back = memory.began - memory.grip.at;
  const double inwards =
      memory.outside && !memory.moved && memory.way < kPullWay && length(back) > kStep ? -dot(force, back) / length(back) : 0;
  return inwards > stiffness * kPullSlack + kPullPart * strength + other ? kPull : kNone;
}

/// A motor warms by the square of its command, and cools by itself.
void Guard::warm(std::int64_t now_ns, Memory& memory) const {
  if (device_.heat_word == 0 || memory.sent_ns == 0) return;
  const double passed = std::clamp(static_cast<double>(now_ns - memory.sent_ns), 0.0, 1e9);
  const double part = std::min(passed / (device_.heat_ms * 1e6), 1.0);
  for (std::size_t i = 0; i < memory.heat.size(); ++i) {
    memory.heat[i] += part * (static_cast<double>(memory.commands[i] * memory.commands[i]) - memory.heat[i]);
  }
}

bool Guard::is_too_hot(const Memory& memory) const {
  const double most = kHeatPart * device_.heat_word * device_.heat_word;
  return device_.heat_word != 0 && std::any_of(memory.heat.begin(), memory.heat.end(), [most](double heat) { return heat > most; });
}

void Guard::hear(const FalconPacket& packet, std::int64_t now_ns, Memory& memory) const {
  ++memory.replies;
  const Result<FalconReply> reply = decode_reply(packet);
  if (!reply) {
    memory.referenced_in_a_row = 0;
    memory.step = 0;
    return;
  }
  const bool first = memory.heard_ns == 0;
  const std::int64_t passed = std::max(
      {std::int64_t{1}, static_cast<std::int64_t>(memory.tick - memory.heard_tick), (now_ns - memory.heard_ns) / period_ns_});  // ticks
  const std::int64_t ticks = std::min(passed, kLongestGap) + 1;  // that the hand had, at most
  const int change = largest_change(memory.counts, reply->counts);
  const bool jumped = first || change > device_.count_jump * ticks;
  follow_buttons(reply->buttons, now_ns, memory);
  const bool all = reply->homed == 7;
  if (!all && (jumped || reply->counts == std::array<std::int16_t, 3>{} || change > device_.count_jump * ticks / 8)) {
    memory.referenced = false;
  }
  memory.referenced_in_a_row = all ? memory.referenced_in_a_row + 1 : 0;
  if (memory.referenced_in_a_row >= 2) memory.referenced = true;
  memory.since.jump = jumped ? memory.replies : 0;  // for this sample alone
  mark(!memory.referenced, memory.replies, memory.since.reference);
  mark(device_.hold_to_run != 0 && (reply->buttons & memory.may_hold & device_.buttons) == 0, memory.replies, memory.since.button);
  follow_counts(reply->counts, memory.referenced && !jumped, memory.encoders);
  memory.counts = reply->counts;
  memory.valid_before = memory.valid;
  memory.valid = memory.replies;
  memory.heard_ns = now_ns;
  memory.heard_tick = memory.tick;
  find_hand(*reply, static_cast<double>(passed) * period_ns_ * 1e-9, change > device_.count_jump, memory);
}

/// Before the packet counts as heard.
void Guard::follow_buttons(std::uint8_t shown, std::int64_t now_ns, Memory& memory) const {
  const auto ticks = static_cast<std::int64_t>(memory.tick - memory.heard_tick);
  const std::int64_t silent = std::min(now_ns - memory.heard_ns, ticks * period_ns_);  // a tick that stood still has forgotten nothing
  const std::int64_t on_its_way = (device_.hold_ticks + static_cast<std::int64_t>(kTicksToNotice)) * period_ns_;
  if (silent > device_.fault_age_ns + on_its_way) {  // what was held meanwhile, nobody knows, and neither does the tick
    memory.knows_buttons = false;
    memory.buttons = memory.may_hold = 0;
    memory.steady = memory.steady_ticks = 0;
  }
  const bool same = ((shown ^ memory.shown) & device_.buttons) == 0;
  memory.steady = same ? std::min(memory.steady + 1, kSteadyPackets) : 1;
  memory.steady_ticks = same ? std::min(memory.steady_ticks + (ticks != 0 ? 1U : 0U), kReleaseTicks) : 1;
  memory.shown = shown;
  if (memory.steady < kSteadyPackets) return;
  if (memory.knows_buttons && (shown & ~memory.buttons & device_.buttons) != 0) memory.stop_tick = 0;  // pressed anew: it resumes
  memory.knows_buttons = true;
  memory.buttons = shown;
  memory.may_hold = memory.steady_ticks == kReleaseTicks ? shown : memory.may_hold | shown;
}

void Guard::find_hand(const FalconReply& reply, double took_s, bool leapt, Memory& memory) const {
  const bool knew = memory.has_grip && !leapt;  // no hand leaps
  const Point before = memory.grip.at;
  memory.has_grip = memory.referenced && arms_.find(reply.counts, before, memory.grip);
  mark(memory.referenced && !memory.has_grip, memory.replies, memory.since.pose);
  const Point& at = memory.grip.at;
  memory.step = memory.has_grip && knew ? length(at - before) : 0;
  if (!knew) memory.repeated_since = memory.tick, memory.repeated_at = memory.grip;  // no movement that a command should have followed
  memory.fastest = std::max(memory.step / took_s, memory.fastest * 0.95);

  const auto oldest = static_cast<std::size_t>(memory.replies % memory.places.size());
  if (!knew) memory.places.fill(at);
  const double way = length(at - memory.places[oldest]);
  memory.places[oldest] = at;
  memory.took[oldest] = took_s;
  double time = 0;
  for (const double took : memory.took) time += took;
  const double fast = kSpeedPart * to_double(device_.speed_limit);  // a count that was wrong once is no movement
  mark(way > fast * time && memory.step > fast * took_s, memory.replies, memory.since.speed);
}

}  // namespace isotouch::guard
