#include "shared/zstd_frame.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace isotouch {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// Magic, descriptor, header fields, then one empty raw block that is the last.
Bytes frame_with(std::uint8_t descriptor, const Bytes& fields, const Bytes& blocks = {1, 0, 0}) {
  Bytes bytes;
  bytes.reserve(64);  // else gcc 12 sees ghosts in the inserts
  for (const std::uint8_t byte : {std::uint8_t{0x28}, std::uint8_t{0xB5}, std::uint8_t{0x2F}, std::uint8_t{0xFD}, descriptor})
    bytes.push_back(byte);
  bytes.insert(bytes.end(), fields.begin(), fields.end());
  bytes.insert(bytes.end(), blocks.begin(), blocks.end());
  return bytes;
}

TEST(ZstdFrame, EveryFormOfTheHeaderIsRead) {
  const auto expect = [](const Bytes& bytes, std::uint64_t content, std::uint64_t window, std::uint32_t dictionary) {
    const auto frame = read_zstd_frame(bytes);
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->content_bytes, content);
    EXPECT_EQ(frame->window_bytes, window);
    EXPECT_EQ(frame->dictionary, dictionary);
  };
  expect(frame_with(0x20, {7}), 7, 7, 0);
  expect(frame_with(0x60, {1, 2}), 0x201 + 256, 0x201 + 256, 0);
  expect(frame_with(0x40, {0x38, 1, 2}), 0x201 + 256, 1U << 17, 0);
  expect(frame_with(0x80, {0x3B, 1, 2, 3, 4}), 0x04030201, (1U << 17) + 3 * (1U << 14), 0);
  expect(frame_with(0xC0, {0x00, 1, 2, 3, 4, 5, 6, 7, 8}), 0x0807060504030201U, 1024, 0);
  expect(frame_with(0x21, {9, 7}), 7, 7, 9);
  expect(frame_with(0x22, {9, 1, 7}), 7, 7, 0x109);
  expect(frame_with(0x23, {9, 0, 0, 1, 7}), 7, 7, 0x01000009);
}

TEST(ZstdFrame, BlocksAreWalkedToTheLast) {
  const Bytes raw = {3 * 8, 0, 0, 'a', 'b', 'c'}, repeated = {2, 16, 0, 'x'}, compressed = {5 + 2 * 8, 0, 0, 1, 2};
  Bytes blocks = raw;
  blocks.insert(blocks.end(), repeated.begin(), repeated.end());
  blocks.insert(blocks.end(), compressed.begin(), compressed.end());
  EXPECT_TRUE(read_zstd_frame(frame_with(0x20, {7}, blocks)));
  Bytes longer = blocks;
  longer.push_back(0);
  EXPECT_FALSE(read_zstd_frame(frame_with(0x20, {7}, longer)));
  longer.insert(longer.end(), {0, 0, 0});
  EXPECT_TRUE(read_zstd_frame(frame_with(0x24, {7}, longer))) << "the checksum of the content";
  EXPECT_FALSE(read_zstd_frame(frame_with(0x20, {7}, {7, 0, 0}))) << "type 3 is none";
  EXPECT_FALSE(read_zstd_frame(frame_with(0x28, {7}))) << "a reserved bit";
  EXPECT_FALSE(read_zstd_frame(frame_with(0x00, {0x38}))) << "no content size";
}

TEST(ZstdFrame, NoBeginningAndNoRandomBytesAreAFrame) {
  const Bytes good = frame_with(0x80, {0x38, 1, 2, 3, 4}, {3 * 8 + 1, 0, 0, 'a', 'b', 'c'});
  ASSERT_TRUE(read_zstd_frame(good));
  for (std::size_t size = 0; size < good.size(); ++size)
    EXPECT_FALSE(read_zstd_frame(Bytes(good.begin(), good.begin() + static_cast<std::ptrdiff_t>(size))));
  std::mt19937 random(3);
  for (int round = 0; round < 20'000; ++round) {
    Bytes bytes = good;
    for (std::size_t i = 4; i < bytes.size(); ++i) bytes[i] = static_cast<std::uint8_t>(random());
    bytes.shrink_to_fit();
    (void)read_zstd_frame(bytes);  // a sanitizer sees what reaches beyond
  }
}

}  // namespace
}  // namespace isotouch
