#include "shared/hash64.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

namespace isotouch {
namespace {

std::uint64_t hash_of(std::string_view text) { return hash64(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()); }

std::vector<std::uint8_t> ramp(std::size_t size) {
  std::vector<std::uint8_t> bytes(size);
  for (std::size_t i = 0; i < size; ++i) bytes[i] = static_cast<std::uint8_t>(i % 251);
  return bytes;
}

TEST(Hash64, AgreesWithPublishedVectors) {
  EXPECT_EQ(hash_of(""), 0xEF46DB3751D8E999U);
  EXPECT_EQ(hash_of("a"), 0xD24EC4F1A98C6E5BU);
  EXPECT_EQ(hash_of("abc"), 0x44BC2CF5AD770999U);
  EXPECT_EQ(hash64(nullptr, 0, 2654435761U), 0xAC75FDA2929B17EFU);
}

/// The bytes 0, 1, 2 … 250, 0 … in lengths that end in each of the algorithm's tails; digits from `xxhsum -H1` 0.8.1.
TEST(Hash64, AgreesWithXxhsumAtEveryTail) {
  const std::vector<std::pair<std::size_t, std::uint64_t>> expected = {
      {1, 0xE934A84ADB052768U},   {3, 0xE5C7BB4533BC65DDU},   {4, 0xFFCED8604453CC1EU},  {5, 0xDD0274386E26030CU},
      {7, 0x14CC643F630C72D2U},   {8, 0x884A173614B81B8DU},   {9, 0x67D85784A7C78C5BU},  {12, 0x424AF23F1F08DCA5U},
      {15, 0xA948F5F0F6ABAC2DU},  {16, 0x44B6EF2FB84169F7U},  {31, 0xC346D2B59B4D8EE1U}, {32, 0xCBF59C5116FF32B4U},
      {33, 0x0C535D1ACAFB8EADU},  {39, 0x00A396EF1679A859U},  {40, 0xF5DA40F1B11741E9U}, {47, 0x0D9883A03E7BFBB8U},
      {63, 0xE26AA9E2A95F8E4FU},  {64, 0xF7C67301DB6713F0U},  {65, 0xC31EB63B2AE4465BU}, {100, 0x6AC1E58032166597U},
      {255, 0x566D96B832B967C1U}, {1000, 0xF306F04AA88B54D3U}};
  for (const auto& [size, hash] : expected) EXPECT_EQ(hash64(ramp(size).data(), size), hash) << size;
}

TEST(Hash64, DependsOnTheSeedTheLengthAndEveryBit) {
  std::set<std::uint64_t> seen;
  std::size_t tried = 0;
  auto bytes = ramp(72);
  for (std::uint64_t seed = 0; seed < 64; ++seed, ++tried) seen.insert(hash64(bytes.data(), bytes.size(), std::uint64_t{1} << seed));
  for (std::size_t size = 0; size <= bytes.size(); ++size, ++tried) seen.insert(hash64(bytes.data(), size));
  for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit, ++tried) {
    bytes[bit / 8] ^= static_cast<std::uint8_t>(1U << (bit % 8));
    seen.insert(hash64(bytes.data(), bytes.size()));
    bytes[bit / 8] ^= static_cast<std::uint8_t>(1U << (bit % 8));
  }
  EXPECT_EQ(seen.size(), tried);
}

TEST(Hash64, TheAlignmentOfTheBytesDoesNotMatter) {
  const auto bytes = ramp(72);
  for (std::size_t shift = 0; shift < 8; ++shift) {
    std::vector<std::uint8_t> moved(bytes.size() + shift);
    std::copy(bytes.begin(), bytes.end(), moved.begin() + static_cast<std::ptrdiff_t>(shift));
    EXPECT_EQ(hash64(moved.data() + shift, bytes.size()), hash64(bytes.data(), bytes.size()));
  }
}

}  // namespace
}  // namespace isotouch
