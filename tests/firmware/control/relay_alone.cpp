/// The relay as a program of its own: what `isotouchd relay SOCKET` does.
#include <cstdio>
#include <string>

#include "firmware/control/relay.h"

int main(int argc, char** argv) {
  const std::string refusal = argc == 2 ? isotouch::control::relay(argv[1], 0, 1) : "usage: relay_alone SOCKET";
  if (refusal.empty()) return 0;
  std::fprintf(stderr, "isotouchd: %s\n", refusal.c_str());
  return 1;
}
