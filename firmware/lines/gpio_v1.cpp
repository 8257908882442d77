/// libgpiod 1.5 and 1.6, as in Debian 12.
#include <gpiod.h>

#include <ctime>
#include <utility>

#include "firmware/lines/gpio.h"
#include "shared/files/c_deleter.h"

namespace isotouch::lines {

namespace {

constexpr const char* kOwner = "isotouchd";
constexpr int kMaxEdges = 64;  // a contact that bounces

using OpenChip = std::unique_ptr<gpiod_chip, files::CDeleter<gpiod_chip_close>>;
using TakenLine = std::unique_ptr<gpiod_line, files::CDeleter<gpiod_line_release>>;

class Line final : public GpioLine {
 public:
  explicit Line(TakenLine line) : line_(std::move(line)) {}

  int get() override { return gpiod_line_get_value(line_.get()); }
  bool set(bool high) override { return gpiod_line_set_value(line_.get(), high ? 1 : 0) == 0; }

  bool wait_edge(std::int64_t timeout_ns, std::int64_t& edge_ns) override {
    timespec timeout{static_cast<std::time_t>(timeout_ns / 1'000'000'000), static_cast<long>(timeout_ns % 1'000'000'000)};
    for (int edges = 0; edges < kMaxEdges; ++edges) {
      const int there = gpiod_line_event_wait(line_.get(), &timeout);
      if (there <= 0) return there == 0;
      gpiod_line_event event{};
      if (gpiod_line_event_read(line_.get(), &event) != 0) return false;
      edge_ns = std::int64_t{event.ts.tv_sec} * 1'000'000'000 + event.ts.tv_nsec;
      timeout = {};
    }
    return true;
  }

 private:
  TakenLine line_;
};

class Chip final : public Gpio {
 public:
  explicit Chip(OpenChip chip) : chip_(std::move(chip)) {}

  std::unique_ptr<GpioLine> input(unsigned offset, bool with_edges) override {
    return take(offset, [with_edges](gpiod_line* line) {
      return with_edges ? gpiod_line_request_both_edges_events_flags(line, kOwner, GPIOD_LINE_REQUEST_FLAG_BIAS_PULL_DOWN)
                        : gpiod_line_request_input_flags(line, kOwner, GPIOD_LINE_REQUEST_FLAG_BIAS_PULL_DOWN);
    });
  }

  std::unique_ptr<GpioLine> output(unsigned offset) override {
    return take(offset, [](gpiod_line* line) { return gpiod_line_request_output(line, kOwner, 0); });
  }

 private:
  template <class Request>
  std::unique_ptr<GpioLine> take(unsigned offset, Request request) {
    gpiod_line* line = gpiod_chip_get_line(chip_.get(), offset);
    return line != nullptr && request(line) == 0 ? std::make_unique<Line>(TakenLine(line)) : nullptr;
  }

  OpenChip chip_;
};

}  // namespace

std::unique_ptr<Gpio> open_gpio(const std::string& chip) {
  OpenChip opened(gpiod_chip_open_lookup(chip.c_str()));
  return opened ? std::make_unique<Chip>(std::move(opened)) : nullptr;
}

}  // namespace isotouch::lines
