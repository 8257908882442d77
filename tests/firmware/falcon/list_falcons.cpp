/// Lists the Falcons of this machine through the real libusb, where there is none as well: its exit code is 1 unless there is a line for each, or one sentence.
#include <cstdio>
#include <string>

#include "firmware/falcon/falcon_list.h"

int main() {
  const isotouch::falcon::UsbListing listing = isotouch::falcon::list_falcons();
  const std::string said = isotouch::falcon::explain(listing);
  std::printf("%s\n", said.c_str());
  return said.starts_with(listing.falcons.empty() ? "no Falcon to list: " : "bus ") ? 0 : 1;
}
