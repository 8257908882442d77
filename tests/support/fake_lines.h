/// Lines whose ends a test holds.
#pragma once

#include <algorithm>
#include <cstdint>

#include "firmware/loop/clock.h"
#include "firmware/loop/safety_lines.h"

namespace isotouch::test {

class FakeLines final : public loop::SafetyLines {
 public:
  explicit FakeLines(loop::Clock& clock) : clock_(clock) {}

  bool pressed = false;
  bool stuck_on = false, stuck_off = false;  ///< the enable's relay
  loop::LineOutputs out;
  std::int64_t edge_ns = 0;   ///< of the stop
  bool sleeps = true;         ///< else somebody else moves the time
  std::int64_t edges_ns = 0;  ///< so long after a wait begins, an edge ends it; 0: none does

  void wait(std::int64_t until_ns) override {
    if (sleeps) clock_.sleep_until_ns(edges_ns > 0 ? std::min(until_ns, clock_.now_ns() + edges_ns) : until_ns);
  }
  loop::LineInputs read() override {
    if (pressed != was_pressed_) edge_ns = clock_.now_ns();
    was_pressed_ = pressed;
    return {pressed, (out.enable || stuck_on) && !stuck_off, edge_ns};
  }
  void set(const loop::LineOutputs& outputs) override { out = outputs; }

 private:
  loop::Clock& clock_;
  bool was_pressed_ = false;
};

}  // namespace isotouch::test
