#include "host/view/picture.h"

#include <gtest/gtest.h>
#include <png.h>

#include <regex>
#include <string>

#include "host/error.h"
#include "host/view/canvas.h"
#include "host/view/text.h"

namespace isotouch::view {
namespace {

std::filesystem::path in_temp(const char* name) { return std::filesystem::path(testing::TempDir()) / name; }

std::string text_of(const std::vector<std::uint8_t>& bytes) { return {bytes.begin(), bytes.end()}; }

/// An image below a line and letters.
Picture example() {
  Picture picture(200, 100, srgb(0x102030));
  Canvas canvas(picture);
  canvas.paint(Image(50, 50, srgb(0xFF8001)), 20, 10);
  canvas.line({0, 90}, {200, 90}, 2, srgb(0xFFFFFF));
  draw_text(canvas, {100, 60}, "force", {.capital = 12, .colour = srgb(0xFFFFFF)});
  return picture;
}

TEST(Picture, APngHoldsThePixelsThatWereGiven) {
  Image image(5, 3, srgb(0x102030));
  image.at(4, 0) = srgb(0xFF8001);
  image.at(0, 2) = {2.0F, -1.0F, 0.0F};  // too bright and darker than black: cut off
  Picture picture(5, 3);
  Canvas(picture).paint(image);
  const std::filesystem::path file = in_temp("pixels.png");
  write_picture(file, picture);

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

TEST(Picture, ItsPixelsAreThoseOfThePng) {
  const Image image = example().pixels();
  EXPECT_EQ(to_byte(image.at(25, 15).g), 0x80);
  EXPECT_EQ(to_byte(image.at(100, 90).r), 0xFF);
  EXPECT_EQ(to_byte(image.at(195, 5).b), 0x30);
}

TEST(Picture, EveryByteSurvivesTheWayThroughLight) {
  for (std::uint32_t byte = 0; byte < 256; ++byte) EXPECT_EQ(to_byte(srgb(byte).b), byte);
}

TEST(Picture, AnSvgHasItsSizeAndLinesInsteadOfPixels) {
  const std::string svg = text_of(encode(example(), ".svg"));
  EXPECT_NE(svg.find("<svg"), std::string::npos);
  EXPECT_NE(svg.find("viewBox=\"0 0 200 100\""), std::string::npos) << svg.substr(0, 300);
  EXPECT_NE(svg.find("stroke-linecap"), std::string::npos);
  EXPECT_NE(svg.find("data:image/png"), std::string::npos) << "the image within it";
}

TEST(Picture, APdfIsOnePageOfItsSize) {
  const std::string pdf = text_of(encode(example(), ".pdf"));
  EXPECT_EQ(pdf.substr(0, 5), "%PDF-");
  EXPECT_NE(pdf.find("MediaBox [ 0 0 150 75 ]"), std::string::npos);
}

TEST(Picture, TheSamePictureGivesTheSameBytes) {
  for (const char* ending : {".png", ".svg", ".pdf"}) {
    // Cairo counts the surfaces of a process, and calls them sources since 1.18, so the first of another process has the same number.
    const auto bytes = [&] {
      return std::regex_replace(text_of(encode(example(), ending)), std::regex("(surface|image|source-)[0-9]+"), "$1");
    };
    EXPECT_EQ(bytes(), bytes()) << ending;
  }
}

TEST(Picture, TheNameSaysTheFormat) {
  for (const auto& [name, begin] : {std::pair{"a.SVG", "<?xml"}, std::pair{"a.pdf", "%PDF-"}, std::pair{"a", "\x89PNG"}}) {
    const std::filesystem::path file = in_temp(name);
    write_picture(file, example());
    std::FILE* open = std::fopen(file.c_str(), "rb");
    ASSERT_NE(open, nullptr);
    char found[6] = {};
    EXPECT_NE(std::fread(found, 1, 5, open), 0U);
    std::fclose(open);
    EXPECT_EQ(std::string(found).substr(0, std::string(begin).size()), begin) << name;
    std::filesystem::remove(file);
  }
}

TEST(Picture, APlaceThatCannotBeWrittenIsNamedInOneSentence) {
  const std::string file = testing::TempDir() + "no_such_folder/picture.png";
  try {
    write_picture(file, Picture(2, 2));
    FAIL() << "nothing was thrown";
  } catch (const InputError& e) {
    EXPECT_NE(std::string(e.what()).find(file), std::string::npos) << e.what();
    EXPECT_EQ(std::string(e.what()).find('\n'), std::string::npos) << e.what();
  }
}

}  // namespace
}  // namespace isotouch::view
