#include "host/stream/frame_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "host/error.h"

namespace isotouch::stream {
namespace {

using testing::HasSubstr;

/// Gives a text in pieces of a size, as a pipe may.
class Pieces {
 public:
  Pieces(std::string text, std::size_t size) : text_(std::move(text)), size_(size) {}
  std::size_t operator()(std::span<std::uint8_t> into) {
    largest_ = std::max(largest_, into.size());
    const std::size_t count = std::min({size_, into.size(), text_.size() - at_});
    std::copy_n(text_.begin() + static_cast<std::ptrdiff_t>(at_), count, into.begin());
    at_ += count;
    return count;
  }
  std::size_t largest() const { return largest_; }

 private:
  std::string text_;
  std::size_t size_, at_ = 0, largest_ = 0;
};

std::vector<std::string> frames(const std::string& text, std::size_t piece) {
  FrameReader reader("in", Pieces(text, piece));
  std::vector<std::string> all;
  while (const auto frame = reader.next()) all.emplace_back(frame->begin(), frame->end());
  EXPECT_EQ(reader.count(), all.size());
  return all;
}

std::string refusal(const std::string& text, std::size_t piece = 7) {
  try {
    frames(text, piece);
  } catch (const InputError& error) {
    return error.what();
  }
  return "taken";
}

TEST(FrameReader, GivesTheFramesWhateverThePieces) {
  const std::string large(3'000'000, 'x');
  const std::string text = "frame 3\nabcframe 0\nframe 8\r\nframe 2\n" + ("frame 3000000\n" + large);
  for (const std::size_t piece : {std::size_t{1}, std::size_t{2}, std::size_t{5}, std::size_t{4096}, text.size()}) {
    EXPECT_THAT(frames(text, piece), testing::ElementsAre("abc", "", "frame 2\n", large)) << piece;
  }
  EXPECT_TRUE(frames("", 1).empty());
}

TEST(FrameReader, RefusesWhatIsNoFrameWithASentence) {
  EXPECT_EQ(refusal("frame 3\nab"),
            "in: frame 1: the stream ends after 2 of its 3 bytes; the program that writes it was stopped, or announces too many");
  EXPECT_THAT(refusal("frame 1\nxframe 9"), HasSubstr("in: frame 2: the stream ends within its first line"));
  EXPECT_THAT(refusal("ply\nformat ascii 1.0\n"), HasSubstr("frame 1 begins as a PLY file does; write a line 'frame BYTES'"));
  EXPECT_THAT(refusal("# .PCD v0.7\n"), HasSubstr("begins as a PCD file does"));
  for (const char* text : {"\n", "x\n", "frame\n", "frame \n", "frame x\n", "frame 3x\n", "frame -3\n", "frame +3\n", "frame 0x3\n",
                           "frame 3 \n", "frame  3\n", "Frame 3\n", "\r\n", "frame 000000000000000000000000000000000001\n"})
    EXPECT_THAT(refusal(text), HasSubstr("does not begin as a frame; write a line 'frame BYTES'")) << text;
}

TEST(FrameReader, FindsGarbageBeforeItHasReadALine) {
  std::string garbage(100'000'000, 'g');
  Pieces pieces(garbage, 64);
  FrameReader reader("in", std::ref(pieces));
  EXPECT_THROW(reader.next(), InputError);
  EXPECT_LE(pieces.largest(), 4096U);
}

TEST(FrameReader, TakesMemoryForWhatCameAndNotForWhatIsAnnounced) {
  EXPECT_THAT(refusal("frame 134217729\n"), HasSubstr("announces more than 128 MiB"));
  EXPECT_THAT(refusal("frame 99999999999999999999\n"), HasSubstr("announces more than 128 MiB"));
  Pieces pieces("frame 134217728\nabc", 4096);
  FrameReader reader("in", std::ref(pieces));
  EXPECT_THROW(reader.next(), InputError);
  EXPECT_LE(pieces.largest(), std::size_t{1} << 20);
}

}  // namespace
}  // namespace isotouch::stream
