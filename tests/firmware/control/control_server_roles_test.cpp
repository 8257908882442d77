/// What each role may ask of the control server, and that every change is logged with its author.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <thread>

#include "firmware/control/control_server.h"
#include "shared/fault_names.h"
#include "tests/firmware/control/control_rig.h"
#include "tests/firmware/store/packed_field.h"

namespace isotouch::control {
namespace {

using protocol::Kind, protocol::Role;
using testing::ElementsAre, testing::HasSubstr;

constexpr uid_t kUser = 4711;

/// A server to which everybody is the user 4711, who has this role.
struct RoleRig : ControlRig {
  explicit RoleRig(Role role)
      : ControlRig(1 << 20, [role](ControlSettings& wish) {
          wish.peer = [](int) { return Peer{true, kUser, {}}; };
          Admission& roles = wish.admission;
          (role == Role::kWatch ? roles.watch : role == Role::kOperate ? roles.operate : roles.service).users = {kUser};
        }) {}
};

/// The answer to each request that changes something, as far as the role decides it: true = it is not refused for the role.
std::vector<bool> allowed(Speaker& speaker) {
  const auto is_allowed = [](const Heard& heard) { return heard.refusal().find("this takes the role") == std::string::npos; };
  const store::PackedField ball = store::packed_ball(1);
  std::vector<bool> all;
  all.push_back(is_allowed(ask(speaker, Kind::kBegin, ball.promise)));
  all.push_back(is_allowed(ask(speaker, Kind::kChunk, protocol::Chunk{0, ball.bytes})));
  all.push_back(is_allowed(ask(speaker, Kind::kCommit)));
  all.push_back(is_allowed(ask(speaker, Kind::kAbort)));
  all.push_back(is_allowed(ask(speaker, Kind::kBeginPatch, protocol::BeginPatch{100})));
  (void)ask(speaker, Kind::kAbort);
  all.push_back(is_allowed(ask(speaker, Kind::kSelect, protocol::Select{1})));
  all.push_back(is_allowed(ask(speaker, Kind::kSet, protocol::Set{protocol::Text::of("friction"), protocol::Text::of("1")})));
  all.push_back(is_allowed(ask(speaker, Kind::kResume)));
  all.push_back(is_allowed(ask(speaker, Kind::kWorst, protocol::WorstRequest{1})));
  all.push_back(is_allowed(ask(speaker, Kind::kPosture)));
  all.push_back(is_allowed(ask(speaker, Kind::kCalibrate, protocol::Calibrate{})));
  all.push_back(is_allowed(ask(speaker, Kind::kRecord)));  // last: records come from here on
  return all;
}

TEST(ControlServerRoles, WhoWatchesSeesEverythingAndMayStop) {
  RoleRig rig(Role::kWatch);
  Speaker speaker(rig.settings.path);
  const Heard welcome = speaker.greet();
  EXPECT_EQ(protocol::decode<protocol::Welcome>(welcome.body)->role, static_cast<std::uint8_t>(Role::kWatch));
  EXPECT_EQ(ask(speaker, Kind::kStatus).kind, Kind::kStatusReport);
  EXPECT_EQ(ask(speaker, Kind::kHistogram, protocol::HistogramRequest{}).kind, Kind::kHistogramReport);
  EXPECT_EQ(ask(speaker, Kind::kFields).kind, Kind::kFieldList);
  EXPECT_EQ(ask(speaker, Kind::kDevice).kind, Kind::kDeviceReport);
  EXPECT_EQ(ask(speaker, Kind::kSettings).kind, Kind::kSettingsReport);
  EXPECT_EQ(ask(speaker, Kind::kWorst, protocol::WorstRequest{0}).kind, Kind::kWorstTicks);
  EXPECT_EQ(ask(speaker, Kind::kStop).kind, Kind::kDone);
  for (const bool is : allowed(speaker)) EXPECT_FALSE(is);
  EXPECT_THAT(rig.logged, ElementsAre("user 4711: stop"));
  for (int tries = 0; tries < 1000 && rig.tick.author == kNobody; ++tries) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  EXPECT_EQ(rig.tick.author, author_of(kUser));
  EXPECT_EQ(rig.tick.obeyed, kRequestStop);
}

TEST(ControlServerRoles, WhoOperatesDoesEverythingButCalibrate) {
  RoleRig rig(Role::kOperate);
  Speaker speaker(rig.settings.path);
  speaker.greet();
  EXPECT_THAT(allowed(speaker), ElementsAre(true, true, true, true, true, true, true, true, true, false, false, true));
}

TEST(ControlServerRoles, WhoServicesDoesEverything) {
  RoleRig rig(Role::kService);
  Speaker speaker(rig.settings.path);
  speaker.greet();
  for (const bool is : allowed(speaker)) EXPECT_TRUE(is);
}

TEST(ControlServerRoles, OnlyWhoServicesMayRaiseALimit) {
  for (const Role role : {Role::kOperate, Role::kService}) {
    RoleRig rig(role);
    Speaker speaker(rig.settings.path);
    speaker.greet();
    EXPECT_EQ(ask(speaker, Kind::kSet, protocol::Set{protocol::Text::of("stiffness"), protocol::Text::of("1")}).kind, Kind::kDone);
    EXPECT_EQ(rig.set_by, author_of(kUser));
    EXPECT_EQ(rig.set_may_raise, role == Role::kService);
  }
}

TEST(ControlServerRoles, AFaultOfTheLinesIsResumedByWhoServices) {
  for (const std::uint16_t fault : {kFaultEmergency, kFaultEnable, kFaultMemory, kFaultGuard, kFaultStopped, kFaultPenetration}) {
    const bool of_service = (fault & kServiceFaults) != 0;
    for (const Role role : {Role::kOperate, Role::kService}) {
      RoleRig rig(role);
      rig.tick.faults = fault;
      Speaker speaker(rig.settings.path);
      speaker.greet();
      while (rig.tick.shown_faults != fault) std::this_thread::sleep_for(std::chrono::milliseconds(1));
      const Heard recording = ask(speaker, Kind::kRecord);  // it begins a run anew
      EXPECT_EQ(recording.kind, of_service && role == Role::kOperate ? Kind::kRefused : Kind::kRecording) << fault;
      if (recording.kind == Kind::kRecording) {
        speaker.say(Kind::kRecordEnd);
        while (speaker.hear().kind != Kind::kDone) {
        }
        rig.logged.clear();
      }
      const Heard heard = ask(speaker, Kind::kResume);
      if (of_service && role == Role::kOperate) {
        EXPECT_THAT(heard.refusal(), HasSubstr("this takes the role service, and user 4711 has the role operate")) << fault;
        EXPECT_TRUE(rig.logged.empty());
      } else {
        EXPECT_EQ(heard.kind, Kind::kDone) << fault;
        EXPECT_THAT(rig.logged, ElementsAre("user 4711: resume"));
      }
    }
  }
}

TEST(ControlServerRoles, EveryChangeIsLoggedWithItsAuthor) {
  RoleRig rig(Role::kService);
  rig.calibration.answers("A1");
  Speaker speaker(rig.settings.path);
  speaker.greet();
  EXPECT_EQ(ask(speaker, Kind::kSet, protocol::Set{protocol::Text::of("friction"), protocol::Text::of("no")}).kind, Kind::kRefused);
  EXPECT_EQ(ask(speaker, Kind::kSet, protocol::Set{protocol::Text::of("friction"), protocol::Text::of("0.5")}).kind, Kind::kDone);
  const store::PackedField ball = store::packed_ball(1);
  const Heard accepted = upload(speaker, ball);
  ASSERT_EQ(accepted.kind, Kind::kAccepted) << accepted.refusal();
  EXPECT_EQ(rig.slots.published().author, author_of(kUser));
  EXPECT_EQ(ask(speaker, Kind::kSelect, protocol::Select{ball.promise.image_hash}).kind, Kind::kAccepted);
  const std::uint32_t near = libnifalcon_model().legs[0].at_zero.raw();
  EXPECT_EQ(ask(speaker, Kind::kCalibrate, protocol::Calibrate{protocol::Text::of("A1"), {near, near + 6, near}}).kind, Kind::kDone);
  EXPECT_EQ(ask(speaker, Kind::kRecord).kind, Kind::kRecording);
  const std::string field = "user 4711: field " + std::string(ball.promise.name.view());
  EXPECT_THAT(rig.logged, ElementsAre("user 4711: friction = 0.5", HasSubstr(field), HasSubstr(field),
                                      "user 4711: other angles were stored for the device", "user 4711: a recording began"));
}

TEST(ControlServerRoles, TheSettingsThatDifferAreTold) {
  ControlRig rig(1 << 20, [](ControlSettings& settings) { settings.recordings.settings_checksum = 0x1234; });
  Speaker speaker(rig.settings.path);
  speaker.greet();
  const Heard heard = ask(speaker, Kind::kSettings);
  ASSERT_EQ(heard.kind, Kind::kSettingsReport);
  const auto report = *protocol::decode<protocol::SettingsReport>(heard.body);
  EXPECT_EQ(report.checksum, 0x1234U);
  EXPECT_EQ(std::string(report.different.begin(), report.different.end()), "feel.friction = 0.5\n");
}

TEST(ControlServerRoles, AControllerWithoutAStateFolderSaysThatItKeepsNoFields) {
  ControlRig rig;
  store::FieldIntake keeps_none(rig.slots, nullptr, rig.clock, {});
  ControlSettings settings = rig.settings;
  settings.path += "2";
  ControlServer server(settings, {keeps_none, rig.tick.commands, rig.tick.stats, rig.tick.shown, rig.clock, nullptr});
  rig.server->stop();
  ASSERT_EQ(server.start().sentence(), "");
  Speaker speaker(settings.path);
  speaker.greet();
  expect_sentence(ask(speaker, Kind::kFields), "keeps no fields, because it has no state folder");
}

}  // namespace
}  // namespace isotouch::control
