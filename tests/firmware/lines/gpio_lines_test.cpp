#include "firmware/lines/gpio_lines.h"

#include <gtest/gtest.h>

#include <cerrno>
#include <map>

#include "firmware/loop/virtual_clock.h"

namespace isotouch::lines {
namespace {

/// A chip whose wires a test holds.
class FakeGpio final : public Gpio {
 public:
  struct Wire {
    int level = 0;
    bool output = false, edges = false;
    std::int64_t edge_ns = 0;  ///< waiting to be taken; 0 = none
    bool waits = true;
    bool takes = true;  ///< what is set
  };
  std::map<unsigned, Wire> wires;
  unsigned busy = 999;
  loop::VirtualClock clock;

  std::unique_ptr<GpioLine> input(unsigned offset, bool with_edges) override {
    wires[offset].edges = with_edges;
    return take(offset);
  }
  std::unique_ptr<GpioLine> output(unsigned offset) override {
    wires[offset].output = true;
    return take(offset);
  }

 private:
  struct Line final : GpioLine {
    Line(Wire& w, loop::Clock& c) : wire(w), clock(c) {}
    int get() override { return wire.level; }
    bool set(bool high) override {
      if (wire.takes) wire.level = high ? 1 : 0;
      return wire.output && wire.takes;
    }
    bool wait_edge(std::int64_t timeout_ns, std::int64_t& edge_ns) override {
      if (!wire.waits || !wire.edges) return false;
      if (wire.edge_ns == 0) clock.sleep_until_ns(clock.now_ns() + timeout_ns);
      if (wire.edge_ns != 0) edge_ns = wire.edge_ns;
      wire.edge_ns = 0;
      return true;
    }
    Wire& wire;
    loop::Clock& clock;
  };
  std::unique_ptr<GpioLine> take(unsigned offset) {
    errno = EBUSY;
    return offset == busy ? nullptr : std::make_unique<Line>(wires[offset], clock);
  }
};

constexpr GpioSettings kAll = {3, 4, 5, 6, 7};

TEST(GpioLines, EachWireIsTakenForWhatItIs) {
  FakeGpio chip;
  GpioLines lines(chip, chip.clock);
  ASSERT_EQ(lines.take(kAll).sentence(), "");
  EXPECT_TRUE(chip.wires[3].edges);
  EXPECT_FALSE(chip.wires[5].edges);
  for (const unsigned wire : {3U, 4U, 5U, 6U, 7U}) EXPECT_EQ(chip.wires[wire].output, wire == 4 || wire == 6 || wire == 7) << wire;
  lines.set({true, false, true});
  EXPECT_EQ(chip.wires[4].level, 1);
  EXPECT_EQ(chip.wires[6].level, 0);
  EXPECT_EQ(chip.wires[7].level, 1);
}

TEST(GpioLines, TheStopIsActiveLowAndWhatCannotBeReadIsAStop) {
  FakeGpio chip;
  GpioLines lines(chip, chip.clock);
  ASSERT_EQ(lines.take(kAll).sentence(), "");
  EXPECT_TRUE(lines.read().stop) << "a broken wire is low";
  chip.wires[3].level = 1;
  EXPECT_FALSE(lines.read().stop);
  chip.wires[3].level = -1;
  EXPECT_TRUE(lines.read().stop);
}

TEST(GpioLines, TheEnableIsReadBackAndWhatCannotBeReadIsWrong) {
  FakeGpio chip;
  GpioLines lines(chip, chip.clock);
  ASSERT_EQ(lines.take(kAll).sentence(), "");
  for (const bool enable : {false, true}) {
    lines.set({enable, false, false});
    for (const int level : {0, 1}) {
      chip.wires[5].level = level;
      EXPECT_EQ(lines.read().enabled, level == 1);
    }
    chip.wires[5].level = -1;
    EXPECT_NE(lines.read().enabled, enable);
  }
}

TEST(GpioLines, AnEnableThatTheChipDoesNotTakeIsWrongWithAndWithoutReadingBack) {
  for (const int back : {5, -1}) {
    FakeGpio chip;
    GpioLines lines(chip, chip.clock);
    ASSERT_EQ(lines.take({3, 4, back, 6, 7}).sentence(), "");
    for (const bool enable : {true, false}) {
      chip.wires[4].takes = true;
      lines.set({!enable, false, false});
      chip.wires[5].level = enable ? 1 : 0;  // as if it had worked
      chip.wires[4].takes = false;
      lines.set({enable, false, false});
      EXPECT_NE(lines.read().enabled, enable) << back;
    }
  }
}

TEST(GpioLines, AnEdgeEndsTheWaitAndTellsTheKernelsTime) {
  FakeGpio chip;
  GpioLines lines(chip, chip.clock);
  ASSERT_EQ(lines.take(kAll).sentence(), "");
  lines.wait(1'000'000);
  EXPECT_EQ(chip.clock.now_ns(), 1'000'000);
  EXPECT_EQ(lines.read().stop_edge_ns, 0);
  chip.wires[3].edge_ns = 1'234'567;
  lines.wait(2'000'000);
  EXPECT_EQ(chip.clock.now_ns(), 1'000'000);
  EXPECT_EQ(lines.read().stop_edge_ns, 1'234'567);
  chip.wires[3].waits = false;
  lines.wait(3'000'000);
  EXPECT_EQ(chip.clock.now_ns(), 3'000'000) << "a line that cannot be waited for does not make it busy";
}

TEST(GpioLines, WiresThatAreNotThereAreNotMissed) {
  FakeGpio chip;
  GpioLines lines(chip, chip.clock);
  ASSERT_EQ(lines.take({}).sentence(), "");
  lines.wait(500);
  EXPECT_EQ(chip.clock.now_ns(), 500);
  EXPECT_FALSE(lines.read().stop);
  lines.set({true, true, true});
  EXPECT_TRUE(lines.read().enabled);
  EXPECT_TRUE(chip.wires.empty());
}

TEST(GpioLines, ALineThatIsTakenAlreadyIsRefusedInOneSentence) {
  FakeGpio chip;
  chip.busy = 6;
  GpioLines lines(chip, chip.clock);
  EXPECT_EQ(lines.take(kAll).sentence(), "lines.heartbeat = 6: the line cannot be taken: Device or resource busy; name one that is free");
}

TEST(GpioLines, EverythingIsLowInTheEnd) {
  FakeGpio chip;
  {
    GpioLines lines(chip, chip.clock);
    ASSERT_EQ(lines.take(kAll).sentence(), "");
    lines.set({true, true, true});
  }
  for (const unsigned wire : {4U, 6U, 7U}) EXPECT_EQ(chip.wires[wire].level, 0);
}

TEST(GpioLines, AChipThatIsNotThereIsNone) {
  EXPECT_EQ(open_gpio("gpiochip_of_nobody"), nullptr);
  EXPECT_NE(errno, 0);
}

}  // namespace
}  // namespace isotouch::lines
