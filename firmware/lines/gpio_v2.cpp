/// libgpiod 2, as in Debian 13.
#include <gpiod.h>

#include <cstddef>
#include <utility>

#include "firmware/lines/gpio.h"
#include "shared/files/c_deleter.h"

namespace isotouch::lines {

namespace {

constexpr const char* kOwner = "isotouchd";
constexpr std::size_t kEdges = 16;
constexpr int kMaxReads = 4;  // of so many edges: a contact that bounces

using Settings = std::unique_ptr<gpiod_line_settings, files::CDeleter<gpiod_line_settings_free>>;
using Config = std::unique_ptr<gpiod_line_config, files::CDeleter<gpiod_line_config_free>>;
using Wish = std::unique_ptr<gpiod_request_config, files::CDeleter<gpiod_request_config_free>>;
using Request = std::unique_ptr<gpiod_line_request, files::CDeleter<gpiod_line_request_release>>;
using OpenChip = std::unique_ptr<gpiod_chip, files::CDeleter<gpiod_chip_close>>;
using Edges = std::unique_ptr<gpiod_edge_event_buffer, files::CDeleter<gpiod_edge_event_buffer_free>>;

class Line final : public GpioLine {
 public:
  Line(Request request, unsigned offset) : request_(std::move(request)), offset_(offset), edges_(gpiod_edge_event_buffer_new(kEdges)) {}

  int get() override { return gpiod_line_request_get_value(request_.get(), offset_); }
  bool set(bool high) override {
    return gpiod_line_request_set_value(request_.get(), offset_, high ? GPIOD_LINE_VALUE_ACTIVE : GPIOD_LINE_VALUE_INACTIVE) == 0;
  }

  bool wait_edge(std::int64_t timeout_ns, std::int64_t& edge_ns) override {
    if (edges_ == nullptr) return false;
    for (int reads = 0; reads < kMaxReads; ++reads) {
      const int there = gpiod_line_request_wait_edge_events(request_.get(), timeout_ns);
      if (there <= 0) return there == 0;
      const int count = gpiod_line_request_read_edge_events(request_.get(), edges_.get(), kEdges);
      if (count <= 0) return false;
      gpiod_edge_event* last = gpiod_edge_event_buffer_get_event(edges_.get(), static_cast<unsigned long>(count) - 1);
      edge_ns = static_cast<std::int64_t>(gpiod_edge_event_get_timestamp_ns(last));
      timeout_ns = 0;
    }
    return true;
  }

 private:
  Request request_;
  unsigned offset_;
  Edges edges_;
};

class Chip final : public Gpio {
 public:
  explicit Chip(OpenChip chip) : chip_(std::move(chip)) {}

  std::unique_ptr<GpioLine> input(unsigned offset, bool with_edges) override {
    return take(offset, [with_edges](gpiod_line_settings* settings) {
      return gpiod_line_settings_set_direction(settings, GPIOD_LINE_DIRECTION_INPUT) == 0 &&
             gpiod_line_settings_set_bias(settings, GPIOD_LINE_BIAS_PULL_DOWN) == 0 &&
             gpiod_line_settings_set_edge_detection(settings, with_edges ? GPIOD_LINE_EDGE_BOTH : GPIOD_LINE_EDGE_NONE) == 0;
    });
  }

  std::unique_ptr<GpioLine> output(unsigned offset) override {
    return take(offset, [](gpiod_line_settings* settings) {
      return gpiod_line_settings_set_direction(settings, GPIOD_LINE_DIRECTION_OUTPUT) == 0 &&
             gpiod_line_settings_set_output_value(settings, GPIOD_LINE_VALUE_INACTIVE) == 0;
    });
  }

 private:
  template <class Set>
  std::unique_ptr<GpioLine> take(unsigned offset, Set set) {
    const Settings settings(gpiod_line_settings_new());
    const Config config(gpiod_line_config_new());
    const Wish wish(gpiod_request_config_new());
    if (!settings || !config || !wish || !set(settings.get())) return nullptr;
    if (gpiod_line_config_add_line_settings(config.get(), &offset, 1, settings.get()) != 0) return nullptr;
    gpiod_request_config_set_consumer(wish.get(), kOwner);
    Request request(gpiod_chip_request_lines(chip_.get(), wish.get(), config.get()));
    return request ? std::make_unique<Line>(std::move(request), offset) : nullptr;
  }

  OpenChip chip_;
};

}  // namespace

std::unique_ptr<Gpio> open_gpio(const std::string& chip) {
  const std::string path = chip.find('/') == std::string::npos ? "/dev/" + chip : chip;
  OpenChip opened(gpiod_chip_open(path.c_str()));
  return opened ? std::make_unique<Chip>(std::move(opened)) : nullptr;
}

}  // namespace isotouch::lines
