#include "shared/packed_field.h"

#include <gtest/gtest.h>

#include <cstring>
#include <vector>

#include "shared/bytes.h"
#include "shared/crc32.h"
#include "shared/field_view.h"

namespace isotouch {
namespace {

constexpr std::uint32_t kBricks = 3;
constexpr std::size_t kFrame = 40;

/// Header, a root of one node, two nodes, bricks.
constexpr std::uint32_t image_bytes(std::uint32_t bricks) { return 832 + 128 * bricks; }

/// Byte for byte from SPEC.md 2 and 4.1, without the names of the layouts; the frame has the right outline and one raw block.
std::vector<std::uint8_t> valid_bytes(std::uint32_t bricks = kBricks) {
  std::vector<std::uint8_t> bytes(320 + kFrame);
  std::uint8_t* at = bytes.data();
  store_le<std::uint32_t>(at + 320, 0xFD2FB528);
  at[324] = 0x80;           // the content size has four bytes
  at[325] = (17 - 10) * 8;  // the window 2^17
  store_le<std::uint32_t>(at + 326, image_bytes(bricks) - 256);
  at[330] = (kFrame - 13) * 8 % 256 + 1;  // the last block, raw
  std::memcpy(at, "ITFP", 4);
  store_le<std::uint16_t>(at + 4, 1);
  store_le<std::uint32_t>(at + 8, 320);
  store_le<std::uint64_t>(at + 16, bytes.size());
  store_le<std::uint64_t>(at + 24, image_bytes(bricks));
  store_le<std::uint64_t>(at + 32, 0x0123456789ABCDEF);
  for (std::uint32_t stream = 0; stream < 3; ++stream) store_le<std::uint32_t>(at + 40 + 4 * stream, 18 + 20 * stream);
  store_le<std::uint32_t>(at + 52, 64 * bricks - 114);
  std::uint8_t* image = at + 64;
  std::memcpy(image, "ITFB", 4);
  store_le<std::uint16_t>(image + 4, 1);
  store_le<std::uint32_t>(image + 8, 256);
  store_le<std::uint64_t>(image + 16, image_bytes(bricks));
  store_le<std::int32_t>(image + 44, 1 << 20);  // 1 mm
  store_le<std::int32_t>(image + 48, 1 << 24);
  store_le<std::int32_t>(image + 52, 4 * 4096);
  store_le<std::int32_t>(image + 80, 1 << 16);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    store_le<std::uint32_t>(image + 56 + 4 * axis, 8);
    store_le<std::uint32_t>(image + 68 + 4 * axis, 1);
  }
  store_le<std::uint32_t>(image + 84, 2);
  store_le<std::uint32_t>(image + 88, bricks);
  store_le<std::uint32_t>(image + 92, 256);
  store_le<std::uint32_t>(image + 96, 320);
  store_le<std::uint32_t>(image + 100, 832);
  return bytes;
}

std::vector<std::uint8_t> sealed(std::vector<std::uint8_t> bytes) {
  store_le(bytes.data() + 12, crc32(bytes.data() + 16, bytes.size() - 16));
  return bytes;
}

TEST(PackedField, EveryFieldIsReadFromItsPlace) {
  const std::vector<std::uint8_t> bytes = sealed(valid_bytes());
  const Result<PackedField> packed = PackedField::parse(bytes);
  ASSERT_TRUE(packed) << describe(packed.error());
  EXPECT_EQ(packed->image_bytes, image_bytes(kBricks));
  EXPECT_EQ(packed->residual_bytes(), image_bytes(kBricks) - 256);
  EXPECT_EQ(packed->image_hash, 0x0123456789ABCDEFU);
  EXPECT_EQ(packed->stream_sizes, (StreamSizes{18, 38, 58, 78}));
  EXPECT_EQ(packed->image_header.data(), bytes.data() + 64);
  EXPECT_EQ(packed->image_header.size(), 256U);
  EXPECT_EQ(packed->frame.data(), bytes.data() + 320);
  EXPECT_EQ(packed->frame.size(), kFrame);
}

TEST(PackedField, EveryByteBehindTheChecksumIsCheckedByIt) {
  const std::vector<std::uint8_t> good = sealed(valid_bytes());
  for (std::size_t at = 24; at < good.size(); ++at) {
    std::vector<std::uint8_t> bytes = good;
    bytes[at] ^= 0x10;
    const Result<PackedField> packed = PackedField::parse(bytes);
    ASSERT_FALSE(packed) << at;
    EXPECT_EQ(packed.error(), Error::kBadChecksum) << at;
  }
}

TEST(PackedField, AnImageThatItsFrameCannotHoldIsRefused) {
  constexpr std::uint64_t kMax = 256 + kFrame * 32768;  // what the checks before allocation leave to a file of 360 bytes
  constexpr auto kMost = static_cast<std::uint32_t>((kMax - image_bytes(0)) / 128);
  for (const std::uint32_t more : {0U, 1U, 256U, 0x1000000U}) {
    const Result<PackedField> packed = PackedField::parse(sealed(valid_bytes(kMost + more)));
    EXPECT_EQ(packed.has_value(), more == 0) << more;
    EXPECT_TRUE(packed || packed.error() == Error::kBadSize) << more;
  }
}

TEST(PackedField, AnImageHeaderIsJudgedBeforeThereIsMemoryForTheImage) {
  constexpr std::size_t kImageHeader = 64;
  for (const std::size_t at : {8U, 16U, 44U, 48U, 56U, 80U}) {
    std::vector<std::uint8_t> bytes = valid_bytes();
    bytes[kImageHeader + at + 3] ^= 0x80;
    EXPECT_FALSE(PackedField::parse(sealed(bytes))) << at;
  }
}

TEST(PackedField, AFrameOfAnotherOutlineIsRefused) {
  for (const std::size_t at : {320U, 324U, 326U, 330U}) {
    std::vector<std::uint8_t> bytes = valid_bytes();
    bytes[at] ^= 0x08;
    EXPECT_EQ(PackedField::parse(sealed(bytes)).error(), Error::kBadFrame) << at;
  }
}

/// The field of three bricks with marks behind its frame.
std::vector<std::uint8_t> marked(const std::vector<std::uint8_t>& marks, std::uint32_t bricks = kBricks) {
  std::vector<std::uint8_t> bytes = valid_bytes(bricks);
  bytes.insert(bytes.end(), marks.begin(), marks.end());
  store_le<std::uint64_t>(bytes.data() + 16, bytes.size());
  store_le<std::uint32_t>(bytes.data() + 56, static_cast<std::uint32_t>(marks.size()));
  return sealed(bytes);
}

TEST(PackedField, MarksStandBehindTheFrame) {
  const std::vector<std::uint8_t> bytes = marked({0b100});
  const Result<PackedField> packed = PackedField::parse(bytes);
  ASSERT_TRUE(packed) << describe(packed.error());
  EXPECT_EQ(packed->frame.size(), kFrame);
  ASSERT_EQ(packed->marks.size(), 1U);
  EXPECT_EQ(packed->marks.data(), bytes.data() + 320 + kFrame);
  EXPECT_EQ(PackedField::parse(sealed(valid_bytes()))->marks.size(), 0U);
  EXPECT_TRUE(PackedField::parse(marked({0, 0b1}, 9)));
  EXPECT_TRUE(PackedField::parse(marked({0, 0x80}, 16)));
}

TEST(PackedField, MarksThatDoNotFitTheBricksAreRefused) {
  const auto refused = [](const std::vector<std::uint8_t>& marks, std::uint32_t bricks) {
    const Result<PackedField> packed = PackedField::parse(marked(marks, bricks));
    return !packed && packed.error() == Error::kBadMarks;
  };
  EXPECT_TRUE(refused({0b001}, 3)) << "far outside has no surface";
  EXPECT_TRUE(refused({0b010}, 3)) << "nor has far inside";
  EXPECT_TRUE(refused({0b1100}, 3)) << "of a brick that is not there";
  EXPECT_TRUE(refused({0b000}, 3)) << "no mark at all";
  EXPECT_TRUE(refused({0, 0}, 9));
  EXPECT_TRUE(refused({4, 0b10}, 9));
  EXPECT_TRUE(refused({4, 0}, 3)) << "too many bytes";
  EXPECT_TRUE(refused({4}, 9)) << "too few";
}

TEST(PackedField, MarksLongerThanTheFileAreRefused) {
  for (const std::uint32_t length : {1U, 41U, 0xFFFFFFFFU}) {
    std::vector<std::uint8_t> bytes = valid_bytes();
    store_le<std::uint32_t>(bytes.data() + 56, length);
    const Result<PackedField> packed = PackedField::parse(sealed(bytes));
    ASSERT_FALSE(packed) << length;
    EXPECT_EQ(packed.error(), length == 1 ? Error::kBadFrame : Error::kBadSize) << length;
  }
}

}  // namespace
}  // namespace isotouch
