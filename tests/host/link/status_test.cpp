#include "host/link/status.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "shared/fault_names.h"

namespace isotouch::link {
namespace {

using protocol::OtherAngles;
using testing::AllOf, testing::HasSubstr, testing::Not, testing::StartsWith;

std::string sentence_of(SupervisorState state, std::uint16_t faults, OtherAngles others) {
  ControllerStatus seen;
  seen.status.state = static_cast<std::uint16_t>(state);
  seen.status.faults = faults;
  seen.device.waits = static_cast<std::uint8_t>(others);
  return sentence(seen);
}

TEST(Status, ADeviceThatIsNotHeardIsTheCauseOfWhatIsMissing) {
  EXPECT_THAT(sentence_of(SupervisorState::kBoot, 0, OtherAngles::kNone), HasSubstr("plug it in"));
  EXPECT_THAT(sentence_of(SupervisorState::kBoot, 0, OtherAngles::kUntrusted),
              AllOf(StartsWith("boot: the angles in use are not those"), Not(HasSubstr("plug it in"))));
  EXPECT_THAT(sentence_of(SupervisorState::kFault, kFaultSilent, OtherAngles::kNone), HasSubstr("check its cable"));
  EXPECT_THAT(sentence_of(SupervisorState::kFault, kFaultSilent, OtherAngles::kKept),
              AllOf(StartsWith("fault: other angles were measured"), Not(HasSubstr("cable"))));
}

TEST(Status, OtherAnglesDoNotHideAFault) {
  const std::string fault = sentence_of(SupervisorState::kFault, kFaultGuard, OtherAngles::kNone);
  const std::string cause = fault.substr(0, fault.find("; then press a button"));
  ASSERT_LT(cause.size(), fault.size());
  for (const OtherAngles others : {OtherAngles::kKept, OtherAngles::kUntrusted}) {
    for (const int faults : {int{kFaultGuard}, kFaultGuard | kFaultSilent})
      EXPECT_THAT(sentence_of(SupervisorState::kFault, static_cast<std::uint16_t>(faults), others), StartsWith(cause + "; besides, "));
  }
}

}  // namespace
}  // namespace isotouch::link
