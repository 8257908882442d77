#include "host/field_file/packed.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zstd.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "host/encoding/write_image.h"
#include "host/error.h"
#include "host/field_file/image.h"
#include "shared/bytes.h"
#include "shared/crc32.h"
#include "shared/field_view.h"
#include "shared/packed_field.h"
#include "shared/residuals.h"
#include "tests/host/encoding/field_bodies.h"

namespace isotouch::field_file {
namespace {

using ::testing::HasSubstr;
using Bytes = std::vector<std::uint8_t>;

Image ball_image() { return encoding::write_image(test::field_of(test::ball(9), {9, 9, 9}), {}); }

bool same(const Image& a, const Image& b) { return std::equal(a.bytes().begin(), a.bytes().end(), b.bytes().begin(), b.bytes().end()); }

Bytes packed(const Image& image) { return pack(*FieldView::parse(image.bytes())); }

/// The core of the sentence that refuses the bytes.
std::string refusal(const Bytes& bytes) {
  try {
    unpack(bytes, "a file");
  } catch (const InputError& e) {
    return e.what();
  }
  return "accepted";
}

/// Makes the checksum right again: the attacker knows the format too.
void seal(Bytes& bytes) {
  store_le(&bytes[packed_layout::kTotalBytesAt], std::uint64_t{bytes.size()});
  store_le(&bytes[packed_layout::kChecksumAt], crc32(&bytes[16], bytes.size() - 16));
}

/// The same packed field around another frame.
Bytes with_frame(const Bytes& bytes, const Bytes& frame) {
  Bytes other = bytes;
  other.resize(packed_layout::kHeaderBytes);
  other.insert(other.end(), frame.begin(), frame.end());
  seal(other);
  return other;
}

Bytes residuals_of(const Bytes& bytes) {
  const PackedField view = *PackedField::parse(bytes);
  Bytes residuals(view.residual_bytes());
  EXPECT_EQ(ZSTD_decompress(residuals.data(), residuals.size(), view.frame.data(), view.frame.size()), residuals.size());
  return residuals;
}

/// A frame made with parameters of its own.
Bytes frame_of(const Bytes& content, const std::vector<std::pair<ZSTD_cParameter, int>>& parameters = {}) {
  ZSTD_CCtx* context = ZSTD_createCCtx();
  for (const auto& [parameter, value] : parameters) ZSTD_CCtx_setParameter(context, parameter, value);
  Bytes frame(ZSTD_compressBound(content.size()));
  frame.resize(ZSTD_compress2(context, frame.data(), frame.size(), content.data(), content.size()));
  ZSTD_freeCCtx(context);
  return frame;
}

TEST(Packed, TheVeryImageComesBack) {
  const std::vector<field::BandField> fields = {
      test::field_of(test::ball(25), Eigen::Vector3d::Constant(25), 3.0, {0.31, -0.17, 0.44}),
      test::field_of(test::hollow_ball(34, 19), Eigen::Vector3d::Constant(34)),
      test::field_of(test::box({40, 30, 2}), {40, 30, 2}),
      test::field_of(test::ball(14), Eigen::Vector3d::Constant(14), 7.99),
      test::field_of(test::ball(14), Eigen::Vector3d::Constant(14), 1.0),
  };
  for (const field::BandField& field : fields) {
    const Image image = encoding::write_image(field, {});
    const Bytes bytes = packed(image);
    EXPECT_TRUE(same(unpack(bytes, "it").image, image));
    EXPECT_LT(2 * bytes.size(), image.size());
    EXPECT_EQ(PackedField::parse(bytes)->image_hash, FieldView::parse(image.bytes())->hash());
  }
}

TEST(Packed, AStiffnessTableComesBackToo) {
  field::BandField field = test::field_of(test::ball(14), Eigen::Vector3d::Constant(14));
  for (const field::Brick& brick : field.bricks) field.stiffness.push_back(1.0 + brick.cell.cast<double>().sum());
  const Image image = encoding::write_image(field, {});
  ASSERT_NE(FieldView::parse(image.bytes())->stiffness_parts, nullptr);
  EXPECT_TRUE(same(unpack(packed(image), "it").image, image));
}

TEST(Packed, ABallOfThatSizeTakesSoManyBits) {
  const Image image = encoding::write_image(test::field_of(test::ball(40), Eigen::Vector3d::Constant(40), 4.0, {0.31, -0.17, 0.44}), {});
  const double samples = 64.0 * FieldView::parse(image.bytes())->brick_count;
  const double bits = 8.0 * static_cast<double>(packed(image).size()) / samples;
  EXPECT_LT(bits, 4.0);
  EXPECT_GT(bits, 2.0) << "so much better: tighten the bound";
}

TEST(Packed, TheGoldenFileUnpacksToItsImage) {
  const auto golden = std::filesystem::path(ISOTOUCH_ROOT) / "tests/golden";
  const Image image = read_field(golden / "packed_1_0.itf").image;
  EXPECT_TRUE(same(image, read_field(golden / "field_1_0.itf").image));
  EXPECT_EQ(FieldView::parse(image.bytes())->hash(), 0x79f3401dc9bbc5adULL);
}

TEST(Packed, TheFrameKeepsToItsWindow) {
  const Image image = encoding::write_image(test::field_of(test::ball(34), Eigen::Vector3d::Constant(34)), {});
  const Bytes bytes = packed(image);
  ASSERT_GT(image.size(), std::size_t{2} << packed_layout::kWindowShift) << "a small frame is its own window";
  EXPECT_EQ(refusal(with_frame(bytes, frame_of(residuals_of(bytes), {{ZSTD_c_windowLog, 17}}))), "accepted");
  EXPECT_THAT(refusal(with_frame(bytes, frame_of(residuals_of(bytes), {{ZSTD_c_windowLog, 18}}))), HasSubstr("compressed part"));
}

struct Malformed {
  std::string what;
  std::string expected;
  std::function<void(Bytes&)> spoil;  ///< the checksum and the total are made right afterwards
};

TEST(Packed, EveryMalformedFileIsRefusedForItsReason) {
  using namespace packed_layout;
  using B = Bytes;
  const Bytes good = packed(ball_image());
  const Bytes residuals = residuals_of(good);
  const auto put = [](B& b, std::size_t at, auto value) { store_le(&b[at], value); };
  const auto image_field = [&](std::size_t at) { return kImageHeaderAt + at; };
  const std::string size = "contradict each other", header = "outside its range", frame = "compressed part", sum = "checksum",
                    index = "table entry";
  const std::vector<Malformed> cases = {
      {"nothing", "accepted", [](B&) {}},
      {"a newer minor version", "accepted", [&](B& b) { put(b, kMinorAt, std::uint16_t{7}); }},
      {"another magic", "not a file of this kind", [](B& b) { b[3] = 'X'; }},
      {"the next major version", "another format version", [&](B& b) { put(b, kMajorAt, std::uint16_t{2}); }},
      {"another header length", header, [&](B& b) { put(b, kHeaderBytesAt, 321U); }},
      {"no frame", size, [](B& b) { b.resize(kHeaderBytes); }},
      {"an image of 2^64 - 1 bytes", size, [&](B& b) { put(b, kImageBytesAt, ~0ULL); }},
      {"an image of 2^32 bytes", size, [&](B& b) { put(b, kImageBytesAt, 1ULL << 32); }},
      {"an image of no bytes", size, [&](B& b) { put(b, kImageBytesAt, 0ULL); }},
      {"an image of one byte more", frame, [&](B& b) { put(b, kImageBytesAt, load_le<std::uint64_t>(&b[kImageBytesAt]) + 1); }},
      {"an image of one byte less", size, [&](B& b) { put(b, kImageBytesAt, load_le<std::uint64_t>(&b[kImageBytesAt]) - 1); }},
      {"an image of 3 GB", size, [&](B& b) { put(b, kImageBytesAt, 3ULL << 30); }},
      {"another hash", sum, [](B& b) { b[kImageHashAt] ^= 1; }},
      {"a stream longer by one", size, [&](B& b) { put(b, kStreamSizesAt, load_le<std::uint32_t>(&b[kStreamSizesAt]) + 1); }},
      {"a stream of 2^32 - 1", size, [&](B& b) { put(b, kStreamSizesAt, ~0U); }},
      {"a sample moved to another stream", size,
       [&](B& b) {
         put(b, kStreamSizesAt, load_le<std::uint32_t>(&b[kStreamSizesAt]) - 1);
         put(b, kStreamSizesAt + 4, load_le<std::uint32_t>(&b[kStreamSizesAt + 4]) + 1);
       }},
      {"an image header that is none", "not a file of this kind", [&](B& b) { b[image_field(0)] = 'X'; }},
      {"an image of the next major version", "another format version", [&](B& b) { b[image_field(image_layout::kMajorAt)] = 2; }},
      {"no band", header, [&](B& b) { put(b, image_field(image_layout::kBandAt), 0); }},
      {"a band beyond 16 bits", header, [&](B& b) { put(b, image_field(image_layout::kBandAt), 32768); }},
      {"the lowest band", header, [&](B& b) { put(b, image_field(image_layout::kBandAt), INT32_MIN); }},
      {"no root", header, [&](B& b) { put(b, image_field(image_layout::kRootSizeAt), 0U); }},
      {"a root of 257 nodes along one axis", header, [&](B& b) { put(b, image_field(image_layout::kRootSizeAt), 257U); }},
      {"a root larger than its place", size, [&](B& b) { put(b, image_field(image_layout::kRootSizeAt), 256U); }},
      {"one node", header, [&](B& b) { put(b, image_field(image_layout::kNodeCountAt), 1U); }},
      {"2^32 - 1 nodes", size, [&](B& b) { put(b, image_field(image_layout::kNodeCountAt), ~0U); }},
      {"one brick", header, [&](B& b) { put(b, image_field(image_layout::kBrickCountAt), 1U); }},
      {"2^32 - 1 bricks", size, [&](B& b) { put(b, image_field(image_layout::kBrickCountAt), ~0U); }},
      {"a root inside the header", size, [&](B& b) { put(b, image_field(image_layout::kRootOffsetAt), 252U); }},
      {"nodes on an odd byte", size, [&](B& b) { ++b[image_field(image_layout::kNodeOffsetAt)]; }},
      {"nodes before the root", size, [&](B& b) { put(b, image_field(image_layout::kNodeOffsetAt), 0U); }},
      {"nodes far behind", size, [&](B& b) { put(b, image_field(image_layout::kNodeOffsetAt), 0xFFFFFFFCU); }},
      {"bricks far behind", size, [&](B& b) { put(b, image_field(image_layout::kBrickOffsetAt), 0xFFFFFFFCU); }},
      {"bricks in the nodes", size, [&](B& b) { put(b, image_field(image_layout::kBrickOffsetAt), 512U); }},
      {"a frame that is none", frame, [](B& b) { b[kHeaderBytes] ^= 1; }},
      {"a frame that ends too early", frame, [](B& b) { b.pop_back(); }},
      {"a byte behind the frame", frame, [](B& b) { b.push_back(0); }},
      {"two frames", frame,
       [&](B& b) {
         b = with_frame(b, frame_of(residuals));
         const B more = frame_of({});
         b.insert(b.end(), more.begin(), more.end());
       }},
      {"a frame of one byte less", frame, [&](B& b) { b = with_frame(b, frame_of(B(residuals.begin(), residuals.end() - 1))); }},
      {"a frame that does not state its size", frame,
       [&](B& b) {
         b = with_frame(b, frame_of(residuals, {{ZSTD_c_contentSizeFlag, 0}}));
       }},
      {"a node that is not there", index,
       [&](B& b) {
         B other = residuals;
         put(other, 0, 0xFFFFFFFFU);
         b = with_frame(b, frame_of(other));
       }},
      {"a node behind the last", index,
       [&](B& b) {
         B other = residuals;
         for (std::size_t n = 0; n < 64; ++n) put(other, 4 * n, 2U);
         b = with_frame(b, frame_of(other));
       }},
      {"a brick that is not there", index,
       [&](B& b) {
         B other = residuals;
         put(other, load_le<std::uint32_t>(&b[image_field(image_layout::kNodeOffsetAt)]) - 256,
             load_le<std::uint32_t>(&b[image_field(image_layout::kBrickCountAt)]));
         b = with_frame(b, frame_of(other));
       }},
      {"another residual", "(checksum|contradict)",
       [&](B& b) {
         B other = residuals;
         other.back() ^= 1;
         b = with_frame(b, frame_of(other));
       }},
  };
  for (const Malformed& malformed : cases) {
    Bytes bytes = good;
    malformed.spoil(bytes);
    seal(bytes);
    EXPECT_THAT(refusal(bytes), ::testing::ContainsRegex(malformed.expected)) << malformed.what;
  }
}

TEST(Packed, EveryLengthButTheRightOneIsRefused) {
  const Bytes good = packed(ball_image());
  for (std::size_t length = 0; length < good.size(); length += length < 400 ? 1 : 37) {
    EXPECT_NE(refusal(Bytes(good.begin(), good.begin() + static_cast<std::ptrdiff_t>(length))), "accepted") << length;
  }
  Bytes longer = good;
  longer.push_back(0);
  EXPECT_THAT(refusal(longer), HasSubstr("contradict"));
}

/// Damage is seen by the checksum; damage by someone who makes the checksum right again, by the rest.
TEST(Packed, EveryChangedByteIsRefusedOrChangesNothing) {
  const Image image = ball_image();
  const Bytes good = packed(image);
  int refused = 0, harmless = 0;
  for (const bool sealed : {false, true}) {
    for (std::size_t at = 0; at < good.size(); at += sealed && at >= packed_layout::kHeaderBytes ? 13 : 1) {
      Bytes bytes = good;
      bytes[at] ^= static_cast<std::uint8_t>(1U << (at % 8));
      if (sealed) seal(bytes);
      try {
        ASSERT_TRUE(same(unpack(bytes, "it").image, image)) << at;
        ++harmless;
      } catch (const InputError&) {
        ++refused;
      }
    }
  }
  EXPECT_GT(refused, 4000);
  EXPECT_GT(harmless, 4) << "the minor version, the reserved bytes";
}

}  // namespace
}  // namespace isotouch::field_file
