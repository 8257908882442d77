#include <gpiod.h>

#include "tests/firmware/lines/fake_gpiod.h"

using isotouch::test::fake_chip;
using isotouch::test::FakeGpiodLine;
using isotouch::test::open_fake_chip;
using isotouch::test::request_fake_line;
using isotouch::test::take_fake_edge;

// The types that gpiod.h only names.
struct gpiod_chip {};
struct gpiod_line_settings {
  FakeGpiodLine line;
};
struct gpiod_line_config {
  unsigned offset;
  FakeGpiodLine line;
};
struct gpiod_request_config {};
struct gpiod_line_request {
  unsigned offset;
};
struct gpiod_edge_event {
  std::int64_t ns;
};
struct gpiod_edge_event_buffer {
  gpiod_edge_event event;
};

gpiod_chip* gpiod_chip_open(const char* path) {
  static gpiod_chip chip;
  return open_fake_chip(path) ? &chip : nullptr;
}

void gpiod_chip_close(gpiod_chip* /*chip*/) { fake_chip().opened = false; }

gpiod_line_settings* gpiod_line_settings_new() { return new gpiod_line_settings; }
void gpiod_line_settings_free(gpiod_line_settings* settings) { delete settings; }
gpiod_line_config* gpiod_line_config_new() { return new gpiod_line_config{}; }
void gpiod_line_config_free(gpiod_line_config* config) { delete config; }
gpiod_request_config* gpiod_request_config_new() { return new gpiod_request_config; }
void gpiod_request_config_free(gpiod_request_config* config) { delete config; }
void gpiod_request_config_set_consumer(gpiod_request_config* /*config*/, const char* /*consumer*/) {}
gpiod_edge_event_buffer* gpiod_edge_event_buffer_new(size_t /*capacity*/) { return new gpiod_edge_event_buffer{}; }
void gpiod_edge_event_buffer_free(gpiod_edge_event_buffer* buffer) { delete buffer; }

int gpiod_line_settings_set_direction(gpiod_line_settings* settings, gpiod_line_direction direction) {
  settings->line.output = direction == GPIOD_LINE_DIRECTION_OUTPUT;
  return 0;
}

int gpiod_line_settings_set_bias(gpiod_line_settings* settings, gpiod_line_bias bias) {
  settings->line.pulled_down = bias == GPIOD_LINE_BIAS_PULL_DOWN;
  return 0;
}

int gpiod_line_settings_set_edge_detection(gpiod_line_settings* settings, gpiod_line_edge edge) {
  settings->line.both_edges = edge == GPIOD_LINE_EDGE_BOTH;
  return 0;
}

int gpiod_line_settings_set_output_value(gpiod_line_settings* settings, gpiod_line_value value) {
  settings->line.level = value == GPIOD_LINE_VALUE_ACTIVE ? 1 : 0;
  return 0;
}

int gpiod_line_config_add_line_settings(gpiod_line_config* config, const unsigned* offsets, size_t /*count*/,
                                        gpiod_line_settings* settings) {
  *config = {*offsets, settings->line};
  return 0;
}

gpiod_line_request* gpiod_chip_request_lines(gpiod_chip* /*chip*/, gpiod_request_config* /*wish*/, gpiod_line_config* config) {
  request_fake_line(config->offset, config->line);
  return new gpiod_line_request{config->offset};
}

void gpiod_line_request_release(gpiod_line_request* request) {
  fake_chip().lines[request->offset].held = false;
  delete request;
}

gpiod_line_value gpiod_line_request_get_value(gpiod_line_request* /*request*/, unsigned offset) {
  return fake_chip().lines[offset].level == 1 ? GPIOD_LINE_VALUE_ACTIVE : GPIOD_LINE_VALUE_INACTIVE;
}

int gpiod_line_request_set_value(gpiod_line_request* /*request*/, unsigned offset, gpiod_line_value value) {
  fake_chip().lines[offset].level = value == GPIOD_LINE_VALUE_ACTIVE ? 1 : 0;
  return 0;
}

int gpiod_line_request_wait_edge_events(gpiod_line_request* request, int64_t /*timeout_ns*/) {
  return fake_chip().lines[request->offset].edge_ns != 0 ? 1 : 0;
}

int gpiod_line_request_read_edge_events(gpiod_line_request* request, gpiod_edge_event_buffer* buffer, size_t /*most*/) {
  buffer->event.ns = take_fake_edge(request->offset);
  return 1;
}

gpiod_edge_event* gpiod_edge_event_buffer_get_event(gpiod_edge_event_buffer* buffer, unsigned long /*index*/) { return &buffer->event; }

uint64_t gpiod_edge_event_get_timestamp_ns(gpiod_edge_event* event) { return static_cast<uint64_t>(event->ns); }
