/// The relay as a program of its own: what `isotouchd relay SOCKET` does.
#include <cstdio>

#include "firmware/control/relay.h"

int main(int argc, char** argv) {
  const isotouch::Refusal refusal = argc == 2 ? isotouch::control::relay(argv[1], 0, 1) : "usage: relay_alone SOCKET";
  if (!refusal) return 0;
  std::fprintf(stderr, "isotouchd: %s\n", refusal.sentence().c_str());
  return 1;
}
