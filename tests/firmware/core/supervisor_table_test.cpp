/// A model check: every entry of the table, walked.
#include "firmware/core/supervisor_table.h"

#include <gtest/gtest.h>

#include <initializer_list>
#include <set>

namespace isotouch::core {
namespace {

using S = SupervisorState;

constexpr S kAll[] = {S::kBoot, S::kHoming, S::kIdle, S::kReady, S::kActive, S::kHold, S::kFault};

Finding finding(std::size_t i) { return static_cast<Finding>(i); }

/// Where one can come from a state by any row of findings but these.
std::set<S> reachable(S from, std::initializer_list<Finding> without = {}) {
  std::set<S> seen = {from}, edge = {from};
  while (!edge.empty()) {
    std::set<S> next;
    for (const S state : edge) {
      for (std::size_t f = 0; f < kFindings; ++f) {
        bool allowed = true;
        for (const Finding none : without) allowed &= finding(f) != none;
        if (allowed && seen.insert(next_state(state, finding(f))).second) next.insert(next_state(state, finding(f)));
      }
    }
    edge = next;
  }
  return seen;
}

TEST(SupervisorTable, EveryStateIsReachedFromTheFirst) { EXPECT_EQ(reachable(S::kBoot), std::set<S>(std::begin(kAll), std::end(kAll))); }

TEST(SupervisorTable, NothingButAPersonLeadsOutOfFault) {
  EXPECT_EQ(reachable(S::kFault, {Finding::kResumed}), std::set<S>{S::kFault});
  EXPECT_EQ(next_state(S::kFault, Finding::kResumed), S::kIdle) << "and then not at once to forces";
  for (const S state : kAll) {
    EXPECT_EQ(next_state(state, Finding::kResumed), state == S::kFault ? S::kIdle : S::kFault)
        << "elsewhere it cannot happen, so it is safe";
  }
}

TEST(SupervisorTable, AFaultComesFromEveryStateAtOnce) {
  for (const S state : kAll) EXPECT_EQ(next_state(state, Finding::kFaulty), S::kFault);
}

TEST(SupervisorTable, ForcesBeginFromReadyAndHoldAloneAndOnlyWhenAllIsWell) {
  int ways = 0;
  for (const S state : kAll) {
    for (std::size_t f = 0; f < kFindings; ++f) {
      if (!allows_force(next_state(state, finding(f)))) continue;
      ++ways;
      EXPECT_EQ(finding(f), Finding::kWell);
      EXPECT_TRUE(state == S::kReady || state == S::kActive || state == S::kHold);
    }
  }
  EXPECT_EQ(ways, 3);
}

TEST(SupervisorTable, ForcesGoInTheTickOfAnyOtherFinding) {
  for (std::size_t f = 0; f < kFindings; ++f) EXPECT_EQ(allows_force(next_state(S::kActive, finding(f))), finding(f) == Finding::kWell);
}

TEST(SupervisorTable, WordsAreAllowedInOneState) {
  for (const S state : kAll) EXPECT_EQ(allows_force(state), state == S::kActive);
}

TEST(SupervisorTable, WhatStandsNotInItIsAFault) {
  EXPECT_EQ(next_state(static_cast<S>(7), Finding::kWell), S::kFault);
  EXPECT_EQ(next_state(S::kActive, static_cast<Finding>(8)), S::kFault);
  EXPECT_FALSE(allows_force(static_cast<S>(7)));
}

TEST(SupervisorTable, FromEveryStateButFaultTheWellKnownWayLeadsToForces) {
  for (S state : kAll) {
    if (state == S::kFault) state = next_state(state, Finding::kResumed);
    for (int tick = 0; tick < 4; ++tick) state = next_state(state, Finding::kWell);
    EXPECT_EQ(state, S::kActive);
  }
}

}  // namespace
}  // namespace isotouch::core
