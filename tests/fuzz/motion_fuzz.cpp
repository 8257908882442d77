/// The door for tables of motion; it reads files, so each input becomes one in memory.
#include <sys/mman.h>
#include <unistd.h>

#include <cmath>
#include <string>

#include "host/error.h"
#include "host/motion/motion_csv.h"
#include "tests/fuzz/input.h"

using namespace isotouch;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const int file = memfd_create("motion", 0);
  fuzz::hold(file >= 0 && write(file, data, size) == static_cast<ssize_t>(size), "a file in memory can be written");
  try {
    motion::MotionColumns columns;
    columns.with_forces = size % 2 == 0;
    const auto points = motion::read_motion_csv("/proc/self/fd/" + std::to_string(file), columns);
    fuzz::hold(points.size() >= 2, "a motion has two places");
    for (std::size_t i = 1; i < points.size(); ++i) fuzz::hold(points[i].time > points[i - 1].time, "time rises");
    for (const auto& point : points) fuzz::hold(point.position.allFinite() && point.force.allFinite(), "numbers are finite");
  } catch (const InputError&) {  // refused with a sentence
  }
  close(file);
  return 0;
}
