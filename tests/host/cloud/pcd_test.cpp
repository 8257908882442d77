#include "host/cloud/pcd.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "host/error.h"
#include "shared/bytes.h"

namespace isotouch::cloud {
namespace {

using Eigen::Vector3d;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

template <class T>
std::string raw(T value) {
  std::uint8_t bytes[sizeof(T)];
  if constexpr (std::is_same_v<T, float>) {
    store_le(bytes, std::bit_cast<std::uint32_t>(value));
  } else if constexpr (std::is_same_v<T, double>) {
    store_le(bytes, std::bit_cast<std::uint64_t>(value));
  } else {
    store_le(bytes, value);
  }
  return {reinterpret_cast<const char*>(bytes), sizeof(T)};
}

/// What PCL's writer puts before the points.
std::string header(const std::string& fields, const std::string& sizes, const std::string& types, const std::string& counts,
                   std::size_t width, std::size_t height, const std::string& data, const std::string& viewpoint = "0 0 0 1 0 0 0") {
  return "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS " + fields + "\nSIZE " + sizes + "\nTYPE " + types + "\nCOUNT " +
         counts + "\nWIDTH " + std::to_string(width) + "\nHEIGHT " + std::to_string(height) + "\nVIEWPOINT " + viewpoint + "\nPOINTS " +
         std::to_string(width * height) + "\nDATA " + data + "\n";
}

std::string xyz_header(std::size_t width, std::size_t height, const std::string& data, const std::string& viewpoint = "0 0 0 1 0 0 0") {
  return header("x y z", "4 4 4", "F F F", "1 1 1", width, height, data, viewpoint);
}

Model read(const std::string& file) { return read_pcd("c.pcd", {reinterpret_cast<const std::uint8_t*>(file.data()), file.size()}); }

/// LZF without any repetition.
std::string stored(const std::string& bytes) {
  std::string packed;
  for (std::size_t at = 0; at < bytes.size(); at += 32) {
    const std::string part = bytes.substr(at, 32);
    packed += static_cast<char>(part.size() - 1) + part;
  }
  return raw(static_cast<std::uint32_t>(packed.size())) + raw(static_cast<std::uint32_t>(bytes.size())) + packed;
}

void expect_the_two_points(const Model& model) {
  ASSERT_EQ(model.positions.size(), 2U);
  ASSERT_EQ(model.normals.size(), 2U);
  EXPECT_EQ(model.positions[0], Vector3d(1, 2, 3));
  EXPECT_EQ(model.positions[1], Vector3d(-4.5, 5, 6));
  EXPECT_EQ(model.normals[0], Vector3d(0, 0, 1));
  EXPECT_EQ(model.normals[1], Vector3d(0, -1, 0));
  EXPECT_FALSE(model.sensor.place);
  EXPECT_FALSE(model.grid);
}

/// Fields that are skipped stand before, between and behind, one of them with several numbers.
const std::string kFields = "rgb x y histogram z normal_x normal_y normal_z label";
const std::string kSizes = "4 8 4 4 2 4 8 1 8";
const std::string kTypes = "U F F F I F F I U";
const std::string kCounts = "1 1 1 3 1 1 1 1 1";

TEST(Pcd, TheThreeFormsHoldTheSamePoints) {
  expect_the_two_points(
      read(header(kFields, kSizes, kTypes, kCounts, 2, 1, "ascii") + "255 1 2 7 8 9 3 0 0 1 4294967296\n\n0 -4.5 5 7 nan 9 6 0 -1 0 0\n"));
  const std::string rgb[] = {raw(std::uint32_t{255}), raw(std::uint32_t{0})}, x[] = {raw(1.0), raw(-4.5)}, y[] = {raw(2.0F), raw(5.0F)};
  const std::string histogram[] = {raw(7.0F) + raw(8.0F) + raw(9.0F), raw(7.0F) + raw(0.0F) + raw(9.0F)};
  const std::string z[] = {raw(std::int16_t{3}), raw(std::int16_t{6})}, nx[] = {raw(0.0F), raw(0.0F)}, ny[] = {raw(0.0), raw(-1.0)};
  const std::string nz[] = {raw(std::int8_t{1}), raw(std::int8_t{0})}, label[] = {raw(std::uint64_t{1} << 32), raw(std::uint64_t{0})};
  std::string by_point, by_field;
  for (int i = 0; i < 2; ++i) by_point += rgb[i] + x[i] + y[i] + histogram[i] + z[i] + nx[i] + ny[i] + nz[i] + label[i];
  for (const auto* field : {rgb, x, y, histogram, z, nx, ny, nz, label}) by_field += field[0] + field[1];
  expect_the_two_points(read(header(kFields, kSizes, kTypes, kCounts, 2, 1, "binary") + by_point));
  expect_the_two_points(read(header(kFields, kSizes, kTypes, kCounts, 2, 1, "binary_compressed") + stored(by_field)));
}

TEST(Pcd, EveryNumberType) {
  const auto first = [](const std::string& type, const std::string& size, const std::string& bytes) {
    const std::string file = header("x y z", size + " " + size + " " + size, type + " " + type + " " + type, "1 1 1", 1, 1, "binary");
    return read(file + bytes + bytes + bytes).positions[0];
  };
  EXPECT_EQ(first("I", "1", raw(std::int8_t{-3})), Vector3d(-3, -3, -3));
  EXPECT_EQ(first("U", "1", raw(std::uint8_t{253})), Vector3d(253, 253, 253));
  EXPECT_EQ(first("I", "2", raw(std::int16_t{-300})), Vector3d(-300, -300, -300));
  EXPECT_EQ(first("U", "2", raw(std::uint16_t{65000})), Vector3d(65000, 65000, 65000));
  EXPECT_EQ(first("I", "4", raw(std::int32_t{-70000})), Vector3d(-70000, -70000, -70000));
  EXPECT_EQ(first("U", "4", raw(std::uint32_t{4000000000})), Vector3d(4e9, 4e9, 4e9));
  EXPECT_EQ(first("I", "8", raw(std::int64_t{-5})), Vector3d(-5, -5, -5));
  EXPECT_EQ(first("U", "8", raw(std::uint64_t{5})), Vector3d(5, 5, 5));
  EXPECT_EQ(first("F", "4", raw(0.5F)), Vector3d(0.5, 0.5, 0.5));
  EXPECT_EQ(first("F", "8", raw(0.1)), Vector3d(0.1, 0.1, 0.1));
}

TEST(Pcd, PointsWithoutFiniteCoordinatesAreLeftOutAndCounted) {
  const Model model = read(xyz_header(3, 1, "ascii") + "nan nan nan\n1 2 3\n1 inf 3\n");
  EXPECT_EQ(model.positions, (std::vector<Vector3d>{{1, 2, 3}}));
  EXPECT_EQ(model.lines, (std::vector<std::size_t>{13}));
  EXPECT_EQ(model.incomplete, 2U);
}

TEST(Pcd, APointWithoutNormalIsLeftOutUnlessNoneHasOne) {
  const std::string begin = header("x y z normal_x normal_y normal_z", "4 4 4 4 4 4", "F F F F F F", "1 1 1 1 1 1", 2, 1, "ascii");
  const Model one = read(begin + "1 2 3 nan nan nan\n4 5 6 0 0 1\n");
  EXPECT_EQ(one.positions, (std::vector<Vector3d>{{4, 5, 6}}));
  EXPECT_EQ(one.incomplete, 1U);
  const Model none = read(begin + "1 2 3 nan nan nan\n4 5 6 0 nan 1\n");
  EXPECT_EQ(none.positions.size(), 2U);
  EXPECT_TRUE(none.normals.empty());
  EXPECT_EQ(none.incomplete, 0U);
}

TEST(Pcd, TheViewpointIsTheSensorsPlace) {
  EXPECT_FALSE(read(xyz_header(1, 1, "ascii") + "1 2 3\n").sensor.place);
  EXPECT_EQ(read(xyz_header(1, 1, "ascii", "7 -8 9.5 1 0 0 0") + "1 2 3\n").sensor.place, Vector3d(7, -8, 9.5));
  for (const char* origin : {"0 0 0 1 0 0 0", "0 0 0 0 0 0 1", "0 0 0 0 0 0 0", "0 0 0 0 1 0 0"})
    EXPECT_FALSE(read(xyz_header(1, 1, "ascii", origin) + "1 2 3\n").sensor.place) << origin;
}

TEST(Pcd, AnOrganisedCloudHasAGrid) {
  std::string body;
  for (const double x : {1.0, kNan, 2.0, 3.0, 4.0, kNan}) body += raw(static_cast<float>(x)) + raw(0.5F) + raw(1.0F);
  const Model model = read(xyz_header(3, 2, "binary", "0 0 -1 1 0 0 0") + body);
  EXPECT_EQ(model.positions.size(), 4U);
  EXPECT_EQ(model.incomplete, 0U) << "nothing returned there";
  ASSERT_TRUE(model.grid);
  EXPECT_EQ(model.grid->columns, 3U);
  EXPECT_EQ(model.grid->cells, (std::vector<std::uint32_t>{0, ScanGrid::kNoReturn, 1, 2, 3, ScanGrid::kNoReturn}));
  EXPECT_EQ(model.grid->sensor, Vector3d(0, 0, -1));
}

/// An image of 20 x 20 pixels, of which some have one place.
Model image_with_constant(int pixels, const std::string& constant) {
  std::string rows;
  for (int i = 0; i < 400; ++i) rows += i < pixels ? constant + '\n' : std::to_string(i % 20) + ' ' + std::to_string(i / 20) + " 40\n";
  return read(xyz_header(20, 20, "ascii") + rows);
}

TEST(Pcd, WhatManyPixelsHaveInCommonIsNoPoint) {
  for (const char* constant : {"0 0 0", "-1 -1 -1", "0 0 4", "nan nan nan"}) {
    const Model model = image_with_constant(82, constant);
    EXPECT_EQ(model.positions.size(), 318U) << constant;
    EXPECT_EQ(model.lines.size(), 318U) << constant;
    EXPECT_EQ(model.incomplete, 0U) << constant;
    ASSERT_TRUE(model.grid);
    for (std::size_t cell = 0; cell < 82; ++cell) ASSERT_EQ(model.grid->cells[cell], ScanGrid::kNoReturn) << constant;
    for (std::size_t cell = 82; cell < 400; ++cell) {
      ASSERT_EQ(model.grid->cells[cell], cell - 82) << constant;
      ASSERT_EQ(model.positions[cell - 82], Vector3d(static_cast<double>(cell % 20), static_cast<double>(cell / 20), 40));
    }
  }
  EXPECT_EQ(image_with_constant(81, "0 0 0").positions.size(), 400U) << "coarse coordinates";
}

/// Of versions before 0.7; carriage returns as Windows writes them.
TEST(Pcd, OldHeadersAreRead) {
  EXPECT_EQ(read("VERSION .5\r\nCOLUMNS x y z\r\nSIZE 4 4 4\r\nTYPE F F F\r\nPOINTS 1\r\nDATA ascii\r\n1 2 3\r\n").positions[0],
            Vector3d(1, 2, 3));
  EXPECT_EQ(read("FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 1\nHEIGHT 1\nDATA ascii\n1 2 3\n").positions.size(), 1U);
}

/// As the readers of text and PLY know them.
TEST(Pcd, NormalsHaveSeveralNames) {
  for (const char* names : {"nx ny nz", "NX NY NZ", "normal_x normal_y normal_z", "normalx normaly normalz"}) {
    const Model model =
        read(header(std::string("x Y z ") + names, "4 4 4 4 4 4", "F F F F F F", "1 1 1 1 1 1", 1, 1, "ascii") + "1 2 3 0 1 0\n");
    EXPECT_EQ(model.normals, (std::vector<Vector3d>{{0, 1, 0}})) << names;
    EXPECT_EQ(model.positions, (std::vector<Vector3d>{{1, 2, 3}})) << names;
  }
}

TEST(Pcd, OfTwoNamesTheFormatsOwnCounts) {
  for (const auto& [names, row] : {std::pair("x y z X normal_x normal_y normal_z nx ny nz", "1 2 3 4 0 1 0 5 6 7"),
                                   std::pair("X nx ny nz x y z normal_x normal_y normal_z", "4 5 6 7 1 2 3 0 1 0")}) {
    const Model model =
        read(header(names, "4 4 4 4 4 4 4 4 4 4", "F F F F F F F F F F", "1 1 1 1 1 1 1 1 1 1", 1, 1, "ascii") + row + '\n');
    EXPECT_EQ(model.positions, (std::vector<Vector3d>{{1, 2, 3}})) << names;
    EXPECT_EQ(model.normals, (std::vector<Vector3d>{{0, 1, 0}})) << names;
  }
  EXPECT_THAT(
      [] { read(header("x y z NX nx ny nz", "4 4 4 4 4 4 4", "F F F F F F F", "1 1 1 1 1 1 1", 1, 1, "ascii") + "1 2 3 0 0 1 0\n"); },
      ::testing::ThrowsMessage<InputError>(::testing::HasSubstr("fields 'NX' and 'nx' are the same; remove one of them")));
}

TEST(Pcd, AFieldOfStiffnessIsRead) {
  for (const bool binary : {false, true}) {
    const std::string body = binary ? raw(1.0F) + raw(2.0F) + raw(3.0F) + raw(0.5F) : "1 2 3 0.5\n";
    EXPECT_EQ(read(header("x y z stiffness", "4 4 4 4", "F F F F", "1 1 1 1", 1, 1, binary ? "binary" : "ascii") + body).stiffness,
              (std::vector<double>{0.5}));
  }
}

TEST(Pcd, WhatTheHeaderSaysTwiceOrBesidesIsRefused) {
  const auto refusal = [](const std::string& file) -> std::string {
    try {
      read(file);
    } catch (const InputError& error) {
      return error.what();
    }
    return "nothing was refused";
  };
  EXPECT_EQ(refusal("FIELDS x y z\nSIZE 8 8 8\nTYPE F F F\nFIELDS a x y z\nWIDTH 1\nDATA ascii\n0 1 2 3\n"),
            "c.pcd: line 4: FIELDS is declared twice");
  EXPECT_EQ(refusal(xyz_header(1, 1, "ascii", "0 0 0 1 0 0 0 7") + "1 2 3\n"),
            "c.pcd: line 9: '7' follows the last number of the viewpoint");
  const std::string packed = xyz_header(1, 1, "binary_compressed") + stored(raw(1.0F) + raw(2.0F) + raw(3.0F));
  EXPECT_EQ(read(packed + std::string(3, '\0')).positions.size(), 1U) << "padding";
  EXPECT_EQ(refusal(packed + "more"), "c.pcd: 4 bytes follow the last point that the header declares; its counts are wrong");
}

}  // namespace
}  // namespace isotouch::cloud
