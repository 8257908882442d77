#include "host/view/png_file.h"

#include <gtest/gtest.h>
#include <png.h>

#include <string>

#include "host/error.h"

namespace isotouch::view {
namespace {

TEST(PngFile, HoldsThePixelsThatWereGiven) {
  Image image(5, 3, srgb(0x102030));
  image.at(4, 0) = srgb(0xFF8001);
  image.at(0, 2) = {2.0F, -1.0F, 0.0F};  // too bright and darker than black: cut off
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "pixels.png";
  write_png(file, image);

  png_image read{};
  read.version = PNG_IMAGE_VERSION;
  ASSERT_NE(png_image_begin_read_from_file(&read, file.c_str()), 0) << read.message;
  read.format = PNG_FORMAT_RGB;
  ASSERT_EQ(read.width, 5U);
  ASSERT_EQ(read.height, 3U);
  std::vector<std::uint8_t> pixels(PNG_IMAGE_SIZE(read));
  ASSERT_NE(png_image_finish_read(&read, nullptr, pixels.data(), 0, nullptr), 0) << read.message;
  const auto pixel = [&](std::size_t x, std::size_t y) {
    const std::uint8_t* p = pixels.data() + 3 * (5 * y + x);
    return (std::uint32_t{p[0]} << 16) | (std::uint32_t{p[1]} << 8) | p[2];
  };
  EXPECT_EQ(pixel(0, 0), 0x102030U);
  EXPECT_EQ(pixel(4, 0), 0xFF8001U);
  EXPECT_EQ(pixel(0, 2), 0xFF0000U);
  std::filesystem::remove(file);
}

TEST(PngFile, EveryByteSurvivesTheWayThroughLight) {
  for (std::uint32_t byte = 0; byte < 256; ++byte) EXPECT_EQ(to_byte(srgb(byte).b), byte);
}

TEST(PngFile, APlaceThatCannotBeWrittenIsNamedInOneSentence) {
  const std::string file = testing::TempDir() + "no_such_folder/picture.png";
  try {
    write_png(file, Image(2, 2));
    FAIL() << "nothing was thrown";
  } catch (const InputError& e) {
    EXPECT_NE(std::string(e.what()).find(file), std::string::npos) << e.what();
    EXPECT_EQ(std::string(e.what()).find('\n'), std::string::npos) << e.what();
  }
}

}  // namespace
}  // namespace isotouch::view
