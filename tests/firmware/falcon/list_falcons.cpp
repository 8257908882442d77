/// Lists the Falcons of this machine through the real libusb, where there is none as well: its exit code is 1 unless there is a line for each, or one sentence.
#include <algorithm>
#include <cstdio>
#include <regex>
#include <sstream>
#include <string>

#include "firmware/falcon/falcon_list.h"

int main() {
  const isotouch::falcon::UsbListing listing = isotouch::falcon::list_falcons();
  const std::string said = isotouch::falcon::explain(listing);
  std::printf("%s\n", said.c_str());
  std::size_t lines = 0;
  std::istringstream text(said);
  for (std::string line; std::getline(text, line); ++lines) {
    if (!std::regex_match(line, std::regex(listing.falcons.empty() ? "no Falcon to list: .+" : "bus [0-9]+ device [0-9]+: .+"))) return 1;
  }
  return lines == std::max<std::size_t>(1, listing.falcons.size()) ? 0 : 1;
}
