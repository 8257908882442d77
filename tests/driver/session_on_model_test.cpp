/// The driver against the simulated Falcon: two programs that share no code, written from one sheet of facts.
#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "firmware/falcon/falcon_session.h"
#include "hil/falcon_model/paths.h"
#include "hil/falcon_model/quirks.h"
#include "tests/driver/model_link.h"

namespace isotouch::falcon {
namespace {

using falcon_model::Fault;
using falcon_model::FaultKind;
using test::ModelClock;
using test::ModelLink;

const std::array<std::uint8_t, 34> kImage = synthetic_image();

falcon_model::Settings held(const std::vector<std::string>& quirks, std::vector<Fault> faults = {}) {
  falcon_model::Settings settings;
  for (const std::string& quirk : quirks) falcon_model::set_quirk(settings.quirks, quirk);
  settings.path = falcon_model::scripted_path("rest");
  settings.faults = std::move(faults);
  return settings;
}

constexpr FalconCommand kSearch{{}, kFalconHoming};  // no force, and the reference marks

struct Desk {
  ModelClock clock;
  ModelLink link;
  FalconSession session{link, clock, kImage};

  explicit Desk(falcon_model::Settings settings) : link(std::move(settings), clock) {}

  bool comes_up() {
    for (int i = 0; i < 3000 && session.state() != SessionState::kRunning; ++i) session.step(kSearch);
    return session.state() == SessionState::kRunning;
  }
};

TEST(SessionOnModel, BootsWhateverTheDeviceDoesBesideTheRule) {
  struct Case {
    std::vector<std::string> quirks;
    BootOutcome outcome;
    int attempts;
  };
  const std::vector<Case> cases = {
      {{}, BootOutcome::kLoaded, 1},
      {{"leading-zero"}, BootOutcome::kLoaded, 1},
      {{"stray-13"}, BootOutcome::kLoaded, 1},
      {{"stale-status"}, BootOutcome::kLoaded, 1},
      {{"mislock"}, BootOutcome::kLoaded, 1},
      {{"silent-on-wrong-rate"}, BootOutcome::kLoaded, 1},
      {{"leading-zero", "stray-13", "stale-status", "mislock"}, BootOutcome::kLoaded, 1},
      {{"fail-handshakes=9"}, BootOutcome::kLoaded, 1},
      {{"fail-uploads=2"}, BootOutcome::kLoaded, 3},
      {{"fail-uploads=4"}, BootOutcome::kLoaded, 2},
      {{"firmware-loaded"}, BootOutcome::kAlreadyRunning, 0},
  };
  for (const Case& c : cases) {
    std::string name;
    for (const std::string& quirk : c.quirks) name += quirk + " ";
    Desk desk(held(c.quirks));
    ASSERT_TRUE(desk.comes_up()) << name << explain(desk.session.last_boot());
    EXPECT_EQ(desk.session.last_boot().outcome, c.outcome) << name;
    EXPECT_EQ(desk.session.last_boot().attempts, c.attempts) << name << "of the last round";
    int fresh = 0;
    Exchange last;
    for (int i = 0; i < 1000; ++i) fresh += (last = desk.session.step(kSearch)).fresh ? 1 : 0;
    EXPECT_EQ(fresh, 1000) << name;
    EXPECT_EQ(last.reply.homed, 7) << name;
  }
}

TEST(SessionOnModel, AsksForWallPower) {
  Desk desk(held({"no-wall-power"}));
  desk.session.step(kSearch);
  desk.session.step(kSearch);
  EXPECT_EQ(desk.session.last_boot().outcome, BootOutcome::kNoHandshake);
  EXPECT_EQ(desk.session.state(), SessionState::kSearching);
}

TEST(SessionOnModel, CountsEveryFaultOfTheWireForWhatItIs) {
  Desk desk(held({"firmware-loaded"}, {{100, FaultKind::kShort, {}},
                                       {200, FaultKind::kMerged, {}},
                                       {300, FaultKind::kLate, {1}},
                                       {400, FaultKind::kCorrupt, {5, 0x20}},
                                       {500, FaultKind::kSplit, {5}},
                                       {600, FaultKind::kModemOnly, {3}},
                                       {700, FaultKind::kStall, {3}}}));
  ASSERT_TRUE(desk.comes_up());
  int fresh = 0, lost = 0;
  for (int i = 0; i < 1000; ++i) {
    const Exchange exchange = desk.session.step({{1, 2, 3}, kFalconHoming});
    fresh += exchange.fresh ? 1 : 0;
    lost += exchange.lost ? 1 : 0;
  }
  const DeviceCounts counts = desk.session.counts();
  EXPECT_EQ(lost, 0);
  EXPECT_EQ(counts.stream.cut, 1U);
  EXPECT_EQ(counts.stream.corrupt, 1U);
  EXPECT_EQ(counts.stream.split, 1U);
  EXPECT_EQ(counts.stream.merged, 2U);
  EXPECT_EQ(counts.late, 2U);
  EXPECT_EQ(counts.timeouts, 7U);  // short, merged, late, corrupt, and three packets that were not heard
  EXPECT_EQ(fresh, 993);
}

TEST(SessionOnModel, ComesBackAfterUnplugAndAfterLostFirmware) {
  Desk desk(held({}, {{500, FaultKind::kUnplug, {3}}, {1500, FaultKind::kFirmwareLost, {}}}));
  ASSERT_TRUE(desk.comes_up());
  std::vector<BootOutcome> boots = {desk.session.last_boot().outcome};
  int homed_steps = 0;
  for (int i = 0; i < 6000; ++i) {
    const SessionState before = desk.session.state();
    homed_steps += desk.session.step(kSearch).reply.homed == 7 ? 1 : 0;
    if (before == SessionState::kBooting) boots.push_back(desk.session.last_boot().outcome);
  }
  EXPECT_EQ(desk.session.losses(), 2U);
  EXPECT_EQ(boots, (std::vector<BootOutcome>{BootOutcome::kLoaded, BootOutcome::kAlreadyRunning, BootOutcome::kLoaded}));
  EXPECT_GT(homed_steps, 4000);
}

TEST(SessionOnModel, IsTheSameRunEveryTime) {
  const auto run = [] {
    Desk desk(held({"stale-status"}, {{300, FaultKind::kLate, {1}}, {700, FaultKind::kStall, {2}}}));
    EXPECT_TRUE(desk.comes_up());
    std::vector<std::int16_t> counts;
    for (std::int16_t i = 0; i < 1500; ++i) {
      const Exchange exchange = desk.session.step({{i, static_cast<std::int16_t>(-i), 0}});
      counts.insert(counts.end(), exchange.reply.counts.begin(), exchange.reply.counts.end());
    }
    return counts;
  };
  const std::vector<std::int16_t> first = run();
  EXPECT_EQ(first, run());
  EXPECT_NE(first.front(), first.back());
}

}  // namespace
}  // namespace isotouch::falcon
