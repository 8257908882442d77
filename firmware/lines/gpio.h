/// The seam to the wires of a GPIO chip. Behind it stands libgpiod, of which the first and the second edition share no function: `gpio_v1.cpp` and
/// `gpio_v2.cpp`, chosen by what is installed; `without_gpio.cpp` where neither is.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

namespace isotouch::lines {

/// One wire, taken by this program until the object goes. What an output does then is the chip's affair: most keep their level.
class GpioLine {
 public:
  virtual ~GpioLine() = default;

  /// returns   1 high, 0 low, -1 it cannot be read
  virtual int get() = 0;

  /// fails     false; of an output only
  virtual bool set(bool high) = 0;

  /// Waits for an edge, and takes all that there are; of an input that was taken with edges.
  ///
  /// timeout_ns  0: does not wait
  /// edge_ns     when the last one was, by the kernel, CLOCK_MONOTONIC; unchanged without one
  /// fails       false: it cannot be waited for
  virtual bool wait_edge(std::int64_t timeout_ns, std::int64_t& edge_ns) = 0;
};

class Gpio {
 public:
  virtual ~Gpio() = default;

  /// An input with the chip's resistor to ground, where it has one: a wire that is broken is low.
  ///
  /// fails     nullptr: errno tells why
  virtual std::unique_ptr<GpioLine> input(unsigned offset, bool with_edges) = 0;

  /// An output, low at first.
  ///
  /// fails     nullptr: errno tells why
  virtual std::unique_ptr<GpioLine> output(unsigned offset) = 0;
};

/// chip      "gpiochip0", or a path in /dev
/// fails     nullptr: errno tells why; EACCES: this user may not
std::unique_ptr<Gpio> open_gpio(const std::string& chip);

}  // namespace isotouch::lines
