#include "firmware/core/supervisor.h"

#include <gtest/gtest.h>

namespace isotouch::core {
namespace {

using S = SupervisorState;

Supervision limits() {
  DeviceModel device = libnifalcon_model();
  device.ramp_ticks = 7;
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

TEST(Supervisor, EveryStateLeadsWhereTheTableSays) {
  Observations unheard, unhomed = well(), uncertain = well(), stale = well(), no_field = well(), stopped = well();
  unhomed.homed = unhomed.pose_settled = false;
  uncertain.pose_settled = false;
  stale.stale_ticks = 3;
  no_field.has_field = false;
  stopped.commands = kCommandStop;
  const S all[] = {S::kBoot, S::kHoming, S::kIdle, S::kReady, S::kActive, S::kHold, S::kFault};
  const S on_unhomed[] = {S::kHoming, S::kHoming, S::kHoming, S::kHoming, S::kHoming, S::kHoming, S::kFault};
  const S on_uncertain[] = {S::kHoming, S::kHoming, S::kIdle, S::kIdle, S::kHold, S::kHold, S::kFault};
  const S on_no_field[] = {S::kHoming, S::kIdle, S::kIdle, S::kIdle, S::kIdle, S::kIdle, S::kFault};
  const S on_well[] = {S::kHoming, S::kIdle, S::kReady, S::kActive, S::kActive, S::kActive, S::kFault};
  for (int i = 0; i < 7; ++i) {
    EXPECT_EQ(after(all[i], stopped), S::kFault);
    EXPECT_EQ(after(all[i], unheard), all[i] == S::kFault ? S::kFault : S::kBoot);
    EXPECT_EQ(after(all[i], unhomed), on_unhomed[i]);
    EXPECT_EQ(after(all[i], uncertain), on_uncertain[i]);
    EXPECT_EQ(after(all[i], stale), on_uncertain[i]);
    EXPECT_EQ(after(all[i], no_field), on_no_field[i]);
    EXPECT_EQ(after(all[i], well()), on_well[i]);
  }
}

TEST(Supervisor, AFaultStaysUntilItsCauseIsGoneAndItIsResumed) {
  SupervisorMemory memory;
  memory.state = S::kActive;
  Observations seen = well();
  seen.too_deep = true;
  supervise(seen, limits(), memory);
  EXPECT_EQ(memory.faults, kFaultPenetration);
  seen.stale_ticks = 101;
  supervise(seen, limits(), memory);
  EXPECT_EQ(memory.faults, kFaultPenetration | kFaultSilent);
  seen.commands = kCommandResume;
  supervise(seen, limits(), memory);
  EXPECT_EQ(memory.state, S::kFault);
  seen = well();
  supervise(seen, limits(), memory);
  EXPECT_EQ(memory.state, S::kFault);
  seen.commands = kCommandStop | kCommandResume;
  supervise(seen, limits(), memory);
  EXPECT_EQ(memory.state, S::kFault) << "stop outweighs resume";
  seen.commands = kCommandResume;
  supervise(seen, limits(), memory);
  EXPECT_EQ(memory.state, S::kReady);
  EXPECT_EQ(memory.faults, 0);
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
