#include "shared/bytes.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>

namespace isotouch {
namespace {

template <class T>
class Bytes : public testing::Test {};
using Widths =
    testing::Types<std::uint8_t, std::int8_t, std::uint16_t, std::int16_t, std::uint32_t, std::int32_t, std::uint64_t, std::int64_t>;
TYPED_TEST_SUITE(Bytes, Widths);

TYPED_TEST(Bytes, WhatIsStoredIsLoadedAtEveryAlignment) {
  std::array<std::uint8_t, 32> buffer{};
  using Limits = std::numeric_limits<TypeParam>;
  for (std::size_t at = 0; at < 16; ++at) {
    for (const TypeParam value : {TypeParam{0}, TypeParam{1}, Limits::min(), Limits::max(), static_cast<TypeParam>(Limits::max() / 3)}) {
      buffer.fill(0xAA);
      store_le(buffer.data() + at, value);
      EXPECT_EQ(load_le<TypeParam>(buffer.data() + at), value);
      for (std::size_t i = 0; i < buffer.size(); ++i) {
        if (i < at || i >= at + sizeof(TypeParam)) {
          ASSERT_EQ(buffer[i], 0xAA) << "a neighbour was written";
        }
      }
    }
  }
}

TEST(Bytes, TheLowestByteComesFirst) {
  constexpr std::array<std::uint8_t, 8> kBytes = {0x01, 0x02, 0x03, 0x84, 0x05, 0x06, 0x07, 0x88};
  static_assert(load_le<std::uint16_t>(kBytes.data()) == 0x0201);
  static_assert(load_le<std::uint32_t>(kBytes.data()) == 0x84030201);
  static_assert(load_le<std::int32_t>(kBytes.data()) == static_cast<std::int32_t>(0x84030201));
  static_assert(load_le<std::uint64_t>(kBytes.data()) == 0x8807060584030201);
  std::array<std::uint8_t, 4> out{};
  store_le(out.data(), std::int32_t{-2});
  EXPECT_EQ(out, (std::array<std::uint8_t, 4>{0xFE, 0xFF, 0xFF, 0xFF}));
}

}  // namespace
}  // namespace isotouch
