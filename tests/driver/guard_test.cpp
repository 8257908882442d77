#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <utility>

#include "shared/fault_names.h"
#include "tests/driver/broken_cores.h"
#include "tests/driver/flip_places.h"

namespace isotouch::test {
namespace {

using falcon_model::Vector;
using loop::Command;

/// What was let through of a core that is wrong by degrees, from the first touch on.
struct Passed {
  double newton = 0;  ///< the largest force that should not have been
  GuardVerdict verdict = GuardVerdict::kNone;
};

/// wrong     what there is too much, N, of the force that the sound core asks for
Passed passed(const std::function<void(Command&)>& says, const std::function<double(const Vec3<Newton>&)>& wrong, int ticks_in_contact,
              const Way& way = {}) {
  const Move move{way};
  FaultBench::Options options;
  options.path = move;
  const auto bench = std::make_unique<FaultBench>(options);
  bench->load(ball_image(25));
  int touched = 0;
  for (; !bench->has_words() || ++touched < ticks_in_contact;) bench->tick();
  bench->tamper = says;
  if (way.by != Vector{}) move.go();
  Passed through;
  for (int t = 0; t < 1500; ++t) {
    bench->tick();
    if (through.verdict == GuardVerdict::kNone) through.verdict = bench->line_state.verdict();
    if (has_force(*bench)) through.newton = std::max(through.newton, wrong(bench->last.out.force));
    EXPECT_FALSE(through.verdict != GuardVerdict::kNone && has_force(*bench));
  }
  return through;
}

double newton(const Vec3<Newton>& force) {
  return std::hypot(std::ldexp(force.x.raw(), -16), std::ldexp(force.y.raw(), -16), std::ldexp(force.z.raw(), -16));
}

TEST(Guard, StopsAForceThatIsTooStrong) {
  const Passed through = passed([](Command& c) { times(8, c); }, [](const Vec3<Newton>& f) { return 8 * newton(f); }, 0);
  EXPECT_EQ(through.verdict, GuardVerdict::kStrong) << name_of(through.verdict);
  EXPECT_LT(through.newton, 2.5) << "of 8";
  EXPECT_GT(through.newton, 0.5) << "else it was stopped for another reason";
}

TEST(Guard, StopsAForceIntoTheObject) {
  const Passed through = passed([](Command& c) { times(-1, c); }, newton, 0);
  EXPECT_EQ(through.verdict, GuardVerdict::kPull) << name_of(through.verdict);
  EXPECT_LT(through.newton, 2.2);
}

TEST(Guard, StopsCommandsThatRepeat) {
  Command frozen;
  const auto says = [&frozen](Command& c) {
    if (frozen.tick == 0) frozen = c;
    c.falcon = frozen.falcon;
  };
  const Passed through = passed(says, [](const Vec3<Newton>&) { return 0.0; }, 1500, {{15, 0, 8}, 300});
  EXPECT_EQ(through.verdict, GuardVerdict::kRepeat) << name_of(through.verdict);
}

/// Balls on one grid, from the smallest to the largest.
const std::vector<std::vector<std::uint8_t>>& balls() {
  static const std::vector<std::vector<std::uint8_t>> all = [] {
    std::vector<std::vector<std::uint8_t>> made;
    for (int n = 0; n <= 20; ++n) made.push_back(ball_image(23 + 0.2 * n));
    return made;
  }();
  return all;
}

/// As the controller applies a patch.
void patch(FaultBench& bench, const std::vector<std::uint8_t>& image) {
  const auto room = bench.fields.begin(image.size());
  if (room.size() < image.size()) return;
  std::copy(image.begin(), image.end(), room.begin());
  const auto view = bench.fields.verify();
  ASSERT_TRUE(view && bench.fields.commit_patched((*view)->hash()));
}

TEST(Guard, LetsASurfaceMoveUnderTheHand) {
  TickSettings damped;
  damped.damping = Damping::of(0.005);
  damped.hand_damping = Damping::of(0.003);
  for (const auto& [every, settings] :
       {std::pair{33, TickSettings{}}, {100, TickSettings{}}, {7, TickSettings{}}, {33, damped}, {7, damped}}) {
    FaultBench::Options options;
    options.tick = settings;
    const auto bench = std::make_unique<FaultBench>(options);
    ASSERT_TRUE(bench->begin());
    int forces = 0, patches = 0, lags = 0;
    std::size_t now = 10, step = 1;
    for (int t = 0; t < 6000; ++t) {
      if (t % every == 0) {
        if (now == 0 || now == 20 || t % 700 < every) step = -step;
        now = std::min<std::size_t>(now + step, 20);
        patch(*bench, balls()[now]);
        ++patches;
      }
      bench->tick();
      ASSERT_EQ(bench->line_state.verdict(), GuardVerdict::kNone) << name_of(bench->line_state.verdict()) << " in tick " << t;
      ASSERT_NE(bench->state(), SupervisorState::kFault) << t;
      forces += has_force(*bench) ? 1 : 0;
      lags += (bench->last.out.status & kLagging) != 0 ? 1 : 0;
    }
    EXPECT_GT(forces, 1000) << every;
    EXPECT_GT(lags, 500) << every;
    EXPECT_GT(patches, 50);
  }
}

/// By steps that the proxy cannot follow, and away altogether.
TEST(Guard, LetsASurfaceJumpUnderTheHand) {
  const std::vector<std::vector<std::uint8_t>> far = {ball_image(25), ball_image(5), ball_image(24), ball_image(33), ball_image(26)};
  for (const Damping damping : {Damping{}, Damping::of(0.005)}) {
    FaultBench::Options options;
    options.tick.damping = damping;
    const auto bench = std::make_unique<FaultBench>(options);
    ASSERT_TRUE(bench->begin());
    for (int t = 0; t < 4000; ++t) {
      if (t % 400 == 0) patch(*bench, far[static_cast<std::size_t>(t / 400) % far.size()]);
      bench->tick();
      ASSERT_EQ(bench->line_state.verdict(), GuardVerdict::kNone) << name_of(bench->line_state.verdict()) << " in tick " << t;
    }
  }
}

/// Before the patch some 5 N would be too strong, and 50 ticks after it 7.5.
TEST(Guard, StopsAForceThatIsTooStrongOnASurfaceThatMoves) {
  const struct {
    int ticks;
    double factor;
    GuardVerdict verdict;
  } rows[] = {{3, 3, GuardVerdict::kStrong}, {50, 3, GuardVerdict::kNone}, {50, 3.8, GuardVerdict::kStrong}};
  for (const auto& row : rows) {
    const auto bench = std::make_unique<FaultBench>(FaultBench::Options{});
    ASSERT_TRUE(bench->begin());
    patch(*bench, balls()[11]);
    for (int t = 0; t < row.ticks; ++t) bench->tick();
    bench->tamper = [&row](Command& c) { times(row.factor, c); };
    bench->tick();
    EXPECT_EQ(bench->line_state.verdict(), row.verdict) << row.ticks << ": " << name_of(bench->line_state.verdict());
    EXPECT_EQ(has_force(*bench), row.verdict == GuardVerdict::kNone);
  }
}

TEST(Guard, StopsOnceItsOwnMemoryWasDamaged) {
  for (std::uint64_t bit = 0; bit < 8 * sizeof(guard::Memory); bit += 331) {
    const auto bench = std::make_unique<FaultBench>(FaultBench::Options{});
    ASSERT_TRUE(bench->begin());
    flip(*bench, {"", {}, FlipPlace::Where::kGuardMemory}, bit);
    bench->tick();
    bench->tick();
    EXPECT_EQ(bench->line_state.verdict(), GuardVerdict::kMemory) << bit;
    EXPECT_FALSE(has_force(*bench)) << bit;
    for (int t = 0; t < 200; ++t) bench->tick();
    bench->commands.ask(kRequestResume);
    for (int t = 0; t < 600; ++t) bench->tick();
    EXPECT_TRUE(has_force(*bench)) << bit;
  }
}

TEST(Guard, AfterItsOwnDamageItStillKnowsWhichPacketsACommandHasSeen) {
  const auto bench = std::make_unique<FaultBench>(FaultBench::Options{});
  ASSERT_TRUE(bench->begin());
  flip(*bench, {"", {}, FlipPlace::Where::kGuardMemory}, 331);
  for (int t = 0; t < 200; ++t) bench->tick();
  bench->commands.ask(kRequestResume);
  for (int t = 0; t < 600; ++t) bench->tick();
  ASSERT_TRUE(has_force(*bench));
  Command frozen;
  bench->tamper = [&frozen](Command& c) {  // a tick that looks at no new packet
    if (frozen.tick == 0) frozen = c;
    c.falcon = frozen.falcon, c.sample = frozen.sample;
  };
  for (int t = 0; t < 20; ++t) bench->tick();
  EXPECT_EQ(bench->line_state.verdict(), GuardVerdict::kStale) << name_of(bench->line_state.verdict());
}

TEST(Guard, BelievesASoundCoreAfterAPersonHasResumed) {
  const auto bench = std::make_unique<FaultBench>(FaultBench::Options{});
  ASSERT_TRUE(bench->begin());
  bench->tamper = [](Command& c) { c.falcon.words[1] = 4096; };
  bench->tick();
  bench->tamper = {};
  for (int t = 0; t < 200; ++t) bench->tick();
  EXPECT_EQ(bench->line_state.verdict(), GuardVerdict::kNone) << "it was silent for 100 ms";
  EXPECT_EQ(bench->state(), SupervisorState::kFault);
  EXPECT_EQ(bench->last.out.faults, kFaultGuard);
  bench->commands.ask(kRequestResume);
  for (int t = 0; t < 600; ++t) bench->tick();
  EXPECT_TRUE(has_force(*bench));
}

}  // namespace
}  // namespace isotouch::test
