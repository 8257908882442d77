#include "shared/files/standard_descriptors.h"

#include <fcntl.h>
#include <unistd.h>

namespace isotouch::files {

void occupy_standard_descriptors() {
  for (int descriptor = STDIN_FILENO; descriptor <= STDERR_FILENO; ++descriptor) {
    if (fcntl(descriptor, F_GETFD) >= 0) continue;
    static_cast<void>(open("/dev/null", descriptor == STDIN_FILENO ? O_WRONLY : O_RDONLY));  // open takes the lowest number that is free
  }
}

}  // namespace isotouch::files
