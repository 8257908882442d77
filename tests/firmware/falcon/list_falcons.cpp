/// Lists the Falcons of this machine through the real libusb, where there is none as well: one sentence, and 1 as exit code.
#include <cstdio>

#include "firmware/falcon/falcon_list.h"

int main() {
  const isotouch::falcon::UsbListing listing = isotouch::falcon::list_falcons();
  std::printf("%s\n", isotouch::falcon::explain(listing).c_str());
  return listing.falcons.empty() ? 1 : 0;
}
