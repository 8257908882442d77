#include "firmware/falcon/firmware_image.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <string>
#include <vector>

#include "tests/support/random.h"
#include "tests/support/scratch_folder.h"

namespace isotouch::falcon {
namespace {

using Bytes = std::vector<std::uint8_t>;
using testing::HasSubstr;
using testing::StartsWith;

Bytes legal() {
  const auto image = synthetic_image();
  return {image.begin(), image.end()};
}

TEST(FirmwareImage, TheSyntheticOneIsLegal) {
  const ImageReport report = check_image(synthetic_image());
  EXPECT_EQ(report.defect, ImageDefect::kNone);
  EXPECT_EQ(report.entry, 0x3F8002U);
  EXPECT_EQ(report.blocks, 1U);
  EXPECT_EQ(report.words, 2U);
  EXPECT_EQ(explain(report), "34 bytes, words: 2, blocks: 1");
}

TEST(FirmwareImage, EachDefectHasItsPlaceAndItsSentence) {
  struct Case {
    Bytes image;
    ImageDefect defect;
    std::size_t offset;
  };
  const auto changed = [](std::size_t at, std::uint8_t value) {
    Bytes image = legal();
    image[at] = value;
    return image;
  };
  Bytes trailing = legal(), no_end = legal(), no_blocks = legal(), header = legal();
  header.resize(21);
  trailing.insert(trailing.end(), {1, 2, 3});
  no_end.resize(32);
  no_blocks.erase(no_blocks.begin() + 22, no_blocks.begin() + 32);
  const std::vector<Case> cases = {
      {{}, ImageDefect::kTooShort, 0},
      {{0xAA}, ImageDefect::kTooShort, 1},
      {header, ImageDefect::kTooShort, 21},
      {changed(0, 0xAB), ImageDefect::kWrongKey, 0},
      {{0x7F, 'E', 'L', 'F'}, ImageDefect::kWrongKey, 0},
      {changed(2, 1), ImageDefect::kReserved, 2},
      {changed(17, 9), ImageDefect::kReserved, 17},
      {changed(18, 0x40), ImageDefect::kWideAddress, 18},
      {changed(24, 0x40), ImageDefect::kWideAddress, 24},
      {changed(22, 4), ImageDefect::kCutBlock, 22},
      {changed(22, 3), ImageDefect::kNoEnd, 34},
      {changed(23, 0xFF), ImageDefect::kCutBlock, 22},
      {no_end, ImageDefect::kNoEnd, 32},
      {changed(32, 1), ImageDefect::kCutBlock, 32},
      {trailing, ImageDefect::kTrailing, 34},
      {no_blocks, ImageDefect::kNoBlocks, 22},
  };
  std::set<ImageDefect> seen;
  for (const Case& c : cases) {
    const ImageReport report = check_image(c.image);
    EXPECT_EQ(report.defect, c.defect) << explain(report);
    EXPECT_EQ(report.offset, c.offset) << explain(report);
    EXPECT_GT(explain(report).size(), 20U);
    seen.insert(report.defect);
  }
  EXPECT_EQ(seen.size(), 8U);
}

TEST(FirmwareImage, EveryCutIsADefect) {
  const Bytes whole = legal();
  for (std::size_t size = 0; size < whole.size(); ++size) {
    EXPECT_NE(check_image(std::span(whole).first(size)).defect, ImageDefect::kNone) << size;
  }
}

TEST(FirmwareImage, RandomBytesAreReadWithinTheirBounds) {
  test::Random random(3);
  int deep = 0;
  for (int i = 0; i < 20000; ++i) {
    Bytes image = legal();
    image.resize(22);
    const auto more = static_cast<std::size_t>(random.bits() % 64);
    for (std::size_t k = 0; k < more; ++k) image.push_back(static_cast<std::uint8_t>(random.bits() % 3));
    image.shrink_to_fit();  // so that the address sanitizer sees the first byte beyond
    const ImageReport report = check_image(image);
    deep += report.blocks > 0 ? 1 : 0;
    EXPECT_LE(report.offset, image.size());
  }
  EXPECT_GT(deep, 1000);
}

TEST(FirmwareImage, AFileIsReadWholeOrRefusedWithItsName) {
  const ScratchFolder folder;
  const std::string path = (folder.path() / "image.bin").string();
  Bytes image = {42};
  const auto refusal = [&](const std::string& name) { return read_image(name, image).sentence(); };
  const auto write = [&](const Bytes& bytes) {
    std::ofstream(path, std::ios::binary).write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  };
  EXPECT_THAT(refusal(path), StartsWith(path + ": not usable as firmware: No such file"));
  EXPECT_THAT(refusal(folder.path().string()), HasSubstr("it cannot be read"));
  write(Bytes(std::size_t{1} << 21));
  EXPECT_THAT(refusal(path), HasSubstr("larger than 1 MiB"));
  write({1, 2, 3});
  EXPECT_THAT(refusal(path), HasSubstr("AA 08"));
  EXPECT_EQ(image, Bytes{42}) << "what was refused changes nothing";
  write(legal());
  EXPECT_EQ(refusal(path), "");
  EXPECT_EQ(image, legal());
}

}  // namespace
}  // namespace isotouch::falcon
