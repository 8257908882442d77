#include "shared/files/state_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <utility>

#include "shared/fault_names.h"

namespace isotouch::files {
namespace {

using testing::HasSubstr, testing::StartsWith;

std::string text(SupervisorState state, std::uint16_t faults = 0, std::uint32_t status = 0) {
  return state_text({static_cast<std::uint16_t>(state), faults, status, true});
}

TEST(StateText, EveryStateHasASentenceThatBeginsWithItsName) {
  std::set<std::string> sentences;
  for (std::uint16_t state = 0; state <= 6; ++state) {
    const std::string sentence = state_text({state, 0, 0, false});
    EXPECT_THAT(sentence, StartsWith(std::string(state_name(state)) + ":"));
    EXPECT_TRUE(sentences.insert(sentence).second);
  }
  EXPECT_EQ(state_text({7, 0, 0, false}), "unknown");
}

TEST(StateText, AFaultIsExplainedWithTheNextStep) {
  EXPECT_EQ(text(SupervisorState::kFault, kFaultSilent | kFaultStopped),
            "fault: no force, because a stop was requested, or the controller began anew after a crash, a stop or a fault, or with changed "
            "angles; its own output says which (journalctl -u isotouchd); check the grip; the device did not answer in time; check its "
            "cable and power supply; then press a button of the grip, or run "
            "'isotouch resume'");
  EXPECT_THAT(text(SupervisorState::kFault, kFaultGuard), HasSubstr("let somebody with the role service run 'isotouch resume'"));
  std::set<std::string> sentences;
  for (const FaultName& fault : kFaultNames) sentences.insert(text(SupervisorState::kFault, fault.fault));
  EXPECT_EQ(sentences.size(), kFaultNames.size());
}

TEST(StateText, TheNextStepIsDoneWithTheProgramThatIsThere) {
  for (const auto& [state, command] :
       {std::pair{SupervisorState::kFault, "resume"}, {SupervisorState::kIdle, "upload"}, {SupervisorState::kHold, "latency"}}) {
    const Condition condition{static_cast<std::uint16_t>(state), 0, 0, false};
    EXPECT_THAT(state_text(condition), HasSubstr(std::string("'isotouch ") + command + "'"));
    EXPECT_THAT(state_text(condition, protocol::OtherAngles::kNone, "isotouchctl"),
                HasSubstr(std::string("'isotouchctl ") + command + "'"));
  }
}

TEST(StateText, WhileOtherAnglesWaitNothingIsAdvisedThatIsRefused) {
  for (const auto others : {protocol::OtherAngles::kKept, protocol::OtherAngles::kUntrusted}) {
    for (const FaultName& fault : kFaultNames) {
      for (std::uint16_t state = 0; state <= 6; ++state) {
        const std::string sentence = state_text({state, fault.fault, 0, true}, others);
        EXPECT_THAT(sentence, StartsWith(std::string(state_name(state)) + ": "));
        EXPECT_THAT(sentence, testing::EndsWith(std::string(angles_text(others))));
        EXPECT_THAT(sentence, testing::Not(testing::ContainsRegex("button|resume"))) << sentence;
      }
    }
  }
  EXPECT_EQ(state_text({static_cast<std::uint16_t>(SupervisorState::kHoming), 0, 0, true}, protocol::OtherAngles::kKept),
            "homing: " + std::string(angles_text(protocol::OtherAngles::kKept)));
}

TEST(StateText, AHoldNamesTheOneCauseThatItWaitsFor) {
  const auto hold = [](std::uint32_t status) { return text(SupervisorState::kHold, 0, status); };
  EXPECT_THAT(hold(kPoseUncertain | kStale), HasSubstr("the position of the grip is uncertain"));
  EXPECT_THAT(hold(kTooFast), HasSubstr("moves too fast"));
  EXPECT_THAT(hold(kStale), HasSubstr("packets of the device are missing"));
  EXPECT_THAT(hold(kBadReply), HasSubstr("malformed"));
  EXPECT_THAT(hold(kLate), HasSubstr("ticks came late"));
  EXPECT_THAT(hold(0), HasSubstr("ticks came late")) << "lateness outlasts the tick that was late";
}

TEST(StateText, WithoutAFieldItAsksForOneAndWithOneItNamesWhatItWaitsFor) {
  constexpr auto kIdle = static_cast<std::uint16_t>(SupervisorState::kIdle);
  EXPECT_THAT(state_text({kIdle, 0, kStale, false}), HasSubstr("there is no field; send one"));
  EXPECT_EQ(state_text({kIdle, 0, kStale, true}),
            "idle: no force yet, because packets of the device are missing; check its cable if this does not end");
}

}  // namespace
}  // namespace isotouch::files
