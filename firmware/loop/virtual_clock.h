/// A time that passes only when it is told to.
#pragma once

#include "firmware/loop/clock.h"

namespace isotouch::loop {

class VirtualClock final : public Clock {
 public:
  std::int64_t now_ns() override { return now_; }
  void sleep_until_ns(std::int64_t when_ns) override {
    if (when_ns > now_) now_ = when_ns;
  }

  std::int64_t suspended_ns() override { return suspended_; }
  void suspend(std::int64_t ns) { suspended_ += ns; }

 private:
  std::int64_t now_ = 0, suspended_ = 0;
};

}  // namespace isotouch::loop
