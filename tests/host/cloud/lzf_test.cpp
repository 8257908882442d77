#include "host/cloud/lzf.h"

#include <gtest/gtest.h>

#include <string>

namespace isotouch::cloud {
namespace {

std::optional<std::string> unpacked(const std::string& packed, std::size_t size) {
  const auto bytes = unpack_lzf({reinterpret_cast<const std::uint8_t*>(packed.data()), packed.size()}, size);
  if (!bytes) return std::nullopt;
  return std::string(bytes->begin(), bytes->end());
}

TEST(Lzf, BytesAsTheyAreAndRepetitions) {
  EXPECT_EQ(unpacked("", 0), "");
  EXPECT_EQ(unpacked(std::string("\2abc", 4), 3), "abc");
  EXPECT_EQ(unpacked(std::string("\2abc\x20\2", 6), 6), "abcabc");                                    // 3 bytes, 3 back
  EXPECT_EQ(unpacked(std::string("\0a\x60\0", 4), 6), "aaaaaa");                                      // 5 bytes, 1 back: over its own end
  EXPECT_EQ(unpacked(std::string("\0a\xe0\xff\0", 5), 265), std::string(265, 'a'));                   // the longest: 264
  EXPECT_EQ(unpacked(std::string("\1ab\xe0\xff\1\xe0\xff\1\x20\1\x21\x0f", 13), 536)->size(), 536U);  // 272 back
}

TEST(Lzf, DamagedBytesAreRefused) {
  EXPECT_FALSE(unpacked(std::string("\2ab", 3), 3));         // ends within bytes
  EXPECT_FALSE(unpacked(std::string("\2abc\x20", 5), 6));    // ends within a repetition
  EXPECT_FALSE(unpacked(std::string("\2abc\xe0", 5), 20));   // ends before its length
  EXPECT_FALSE(unpacked(std::string("\2abc\x20\3", 6), 6));  // from before the beginning
  EXPECT_FALSE(unpacked(std::string("\2abc\x20\2", 6), 5));  // more than stated
  EXPECT_FALSE(unpacked(std::string("\2abc\x20\2", 6), 7));  // less than stated
  EXPECT_FALSE(unpacked(std::string("\2abc", 4), 2));
  EXPECT_FALSE(unpacked(std::string("\2abc", 4), ~std::size_t{0}));  // no memory is taken for what cannot come out
}

}  // namespace
}  // namespace isotouch::cloud
