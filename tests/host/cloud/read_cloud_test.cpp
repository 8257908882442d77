#include "host/cloud/read_cloud.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <vector>

#include "host/error.h"

namespace isotouch::cloud {
namespace {

using Eigen::Vector3d;

/// Real clouds; the folder is named by ISOTOUCH_DATA.
class RealClouds : public ::testing::Test {
 protected:
  void SetUp() override {
    const char* folder = std::getenv("ISOTOUCH_DATA");
    if (folder == nullptr) GTEST_SKIP() << "ISOTOUCH_DATA names no folder";
    clouds_ = std::filesystem::path(folder) / "clouds";
  }

  OrientedPoints read(const std::string& name) { return read_cloud(clouds_ / name, report_); }

  std::filesystem::path clouds_;
  CloudReport report_;
};

/// A point as it would stand in a file of floats.
std::array<float, 6> as_floats(const OrientedPoints& cloud, std::size_t i) {
  std::array<float, 6> row{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    row[axis] = static_cast<float>(cloud.positions[i][static_cast<Eigen::Index>(axis)]);
    row[3 + axis] = static_cast<float>(cloud.normals[i][static_cast<Eigen::Index>(axis)]);
  }
  return row;
}

TEST_F(RealClouds, AllAreReadWithTheirNormalsOutward) {
  std::size_t read_files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(clouds_)) {
    if (entry.path().extension() != ".ply") continue;
    ++read_files;
    const OrientedPoints cloud = read_cloud(entry.path(), report_);
    EXPECT_GE(cloud.size(), 3725U) << entry.path();
    EXPECT_EQ(cloud.size(), report_.points_read) << entry.path();
    EXPECT_TRUE(report_.has_normals) << entry.path();
    EXPECT_THAT(report_.warnings(), ::testing::IsEmpty()) << entry.path();
  }
  EXPECT_GE(read_files, 15U);
}

TEST_F(RealClouds, KittenAsTextEqualsItsPly) {
  const OrientedPoints ply = read("kitten.ply");
  const OrientedPoints text = read("foreign/kitten.xyz");
  ASSERT_EQ(ply.size(), 5210U);
  ASSERT_EQ(text.size(), 5210U);
  for (std::size_t i = 0; i < ply.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      ASSERT_EQ(static_cast<float>(ply.positions[i][axis]), static_cast<float>(text.positions[i][axis])) << i;
    }
    ASSERT_LT((ply.normals[i] - text.normals[i]).norm(), 2e-7) << i;
  }
}

TEST_F(RealClouds, EveryPointOfTheThinnedElephantIsInTheWholeOne) {
  const OrientedPoints thinned = read("elephant.ply");
  const OrientedPoints whole = read("foreign/elephant.pwn");
  ASSERT_EQ(whole.size(), 10000U);
  const auto position = [](const OrientedPoints& cloud, std::size_t i) {
    const auto row = as_floats(cloud, i);
    return std::array{row[0], row[1], row[2]};
  };
  std::vector<std::array<float, 3>> places;
  for (std::size_t i = 0; i < whole.size(); ++i) places.push_back(position(whole, i));
  std::sort(places.begin(), places.end());
  for (std::size_t i = 0; i < thinned.size(); ++i) ASSERT_TRUE(std::binary_search(places.begin(), places.end(), position(thinned, i))) << i;
}

TEST_F(RealClouds, DrillAsObjFindsItsNormalsThroughTheFaces) {
  EXPECT_EQ(read("foreign/drill.obj").size(), 7866U);
  EXPECT_TRUE(report_.has_normals);
}

TEST_F(RealClouds, OniIsReadInDouble) {
  const OrientedPoints cloud = read("foreign/oni.ply");
  EXPECT_EQ(cloud.size(), 1435U);
  EXPECT_EQ(cloud.positions[0], Vector3d(-0.120621, -0.048544, -0.228788));
}

TEST_F(RealClouds, AMeshWithoutNormalsIsReadAsPointsThatHaveNone) {
  EXPECT_EQ(read("foreign/bun_zipper_res4.ply").size(), 453U);
  EXPECT_FALSE(report_.has_normals);
}

}  // namespace
}  // namespace isotouch::cloud
