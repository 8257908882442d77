#include "host/cloud/source_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "host/cloud/read_cloud.h"
#include "host/error.h"
#include "tests/support/scratch_folder.h"

namespace isotouch::cloud {
namespace {

std::string cube() {
  std::string text = "ply\nformat ascii 1.0\nelement vertex 8\n";
  for (const char* name : {"x", "y", "z", "nx", "ny", "nz"}) text += std::string("property float ") + name + "\n";
  text += "end_header\n";
  for (int corner = 0; corner < 8; ++corner) {
    const auto place = [&](int axis) { return (corner >> axis & 1) != 0 ? "1 " : "-1 "; };
    const std::string row = std::string(place(0)) + place(1) + place(2);
    text += row + row + "\n";
  }
  return text;
}

/// What comes out of a pipe can be read only once.
TEST(SourceFile, IsReadOnce) {
  const ScratchFolder folder;
  const std::filesystem::path pipe = folder.path() / "cloud.ply";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  std::thread writer([&] { std::ofstream(pipe) << cube(); });
  const SourceFile source(pipe);
  writer.join();
  EXPECT_FALSE(source.is_mesh());
  CloudReport report;
  EXPECT_EQ(read_cloud(source, report).size(), 8U);
  EXPECT_EQ(report.source_hash, source.hash());
}

/// A hill of 9 × 9 points, as an organised PCD file.
std::string hill() {
  std::string text = "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 9\nHEIGHT 9\nDATA ascii\n";
  for (int y = -4; y <= 4; ++y) {
    for (int x = -4; x <= 4; ++x)
      text += std::to_string(x) + ' ' + std::to_string(y) + ' ' + std::to_string(40 + 0.05 * (x * x + y * y)) + '\n';
  }
  return text;
}

TEST(SourceFile, AGridGivesNormalsThatFaceItsSensorOrTheViewpoint) {
  const ScratchFolder folder;
  const auto file = folder.write("hill.pcd", hill());
  CloudReport report;
  const OrientedPoints seen = read_cloud(file, report);
  EXPECT_EQ(seen.size(), 77U);
  EXPECT_EQ(report.edges, 4U);
  EXPECT_TRUE(report.has_normals);
  EXPECT_EQ(report.viewpoint, Eigen::Vector3d(0, 0, 0));
  EXPECT_EQ(report.warnings(), (std::vector<std::string>{"the normals were taken from the scan's grid and face its sensor",
                                                         "4 points were left out: at edges of the grid and at jumps in depth"}));
  const OrientedPoints behind = read_cloud(SourceFile(file, {.viewpoint = Eigen::Vector3d(0, 0, 100)}), report);
  ASSERT_EQ(behind.size(), 77U);
  for (std::size_t i = 0; i < 77; ++i) {
    EXPECT_LT(seen.normals[i].z(), -0.8);
    EXPECT_EQ(behind.normals[i], -seen.normals[i]);
  }
}

TEST(SourceFile, ACameraIsForDepthImagesOnly) {
  const ScratchFolder folder;
  EXPECT_THROW(SourceFile(folder.write("hill.pcd", hill()), {.camera = DepthCamera{}}), InputError);
  EXPECT_THROW(SourceFile(folder.write("hill.pcd", hill())).faces(), InputError);
}

TEST(SourceFile, ABrokenHeaderAndAnEmptyFileAreRefusedAtOnce) {
  const ScratchFolder folder;
  EXPECT_THROW(SourceFile(folder.write("a.ply", "ply\nformat nonsense\n")), InputError);
  EXPECT_THROW(SourceFile(folder.write("a.xyz", "")), InputError);
  EXPECT_THROW(SourceFile(folder.path() / "none.xyz"), InputError);
}

}  // namespace
}  // namespace isotouch::cloud
