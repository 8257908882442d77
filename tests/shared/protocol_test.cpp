#include "shared/protocol.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string_view>
#include <vector>

namespace isotouch::protocol {
namespace {

std::vector<std::uint8_t> frame_of(Kind kind, std::string_view body) {
  std::vector<std::uint8_t> bytes(kHeaderBytes + body.size());
  std::copy(body.begin(), body.end(), bytes.begin() + kHeaderBytes);
  EXPECT_EQ(seal_frame(kind, body.size(), bytes), bytes.size());
  return bytes;
}

TEST(Wire, AFrameStandsAsPublished) {
  const std::vector<std::uint8_t> expected = {'I', 'T', 'C', 'W', 6, 0, 0, 0, 3, 0, 0, 0, 0xE2, 0xF9, 0xBF, 0x78, 'a', 'b', 'c'};
  EXPECT_EQ(frame_of(Kind::kStatus, "abc"), expected);
}

TEST(Wire, AFrameIsReadBackAndLeavesTheNext) {
  std::vector<std::uint8_t> stream = frame_of(Kind::kChunk, "twelve bytes");
  const std::vector<std::uint8_t> second = frame_of(Kind::kStop, "");
  stream.insert(stream.end(), second.begin(), second.end());
  const Result<Frame> first = read_frame(stream);
  ASSERT_TRUE(first);
  EXPECT_EQ(first->kind, Kind::kChunk);
  EXPECT_EQ(first->body.size(), 12U);
  EXPECT_EQ(first->body.front(), 't');
  const Result<Frame> next = read_frame(std::span(stream).subspan(first->size));
  ASSERT_TRUE(next);
  EXPECT_EQ(next->kind, Kind::kStop);
  EXPECT_EQ(next->size, kHeaderBytes);
}

TEST(Wire, EveryBeginningOfAFrameWantsMore) {
  const std::vector<std::uint8_t> whole = frame_of(Kind::kBegin, "anything");
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const Result<Frame> frame = read_frame(std::span(whole).first(size));
    ASSERT_TRUE(frame) << size;
    EXPECT_EQ(frame->size, 0U) << size;
  }
}

TEST(Wire, EveryFlippedBitIsSeen) {
  const std::vector<std::uint8_t> whole = frame_of(Kind::kBegin, "anything");
  for (std::size_t bit = 0; bit < 8 * whole.size(); ++bit) {
    std::vector<std::uint8_t> changed = whole;
    changed[bit / 8] ^= static_cast<std::uint8_t>(1U << bit % 8);
    const Result<Frame> frame = read_frame(changed);
    EXPECT_TRUE(!frame || frame->size == 0) << "bit " << bit;  // a longer length waits for bytes that never come
  }
}

TEST(Wire, WhatCannotBecomeAFrameIsRefusedAtOnce) {
  const std::vector<std::uint8_t> whole = frame_of(Kind::kHello, "");
  std::vector<std::uint8_t> other = whole;
  other[0] = 'G';
  EXPECT_EQ(read_frame(std::span(other).first(1)).error(), Error::kBadMagic);
  std::vector<std::uint8_t> reserved = whole;
  reserved[6] = 1;
  EXPECT_EQ(read_frame(reserved).error(), Error::kBadHeader);
  std::vector<std::uint8_t> large = whole;
  large[kLengthAt + 2] = 1, large[kLengthAt] = 1;
  EXPECT_EQ(read_frame(large).error(), Error::kBadSize);
  std::vector<std::uint8_t> changed = whole;
  changed[kChecksumAt] ^= 1;
  EXPECT_EQ(read_frame(changed).error(), Error::kBadChecksum);
}

TEST(Wire, TheLongestBodyFitsAFrame) {
  std::vector<std::uint8_t> frame(kMaxFrame, 0x5A);
  EXPECT_EQ(seal_frame(Kind::kRecords, kMaxBody, frame), kMaxFrame);
  const Result<Frame> back = read_frame(frame);
  ASSERT_TRUE(back);
  EXPECT_EQ(back->body.size(), kMaxBody);
}

TEST(Wire, NoBytesMakeTheReaderReachBeyondThem) {
  std::mt19937 random(7);
  int complete = 0;
  for (int round = 0; round < 20'000; ++round) {
    std::vector<std::uint8_t> bytes =
        frame_of(static_cast<Kind>(random() % 256), std::string_view("0123456789abcdef").substr(random() % 16));
    if (round % 2 == 1) bytes[random() % bytes.size()] = static_cast<std::uint8_t>(random());
    bytes.resize(random() % (bytes.size() + 8));
    bytes.shrink_to_fit();  // so that a sanitizer sees the first byte too many
    const Result<Frame> frame = read_frame(bytes);
    if (!frame || frame->size == 0) continue;
    ++complete;
    ASSERT_LE(frame->size, bytes.size());
    ASSERT_EQ(frame->size, kHeaderBytes + frame->body.size());
  }
  EXPECT_GT(complete, 1000);
}

}  // namespace
}  // namespace isotouch::protocol
