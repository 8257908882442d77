#include <gpiod.h>

#include <ctime>
#include <map>

#include "tests/firmware/lines/fake_gpiod.h"

using isotouch::test::fake_chip;
using isotouch::test::FakeGpiodLine;
using isotouch::test::open_fake_chip;
using isotouch::test::request_fake_line;
using isotouch::test::take_fake_edge;

// The types that gpiod.h only names.
struct gpiod_chip {};
struct gpiod_line {
  unsigned offset;
};

namespace {

FakeGpiodLine& of(gpiod_line* line) { return fake_chip().lines[line->offset]; }

int request_input(gpiod_line* line, int flags, bool edges) {
  request_fake_line(line->offset, {.pulled_down = (flags & GPIOD_LINE_REQUEST_FLAG_BIAS_PULL_DOWN) != 0, .both_edges = edges});
  return 0;
}

}  // namespace

gpiod_chip* gpiod_chip_open_lookup(const char* name) {
  static gpiod_chip chip;
  return open_fake_chip(name) ? &chip : nullptr;
}

void gpiod_chip_close(gpiod_chip* /*chip*/) { fake_chip().opened = false; }

gpiod_line* gpiod_chip_get_line(gpiod_chip* /*chip*/, unsigned offset) {
  static std::map<unsigned, gpiod_line> lines;
  return &(lines[offset] = {offset});
}

int gpiod_line_request_both_edges_events_flags(gpiod_line* line, const char* /*owner*/, int flags) {
  return request_input(line, flags, true);
}

int gpiod_line_request_input_flags(gpiod_line* line, const char* /*owner*/, int flags) { return request_input(line, flags, false); }

int gpiod_line_request_output(gpiod_line* line, const char* /*owner*/, int level) {
  request_fake_line(line->offset, {.output = true, .level = level});
  return 0;
}

void gpiod_line_release(gpiod_line* line) { of(line).held = false; }

int gpiod_line_get_value(gpiod_line* line) { return of(line).level; }

int gpiod_line_set_value(gpiod_line* line, int level) {
  of(line).level = level;
  return 0;
}

int gpiod_line_event_wait(gpiod_line* line, const timespec* /*timeout*/) { return of(line).edge_ns != 0 ? 1 : 0; }

int gpiod_line_event_read(gpiod_line* line, gpiod_line_event* event) {
  const std::int64_t ns = take_fake_edge(line->offset);
  event->ts = {static_cast<std::time_t>(ns / 1'000'000'000), static_cast<long>(ns % 1'000'000'000)};
  return 0;
}
