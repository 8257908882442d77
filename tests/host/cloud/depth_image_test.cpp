#include "host/cloud/depth_image.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "host/error.h"
#include "tests/support/png16.h"

namespace isotouch::cloud {
namespace {

using Eigen::Vector3d;
using ::testing::HasSubstr;

const DepthCamera kCamera{.fx = 4, .fy = 2, .cx = 0.5, .cy = 1, .units_per_metre = 1000};

std::string rows_of(const std::vector<std::uint16_t>& depths) {
  std::string rows;
  for (const std::uint16_t depth : depths) rows += {static_cast<char>(depth >> 8), static_cast<char>(depth & 0xff)};
  return rows;
}

Model read(const std::string& file, const DepthCamera& camera = kCamera) {
  return read_depth_image("d.png", {reinterpret_cast<const std::uint8_t*>(file.data()), file.size()}, camera);
}

std::string refusal(const std::string& file) {
  try {
    read(file);
  } catch (const InputError& e) {
    return e.what();
  }
  return "accepted";
}

TEST(DepthImage, APixelIsAPlaceBeforeTheCamera) {
  const Model model = read(test::png(2, 2, rows_of({1000, 0, 2000, 65535})));
  ASSERT_EQ(model.positions.size(), 3U);
  EXPECT_EQ(model.positions[0], Vector3d(-0.125, -0.5, 1));  // column 0, row 0
  EXPECT_EQ(model.positions[1], Vector3d(-0.25, 0, 2));      // column 0, row 1
  EXPECT_EQ(model.positions[2], Vector3d(0.125 * 65.535, 0, 65.535));
  EXPECT_EQ(model.grid->columns, 2U);
  EXPECT_EQ(model.grid->cells, (std::vector<std::uint32_t>{0, ScanGrid::kNoReturn, 1, 2}));
  EXPECT_EQ(model.grid->sensor, Vector3d::Zero());
  EXPECT_TRUE(model.normals.empty());
}

/// One frame of a stream shows nothing when somebody stands before the camera.
TEST(DepthImage, AnImageMayShowNothing) {
  const Model model = read(test::png(2, 1, rows_of({0, 0})));
  EXPECT_TRUE(model.positions.empty());
  EXPECT_EQ(model.grid->cells, (std::vector<std::uint32_t>{ScanGrid::kNoReturn, ScanGrid::kNoReturn}));
}

TEST(DepthImage, ScaleDividesEveryLength) {
  DepthCamera tum = kCamera;
  tum.units_per_metre = 5000;
  EXPECT_EQ(read(test::png(1, 1, rows_of({5000})), tum).positions[0], Vector3d(-0.125, -0.5, 1));
}

/// A picture would be brightened; a depth is a number.
TEST(DepthImage, GammaChangesNothing) {
  const std::string gamma = test::png_chunk("gAMA", test::big_endian(100000 / 2));
  EXPECT_EQ(read(test::png(1, 1, rows_of({12345}), 16, 0, gamma)).positions[0].z(), 12.345);
}

TEST(DepthImage, OtherPicturesAreRefused) {
  EXPECT_THAT(refusal(test::png(2, 1, "ab", 8)),
              HasSubstr("d.png: a depth image holds one 16-bit grey value a pixel, this PNG file has 8 bits"));
  EXPECT_THAT(refusal(test::png(1, 1, "abcdef", 16, 2)), HasSubstr("16 bits and 3 channels"));
  EXPECT_THAT(refusal("plain text"), HasSubstr("d.png: the PNG file is damaged"));
}

TEST(DepthImage, DamageIsFound) {
  const std::string sound = test::png(2, 2, rows_of({1000, 1000, 2000, 65535}));
  for (std::size_t size = 0; size < sound.size(); ++size) {
    EXPECT_THAT(refusal(sound.substr(0, size)), HasSubstr("d.png: the PNG file is damaged")) << size;
  }
  std::string turned = sound;
  turned[sound.size() - 20] ^= 1;
  EXPECT_THAT(refusal(turned), HasSubstr("d.png: the PNG file is damaged"));
}

/// Another size in the header of a small image, and so many bytes behind it.
std::string of_size(std::uint32_t width, std::uint32_t height, std::size_t more = 0) {
  std::string lie = test::png(2, 2, rows_of({1, 1, 1, 1}));
  const std::string header = test::png_chunk("IHDR", test::big_endian(width) + test::big_endian(height) + lie.substr(24, 5));
  return lie.replace(8, header.size(), header) + std::string(more, '\0');
}

/// Two lies in the header: memory is not taken for either.
TEST(DepthImage, MorePixelsThanTheFileCanHoldAreRefused) {
  for (const auto& [width, height] : {std::pair{1000000U, 1000000U}, {2U, 900000U}})
    EXPECT_THAT(refusal(of_size(width, height)), HasSubstr("pixels, more than the file has room for")) << width;
}

/// An empty image of any size may pack a thousandfold.
TEST(DepthImage, MorePixelsThanAnySensorHasAreRefused) {
  EXPECT_THAT(refusal(of_size(8192, 4097, 70'000)), HasSubstr("8192 × 4097 pixels are more than the 33554432"));
  EXPECT_THAT(refusal(of_size(4097, 8192, 70'000)), HasSubstr("pixels are more than"));
  EXPECT_THAT(refusal(of_size(8192, 4096, 70'000)), HasSubstr("the PNG file is damaged"));
}

}  // namespace
}  // namespace isotouch::cloud
