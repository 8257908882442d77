/// What a loop does when a bit of its memory flips.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

#include "tests/firmware/loop/loop_bench.h"

namespace isotouch::loop {
namespace {

/// Flips a bit of something that nobody may change.
template <class T>
void flip(const T& value, std::size_t bit) {
  volatile std::uint8_t* const at = reinterpret_cast<std::uint8_t*>(const_cast<T*>(&value)) + bit / 8;
  *at = static_cast<std::uint8_t>(*at ^ 1U << bit % 8);
}

/// Presses into the ball, and rests there.
std::unique_ptr<Bench> pressing() {
  static const std::vector<FalconPacket> way = [] {
    std::vector<FalconPacket> packets;
    for (int i = 0; i < 300; ++i) packets.push_back(grip_at({11.0 - 0.02 * i, 0, 0}));
    return packets;
  }();
  auto bench = std::make_unique<Bench>();
  bench->load(ball());
  bench->device.answer = [](const Command&) { return way.front(); };
  bench->steps(400);
  bench->device.answer = [i = std::size_t{0}](const Command&) mutable { return way[std::min(i++, way.size() - 1)]; };
  bench->steps(350);
  return bench;
}

TEST(Loop, AFlippedBitOfItsStateStopsTheNextTickAndIsForgotten) {
  std::vector<std::size_t> bits;
  for (std::size_t bit = 0; bit < 8 * sizeof(core::TickState); bit += 97) bits.push_back(bit);
  for (std::size_t bit = 0; bit < 8 * sizeof(core::SupervisorMemory); bit += 5)
    bits.push_back(8 * offsetof(core::TickState, supervisor) + bit);
  for (const std::size_t bit : bits) {
    const auto bench = pressing();
    ASSERT_NE(bench->shown.get().out.commands, MotorCommands{}) << "else nothing is tested";
    flip(bench->loop.state(), bit);
    const TickRecord record = bench->step();
    EXPECT_EQ(record.out.commands, MotorCommands{}) << bit;
    EXPECT_EQ(record.out.faults, kFaultMemory) << bit;
    EXPECT_EQ(record.in.requests, kRequestRestart) << "a replay forgets what was damaged, too";
    EXPECT_EQ(record.in.heat, 0U) << "nobody knows it";
    EXPECT_EQ(bench->loop.take_damage(), Damage::kState);
    EXPECT_EQ(bench->step().in.lines, 0) << bit;
    EXPECT_EQ(bench->loop.take_damage(), Damage::kNone);
    bench->requests.ask(kRequestResume);
    bench->steps(20);
    EXPECT_EQ(bench->state(), SupervisorState::kActive) << bit;
  }
}

TEST(Loop, AFlippedBitOfItsModelStopsEveryTick) {
  for (std::size_t bit = 0; bit < 8 * sizeof(core::TickModel); bit += 97) {
    const auto bench = pressing();
    flip(bench->loop.model(), bit);
    for (int t = 0; t < 3; ++t) {
      const TickRecord record = bench->step();
      EXPECT_EQ(record.out.commands, MotorCommands{}) << bit;
      EXPECT_EQ(record.in.lines, kLineMemory) << bit;
      bench->requests.ask(kRequestResume);
    }
    EXPECT_EQ(bench->loop.take_damage(), Damage::kPrepared);
  }
}

TEST(Loop, AFlippedBitOfTheFieldThatIsFeltStopsTheSecondTickUntilAnotherFieldComes) {
  const auto bench = pressing();
  const FieldView& view = *bench->fields.published().view;
  flip(*view.brick(50, 30, 30), 3);
  static_cast<void>(bench->step());
  const TickRecord record = bench->step();
  EXPECT_EQ(record.out.commands, MotorCommands{});
  EXPECT_EQ(record.in.lines, kLineMemory);
  EXPECT_EQ(bench->loop.take_damage(), Damage::kField);
  bench->requests.ask(kRequestResume);
  EXPECT_EQ(bench->step().in.lines, kLineMemory);
  bench->load(ball());
  EXPECT_EQ(bench->step().in.lines, 0);
}

TEST(Loop, ItsViewOfTheFieldIsItsOwn) {
  const auto bench = pressing();
  const FieldView& view = *bench->fields.published().view;
  const MotorCommands before = bench->step().out.commands;
  flip(view.stiffness, 19);
  EXPECT_EQ(bench->step().out.commands, before);
  EXPECT_NE(bench->fields.damaged_in(7), 0U) << "the guard uses the other one";
}

}  // namespace
}  // namespace isotouch::loop
