#include "host/cloud/ply.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <string>
#include <vector>

#include "host/error.h"
#include "host/files/whole_file.h"
#include "shared/bytes.h"
#include "tests/support/scratch_folder.h"

namespace isotouch::cloud {
namespace {

using Eigen::Vector3d;

Model read(const std::string& text) { return read_ply("f.ply", {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}); }

/// The value's bytes in either order.
template <class T>
std::string raw(T value, bool big_endian) {
  std::uint8_t bytes[sizeof(T)];
  if constexpr (std::is_same_v<T, float>) {
    store_le(bytes, std::bit_cast<std::uint32_t>(value));
  } else if constexpr (std::is_same_v<T, double>) {
    store_le(bytes, std::bit_cast<std::uint64_t>(value));
  } else {
    store_le(bytes, value);
  }
  if (big_endian) std::reverse(bytes, bytes + sizeof(T));
  return {reinterpret_cast<const char*>(bytes), sizeof(T)};
}

void expect_the_two_points(const Model& model) {
  ASSERT_EQ(model.positions.size(), 2U);
  ASSERT_EQ(model.normals.size(), 2U);
  EXPECT_EQ(model.positions[0], Vector3d(1, 2, 3));
  EXPECT_EQ(model.positions[1], Vector3d(-4.5, 5, 6));
  EXPECT_EQ(model.normals[0], Vector3d(0, 0, 1));
  EXPECT_EQ(model.normals[1], Vector3d(0, -1, 0));
}

TEST(Ply, AsciiWithPropertiesAndElementsInAnyOrderAndListsToSkip) {
  const Model model = read(
      "ply\nformat ascii 1.0\ncomment any\nobj_info any\n"
      "element face 2\nproperty uchar flag\nproperty list uchar int vertex_indices\n"
      "element vertex 2\nproperty float nz\nproperty float x\nproperty list uchar int neighbours\nproperty double y\nproperty float nx\n"
      "property uchar red\nproperty float z\nproperty float ny\n"
      "element material 1\nproperty int a\nend_header\n"
      "7 3 0 1 0\n7 4 0 1 1 0\n"
      "1 1 2 8 9 2 0 255 3 0\n\n0 -4.5 0 5 0 255 6 -1\n"
      "3\n");
  expect_the_two_points(model);
  EXPECT_EQ(model.faces.size(), 3U);  // a triangle, and a square cut in two
  EXPECT_EQ(model.lines, (std::vector<std::size_t>{22, 24}));
}

TEST(Ply, BothByteOrdersAndEveryNumberType) {
  for (const bool big : {false, true}) {
    std::string text = "ply\r\nformat binary_";
    text += big ? "big" : "little";
    text +=
        "_endian 1.0\r\nelement vertex 2\r\nproperty double x\r\nproperty float32 y\r\nproperty short z\r\nproperty list uint16 int8 "
        "skipped\r\n"
        "property int nx\r\nproperty int8 ny\r\nproperty uchar nz\r\nproperty uint32 label\r\nend_header\r\n";
    text += raw(1.0, big) + raw(2.0F, big) + raw(std::int16_t{3}, big) + raw(std::uint16_t{3}, big) + "abc" + raw(std::int32_t{0}, big) +
            raw(std::int8_t{0}, big) + raw(std::uint8_t{1}, big) + raw(std::uint32_t{77}, big);
    text += raw(-4.5, big) + raw(5.0F, big) + raw(std::int16_t{6}, big) + raw(std::uint16_t{0}, big) + raw(std::int32_t{0}, big) +
            raw(std::int8_t{-1}, big) + raw(std::uint8_t{0}, big) + raw(std::uint32_t{77}, big);
    const Model model = read(text);
    expect_the_two_points(model);
    EXPECT_EQ(model.format, big ? "PLY, binary big-endian" : "PLY, binary little-endian");
  }
}

TEST(Ply, NumbersThatAreNotUsedMayBeAnything) {
  const Model model = read(
      "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\nproperty float "
      "quality\nend_header\n1 2 3 nan\n");
  EXPECT_EQ(model.positions.size(), 1U);
  EXPECT_TRUE(model.normals.empty());
}

TEST(Ply, WhatIsWrittenIsReadToTheLastBit) {
  const ScratchFolder folder;
  const OrientedPoints points{{Vector3d(0.1, -1e-300, 1e10), Vector3d(1.0 / 3, 2, 3)}, {Vector3d(0.6, 0.8, 0), Vector3d(0, 0, 1)}};
  const auto file = folder.path() / "cloud.ply";
  write_ply(file, points, "a remark");
  const auto bytes = read_file(file);
  const Model model = read_ply(file.string(), bytes);
  EXPECT_EQ(model.positions, points.positions);
  EXPECT_EQ(model.normals, points.normals);
}

TEST(Ply, AStiffnessIsReadAndWrittenBack) {
  const Model model = read(
      "ply\nformat ascii 1.0\nelement vertex 2\nproperty float stiffness\nproperty float x\nproperty float y\nproperty float z\n"
      "property float nx\nproperty float ny\nproperty float nz\nend_header\n0.5 1 2 3 0 0 1\n1.25 -4.5 5 6 0 -1 0\n");
  expect_the_two_points(model);
  EXPECT_EQ(model.stiffness, (std::vector<double>{0.5, 1.25}));

  const ScratchFolder folder;
  write_ply(folder.path() / "points.ply", {model.positions, model.normals, model.stiffness});
  const Model again = read_ply("points.ply", read_file(folder.path() / "points.ply"));
  expect_the_two_points(again);
  EXPECT_EQ(again.stiffness, model.stiffness);
  write_ply(folder.path() / "points.ply", {model.positions, model.normals, {}});
  EXPECT_TRUE(read_ply("points.ply", read_file(folder.path() / "points.ply")).stiffness.empty());
}

/// Of three columns and two rows, in which one cell returned nothing and one twice.
std::string range_image(const std::string& info) {
  return "ply\nformat ascii 1.0\n" + info +
         "obj_info num_cols 3\nobj_info num_rows 2\nobj_info echo_frames 512\nbye\n"
         "element vertex 6\nproperty float x\nproperty float y\nproperty float z\n"
         "element range_grid 6\nproperty list uchar int vertex_indices\nend_header\n"
         "0 0 0\n1 0 0\n2 0 0\n0 2 0\n2 2 0\n2 2 1\n1 0\n1 1\n1 2\n1 3\n0 \n2 5 4\n";
}

TEST(Ply, ARangeGridSaysWhichVertexIsInWhichCell) {
  const Model model = read(range_image("obj_info is_cyberware_data 1\nobj_info is_warped 0\n"));
  ASSERT_TRUE(model.grid);
  EXPECT_EQ(model.grid->columns, 3U);
  EXPECT_EQ(model.grid->cells, (std::vector<std::uint32_t>{0, 1, 2, 3, ScanGrid::kNoReturn, 5}));
  EXPECT_TRUE(model.faces.empty());
}

TEST(Ply, TheSensorOfARangeGridIsFarAwayOrTheOrigin) {
  const auto direction = [](const std::string& info) -> Vector3d {
    const Vector3d sensor = read(range_image(info)).grid->sensor;
    return sensor.isZero() ? sensor : Vector3d((sensor - Vector3d(1, 1, 0.5)) / 2000);
  };
  EXPECT_EQ(direction(""), Vector3d(0, 0, 1));
  EXPECT_LT((direction("obj_info is_warped 1\n") - Vector3d(0.5, 0, std::sqrt(0.75))).norm(), 1e-12);
  EXPECT_LT((direction("obj_info is_warped 1\nobj_info is_right_mirror_open 0\n") - Vector3d(-0.5, 0, std::sqrt(0.75))).norm(), 1e-12);
  EXPECT_EQ(direction("obj_info is_cyberware_data 0\n"), Vector3d(0, 0, 0));
}

TEST(Ply, AGridThatIsNoImageIsNotUsed) {
  EXPECT_FALSE(read(range_image("obj_info is_linear_scan 0\n")).grid) << "the object was turned before the scanner";
  std::string unknown = range_image("");
  unknown.replace(unknown.find("num_cols"), 8, "any_cols");
  EXPECT_FALSE(read(unknown).grid);
}

/// As the readers of text and PCD know them.
TEST(Ply, NormalsHaveSeveralNames) {
  for (const std::string name : {"n*", "N*", "normal_*", "normal*", "Normal_*"}) {
    std::string text = "ply\nformat ascii 1.0\nelement vertex 1\nproperty float X\nproperty float y\nproperty float z\n";
    for (const char axis : {'x', 'y', 'z'}) {
      std::string own = name;
      own.replace(own.find('*'), 1, 1, axis);
      text += "property float " + own + "\n";
    }
    text += "end_header\n1 2 3 0 1 0\n";
    const Model model = read(text);
    EXPECT_EQ(model.normals, (std::vector<Vector3d>{{0, 1, 0}})) << name;
    EXPECT_EQ(model.positions, (std::vector<Vector3d>{{1, 2, 3}})) << name;
  }
}

TEST(Ply, OfTwoNamesTheFormatsOwnCounts) {
  const std::string begin = "ply\nformat ascii 1.0\nelement vertex 1\n";
  const std::string own = "property float x\nproperty float y\nproperty float z\nproperty float nx\nproperty float ny\nproperty float nz\n";
  const std::string other = "property float X\nproperty float Nx\nproperty float Ny\nproperty list uchar float normal_z\n";
  for (const std::string& text :
       {begin + own + other + "end_header\n1 2 3 0 1 0 4 5 6 1 7\n", begin + other + own + "end_header\n4 5 6 1 7 1 2 3 0 1 0\n"}) {
    const Model model = read(text);
    EXPECT_EQ(model.positions, (std::vector<Vector3d>{{1, 2, 3}}));
    EXPECT_EQ(model.normals, (std::vector<Vector3d>{{0, 1, 0}}));
  }
  EXPECT_THAT([&] { read(begin + own + "property float stiffness\nproperty float stiffness\nend_header\n1 2 3 0 1 0 1 1\n"); },
              ::testing::Throws<InputError>());
  EXPECT_THAT(
      [&] {
        read(begin +
             "property float x\nproperty float y\nproperty float z\nproperty float NX\n"
             "property float normal_x\nend_header\n1 2 3 0 0\n");
      },
      ::testing::ThrowsMessage<InputError>(::testing::HasSubstr("'NX' and 'normal_x' of element 'vertex' are the same; remove one")));
}

TEST(Ply, TextHoldsTheDeclaredFloats) {
  const Model model = read(
      "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty double y\nproperty float32 z\nend_header\n500000.03 0.1 "
      "1e200\n");
  EXPECT_EQ(model.positions, (std::vector<Vector3d>{{500000.03125, 0.1, 1e200}}));
}

TEST(Ply, StiffnessIsReadInAnyCase) {
  EXPECT_EQ(read("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\nproperty double "
                 "Stiffness\nend_header\n1 2 3 0.2\n")
                .stiffness,
            (std::vector<double>{0.2}));
}

}  // namespace
}  // namespace isotouch::cloud
