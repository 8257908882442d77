/// libgpiod without a kernel: its functions, as far as `firmware/lines` calls them, in front of one chip whose lines remember how they were requested.
/// Programs that link it never see a real chip.
#pragma once

#include <cstdint>
#include <map>
#include <string>

namespace isotouch::test {

struct FakeGpiodLine {
  bool output = false;
  bool pulled_down = false;
  bool both_edges = false;
  int level = 0;             ///< of an input set by a test; of an output as it was requested or set
  std::int64_t edge_ns = 0;  ///< waiting to be taken; 0 = none
  bool held = false;         ///< requested, and not released
};

struct FakeChip {
  std::map<unsigned, FakeGpiodLine> lines;
  bool opened = false;
};

/// The chip "fakechip", the only one there is. Empty it at the start of every test.
inline FakeChip& fake_chip() {
  static FakeChip chip;
  return chip;
}

/// returns   false: another chip, or a path to one
inline bool is_fake_chip(const std::string& name) { return name == "fakechip" || name == "/dev/fakechip"; }

}  // namespace isotouch::test
