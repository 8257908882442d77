#include "shared/field_view.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <string>
#include <vector>

#include "shared/bytes.h"
#include "shared/crc32.h"
#include "shared/hash64.h"

namespace isotouch {
namespace {

/// An image whose length is exact, so that a sanitizer sees every byte read behind it.
class Image {
 public:
  explicit Image(std::size_t bytes) : words_(static_cast<std::uint8_t*>(std::calloc(1, bytes))), size_(bytes) {}
  Image(const Image& other) : Image(other.size_) { std::memcpy(words_, other.words_, size_); }
  Image& operator=(const Image&) = delete;
  ~Image() { std::free(words_); }

  std::uint8_t* at(std::size_t offset) { return words_ + offset; }
  std::size_t size() const { return size_; }
  std::span<const std::uint8_t> bytes() const { return {words_, size_}; }

  template <class T>
  Image& put(std::size_t offset, T value) {
    store_le(at(offset), value);
    return *this;
  }
  /// Makes the checksum right again: the attacker knows the format too.
  Image& seal() { return put(12, crc32(words_ + 16, size_ - 16)); }
  Image resized(std::size_t bytes) const {
    Image other(bytes);
    std::memcpy(other.words_, words_, std::min(bytes, size_));
    return other;
  }

 private:
  std::uint8_t* words_;
  std::size_t size_;
};

constexpr std::uint32_t kRootAt = 256, kNodesAt = 320, kNodeBytes = 256, kNodes = 3;
constexpr std::uint32_t kBricksAt = kNodesAt + kNodes * kNodeBytes, kBrickBytes = 128, kBricks = 10;
constexpr std::size_t kTotal = kBricksAt + kBricks * kBrickBytes;
constexpr std::int16_t kBand = 4 * 4096;

/// Byte for byte from SPEC.md, without the names of image_layout: 8 samples a side, one stored node with eight bricks, a cube of 4 samples inside.
Image valid_image() {
  Image image(kTotal);
  std::memcpy(image.at(0), "ITFB", 4);
  image.put<std::uint16_t>(4, 1).put<std::uint16_t>(6, 0).put<std::uint32_t>(8, 256).put<std::uint64_t>(16, kTotal);
  image.put<std::uint64_t>(24, 0x0123456789ABCDEF);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    image.put<std::int32_t>(32 + 4 * axis, -(static_cast<std::int32_t>(axis) + 1) << 20);
    image.put<std::uint32_t>(56 + 4 * axis, 8).put<std::uint32_t>(68 + 4 * axis, 1);
  }
  image.put<std::int32_t>(44, 1 << 19).put<std::int32_t>(48, 2 << 24).put<std::int32_t>(52, kBand).put<std::int32_t>(80, 52429);
  image.put(84, kNodes).put(88, kBricks).put(92, kRootAt).put(96, kNodesAt).put(100, kBricksAt);
  image.put<std::uint32_t>(104, 0).put<std::uint32_t>(108, 3756);

  image.put<std::uint32_t>(kRootAt, 2);
  for (std::uint32_t slot = 0; slot < 64; ++slot) {
    const std::uint32_t x = slot & 3, y = (slot >> 2) & 3, z = slot >> 4;
    const bool stored = x < 2 && y < 2 && z < 2;
    image.put<std::uint32_t>(kNodesAt + 4 * slot, 0).put<std::uint32_t>(kNodesAt + kNodeBytes + 4 * slot, 1);
    image.put<std::uint32_t>(kNodesAt + 2 * kNodeBytes + 4 * slot, stored ? 2 + x + 2 * y + 4 * z : 0);
  }
  for (std::uint32_t brick = 0; brick < kBricks; ++brick) {
    for (std::uint32_t sample = 0; sample < 64; ++sample) {
      std::int16_t value = brick == 1 ? std::int16_t{-kBand} : kBand;
      if (brick >= 2) {
        const std::uint32_t i = ((brick - 2) & 1) * 4 + (sample & 3);
        const std::uint32_t j = (((brick - 2) >> 1) & 1) * 4 + ((sample >> 2) & 3);
        const std::uint32_t k = ((brick - 2) >> 2) * 4 + (sample >> 4);
        const auto inside = [](std::uint32_t index) { return index >= 2 && index < 6; };
        if (inside(i) && inside(j) && inside(k)) value = static_cast<std::int16_t>(-1000 - static_cast<int>(i + 10 * j + 100 * k));
      }
      image.put(kBricksAt + kBrickBytes * brick + 2 * sample, value);
    }
  }
  image.seal();
  return image;
}

constexpr std::size_t kTableAt = kTotal;

/// The same with a table of stiffness behind the bricks.
Image image_with_table() {
  Image image = valid_image().resized(kTotal + kBricks);
  image.put<std::uint16_t>(6, 2).put<std::uint64_t>(16, kTotal + kBricks).put<std::uint32_t>(172, kTableAt);
  for (std::uint32_t brick = 2; brick < kBricks; ++brick) image.put<std::uint8_t>(kTableAt + brick, static_cast<std::uint8_t>(25 * brick));
  image.seal();
  return image;
}

/// Reads all that the view may be asked for. The sum keeps the compiler from skipping it.
std::int64_t read_everything(const FieldView& view) {
  std::int64_t sum = 0;
  for (std::int32_t k = 0; k < view.size[2]; ++k) {
    for (std::int32_t j = 0; j < view.size[1]; ++j) {
      for (std::int32_t i = 0; i < view.size[0]; ++i) sum += view.coefficient(i, j, k);
    }
  }
  return sum;
}

TEST(Field, EveryHeaderFieldIsReadFromItsPlace) {
  const Image image = valid_image();
  const Result<FieldView> parsed = FieldView::parse(image.bytes());
  ASSERT_TRUE(parsed) << describe(parsed.error());
  EXPECT_EQ(parsed->origin, (Vec3<Mm>{Mm::of(-1), Mm::of(-2), Mm::of(-3)}));
  EXPECT_EQ(parsed->edge, MmPerVoxel::of(0.5));
  EXPECT_EQ(parsed->inverse_edge, VoxelPerMm::of(2));
  EXPECT_EQ(parsed->band, Distance::of(4));
  EXPECT_EQ(parsed->stiffness, Stiffness::of(0.8));
  EXPECT_EQ(parsed->size, (std::array<std::int32_t, 3>{8, 8, 8}));
  EXPECT_EQ(parsed->root_size, (std::array<std::int32_t, 3>{1, 1, 1}));
  EXPECT_EQ(parsed->node_count, kNodes);
  EXPECT_EQ(parsed->brick_count, kBricks);
  EXPECT_EQ(parsed->hash(), hash64(image.bytes().data(), image.size()));
}

TEST(Field, TheHeaderSaysWhatItIsBetweenSamples) {
  Image image = valid_image();
  EXPECT_EQ(FieldView::parse(image.bytes()).value().interpolation, Interpolation::kSpline);
  image.put<std::uint32_t>(176, 1);
  image.seal();
  EXPECT_EQ(FieldView::parse(image.bytes()).value().interpolation, Interpolation::kTrilinear);
}

TEST(Field, EverySampleIsFoundThroughTheTree) {
  const Image image = valid_image();
  const Result<FieldView> view = FieldView::parse(image.bytes());
  ASSERT_TRUE(view);
  for (std::int32_t k = 0; k < 8; ++k) {
    for (std::int32_t j = 0; j < 8; ++j) {
      for (std::int32_t i = 0; i < 8; ++i) {
        const auto inside = [](std::int32_t index) { return index >= 2 && index < 6; };
        const std::int32_t expected = inside(i) && inside(j) && inside(k) ? -1000 - (i + 10 * j + 100 * k) : kBand;
        ASSERT_EQ(view->coefficient(i, j, k), expected) << i << " " << j << " " << k;
      }
    }
  }
}

TEST(Field, ATableOfStiffnessIsFoundBehindTheBricks) {
  const Image image = image_with_table();
  const Result<FieldView> view = FieldView::parse(image.bytes());
  ASSERT_TRUE(view) << describe(view.error());
  ASSERT_EQ(view->stiffness_parts, image.bytes().data() + kTableAt);
  EXPECT_EQ(view->stiffness_parts[view->brick_number(5, 1, 1)], 75) << "brick 3";
  EXPECT_EQ(view->stiffness_parts[view->brick_number(5, 5, 5)], 225) << "brick 9";
  EXPECT_EQ(FieldView::parse(valid_image().bytes())->stiffness_parts, nullptr);
}

TEST(Field, EveryMalformedTableOfStiffnessIsRefused) {
  using I = Image;
  const std::vector<std::pair<Error, std::function<void(I&)>>> cases = {
      {Error::kBadSize, [](I& i) { i.put<std::uint32_t>(172, 0); }},
      {Error::kBadSize, [](I& i) { i.put<std::uint32_t>(172, kTableAt - 1); }},
      {Error::kBadSize, [](I& i) { i.put<std::uint32_t>(172, kTableAt + 1); }},
      {Error::kBadSize, [](I& i) { i.put<std::uint32_t>(172, kBricksAt); }},
      {Error::kBadSize, [](I& i) { i.put<std::uint32_t>(172, ~0U); }},
      {Error::kBadSize, [](I& i) { i.put<std::uint32_t>(88, kBricks - 1); }},
      {Error::kBadIndex, [](I& i) { i.put<std::uint8_t>(kTableAt, 1); }},
      {Error::kBadIndex, [](I& i) { i.put<std::uint8_t>(kTableAt + 1, 255); }},
      {Error::kBadIndex, [](I& i) { i.put<std::uint8_t>(kTableAt + 2, 0); }},
      {Error::kBadIndex, [](I& i) { i.put<std::uint8_t>(kTableAt + kBricks - 1, 0); }},
  };
  for (std::size_t n = 0; n < cases.size(); ++n) {
    Image image = image_with_table();
    cases[n].second(image);
    image.seal();
    const Result<FieldView> parsed = FieldView::parse(image.bytes());
    ASSERT_FALSE(parsed) << n;
    EXPECT_EQ(parsed.error(), cases[n].first) << n << ": " << describe(parsed.error());
  }
  for (const std::size_t size : {kTotal, kTotal + kBricks - 1, kTotal + kBricks + 1}) {
    Image image = image_with_table().resized(size);
    image.put<std::uint64_t>(16, size).seal();
    EXPECT_FALSE(FieldView::parse(image.bytes())) << size;
  }
}

TEST(Field, ANewerMinorVersionIsReadAndItsAdditionsIgnored) {
  Image image = valid_image();
  image.put<std::uint16_t>(6, 9).put<std::uint32_t>(200, 0xFFFFFFFF).seal();
  EXPECT_TRUE(FieldView::parse(image.bytes()));
}

TEST(Field, TheExtremesOfEveryRangeAreAccepted) {
  const std::vector<std::function<void(Image&)>> extremes = {
      [](Image& i) { i.put<std::int32_t>(32, 512 << 20).put<std::int32_t>(36, -(512 << 20)); },
      [](Image& i) { i.put<std::int32_t>(44, 1 << 14).put<std::int32_t>(48, 1 << 30); },
      [](Image& i) { i.put<std::int32_t>(44, 16 << 20).put<std::int32_t>(48, 1 << 20); },
      [](Image& i) { i.put<std::int32_t>(80, 1); },
      [](Image& i) { i.put<std::int32_t>(80, 100 << 16); },
  };
  for (std::size_t n = 0; n < extremes.size(); ++n) {
    Image image = valid_image();
    extremes[n](image);
    image.seal();
    EXPECT_TRUE(FieldView::parse(image.bytes())) << n;
  }
}

struct Malformed {
  std::string what;
  Error expected;
  std::function<void(Image&)> spoil;  ///< the checksum is made right afterwards
};

TEST(Field, EveryMalformedImageIsRefusedForItsReason) {
  using I = Image;
  const std::vector<Malformed> cases = {
      {"another magic", Error::kBadMagic, [](I& i) { i.put<std::uint8_t>(0, 'X'); }},
      {"a trace", Error::kBadMagic, [](I& i) { std::memcpy(i.at(0), "ITRC", 4); }},
      {"the next major version", Error::kBadVersion, [](I& i) { i.put<std::uint16_t>(4, 2); }},
      {"major version 0", Error::kBadVersion, [](I& i) { i.put<std::uint16_t>(4, 0); }},
      {"another header length", Error::kBadHeader, [](I& i) { i.put<std::uint32_t>(8, 128); }},
      {"a total of 2^64 - 1", Error::kTruncated, [](I& i) { i.put<std::uint64_t>(16, ~0ULL); }},
      {"a total of one byte less", Error::kBadSize, [](I& i) { i.put<std::uint64_t>(16, kTotal - 1); }},
      {"a total of 0", Error::kBadSize, [](I& i) { i.put<std::uint64_t>(16, 0); }},
      {"an origin beyond 512 mm", Error::kBadHeader, [](I& i) { i.put<std::int32_t>(32, (512 << 20) + 1); }},
      {"an origin at the lowest integer", Error::kBadHeader, [](I& i) { i.put<std::int32_t>(40, INT32_MIN); }},
      {"an edge of 0", Error::kBadHeader, [](I& i) { i.put<std::int32_t>(44, 0); }},
      {"a negative edge", Error::kBadHeader, [](I& i) { i.put<std::int32_t>(44, -(1 << 19)); }},
      {"an edge below 1/64 mm", Error::kBadHeader, [](I& i) { i.put<std::int32_t>(44, (1 << 14) - 1); }},
      {"an edge above 16 mm", Error::kBadHeader, [](I& i) { i.put<std::int32_t>(44, (16 << 20) + 1); }},
      {"an edge of 17 mm with its reciprocal", Error::kBadHeader,
       [](I& i) { i.put<std::int32_t>(44, 17 << 20).put<std::int32_t>(48, 986895); }},
      {"a reciprocal that is not the edge's", Error::kBadHeader, [](I& i) { i.put<std::int32_t>(48, (2 << 24) + 33); }},
      {"a reciprocal of the other sign", Error::kBadHeader, [](I& i) { i.put<std::int32_t>(48, -(2 << 24)); }},
      {"an interpolation that there is not", Error::kBadHeader, [](I& i) { i.put<std::uint32_t>(176, 2); }},
      {"a method that there is not", Error::kBadHeader, [](I& i) { i.put<std::uint32_t>(104, 2); }},
      {"a spline of the published method", Error::kBadHeader, [](I& i) { i.put<std::uint32_t>(104, 1); }},
      {"a band below 1 voxel", Error::kBadHeader, [](I& i) { i.put<std::int32_t>(52, 4095); }},
      {"a band that int16 cannot hold", Error::kBadHeader, [](I& i) { i.put<std::int32_t>(52, 8 * 4096); }},
      {"a stiffness of 0", Error::kBadHeader, [](I& i) { i.put<std::int32_t>(80, 0); }},
      {"a stiffness above 100 N/mm", Error::kBadHeader, [](I& i) { i.put<std::int32_t>(80, (100 << 16) + 1); }},
      {"7 samples", Error::kBadHeader, [](I& i) { i.put<std::uint32_t>(56, 7); }},
      {"4097 samples", Error::kBadHeader, [](I& i) { i.put<std::uint32_t>(60, 4097); }},
      {"2^32 - 1 samples", Error::kBadHeader, [](I& i) { i.put<std::uint32_t>(64, ~0U); }},
      {"17 samples in one node", Error::kBadSize, [](I& i) { i.put<std::uint32_t>(56, 17); }},
      {"a root larger than the grid", Error::kBadSize, [](I& i) { i.put<std::uint32_t>(68, 2); }},
      {"the largest grid in a small file", Error::kBadSize,
       [](I& i) {
         for (std::size_t axis = 0; axis < 3; ++axis) i.put<std::uint32_t>(56 + 4 * axis, 4096).put<std::uint32_t>(68 + 4 * axis, 256);
       }},
      {"1 node", Error::kBadHeader, [](I& i) { i.put<std::uint32_t>(84, 1); }},
      {"1 brick", Error::kBadHeader, [](I& i) { i.put<std::uint32_t>(88, 1); }},
      {"2^32 - 1 nodes", Error::kBadSize, [](I& i) { i.put<std::uint32_t>(84, ~0U); }},
      {"a node count that is right modulo 2^24", Error::kBadSize, [](I& i) { i.put<std::uint32_t>(84, (1U << 24) + kNodes); }},
      {"a brick count that is right modulo 2^25", Error::kBadSize, [](I& i) { i.put<std::uint32_t>(88, (1U << 25) + kBricks); }},
      {"a root table elsewhere", Error::kBadSize, [](I& i) { i.put<std::uint32_t>(92, 260); }},
      {"nodes elsewhere", Error::kBadSize, [](I& i) { i.put<std::uint32_t>(96, 256); }},
      {"bricks elsewhere", Error::kBadSize, [](I& i) { i.put<std::uint32_t>(100, ~0U); }},
      {"a root entry one behind the nodes", Error::kBadIndex, [](I& i) { i.put(kRootAt, kNodes); }},
      {"a root entry of 2^32 - 1", Error::kBadIndex, [](I& i) { i.put<std::uint32_t>(kRootAt, ~0U); }},
      {"a node entry one behind the bricks", Error::kBadIndex, [](I& i) { i.put(kNodesAt + 2 * kNodeBytes, kBricks); }},
      {"a node entry of 2^32 - 1 where no sample is", Error::kBadIndex,
       [](I& i) { i.put<std::uint32_t>(kNodesAt + 3 * kNodeBytes - 4, ~0U); }},
      {"node 0 with a stored brick", Error::kBadIndex, [](I& i) { i.put<std::uint32_t>(kNodesAt, 2); }},
      {"node 1 not inside throughout", Error::kBadIndex, [](I& i) { i.put<std::uint32_t>(kNodesAt + 2 * kNodeBytes - 4, 0); }},
      {"brick 0 not outside throughout", Error::kBadIndex, [](I& i) { i.put<std::int16_t>(kBricksAt + 126, kBand - 1); }},
      {"brick 1 not inside throughout", Error::kBadIndex, [](I& i) { i.put<std::int16_t>(kBricksAt + 128, kBand); }},
      {"a number beyond the band", Error::kBadSample, [](I& i) { i.put<std::int16_t>(kBricksAt + 3 * kBrickBytes + 30, kBand + 1); }},
      {"a number beyond the band inside", Error::kBadSample,
       [](I& i) { i.put<std::int16_t>(kBricksAt + 3 * kBrickBytes + 30, -kBand - 1); }},
      {"a node of two entries", Error::kBadIndex,
       [](I& i) { i.put<std::uint32_t>(56, 24).put<std::uint32_t>(68, 2).put<std::uint32_t>(kRootAt + 4, 2); }},
      {"a brick of no cell", Error::kBadIndex, [](I& i) { i.put<std::uint32_t>(kNodesAt + 2 * kNodeBytes + 4 * 21, 0); }},
      {"bricks in another order", Error::kBadIndex,
       [](I& i) {
         i.put<std::uint32_t>(kNodesAt + 2 * kNodeBytes, 3).put<std::uint32_t>(kNodesAt + 2 * kNodeBytes + 4, 2);
         std::swap_ranges(i.at(kBricksAt + 2 * kBrickBytes), i.at(kBricksAt + 3 * kBrickBytes), i.at(kBricksAt + 3 * kBrickBytes));
       }},
      {"a brick beyond the grid that is inside", Error::kBadIndex,
       [](I& i) { i.put<std::uint32_t>(kNodesAt + 2 * kNodeBytes + 4 * 2, 1); }},
      {"an object open at the first layer", Error::kBadIndex, [](I& i) { i.put<std::int16_t>(kBricksAt + 2 * kBrickBytes, -1); }},
      {"an object open at the second layer", Error::kBadIndex,
       [](I& i) { i.put<std::int16_t>(kBricksAt + 2 * kBrickBytes + 2 * (1 + 4 * 2 + 16 * 2), kBand - 1); }},
      {"an object open at the second layer upwards", Error::kBadIndex,
       [](I& i) { i.put<std::int16_t>(kBricksAt + 2 * kBrickBytes + 2 * (2 + 4 * 2 + 16 * 1), kBand - 1); }},
      {"an object open at the last but one layer", Error::kBadIndex,
       [](I& i) { i.put<std::int16_t>(kBricksAt + 9 * kBrickBytes + 2 * (2 + 4 * 2 + 16 * 2), kBand - 1); }},
      {"a root that is far inside", Error::kBadIndex, [](I& i) { i.put<std::uint32_t>(kRootAt, 1); }},
  };
  for (const Malformed& malformed : cases) {
    Image image = valid_image();
    malformed.spoil(image);
    image.seal();
    const Result<FieldView> parsed = FieldView::parse(image.bytes());
    EXPECT_FALSE(parsed) << malformed.what;
    if (parsed) continue;
    EXPECT_EQ(parsed.error(), malformed.expected) << malformed.what << ": " << describe(parsed.error());
  }
}

TEST(Field, SamplesBeyondTheGridAreFarOutside) {
  Image image = valid_image().resized(kTotal + kBrickBytes);  // 10 samples along z: of one more brick, two layers lie beyond
  image.put<std::uint64_t>(16, kTotal + kBrickBytes).put<std::uint32_t>(64, 10).put(88, kBricks + 1);
  image.put<std::uint32_t>(kNodesAt + 2 * kNodeBytes + 4 * 32, kBricks);
  for (std::size_t sample = 0; sample < 64; ++sample) image.put<std::int16_t>(kTotal + 2 * sample, kBand);
  EXPECT_TRUE(FieldView::parse(image.seal().bytes()));
  for (const std::size_t layer : {2U, 3U}) {
    Image open(image);
    open.put<std::int16_t>(kTotal + 2 * (16 * layer + 5), -1).seal();
    const Result<FieldView> parsed = FieldView::parse(open.bytes());
    ASSERT_FALSE(parsed) << layer;
    EXPECT_EQ(parsed.error(), Error::kBadIndex);
  }
}

TEST(Field, EveryLengthButTheRightOneIsRefused) {
  const Image image = valid_image();
  for (std::size_t size = 0; size < kTotal; size += size < 300 ? 1 : 37) {
    const Result<FieldView> parsed = FieldView::parse(image.resized(size).bytes());
    ASSERT_FALSE(parsed) << size;
    EXPECT_EQ(parsed.error(), size < 4 ? Error::kBadMagic : Error::kTruncated) << size;
  }
  for (const std::size_t more : {1U, 8U, 128U}) {
    const Result<FieldView> parsed = FieldView::parse(image.resized(kTotal + more).bytes());
    ASSERT_FALSE(parsed);
    EXPECT_EQ(parsed.error(), Error::kBadSize);
  }
}

TEST(Field, AnImageOffItsAlignmentIsRefused) {
  const Image image = valid_image();
  Image shifted(kTotal + 8);
  for (std::size_t shift = 1; shift < 8; ++shift) {
    std::memcpy(shifted.at(shift), image.bytes().data(), kTotal);
    const Result<FieldView> parsed = FieldView::parse({shifted.at(shift), kTotal});
    ASSERT_FALSE(parsed);
    EXPECT_EQ(parsed.error(), Error::kMisaligned);
  }
}

TEST(Field, EveryBitFlippedBehindTheChecksumIsSeen) {
  Image image = valid_image();
  for (std::size_t offset = 24; offset < kTotal; ++offset) {
    *image.at(offset) ^= static_cast<std::uint8_t>(1U << (offset % 8));
    const Result<FieldView> parsed = FieldView::parse(image.bytes());
    ASSERT_FALSE(parsed) << offset;
    EXPECT_EQ(parsed.error(), Error::kBadChecksum) << offset;
    *image.at(offset) ^= static_cast<std::uint8_t>(1U << (offset % 8));
  }
}

/// The checksum is no protection against intent: whatever stands in header and tables, the view that is accepted never leaves its image.
TEST(Field, NoByteOfHeaderOrTablesCanMakeTheViewLeaveTheImage) {
  const Image original = valid_image();
  int accepted = 0, refused = 0;
  for (std::size_t offset = 0; offset < kBricksAt; ++offset) {
    for (const int change : {0x01, 0x02, 0x04, 0x08, 0x10, 0x20, 0x40, 0x80, 0xFF}) {
      Image image(original);
      *image.at(offset) ^= static_cast<std::uint8_t>(change);
      if (offset < 12 || offset >= 16) image.seal();
      const Result<FieldView> parsed = FieldView::parse(image.bytes());
      if (parsed) {
        ++accepted;
        ASSERT_GE(read_everything(*parsed), 512 * -32768) << offset;
        // Only what has no bearing on the layout may change unnoticed, and a size that needs no further node.
        const bool harmless = (offset >= 6 && offset < 8) || (offset >= 24 && offset < 44) ||
                              (offset >= 56 && offset < 68 && offset % 4 == 0) || (offset >= 80 && offset < 84) || offset >= 104;
        ASSERT_TRUE(harmless) << offset;
      } else {
        ++refused;
      }
    }
  }
  EXPECT_GT(accepted, 1000);
  EXPECT_GT(refused, 1000);
}

}  // namespace
}  // namespace isotouch
