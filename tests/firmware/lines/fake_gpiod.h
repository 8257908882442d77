/// libgpiod without a kernel: its functions, as far as `firmware/lines` calls them, in front of one chip whose lines remember how they were requested.
/// Programs that link it never see a real chip.
#pragma once

#include <cerrno>
#include <cstdint>
#include <map>
#include <string>
#include <utility>

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

/// returns   false, and errno ENOENT: another chip, or a path to one
inline bool open_fake_chip(const std::string& name) {
  const bool there = name == "fakechip" || name == "/dev/fakechip";
  if (there) {
    fake_chip().opened = true;
  } else {
    errno = ENOENT;
  }
  return there;
}

/// Requests a line anew: nothing of an earlier request stays, and the level and the edge of an input are those that a test has set.
inline void request_fake_line(unsigned offset, FakeGpiodLine wish) {
  FakeGpiodLine& line = fake_chip().lines[offset];
  if (!wish.output) wish.level = line.level, wish.edge_ns = line.edge_ns;
  wish.held = true;
  line = wish;
}

/// The time of the edge that waits, which then waits no more.
inline std::int64_t take_fake_edge(unsigned offset) { return std::exchange(fake_chip().lines[offset].edge_ns, 0); }

}  // namespace isotouch::test
