/// Where this was built, there was no libgpiod.
#include <cerrno>

#include "firmware/io/gpio.h"

namespace isotouch::io {

std::unique_ptr<Gpio> open_gpio(const std::string& /*chip*/) {
  errno = ENOSYS;
  return nullptr;
}

}  // namespace isotouch::io
