#include "firmware/falcon/falcon_link.h"

namespace isotouch::falcon {

const char* advice(LinkError error) {
  switch (error) {
    case LinkError::kNotFound: return "plug in its USB cable, or start the simulated one";
    case LinkError::kNotAllowed: return "install 60-isotouch-falcon.rules into /etc/udev/rules.d and plug it in again";
    case LinkError::kBusy: return "end the other program";
    case LinkError::kNoUsb: return "use a machine with USB, or let the container have /dev/bus/usb";
    case LinkError::kGone: return "plug it in again, it will be found";
    case LinkError::kUnsuitable: return "unplug it and try another one";
    default: return "unplug it, wait a moment and plug it in again";
  }
}

}  // namespace isotouch::falcon
