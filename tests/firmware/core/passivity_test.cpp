#include "firmware/core/passivity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <deque>

#include "tests/support/accuracy.h"
#include "tests/support/random.h"

namespace isotouch::core {
namespace {

template <class Q>
Q fixed(double value) {
  return Q::from_raw(static_cast<std::int32_t>(std::lround(std::ldexp(value, Q::kFractionBits))));
}
double to_double(Energy e) { return std::ldexp(e.raw(), -Energy::kFractionBits); }

/// A wall at x = 0, felt by a hand that goes where it is told.
struct Wall {
  Passivity passivity;
  double stiffness;
  PassivityState state;
  std::deque<double> said;  // forces, oldest first
  double twin = 0, stored = 0, last = 0;
  bool begun = false;

  /// Tells the ledger one tick; its twin is kept in doubles.
  void at(double x, double limit = 1000) {
    const double deflection = std::max(-x, 0.0), spring = stiffness * deflection, felt = std::min(spring, limit);
    Force force;
    force.deflection.x = fixed<Mm>(deflection);
    force.spring.x = fixed<Newton>(spring);
    force.newton.x = fixed<Newton>(felt);
    force.limited = spring > limit;
    if (force.limited) force.kept = fixed<Ratio>(limit / spring);
    book_energy({fixed<Mm>(x) - fixed<Mm>(begun ? last : x), {}, {}}, force, {}, passivity, state);

    const double holds = spring > limit ? felt * deflection - felt * felt / stiffness / 2 : felt * deflection / 2;
    const double device = std::ldexp(passivity.device.raw(), -DampingPerTick::kFractionBits);
    if (begun) {
      const double late = said.size() > passivity.delay ? said[said.size() - 1 - passivity.delay] : 0;
      twin = std::min(twin + (device * (x - last) - late) * (x - last) - (holds - stored), 0.02);
    }
    begun = true;
    said.push_back(felt);
    stored = holds;
    last = x;
  }
};

TEST(Passivity, TheLedgerIsThatOfTheTwin) {
  test::Random random(81);
  double worst = 0;
  for (std::uint32_t delay = 0; delay <= 7; ++delay) {
    Wall wall{{Damping::of(0.01), DampingPerTick::of(3), delay}, 2.0, {}, {}};
    double x = 1, v = 0;
    for (int t = 0; t < 3000; ++t) {
      v = 0.9 * v + random.uniform(-0.1, 0.1) - 0.01 * x;
      x += v;
      wall.at(x, 1.5);
      worst = std::max(worst, std::abs(to_double(wall.state.balance) - wall.twin));
    }
  }
  EXPECT_THAT(worst, test::IsAccuracyOf(0.000022));  // N·mm after thousands of sums: the spring's newtons have 16 bits
}

TEST(Passivity, WithinTheCertificateThereIsNeverADebtWhateverTheCounts) {
  test::Random random(82);
  for (std::uint32_t delay = 0; delay <= 3; ++delay) {
    // K = 2b / ((2d + 1) T), and a hand of counts of 46 µm that shakes, strokes and hits. Transients of a stop are debts of a few µJ.
    Wall wall{{Damping::of(0.01), DampingPerTick::of(3), delay}, 0.99 * 2 * 3 / (2 * delay + 1.0), {}, {}};
    double worst = 0;
    for (int t = 0; t < 20'000; ++t) {
      const double hand = -1 + 1.5 * std::sin(0.02 * t) + 0.05 * std::sin(0.4 * t);
      const double counts = 0.046 * std::floor((hand + random.uniform(-0.02, 0.02)) / 0.046);
      wall.at(counts);
      worst = std::min(worst, to_double(wall.state.balance));
    }
    EXPECT_GT(worst, -0.02) << delay;
  }
}

TEST(Passivity, BeyondItAnOscillationRunsUpADebtAndIsDamped) {
  for (std::uint32_t delay = 1; delay <= 3; ++delay) {
    Wall wall{{Damping::of(0.01), DampingPerTick::of(3), delay}, 1.5 * 2 * 3 / (2 * delay + 1.0), {}, {}};
    EXPECT_EQ(injected_damping(wall.passivity, wall.state), Damping{});
    for (int t = 0; t < 2000; ++t) wall.at(-1 + 0.5 * std::sin(0.1 * t));
    EXPECT_LT(to_double(wall.state.balance), -0.5);
    EXPECT_EQ(injected_damping(wall.passivity, wall.state), wall.passivity.most);
  }
}

TEST(Passivity, DampingGrowsWithTheDebtUpToItsLimit) {
  const Passivity passivity{Damping::of(0.01), {}, 1};
  PassivityState state;
  const auto damping_at = [&](double balance) {
    state.balance = fixed<Energy>(balance);
    return std::ldexp(injected_damping(passivity, state).raw(), -Damping::kFractionBits);
  };
  EXPECT_EQ(damping_at(0.02), 0);
  EXPECT_NEAR(damping_at(-0.05), 0.0025, 0.000001);
  EXPECT_NEAR(damping_at(-0.2), 0.01, 0.000001);
  EXPECT_NEAR(damping_at(-2000), 0.01, 0.0000001);
}

TEST(Passivity, ARampBeginsTheLedgerAnew) {
  Wall wall{{Damping::of(0.01), {}, 1}, 2, {}, {}};
  for (int t = 0; t < 500; ++t) wall.at(-1 + 0.5 * std::sin(0.1 * t));
  EXPECT_LT(to_double(wall.state.balance), -0.1);
  Force force;
  force.ramping = true;
  book_energy({}, force, {}, wall.passivity, wall.state);
  EXPECT_EQ(wall.state.balance, Energy{});
}

TEST(Passivity, HalfOfWhatIsInjectedCountsAsPaid) {
  const Passivity passivity{Damping::of(0.01), {}, 0};
  const auto after = [&](Newton injected) {
    PassivityState state;
    Force force;
    force.newton.x = Newton::of(-1);
    book_energy({}, force, {injected, {}, {}}, passivity, state);
    book_energy({Mm::of(0.01), {}, {}}, force, {injected, {}, {}}, passivity, state);
    return to_double(state.balance);
  };
  EXPECT_NEAR(after(Newton{}), 0.01, 0.00001);
  EXPECT_NEAR(after(Newton::of(-1)), 0.005, 0.00001);
}

}  // namespace
}  // namespace isotouch::core
