#include "firmware/core/supervisor.h"

#include <gtest/gtest.h>

namespace isotouch::core {
namespace {

using S = SupervisorState;

constexpr std::uint32_t kHold = 3, kFault = 100;  // ticks

Supervision limits(bool hold_to_run = false) {
  DeviceModel device = libnifalcon_model();
  device.ramp_ticks = 7;
  device.hold_to_run = hold_to_run ? 1 : 0;
  return make_supervision(device, 1'000'000);
}

Observations well() {
  Observations seen;
  seen.heard = seen.homed = seen.pose_settled = seen.has_field = true;
  return seen;
}

/// One tick from a state: where it leads.
S after(S from, const Observations& seen) {
  SupervisorMemory memory;
  memory.state = from;
  const Permission permission = supervise(seen, limits(), memory);
  EXPECT_EQ(permission.granted, memory.state == S::kActive);
  return memory.state;
}

/// Goes through everything that a tick can find and remember; every limit with both its edges. Reports the first that breaks a property.
struct Exhaustive {
  std::uint64_t steps = 0, active = 0, resumed = 0;
  const char* broken = nullptr;

  void check(const Observations& seen, const Supervision& with, const SupervisorMemory& before) {
    SupervisorMemory memory = before;
    const Permission permission = supervise(seen, with, memory);
    ++steps;
    const bool is_active = memory.state == S::kActive;
    active += is_active ? 1 : 0;
    const bool fresh =
        seen.heard && seen.stale_ticks == 0 && ((seen.buttons ^ before.shown) & with.buttons) == 0 && before.steady + 1 >= kSteadyPackets;
    const bool pressed = fresh && before.knows_buttons != 0 && (seen.buttons & ~before.buttons & with.buttons) != 0;
    const bool asked = (seen.requests & kRequestResume) != 0 || pressed;
    const auto demand = [&](bool holds, const char* property) {
      if (!holds && broken == nullptr) broken = property;
    };
    demand(permission.granted == is_active, "words in active alone");
    demand(is_active || (permission.part == ForcePart{} && !permission.ramping), "no part of a force elsewhere");
    demand(memory.state <= S::kFault, "a state of the table");
    demand((memory.faults != 0) == (memory.state == S::kFault), "a fault has a reason, and nothing else has");
    if (before.state == S::kFault && memory.state != S::kFault) {
      ++resumed;
      demand(asked && memory.state == S::kIdle, "only a person leads out of fault, and not to forces");
    }
    const bool cause = (seen.requests & kRequestStop) != 0 || seen.lines != 0 || (seen.heard && seen.stale_ticks > kFault);
    demand(!cause || memory.state == S::kFault, "a cause of fault is one from everywhere");
    const bool forces = before.state == S::kActive || before.state == S::kHold;
    demand(!(forces && seen.jumped && seen.homed) || memory.state == S::kFault, "a jump under forces is a fault");
    demand(!(before.state == S::kActive && seen.too_deep) || memory.state == S::kFault, "a hand too deep is a fault");
    const bool late = before.lateness + seen.late * kLatenessOfAPeriod >= kHold * kLatenessOfAPeriod;
    const bool doubt = seen.stale_ticks >= kHold || late || !seen.pose_settled || seen.too_fast;
    const bool let_go = with.hold_to_run && (memory.knows_buttons == 0 || (seen.buttons & memory.buttons & with.buttons) == 0);
    demand(!is_active || !(doubt || cause || let_go || !seen.heard || !seen.homed || !seen.has_field), "forces only when all is well");
    demand(!(before.state == S::kHold && doubt && before.held_ticks >= kFault) || seen.stale_ticks >= kHold || memory.state == S::kFault ||
               !seen.heard || !seen.homed,
           "a hold does not last");
    demand(!(is_active && seen.new_field) || permission.part == ForcePart{}, "another field begins without force");
  }
};

TEST(Supervisor, WhateverItFindsAndRemembersItsPromisesHold) {
  Exhaustive all;
  for (std::uint32_t bits = 0; bits < 256; ++bits) {
    Observations seen;
    seen.heard = (bits & 1) != 0, seen.homed = (bits & 2) != 0, seen.jumped = (bits & 4) != 0, seen.pose_settled = (bits & 8) != 0;
    seen.has_field = (bits & 16) != 0, seen.new_field = (bits & 32) != 0, seen.too_deep = (bits & 64) != 0,
    seen.too_fast = (bits & 128) != 0;
    for (const std::uint32_t stale : {0U, kHold - 1, kHold, kFault, kFault + 1}) {
      for (const std::uint32_t late : {0U, 2U, 3U, 31U}) {
        for (std::uint32_t outside = 0; outside < 32; ++outside) {  // lines, stop, resume, a button
          seen.stale_ticks = stale;
          seen.late = late;
          seen.lines = static_cast<std::uint8_t>(outside & 3);
          seen.requests = static_cast<std::uint8_t>((outside >> 2) & 3);
          seen.buttons = static_cast<std::uint8_t>(outside >> 4);
          for (std::uint32_t memory = 0; memory < 7 * 32; ++memory) {
            SupervisorMemory before;
            before.state = static_cast<S>(memory / 32);
            before.faults = before.state == S::kFault ? std::uint16_t{kFaultStopped} : std::uint16_t{0};
            before.ramp = (memory & 1) != 0 ? 7 : 0;
            before.buttons = (memory & 2) != 0 ? 0xFF : 0;
            before.knows_buttons = (memory & 6) != 0 ? 1 : 0;
            before.shown = 1;
            before.steady = (memory & 1) != 0 ? kSteadyPackets - 1 : kSteadyPackets - 2;
            before.held_ticks = (memory & 4) != 0 ? kFault : 0;
            before.lateness = (memory & 8) != 0 ? kHold * kLatenessOfAPeriod - 1 : 0;
            static const Supervision kBoth[] = {limits(false), limits(true)};
            all.check(seen, kBoth[(memory & 16) != 0 ? 1 : 0], before);
          }
        }
      }
    }
  }
  EXPECT_EQ(all.broken, nullptr) << all.broken;
  EXPECT_EQ(all.steps, 256U * 5 * 4 * 32 * 7 * 32);
  EXPECT_GT(all.active, 1000U);
  EXPECT_GT(all.resumed, 1000U);
}

TEST(Supervisor, EveryStateLeadsWhereTheTableSays) {
  Observations unheard, unhomed = well(), uncertain = well(), stale = well(), no_field = well(), stopped = well();
  unhomed.homed = unhomed.pose_settled = false;
  uncertain.pose_settled = false;
  stale.stale_ticks = kHold;
  no_field.has_field = false;
  stopped.requests = kRequestStop;
  for (const S from : {S::kBoot, S::kHoming, S::kIdle, S::kReady, S::kActive, S::kHold, S::kFault}) {
    EXPECT_EQ(after(from, stopped), next_state(from, Finding::kFaulty));
    EXPECT_EQ(after(from, unheard), next_state(from, Finding::kUnheard));
    EXPECT_EQ(after(from, unhomed), next_state(from, Finding::kUnhomed));
    EXPECT_EQ(after(from, uncertain), next_state(from, Finding::kUncertain));
    EXPECT_EQ(after(from, stale), next_state(from, Finding::kUncertain));
    EXPECT_EQ(after(from, no_field), next_state(from, Finding::kNoField));
    EXPECT_EQ(after(from, well()), next_state(from, Finding::kWell));
  }
}

TEST(Supervisor, EachConditionHasItsOwnFault) {
  const auto fault_of = [](auto change) {
    SupervisorMemory memory;
    memory.state = S::kActive;
    Observations seen = well();
    change(seen);
    supervise(seen, limits(), memory);
    return memory.faults;
  };
  EXPECT_EQ(fault_of([](Observations& o) { o.requests = kRequestStop; }), kFaultStopped);
  EXPECT_EQ(fault_of([](Observations& o) { o.stale_ticks = kFault + 1; }), kFaultSilent);
  EXPECT_EQ(fault_of([](Observations& o) { o.too_deep = true; }), kFaultPenetration);
  EXPECT_EQ(fault_of([](Observations& o) { o.jumped = true; }), kFaultEncoders);
  EXPECT_EQ(fault_of([](Observations& o) { o.lines = kLineStop; }), kFaultEmergency);
  EXPECT_EQ(fault_of([](Observations& o) { o.lines = kLineEnableWrong; }), kFaultEnable);
  EXPECT_EQ(fault_of([](Observations& o) { o.requests = kRequestPaused; }), kFaultLate);
  EXPECT_EQ(fault_of([](Observations& o) { o.jumped = o.homed = false; }), 0);
  EXPECT_EQ(fault_of([](Observations& o) { o.jumped = true, o.homed = false; }), 0) << "homing begins again, by itself";
}

TEST(Supervisor, AMemoryThatContradictsItselfIsAFault) {
  SupervisorMemory fault_without_reason, reason_without_fault;
  fault_without_reason.state = S::kFault;
  reason_without_fault.state = S::kActive;
  reason_without_fault.faults = kFaultStopped;
  for (SupervisorMemory memory : {fault_without_reason, reason_without_fault}) {
    Observations seen = well();
    seen.requests = kRequestResume;
    EXPECT_TRUE(is_in_fault(memory));
    EXPECT_FALSE(supervise(seen, limits(), memory).granted);
    EXPECT_EQ(memory.state, S::kFault);
    EXPECT_TRUE(memory.faults & kFaultMemory) << "and nobody resumes in the same tick";
    EXPECT_FALSE(supervise(seen, limits(), memory).granted);
    EXPECT_EQ(memory.state, S::kIdle) << "a person resumes";
  }
}

TEST(Supervisor, AHoldThatLastsIsAFaultOfItsReason) {
  const auto fault_of = [](auto change, std::uint32_t ticks, std::uint32_t most = kFault) {
    SupervisorMemory memory;
    memory.state = S::kActive;
    Observations seen = well();
    change(seen);
    for (std::uint32_t t = 0; t < ticks; ++t) {
      EXPECT_FALSE(supervise(seen, limits(), memory).granted);
      EXPECT_EQ(memory.state, t < most ? S::kHold : S::kFault);
    }
    return memory.faults;
  };
  EXPECT_EQ(fault_of([](Observations& o) { o.pose_settled = false; }, kFault), 0);
  EXPECT_EQ(fault_of([](Observations& o) { o.pose_settled = false; }, kFault + 1), kFaultPose);
  EXPECT_EQ(fault_of([](Observations& o) { o.too_fast = true; }, kFault + 1), kFaultSpeed);
  constexpr std::uint32_t kLateTicks = kFault / (kHold + 1);  // each with those that were left out before it
  EXPECT_EQ(fault_of([](Observations& o) { o.late = kHold; }, kLateTicks + 1, kLateTicks), kFaultLate);
}

TEST(Supervisor, AFaultStaysUntilItsCauseIsGoneAndItIsResumed) {
  SupervisorMemory memory;
  memory.state = S::kActive;
  Observations seen = well();
  seen.too_deep = true;
  supervise(seen, limits(), memory);
  EXPECT_EQ(memory.faults, kFaultPenetration);
  seen.stale_ticks = kFault + 1;
  supervise(seen, limits(), memory);
  EXPECT_EQ(memory.faults, kFaultPenetration | kFaultSilent);
  seen.requests = kRequestResume;
  supervise(seen, limits(), memory);
  EXPECT_EQ(memory.state, S::kFault);
  seen = well();
  supervise(seen, limits(), memory);
  EXPECT_EQ(memory.state, S::kFault);
  seen.requests = kRequestStop | kRequestResume;
  supervise(seen, limits(), memory);
  EXPECT_EQ(memory.state, S::kFault) << "stop outweighs resume";
  seen.requests = kRequestResume;
  supervise(seen, limits(), memory);
  EXPECT_EQ(memory.state, S::kIdle);
  EXPECT_EQ(memory.faults, 0);
}

/// So many valid packets show these buttons.
void show(std::uint8_t buttons, int packets, SupervisorMemory& memory, const Supervision& with = limits()) {
  Observations seen = well();
  seen.buttons = buttons;
  for (int n = 0; n < packets; ++n) supervise(seen, with, memory);
}

TEST(Supervisor, AButtonResumesWhenItIsPressedAnew) {
  SupervisorMemory memory;
  memory.state = S::kFault;
  memory.faults = kFaultStopped;
  show(2, 100, memory);
  EXPECT_EQ(memory.state, S::kFault) << "held before anything was known: it may be stuck";
  show(0, kSteadyPackets, memory);
  show(2, kSteadyPackets - 1, memory);
  EXPECT_EQ(memory.state, S::kFault) << "not long enough for a hand";
  show(2, 1, memory);
  EXPECT_EQ(memory.state, S::kIdle);

  memory.state = S::kFault;
  memory.faults = kFaultStopped;
  show(2, 100, memory);
  EXPECT_EQ(memory.state, S::kFault) << "still held";
  Supervision other = limits();
  other.buttons = 8;
  show(3, 100, memory, other);
  EXPECT_EQ(memory.state, S::kFault) << "not one of those that count";
}

TEST(Supervisor, APacketWithAWrongBitResumesNothing) {
  for (const std::uint8_t held : {std::uint8_t{0}, std::uint8_t{2}}) {
    SupervisorMemory memory;
    memory.state = S::kFault;
    memory.faults = kFaultStopped;
    show(held, 100, memory);
    for (int n = 0; n < 100; ++n) {
      show(static_cast<std::uint8_t>(held ^ 2), 1 + n % (kSteadyPackets - 1), memory);
      show(held, 1 + n % 20, memory);
    }
    EXPECT_EQ(memory.state, S::kFault) << int{held};
  }
}

TEST(Supervisor, AButtonThatDoesNotCountHidesNone) {
  Supervision with = limits(true);
  with.buttons = 2;
  SupervisorMemory memory;
  const auto flicker = [&](int buttons) {
    for (int n = 0; n < kSteadyPackets; ++n) show(static_cast<std::uint8_t>(buttons | n % 2), 1, memory, with);
  };
  flicker(2);
  flicker(2);
  EXPECT_EQ(memory.state, S::kActive) << "it is held";
  flicker(0);
  show(2, 1, memory, with);
  EXPECT_EQ(memory.state, S::kReady) << "it was let go";
  memory.state = S::kFault;
  memory.faults = kFaultStopped;
  flicker(0);
  flicker(2);
  EXPECT_EQ(memory.state, S::kIdle) << "it was pressed anew";
}

TEST(Supervisor, AButtonThatIsStuckWhenTheDeviceComesBackResumesNothing) {
  SupervisorMemory memory;
  show(0, 100, memory);
  Observations seen = well();
  for (seen.stale_ticks = 1; seen.stale_ticks <= kFault + 1; ++seen.stale_ticks) supervise(seen, limits(), memory);
  ASSERT_EQ(memory.state, S::kFault);
  show(2, 100, memory);
  EXPECT_EQ(memory.state, S::kFault);
  show(0, kSteadyPackets, memory);
  show(2, kSteadyPackets, memory);
  EXPECT_EQ(memory.state, S::kIdle);
}

TEST(Supervisor, APacketThatComesNoMoreIsNoSteadyHand) {
  SupervisorMemory memory;
  memory.state = S::kFault;
  memory.faults = kFaultStopped;
  show(0, 100, memory);
  Observations seen = well();
  seen.buttons = 2;
  for (seen.stale_ticks = 0; seen.stale_ticks < 50; ++seen.stale_ticks) supervise(seen, limits(), memory);
  EXPECT_EQ(memory.state, S::kFault);
}

TEST(Supervisor, WhereAButtonMustBeHeldForcesLastAsLongAsItIs) {
  SupervisorMemory memory;
  memory.state = S::kReady;
  Observations seen = well();
  for (int t = 0; t < 10; ++t) EXPECT_FALSE(supervise(seen, limits(true), memory).granted);
  seen.buttons = 1;
  for (int t = 1; t < kSteadyPackets; ++t) EXPECT_FALSE(supervise(seen, limits(true), memory).granted) << "it may be a wrong bit";
  EXPECT_TRUE(supervise(seen, limits(true), memory).granted);
  EXPECT_TRUE(supervise(seen, limits(true), memory).ramping);
  seen.buttons = 0;
  EXPECT_FALSE(supervise(seen, limits(true), memory).granted);
  EXPECT_EQ(memory.state, S::kReady);
}

TEST(Supervisor, WhereAButtonMustBeHeldAPacketWithAWrongBitHoldsNone) {
  SupervisorMemory memory;
  const Supervision with = limits(true);
  Observations seen = well();
  const auto tick = [&](std::uint8_t buttons) {
    seen.buttons = buttons;
    return supervise(seen, with, memory).granted;
  };
  for (int t = 0; t < 4; ++t) EXPECT_FALSE(tick(0));
  EXPECT_FALSE(tick(1)) << "nobody knows yet what is held";
  for (int t = 0; t < 400; ++t) EXPECT_FALSE(tick(static_cast<std::uint8_t>(t % 4)));
  show(1, kSteadyPackets, memory, with);
  ASSERT_EQ(memory.state, S::kActive);

  for (seen.stale_ticks = 1; seen.stale_ticks <= kFault + 1; ++seen.stale_ticks) EXPECT_FALSE(seen.stale_ticks > kHold && tick(1));
  memory.state = S::kReady;
  memory.faults = 0;
  seen = well();
  EXPECT_FALSE(tick(1)) << "nor after a silence";
}

TEST(Supervisor, LateTicksHoldWhenThreePeriodsAreLeftOutAtOnceOrNearlySo) {
  const auto state_after = [](std::initializer_list<std::uint32_t> lates) {
    SupervisorMemory memory;
    memory.state = S::kActive;
    for (const std::uint32_t late : lates) {
      Observations seen = well();
      seen.late = late;
      supervise(seen, limits(), memory);
    }
    return memory.state;
  };
  EXPECT_EQ(state_after({2}), S::kActive);
  EXPECT_EQ(state_after({3}), S::kHold);
  EXPECT_EQ(state_after({3, 0}), S::kActive) << "leaves by itself";
  EXPECT_EQ(state_after({1, 1, 1}), S::kActive);
  EXPECT_EQ(state_after({1, 1, 1, 1}), S::kHold);
  EXPECT_EQ(state_after({2, 0, 0, 0, 0, 0, 0, 1}), S::kActive);
  EXPECT_EQ(state_after({31, 0, 0, 0, 0, 0, 0}), S::kHold) << "after a long pause not at once";
  EXPECT_EQ(state_after({31, 31, 31}), S::kHold);
  EXPECT_EQ(state_after({31, 31, 31, 31, 31}), S::kFault) << "what is left out is held, too";
}

TEST(Supervisor, TheRampRisesEvenlyToOneAndBeginsAgainAfterRest) {
  SupervisorMemory memory;
  memory.state = S::kReady;
  for (int round = 0; round < 2; ++round) {
    for (int t = 1; t <= 20; ++t) {
      const Permission permission = supervise(well(), limits(), memory);
      EXPECT_EQ(permission.ramping, t <= 7);
      EXPECT_NEAR(permission.part.raw() / 1073741824.0, t >= 7 ? 1 : t / 7.0, 1e-8);
    }
    Observations other = well();
    if (round == 0) other.new_field = true;
    if (round == 1) other.stale_ticks = 5;
    EXPECT_EQ(supervise(other, limits(), memory).part, ForcePart{});
  }
}

TEST(Supervisor, DepthBeforeThereIsAForceIsNoFault) {
  Observations seen = well();
  seen.too_deep = true;
  EXPECT_EQ(after(S::kReady, seen), S::kActive);
  EXPECT_EQ(after(S::kHold, seen), S::kActive);
  EXPECT_EQ(after(S::kActive, seen), S::kFault);
}

TEST(Supervisor, TheFaultAgeIsCountedInTicks) {
  EXPECT_EQ(make_supervision(libnifalcon_model(), 250'000).fault_ticks, 400U);
  EXPECT_EQ(make_supervision(libnifalcon_model(), 4'000'000).fault_ticks, 25U);
}

}  // namespace
}  // namespace isotouch::core
