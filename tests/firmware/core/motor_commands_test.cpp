#include "firmware/core/motor_commands.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "tests/support/falcon_twin.h"

namespace isotouch::core {
namespace {

using Words = MotorCommands;

JointTorques torques(double a, double b, double c) {
  const auto q = [](double v) { return NewtonMm::from_raw(static_cast<std::int32_t>(std::lround(v * 4096))); };
  return {q(a), q(b), q(c)};
}

/// A model without a slew limit that could be met.
Motors fast(DeviceModel model) {
  model.word_slew = 100'000'000;
  return make_motors(model, 1'000'000);
}

TEST(Commanded, AreThePublishedOnes) {
  struct Row {
    std::array<double, 3> torques;
    Words first, second;  // with 1e-4 and 1.5114e-4 N·m a command
  };
  const std::vector<Row> rows = {{{15.488, -52.725, 37.237}, {-155, 527, -372}, {-102, 349, -246}},
                                 {{-51.940, 12.557, 39.383}, {519, -126, -394}, {344, -83, -261}},
                                 {{24.180, 24.180, 24.180}, {-242, -242, -242}, {-160, -160, -160}},
                                 {{-120.901, -120.901, -120.901}, {1209, 1209, 1209}, {800, 800, 800}},
                                 {{155.456, -45.466, 107.632}, {-1555, 455, -1076}, {-1029, 301, -712}},
                                 {{171.153, -59.801, 115.832}, {-1712, 598, -1158}, {-1132, 396, -766}},
                                 {{148.139, 22.911, 73.969}, {-1481, -229, -740}, {-980, -152, -489}},
                                 {{-168.905, -139.909, -55.595}, {1689, 1399, 556}, {1118, 926, 368}},
                                 {{183.647, -43.339, 79.490}, {-1836, 433, -795}, {-1215, 287, -526}}};
  for (const Row& row : rows) {
    const JointTorques tau = torques(row.torques[0], row.torques[1], row.torques[2]);
    EXPECT_EQ(motor_commands(tau, fast(libnifalcon_model()), {}).commands, row.first);
    EXPECT_EQ(motor_commands(tau, fast(martin_hillier_model()), {}).commands, row.second);
  }
}

TEST(Commanded, TooLargeOnesAreScaledTogether) {
  const Motors motors = fast(libnifalcon_model());
  test::Random random(95);
  int limited = 0;
  for (int n = 0; n < 100'000; ++n) {
    const double size = n % 2 == 0 ? 900 : 500'000;
    const test::Point t = n < 8 ? test::Point{n & 1 ? size : -size, n & 2 ? size : -size, n & 4 ? size : 0} : random.in_box(size);
    const Commanded out = motor_commands(torques(t.x, t.y, t.z), motors, {});
    const double largest = std::max({std::abs(t.x), std::abs(t.y), std::abs(t.z)}) / 0.1;
    const double scale = largest > 4095 ? 4095 / largest : 1;
    EXPECT_EQ(out.limited, largest > 4095.01) << largest;
    for (std::size_t i = 0; i < 3; ++i) ASSERT_NEAR(out.commands[i], -t[i] / 0.1 * scale, 0.55);
    limited += out.limited ? 1 : 0;
  }
  EXPECT_GT(limited, 50'000);
}

TEST(Commanded, ChangeNoFasterThanTheSlewLimitAndArrive) {
  DeviceModel model = libnifalcon_model();
  model.word_slew = 250'000;
  for (const std::uint32_t period_ns : {100'000U, 1'000'000U, 4'000'000U}) {
    const Motors motors = make_motors(model, period_ns);
    const int most = static_cast<int>(period_ns / 4000);
    Words last{};
    const JointTorques tau = torques(-300, 150, 75);
    int ticks = 0;
    bool limited = true;
    for (; limited && ticks < 1000; ++ticks) {
      const Commanded out = motor_commands(tau, motors, last);
      for (std::size_t i = 0; i < 3; ++i) EXPECT_LE(std::abs(out.commands[i] - last[i]), most);
      if (out.slew_limited) {
        EXPECT_NEAR(out.commands[1], -0.5 * out.commands[0], 0.5 * ticks + 2);  // all three together
      }
      limited = out.slew_limited;
      last = out.commands;
    }
    EXPECT_EQ(last, (Words{3000, -1500, -750}));
    EXPECT_NEAR(ticks, 3000.0 / most + 1, 1.01);
  }
}

TEST(Commanded, OfNoTorqueAreZeroFromRest) {
  EXPECT_EQ(motor_commands({}, fast(libnifalcon_model()), {}).commands, Words{});
  EXPECT_FALSE(motor_commands({}, fast(libnifalcon_model()), {}).slew_limited);
}

}  // namespace
}  // namespace isotouch::core
