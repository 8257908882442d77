/// libgpiod 1.5 and 1.6, as in Debian 12.
#include <gpiod.h>

#include <ctime>

#include "firmware/io/gpio.h"

namespace isotouch::io {

namespace {

constexpr const char* kOwner = "isotouchd";
constexpr int kMostEdges = 64;  // a contact that bounces

class Line final : public GpioLine {
 public:
  explicit Line(gpiod_line* line) : line_(line) {}
  ~Line() override { gpiod_line_release(line_); }
  Line(const Line&) = delete;
  Line& operator=(const Line&) = delete;

  int get() override { return gpiod_line_get_value(line_); }
  bool set(bool high) override { return gpiod_line_set_value(line_, high ? 1 : 0) == 0; }

  bool wait_edge(std::int64_t timeout_ns, std::int64_t& edge_ns) override {
    timespec timeout{static_cast<std::time_t>(timeout_ns / 1'000'000'000), static_cast<long>(timeout_ns % 1'000'000'000)};
    for (int edges = 0; edges < kMostEdges; ++edges) {
      const int there = gpiod_line_event_wait(line_, &timeout);
      if (there <= 0) return there == 0;
      gpiod_line_event event{};
      if (gpiod_line_event_read(line_, &event) != 0) return false;
      edge_ns = std::int64_t{event.ts.tv_sec} * 1'000'000'000 + event.ts.tv_nsec;
      timeout = {};
    }
    return true;
  }

 private:
  gpiod_line* line_;
};

class Chip final : public Gpio {
 public:
  explicit Chip(gpiod_chip* chip) : chip_(chip) {}
  ~Chip() override { gpiod_chip_close(chip_); }
  Chip(const Chip&) = delete;
  Chip& operator=(const Chip&) = delete;

  std::unique_ptr<GpioLine> input(unsigned offset, bool with_edges) override {
    gpiod_line* line = gpiod_chip_get_line(chip_, offset);
    if (line == nullptr) return nullptr;
    const int taken = with_edges ? gpiod_line_request_both_edges_events_flags(line, kOwner, GPIOD_LINE_REQUEST_FLAG_BIAS_PULL_DOWN)
                                 : gpiod_line_request_input_flags(line, kOwner, GPIOD_LINE_REQUEST_FLAG_BIAS_PULL_DOWN);
    return taken == 0 ? std::make_unique<Line>(line) : nullptr;
  }

  std::unique_ptr<GpioLine> output(unsigned offset) override {
    gpiod_line* line = gpiod_chip_get_line(chip_, offset);
    if (line == nullptr || gpiod_line_request_output(line, kOwner, 0) != 0) return nullptr;
    return std::make_unique<Line>(line);
  }

 private:
  gpiod_chip* chip_;
};

}  // namespace

std::unique_ptr<Gpio> open_gpio(const std::string& chip) {
  gpiod_chip* opened = gpiod_chip_open_lookup(chip.c_str());
  return opened != nullptr ? std::make_unique<Chip>(opened) : nullptr;
}

}  // namespace isotouch::io
