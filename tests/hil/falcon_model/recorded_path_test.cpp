#include <gtest/gtest.h>

#include <stdexcept>

#include "hil/falcon_model/paths.h"
#include "tests/support/scratch_folder.h"

namespace isotouch::falcon_model {
namespace {

std::string little(std::uint64_t value, int bytes) {
  std::string text;
  for (int i = 0; i < bytes; ++i) text += static_cast<char>(value >> 8 * i & 0xFF);
  return text;
}

/// CRC-32 of IEEE 802.3.
std::uint32_t checksum(const std::string& text) {
  std::uint32_t state = 0xFFFFFFFFU;
  for (const char c : text) {
    state ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit) state = state >> 1 ^ ((state & 1U) != 0 ? 0xEDB88320U : 0U);
  }
  return ~state;
}

/// Two ticks of 2 ms: (1, 2, 3) and (3, 2, -1) mm, in the version of shared/SPEC.md, section 3.
std::string trace(char kind = 0, std::uint64_t count = 2, int major = 3) {
  std::string header = "ITRC" + little(static_cast<std::uint64_t>(major), 2) + little(0, 2) + little(256, 4) + little(104, 4) +
                       little(count, 8) + little(0, 8) + little(0, 4) + little(2'000'000, 4);
  header.resize(252);
  const auto record = [kind](int x, int y, int z) {
    std::string text(16, '\0');
    text[0] = kind;
    for (const int mm : {x, y, z}) text += little(static_cast<std::uint32_t>(mm * (1 << 20)), 4);
    text.resize(104);
    return text;
  };
  return header + little(checksum(header), 4) + record(1, 2, 3) + record(3, 2, -1);
}

TEST(RecordedPath, ATraceIsFollowedBetweenItsTicksAndHeldAtItsEnd) {
  const ScratchFolder folder;
  const Path path = recorded_path(folder.write("a.trace", trace()));
  EXPECT_EQ(path(0), (Vector{1, 2, 3}));
  EXPECT_EQ(path(1), (Vector{2, 2, 1}));
  EXPECT_EQ(path(2), (Vector{3, 2, -1}));
  EXPECT_EQ(path(500), (Vector{3, 2, -1}));
}

TEST(RecordedPath, WhatIsNoTraceOfPositionsIsRefusedWithItsName) {
  const ScratchFolder folder;
  const std::string good = trace();
  std::string other = good, damaged = good;
  other[0] = 'X';
  damaged[50] = 1;
  for (const std::string& content : {std::string(), good.substr(0, 40), good.substr(0, 400), other, damaged, trace(1), trace(0, 0),
                                     trace(0, 1ULL << 60), trace(0, 2, 1)}) {
    try {
      recorded_path(folder.write("bad.trace", content));
      ADD_FAILURE() << "taken";
    } catch (const std::runtime_error& e) {
      EXPECT_NE(std::string(e.what()).find("bad.trace: "), std::string::npos);
    }
  }
  EXPECT_THROW(recorded_path(folder.path() / "none.trace"), std::runtime_error);
}

}  // namespace
}  // namespace isotouch::falcon_model
