#include "host/cloud/source_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cmath>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "host/cloud/read_cloud.h"
#include "host/error.h"
#include "tests/support/range_image.h"
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
  EXPECT_EQ(report.sensor.place, Eigen::Vector3d(0, 0, 0));
  EXPECT_EQ(report.warnings(), (std::vector<std::string>{"the normals were taken from the scan's grid and face its sensor",
                                                         "4 points were left out: at edges of the grid and at jumps in depth"}));
  const OrientedPoints behind = read_cloud(SourceFile(file, {.viewpoint = Eigen::Vector3d(0, 0, 100)}), report);
  ASSERT_EQ(behind.size(), 77U);
  for (std::size_t i = 0; i < 77; ++i) {
    EXPECT_LT(seen.normals[i].z(), -0.8);
    EXPECT_EQ(behind.normals[i], -seen.normals[i]);
  }
}

/// With `--no-viewpoint` the file counts as one that says nothing of its sensor.
TEST(SourceFile, WhatTheFileSaysOfItsSensorCanBeIgnored) {
  const ScratchFolder folder;
  const auto stated = [](std::string text) { return text.insert(text.find("DATA"), "VIEWPOINT 0 0 100 1 0 0 0\n"); };
  const SensorOptions none{.ignores_viewpoint = true};
  const Model image = SourceFile(folder.write("hill.pcd", stated(hill())), none).points();
  EXPECT_EQ(image.sensor.place, Eigen::Vector3d(0, 0, 0));
  EXPECT_TRUE(image.sensor.is_assumed);
  EXPECT_LT(image.normals[0].z(), -0.8);
  std::string list = stated(hill());
  list.replace(list.find("WIDTH 9\nHEIGHT 9"), 16, "WIDTH 81\nHEIGHT 1");
  EXPECT_EQ(SourceFile(folder.write("list.pcd", list)).points().sensor.place, Eigen::Vector3d(0, 0, 100));
  EXPECT_FALSE(SourceFile(folder.write("list.pcd", list), none).points().sensor.place);
}

/// A ball as a camera sees it from the origin, and then moved.
std::string ball_image(const std::string& viewpoint, const Eigen::Vector3d& moved, bool mirrored = false) {
  const test::RangeImage image = test::ball_image(0.05, 0.5);
  std::string text = "FIELDS x y z\nSIZE 8 8 8\nTYPE F F F\nWIDTH " + std::to_string(image.width) + "\nHEIGHT " +
                     std::to_string(image.height) + "\nVIEWPOINT " + viewpoint + "\nDATA ascii\n";
  for (std::size_t cell = 0; cell < image.pixels.size(); ++cell) {
    const std::size_t i = mirrored ? cell - cell % image.width + image.width - 1 - cell % image.width : cell;
    const auto [x, y, one] = image.ray(i);
    const double z = image.pixels[i].z;
    const Eigen::Vector3d p = Eigen::Vector3d(x * z, y * z, z) + moved;
    text += z == 0 ? "nan nan nan\n" : std::to_string(p.x()) + ' ' + std::to_string(p.y()) + ' ' + std::to_string(p.z()) + '\n';
  }
  return text;
}

/// Programs that know where the camera stood may leave the points in the camera's own frame.
TEST(SourceFile, AnImageInTheCamerasFrameWasSeenFromTheOriginWhateverTheFileStates) {
  const ScratchFolder folder;
  for (const char* stated : {"0.1 0.2 1.2 0 1 0 0", "0.5 -0.3 1.5 0 0.92388 0.382683 0", "0 -1.2 0.7 1 0 0 0"}) {
    for (const bool mirrored : {false, true}) {
      const Model image = SourceFile(folder.write("ball.pcd", ball_image(stated, {0, 0, 0}, mirrored))).points();
      ASSERT_EQ(image.sensor.place, Eigen::Vector3d(0, 0, 0)) << stated << mirrored;
      EXPECT_TRUE(image.sensor.refuted_place);
      for (std::size_t i = 0; i < image.positions.size(); ++i) ASSERT_LT(image.normals[i].dot(image.positions[i]), 0) << stated << mirrored;
    }
  }
}

TEST(SourceFile, AnImageInTheWorldsFrameWasSeenFromWhereTheFileStates) {
  const ScratchFolder folder;
  const Eigen::Vector3d place(0.1, 0.2, -1);
  for (const bool mirrored : {false, true}) {
    const Model image = SourceFile(folder.write("ball.pcd", ball_image("0.1 0.2 -1 1 0 0 0", place, mirrored))).points();
    ASSERT_EQ(image.sensor.place, place) << mirrored;
    EXPECT_FALSE(image.sensor.is_assumed);
    for (std::size_t i = 0; i < image.positions.size(); ++i) ASSERT_GT(image.normals[i].dot(place - image.positions[i]), 0) << mirrored;
  }
}

/// Neither coordinates in whole millimetres nor a wide lens refute the place that a file states.
TEST(SourceFile, ARoughMirroredImageWasSeenFromWhereTheFileStates) {
  const ScratchFolder folder;
  const Eigen::Vector3d place(0.3, 0.1, 0.4);
  for (const auto& [bend, step] : {std::pair{0.0, 0.002}, {1.0, 1e-6}}) {
    constexpr int kWidth = 120, kHeight = 100;
    std::string rows;
    for (int row = 0; row < kHeight; ++row) {
      for (int column = kWidth - 1; column >= 0; --column) {
        const double u = (column - 59.5) / 80, v = (row - 49.5) / 80, bent = 1 + bend * (u * u + v * v);
        const Eigen::Vector3d ray = Eigen::Vector3d(bent * u, bent * v, 1).normalized();
        const double middle = 0.35 * ray.z(), under = middle * middle - (0.35 * 0.35 - 0.1 * 0.1);  // a ball of 0.1 m
        if (under < 0) {
          rows += "nan nan nan\n";
          continue;
        }
        const Eigen::Vector3d p = ray * (middle - std::sqrt(under)) + place;
        for (int axis = 0; axis < 3; ++axis) rows += std::to_string(step * std::round(p[axis] / step)) + (axis < 2 ? ' ' : '\n');
      }
    }
    const Model image =
        SourceFile(folder.write("ball.pcd", "FIELDS x y z\nSIZE 8 8 8\nTYPE F F F\nWIDTH " + std::to_string(kWidth) + "\nHEIGHT " +
                                                std::to_string(kHeight) + "\nVIEWPOINT 0.3 0.1 0.4 1 0 0 0\nDATA ascii\n" + rows))
            .points();
    EXPECT_EQ(image.sensor.place, place) << bend;
    EXPECT_FALSE(image.sensor.refuted_place);
    for (std::size_t i = 0; i < image.normals.size(); ++i) ASSERT_GT(image.normals[i].dot(place - image.positions[i]), 0) << bend;
  }
}

/// Neither the place that the file states nor the origin: the camera stood at (0, 0, -1), and the ball lies at (0, 0, -0.5).
TEST(SourceFile, APlaceThatAnImageWasNotSeenFromIsNotTaken) {
  const ScratchFolder folder;
  const Model image = SourceFile(folder.write("ball.pcd", ball_image("0.1 0.2 0.7 1 0 0 0", {0, 0, -1}))).points();
  EXPECT_TRUE(image.normals.empty());
  EXPECT_FALSE(image.sensor.place);
  EXPECT_EQ(image.sensor.refuted_place, Eigen::Vector3d(0.1, 0.2, 0.7));
}

TEST(SourceFile, ARefutedPlaceOfTheSensorIsReported) {
  const ScratchFolder folder;
  const Eigen::Vector3d moved(0, 0, -1);
  const auto read = [&](const std::string& viewpoint, const SensorOptions& sensor) {
    CloudReport report;
    (void)read_cloud(SourceFile(folder.write("ball.pcd", ball_image(viewpoint, moved)), sensor), report);
    return report;
  };
  const CloudReport stated = read("0.1 0.2 0.7 1 0 0 0", {});
  const std::string sentence =
      "the image was not seen from the file's own place of the sensor, (0.1, 0.2, 0.7), and its grid was not used; if it was, give this "
      "place with --viewpoint";
  EXPECT_EQ(stated.sensor_doubt(), sentence);
  EXPECT_EQ(stated.warnings(), std::vector<std::string>{sentence});
  const CloudReport assumed = read("0 0 0 1 0 0 0", {});
  EXPECT_EQ(
      assumed.sensor_doubt(),
      "the image does not look as if its sensor had stood in the origin, and its grid was not used; if it did, give --viewpoint 0 0 0");
  EXPECT_TRUE(assumed.warnings().empty());
  EXPECT_EQ(read("0.1 0.2 0.7 1 0 0 0", {.ignores_viewpoint = true}).sensor_doubt(), assumed.sensor_doubt());
  EXPECT_EQ(read("0 0 0 1 0 0 0", {.viewpoint = moved}).sensor_doubt(), "");
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

/// A ball as a camera in the origin sees it, as a range image of PLY.
std::string ball_grid(const std::string& info) {
  const test::RangeImage image = test::ball_image(0.05, 0.5);
  std::string vertices, cells;
  std::size_t count = 0;
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const auto [x, y, one] = image.ray(i);
    const double z = image.pixels[i].z;
    cells += z == 0 ? "0\n" : "1 " + std::to_string(count) + '\n';
    if (z == 0) continue;
    vertices += std::to_string(x * z) + ' ' + std::to_string(y * z) + ' ' + std::to_string(z) + '\n';
    ++count;
  }
  return "ply\nformat ascii 1.0\nobj_info num_cols " + std::to_string(image.width) + "\nobj_info num_rows " + std::to_string(image.height) +
         '\n' + info + "element vertex " + std::to_string(count) +
         "\nproperty float x\nproperty float y\nproperty float z\nelement range_grid " + std::to_string(image.pixels.size()) +
         "\nproperty list uchar int vertex_indices\nend_header\n" + vertices + cells;
}

/// A file that does not name Stanford's scanner may come from any other camera.
TEST(SourceFile, ARangeImageMayRefuteAScannerThatItsFileDoesNotName) {
  const ScratchFolder folder;
  const Model image = SourceFile(folder.write("ball.ply", ball_grid(""))).points();
  EXPECT_EQ(image.sensor.place, Eigen::Vector3d(0, 0, 0));
  EXPECT_TRUE(image.sensor.is_assumed);
  EXPECT_FALSE(image.sensor.refuted_place) << "the file names none";
  ASSERT_FALSE(image.normals.empty());
  for (std::size_t i = 0; i < image.positions.size(); ++i) ASSERT_LT(image.normals[i].dot(image.positions[i]), 0);
  EXPECT_GT(SourceFile(folder.write("ball.ply", ball_grid("obj_info is_cyberware_data 1\n"))).points().sensor.place->z(), 1);
}

/// A scanner's view from far away is no camera's in the origin.
TEST(SourceFile, TheScannerThatAFileDoesNotNameIsAssumed) {
  const ScratchFolder folder;
  std::string vertices, cells;
  for (int i = 0; i < 81; ++i) {
    const int x = i % 9 - 4, y = 4 - i / 9;
    vertices += std::to_string(x) + ' ' + std::to_string(y) + ' ' + std::to_string(-0.05 * (x * x + y * y)) + '\n';
    cells += "1 " + std::to_string(i) + '\n';
  }
  const Model image =
      SourceFile(folder.write("hill.ply",
                              "ply\nformat ascii 1.0\nobj_info num_cols 9\nobj_info num_rows 9\nelement vertex 81\nproperty float "
                              "x\nproperty float y\nproperty float z\nelement range_grid 81\nproperty list uchar int "
                              "vertex_indices\nend_header\n" +
                                  vertices + cells))
          .points();
  ASSERT_TRUE(image.sensor.place);
  EXPECT_GT(image.sensor.place->z(), 100);
  EXPECT_TRUE(image.sensor.is_assumed) << "nobody says so";
}

/// Stanford's meshes may hold their faces as strips of triangles.
TEST(SourceFile, StripsOfTrianglesAreNoBareCloud) {
  const ScratchFolder folder;
  const auto mesh = [&](const std::string& normals) {
    return SourceFile(folder.write(
        "strips.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n" + normals +
                          "element tristrips 1\nproperty list int int vertex_indices\nend_header\n"
                          "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"));
  };
  const SourceFile strips = mesh("");
  EXPECT_TRUE(strips.is_mesh());
  EXPECT_EQ(strips.points().positions.size(), 3U) << "when somebody asks for them";
  try {
    (void)strips.faces();
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()), strips.name() +
                                             ": its faces are strips of triangles (element 'tristrips'), which are not read; save the mesh "
                                             "with faces");
  }
}

}  // namespace
}  // namespace isotouch::cloud
