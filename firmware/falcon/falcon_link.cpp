#include "firmware/falcon/falcon_link.h"

namespace isotouch::falcon {

const char* advice(Error error) {
  switch (error) {
    case Error::kNotFound: return "plug in its USB cable, or start the simulated one";
    case Error::kNotAllowed: return "install 60-isotouch-falcon.rules into /etc/udev/rules.d and plug it in again";
    case Error::kBusy: return "end the other program";
    case Error::kNoUsb: return "use a machine with USB, or let the container have /dev/bus/usb";
    case Error::kGone: return "plug it in again, it will be found";
    case Error::kUnsuitable: return "unplug it and try another one";
    default: return "unplug it, wait a moment and plug it in again";
  }
}

}  // namespace isotouch::falcon
