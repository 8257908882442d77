#include "shared/crc32.h"

#include <gtest/gtest.h>

#include <numeric>
#include <string_view>
#include <vector>

namespace isotouch {
namespace {

std::uint32_t crc_of(std::string_view text) { return crc32(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()); }

std::vector<std::uint8_t> ramp(std::size_t size) {
  std::vector<std::uint8_t> bytes(size);
  std::iota(bytes.begin(), bytes.end(), std::uint8_t{3});
  return bytes;
}

TEST(Crc32, AgreesWithPublishedVectors) {
  EXPECT_EQ(crc_of(""), 0U);
  EXPECT_EQ(crc_of("a"), 0xE8B7BE43U);
  EXPECT_EQ(crc_of("123456789"), 0xCBF43926U);
  EXPECT_EQ(crc_of("The quick brown fox jumps over the lazy dog"), 0x414FA339U);
}

TEST(Crc32, PiecesGiveTheSameAsTheWhole) {
  const auto bytes = ramp(100);
  const std::uint32_t whole = crc32(bytes.data(), bytes.size());
  for (std::size_t cut = 0; cut <= bytes.size(); ++cut) {
    EXPECT_EQ(crc32(bytes.data() + cut, bytes.size() - cut, crc32(bytes.data(), cut)), whole) << cut;
  }
}

TEST(Crc32, ALongPieceIsThatOfItsBytesOneByOne) {
  const auto bytes = ramp(67);
  std::uint32_t one_by_one = 0;
  for (std::size_t n = 0; n < bytes.size(); ++n) {
    EXPECT_EQ(crc32(bytes.data(), n), one_by_one) << n;
    one_by_one = crc32(bytes.data() + n, 1, one_by_one);
  }
}

TEST(Crc32, EveryFlippedBitIsSeen) {
  auto bytes = ramp(256);
  const std::uint32_t whole = crc32(bytes.data(), bytes.size());
  for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
    const auto mask = static_cast<std::uint8_t>(1U << (bit % 8));
    bytes[bit / 8] ^= mask;
    EXPECT_NE(crc32(bytes.data(), bytes.size()), whole) << bit;
    bytes[bit / 8] ^= mask;
  }
}

}  // namespace
}  // namespace isotouch
