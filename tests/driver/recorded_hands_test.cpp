#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "shared/fault_names.h"
#include "tests/driver/fault_bench.h"

namespace isotouch::test {
namespace {

using falcon_model::Vector;

struct Moment {
  double ms;
  std::array<double, 3> mm;
};

/// Lines of time in seconds and a position in millimetres, among others; the middle of what the hand reached is moved to 0.
std::vector<Moment> read_hand(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::string line;
  std::getline(in, line);
  std::vector<Moment> hand;
  while (std::getline(in, line)) {
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream text(line);
    Moment now{};
    text >> now.ms >> now.mm[0] >> now.mm[1] >> now.mm[2];
    now.ms *= 1000;
    hand.push_back(now);
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto less = [axis](const Moment& a, const Moment& b) { return a.mm[axis] < b.mm[axis]; };
    const auto [low, high] = std::minmax_element(hand.begin(), hand.end(), less);
    const double middle = (low->mm[axis] + high->mm[axis]) / 2;
    for (Moment& now : hand) now.mm[axis] -= middle;
  }
  return hand;
}

/// Presses, and then moves as the recorded hand did, in and around the front of the ball, within 25 mm.
falcon_model::Path as(const std::vector<Moment>& hand, int turn) {
  double most = 1;
  for (const Moment& now : hand) {
    for (const double x : now.mm) most = std::max(most, std::abs(x));
  }
  const double scale = std::min(1.0, 25 / most), begins = 3500, joins = 1000;
  return [=, press = pressing_hand()](double ms) {
    if (ms < begins) return press(ms);
    const double t = hand.front().ms + std::max(0.0, ms - begins - joins);
    auto after = std::lower_bound(hand.begin() + 1, hand.end() - 1, t, [](const Moment& m, double when) { return m.ms < when; });
    const Moment &a = *(after - 1), &b = *after;
    const double part = std::clamp((t - a.ms) / std::max(b.ms - a.ms, 1e-9), 0.0, 1.0);
    std::array<double, 3> at{};
    for (std::size_t i = 0; i < 3; ++i) {
      const auto axis = (i + static_cast<std::size_t>(turn)) % 3;
      at[i] = (turn < 3 ? scale : -scale) * (a.mm[axis] + part * (b.mm[axis] - a.mm[axis]));
    }
    const double join = std::min((ms - begins) / joins, 1.0);
    return Vector{join * at[0], join * at[1], 18 + join * (at[2] + 5)};
  };
}

TEST(RecordedHandsHeavy, TheGuardStopsNone) {
  const char* data = std::getenv("ISOTOUCH_DATA");
  if (data == nullptr) GTEST_SKIP() << "ISOTOUCH_DATA is not set";
  int hands = 0, touching = 0;
  for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(data) / "traces")) {
    if (entry.path().extension() != ".csv") continue;
    const std::vector<Moment> hand = read_hand(entry.path());
    ASSERT_GT(hand.size(), 100U) << entry.path();
    for (int turn = 0; turn < 6; ++turn, ++hands) {
      FaultBench::Options options;
      options.path = as(hand, turn);
      const auto bench = std::make_unique<FaultBench>(options);
      ASSERT_TRUE(bench->begin());
      const int ticks = 3000 + static_cast<int>(hand.back().ms - hand.front().ms);
      for (int t = 0; t < ticks; ++t) {
        if (t % 700 == 0) bench->commands.ask(kRequestResume);
        if (t % 1500 == 700) bench->commands.ask(kRequestStop);  // its ramp is another force
        bench->tick();
        const GuardVerdict verdict = bench->line_state.verdict();
        ASSERT_EQ(verdict, GuardVerdict::kNone)
            << entry.path().filename() << ", turn " << turn << ", tick " << t << ": " << name_of(verdict);
        touching += bench->has_words() ? 1 : 0;
      }
    }
  }
  EXPECT_GE(hands, 42);
  EXPECT_GT(touching, 50'000) << "else nothing is tested";
}

}  // namespace
}  // namespace isotouch::test
