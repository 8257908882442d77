/// The driver's link straight to the simulated Falcon's core, without a socket and with a clock of its own: runs are the same every time.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include "firmware/falcon/falcon_link.h"
#include "firmware/loop/clock.h"
#include "hil/falcon_model/simulated_falcon.h"

namespace isotouch::test {

class ModelClock final : public loop::Clock {
 public:
  std::int64_t now_ns() override { return now; }
  void sleep_until_ns(std::int64_t when_ns) override { now = std::max(now, when_ns); }
  std::int64_t now = 0;
};

class ModelLink final : public falcon::FalconLink {
 public:
  ModelLink(falcon_model::Settings settings, ModelClock& clock) : falcon(std::move(settings)), clock_(clock) {}

  falcon_model::SimulatedFalcon falcon;

  falcon::LinkResult<void> open() override {
    if (!falcon.open()) return falcon::LinkError::kNotFound;
    open_ = true;
    return {};
  }
  void close() override { open_ = false; }
  bool is_open() const override { return open_; }
  const falcon::FalconIdentity& identity() const override { return identity_; }

  falcon::LinkResult<std::size_t> control(const falcon::UsbSetup& setup, std::span<std::uint8_t> answer) override {
    if (!there()) return falcon::LinkError::kGone;
    const falcon_model::ControlAnswer got = falcon.control(setup);
    if (got.stalled) return falcon::LinkError::kStalled;
    const std::size_t size = std::min(answer.size(), got.data.size());
    std::copy_n(got.data.begin(), size, answer.begin());
    return size;
  }

  falcon::LinkResult<std::size_t> write(std::span<const std::uint8_t> data, std::uint32_t /*timeout_ms*/) override {
    if (!there()) return falcon::LinkError::kGone;
    return falcon.write(data);
  }

  /// Data at once; else a bare status pair after a millisecond, when there is time for it.
  falcon::LinkResult<std::size_t> read(std::span<std::uint8_t> buffer, std::uint32_t timeout_ms) override {
    if (!there()) return falcon::LinkError::kGone;
    if (!falcon.has_data() && timeout_ms == 0) return falcon::LinkError::kTimedOut;
    const falcon_model::Bytes transfer = falcon.read(buffer.size());
    if (transfer.empty()) return falcon::LinkError::kGone;
    if (transfer.size() <= 2 && timeout_ms > 0) clock_.now += 1'000'000;
    std::copy(transfer.begin(), transfer.end(), buffer.begin());
    return transfer.size();
  }

 private:
  bool there() const { return open_ && falcon.present(); }

  ModelClock& clock_;
  falcon::FalconIdentity identity_;
  bool open_ = false;
};

}  // namespace isotouch::test
