#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "host/cloud/ply.h"
#include "host/cloud/shapes.h"
#include "host/error.h"
#include "host/files/whole_file.h"
#include "tests/host/commands/build_fixture.h"
#include "tests/support/png16.h"
#include "tests/support/range_image.h"

namespace isotouch::commands {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

/// A depth image of a ball half a metre before the camera, in tenths of a millimetre.
///
/// step    of so many columns and rows only one was seen; from 2 on no pixel has neighbours, so the grid gives no normals
std::string ball_png(std::size_t step = 1) {
  const test::RangeImage image = test::ball_image(0.05, 0.5);
  std::string rows;
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const bool is_seen = i % image.width % step == 0 && i / image.width % step == 0;
    const auto depth = is_seen ? static_cast<unsigned>(std::lround(image.pixels[i].z * 10000)) : 0U;
    rows += {static_cast<char>(depth >> 8), static_cast<char>(depth & 0xff)};
  }
  return test::png(static_cast<std::uint32_t>(image.width), static_cast<std::uint32_t>(image.height), rows);
}

/// The same ball as PCL would save it, without its grid.
std::string ball_pcd(const std::string& viewpoint) {
  const test::RangeImage image = test::ball_image(0.05, 0.5);
  std::string rows;
  std::size_t points = 0;
  for (std::size_t i = 0; i < image.pixels.size(); i += 5) {
    const double z = image.pixels[i].z;
    if (z == 0) continue;
    const auto [x, y, one] = image.ray(i);
    rows += std::to_string(x * z) + ' ' + std::to_string(y * z) + ' ' + std::to_string(z) + '\n';
    ++points;
  }
  return "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nVIEWPOINT " + viewpoint + "\nPOINTS " + std::to_string(points) + "\nDATA ascii\n" + rows;
}

/// What becomes of scans that are open, doubtful, without normals, or seen by one camera.
class BuildScan : public Build {};

TEST_F(BuildScan, AnOpenScanIsClosedAndItsRimTold) {
  const cloud::OrientedPoints sphere = cloud::sample_shape(cloud::shape("sphere"), 4000);
  cloud::OrientedPoints half;
  for (std::size_t i = 0; i < sphere.size(); ++i) {
    if (sphere.positions[i].z() > 0) continue;
    half.positions.push_back(sphere.positions[i]);
    half.normals.push_back(sphere.normals[i]);
  }
  cloud::write_ply(file("half.ply"), half);
  const auto json = nlohmann::json::parse(run("build " + file("half.ply") + " -o " + file("h.itf") + " --grid 80 --json"));
  ASSERT_EQ(json["warnings"].size(), 2U);
  EXPECT_THAT(json["warnings"][0].get<std::string>(), HasSubstr("only one side"));
  const auto warning = json["warnings"][1].get<std::string>();
  const std::string start = "the scan is open: its rims are about ";
  ASSERT_EQ(warning.rfind(start, 0), 0U) << warning;
  const double equator = M_PI * 70;
  EXPECT_NEAR(std::stod(warning.substr(start.size())), equator, 0.15 * equator);
  EXPECT_NEAR(json["verdict"]["rim_mm"].get<double>(), equator, 0.15 * equator);
  EXPECT_TRUE(json["verdict"]["plausible"].get<bool>());
  const auto info = nlohmann::json::parse(run("info " + file("h.itf") + " --surface --json"));
  EXPECT_EQ(info["components"], 1);
  EXPECT_NEAR(info["invented_share"].get<double>(), 1.4 / 3.4, 0.04) << "disc and wall beside half a sphere";
  EXPECT_NEAR(info["invented_share"].get<double>(), json["verdict"]["invented_share"].get<double>(), 0.02);
  EXPECT_THAT(run("info " + file("h.itf")), HasSubstr("% of the surface, where nobody scanned"));
  const double with_back = 2.0 / 3 * M_PI * 35 * 35 * 35 + 7 * M_PI * 35 * 35;  // a wall of a tenth of the side goes on behind the rim
  EXPECT_NEAR(info["volume_mm3"].get<double>(), with_back, 0.1 * with_back);
}

TEST_F(BuildScan, MarksOfInventedSurfaceStayInPackedFilesAlone) {
  cloud::OrientedPoints half = cloud::sample_shape(cloud::shape("sphere"), 2000);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < half.size(); ++i) {
    if (half.positions[i].z() > 0) continue;
    half.positions[kept] = half.positions[i];
    half.normals[kept++] = half.normals[i];
  }
  half.positions.resize(kept);
  half.normals.resize(kept);
  cloud::write_ply(file("half.ply"), half);
  run("build " + file("half.ply") + " -o " + file("h.itf") + " --grid 40");
  const auto share = [&](const char* name) {
    const auto info = nlohmann::json::parse(run("info " + file(name) + " --json"));
    return info.contains("invented_share") ? info["invented_share"].get<double>() : -1;
  };
  run("export " + file("h.itf") + " -o " + file("again.itf"));
  EXPECT_GT(share("h.itf"), 0.3);
  EXPECT_EQ(share("again.itf"), share("h.itf"));
  run("export " + file("h.itf") + " -o " + file("h.itfi"));
  EXPECT_EQ(share("h.itfi"), -1) << "an image knows nothing of them";
  EXPECT_THAT(run("info " + file("h.itfi")), Not(HasSubstr("invented")));
  EXPECT_EQ(run("info " + file("h.itf") + " --key hash"), run("info " + file("h.itfi") + " --key hash"));
  for (const char* name : {"h.itf", "h.itfi"})
    run("render surface " + file(name) + " --size 320x320 --view 200,10 -o " + file(name) + ".png");
  EXPECT_NE(read_file(file("h.itf.png")), read_file(file("h.itfi.png"))) << "only one of them shows what was invented";
}

TEST_F(BuildScan, AnImplausibleFieldIsRefusedUnlessAccepted) {
  cloud::OrientedPoints points = cloud::sample_shape(cloud::shape("sphere"), 1000);
  for (std::size_t i = 0; i < points.size(); ++i) points.normals[i] = points.normals[(7 * i + 13) % points.size()];
  cloud::write_ply(file("bad.ply"), points);
  const std::string build = "build " + file("bad.ply") + " -o " + file("b.itf") + " --grid 40 --json";
  EXPECT_THROW(run(build), InputError);
  EXPECT_FALSE(fs::exists(file("b.itf")));
  const auto json = nlohmann::json::parse(run(build + " --accept-implausible"));
  EXPECT_FALSE(json["verdict"]["plausible"].get<bool>());
  EXPECT_GE(json["verdict"]["reasons"].size(), 1U);
  for (const char* key : {"noise_spacing", "stray_share", "turned_share", "invented_share", "rim_mm", "volume_of_hull"}) {
    EXPECT_TRUE(json["verdict"][key].is_number()) << key;
  }
  EXPECT_TRUE(fs::exists(file("b.itf")));
}

TEST_F(BuildScan, AnEmptyFieldIsNotOfferedToBeAccepted) {
  cloud::OrientedPoints ring;  // no surface
  for (int i = 0; i < 200; ++i) {
    const double angle = 2 * std::numbers::pi * i / 200;
    ring.normals.emplace_back(std::cos(angle), std::sin(angle), 0);
    ring.positions.emplace_back(50 * ring.normals.back());
  }
  cloud::write_ply(file("ring.ply"), ring);
  for (const char* accept : {"", " --accept-implausible"}) {
    try {
      run("build " + file("ring.ply") + " -o " + file("r.itf") + " --grid 40" + accept);
      FAIL();
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr("the field is empty"));
      EXPECT_THAT(error.what(), Not(HasSubstr("--accept-implausible")));
    }
  }
}

TEST_F(BuildScan, PointsWithoutNormalsGetThemAndThatIsSaid) {
  std::ofstream text(file("bare.xyz"));
  for (const auto& p : cloud::sample_shape(cloud::shape("torus"), 2000).positions) text << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
  text.close();
  const auto json = nlohmann::json::parse(run("build " + file("bare.xyz") + " -o " + file("bare.itf") + " --grid 60 --json"));
  EXPECT_THAT(json["warnings"][0].get<std::string>(), HasSubstr("normals were estimated"));
  EXPECT_TRUE(json["verdict"]["plausible"].get<bool>()) << json["verdict"].dump();
  EXPECT_THROW(run("build " + file("bare.xyz") + " -o " + file("x.itf") + " --normals file"), InputError);
}

TEST_F(BuildScan, NormalsThatNobodyCanUseDoNotHinderEstimatedOnes) {
  cloud::OrientedPoints torus = cloud::sample_shape(cloud::shape("torus"), 2000);
  for (std::size_t i = 0; i < torus.size(); ++i) torus.normals[i] *= i % 2 == 0 ? 0.0 : 255.0;
  cloud::write_ply(file("torus.ply"), torus);
  EXPECT_NO_THROW(run("build " + file("torus.ply") + " -o " + file("t.itf") + " --grid 60 --normals estimate"));
}

/// A relief in its own frame, row by row, as PCL saves an organised cloud whose sensor nobody set.
std::string relief_pcd() {
  std::string rows;
  for (int row = 0; row < 60; ++row) {
    for (int column = 0; column < 60; ++column) {
      const double x = column - 29.5, y = 29.5 - row;
      rows += std::to_string(x) + ' ' + std::to_string(y) + ' ' + std::to_string(8 + 6 * std::exp(-(x * x + y * y) / 300)) + '\n';
    }
  }
  return "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 60\nHEIGHT 60\nVIEWPOINT 0 0 0 1 0 0 0\nDATA ascii\n" + rows;
}

TEST_F(BuildScan, AnImageThatNobodySawFromTheOriginNeedsAViewpoint) {
  std::ofstream(file("relief.pcd")) << relief_pcd();
  const std::string build = "build " + file("relief.pcd") + " -o " + file("r.itf") + " --grid 40 --json";
  try {
    run(build);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("give the sensor's place with --viewpoint X Y Z, or scan all round; if several views were merged, "
                                        "save the scan with outward normals; the image does not look as if its sensor had stood "
                                        "in the origin, and its grid was not used; if it did, give --viewpoint 0 0 0"));
  }
  EXPECT_NO_THROW(run(build + " --viewpoint 0 0 500"));
}

TEST_F(BuildScan, AScanWithoutASideIsRefusedWhateverTheMethod) {
  cloud::OrientedPoints points = cloud::sample_shape(cloud::shape("sphere"), 1000);
  for (std::size_t i = 0; i < points.size(); ++i) points.normals[i] = points.normals[(7 * i + 13) % points.size()];
  cloud::write_ply(file("bad.ply"), points);
  const std::string build = "build " + file("bad.ply") + " -o " + file("b.itf") + " --method published --grid 30";
  try {
    run(build);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("the normals do not agree on which side is outside"));
  }
  EXPECT_FALSE(fs::exists(file("b.itf")));
  EXPECT_NO_THROW(run(build + " --accept-implausible"));
}

TEST_F(BuildScan, ADepthImageBecomesAOneSidedBodyOfItsTrueSize) {
  std::ofstream(file("ball.png"), std::ios::binary) << ball_png();
  const std::string camera = " --intrinsics 500,480,80.25,58.5 --depth-scale 10000";
  const auto json =
      nlohmann::ordered_json::parse(run("build " + file("ball.png") + camera + " --units m --grid 60 -o " + file("b.itf") + " --json"));
  EXPECT_GT(json["points"], 7000);
  const auto warnings = json["warnings"].get<std::vector<std::string>>();
  EXPECT_THAT(warnings, ::testing::Contains("the normals were taken from the scan's grid and face its sensor"));
  EXPECT_THAT(warnings, ::testing::Contains(HasSubstr("only one side was scanned")));
  EXPECT_EQ(json["verdict"]["plausible"], true);
  // A little less than half of a ball of 50 mm was seen, and the camera sees it in the direction of -z.
  const auto info = nlohmann::ordered_json::parse(run("info " + file("b.itf") + " --json"));
  EXPECT_NEAR(info["voxel_mm"].get<double>(), 100.0 / 60, 0.06);
}

/// Its camera stands in the origin whatever is said: no advice about the sensor leads anywhere.
TEST_F(BuildScan, ADepthImageNeedsNoWordOfItsSensor) {
  for (const std::size_t step : {1U, 2U}) {
    std::ofstream(file("ball.png"), std::ios::binary) << ball_png(step);
    for (const char* said : {"", " --no-viewpoint", " --viewpoint 0 0 0", " --normals estimate --no-viewpoint"}) {
      const auto json =
          nlohmann::json::parse(run("build " + file("ball.png") + " --intrinsics 500,480,80.25,58.5 --depth-scale 10000 --grid 40 -o " +
                                    file("b.itf") + " --json" + said));
      EXPECT_THAT(json["warnings"].dump(), Not(HasSubstr("viewpoint"))) << step << said;
    }
  }
}

TEST_F(BuildScan, ADepthImageSaysWhereItsNormalsComeFromOnce) {
  std::ofstream(file("ball.png"), std::ios::binary) << ball_png();
  const auto warnings = [&](const char* normals) {
    return nlohmann::json::parse(run("build " + file("ball.png") +
                                     " --intrinsics 500,480,80.25,58.5 --depth-scale 10000 --grid 40 --json -o " + file("b.itf") +
                                     " --accept-implausible --normals " + normals))["warnings"]
        .dump();
  };
  EXPECT_THAT(warnings("file"), HasSubstr("taken from the scan's grid"));
  EXPECT_THAT(warnings("file"), Not(HasSubstr("estimated")));
  EXPECT_THAT(warnings("estimate"), HasSubstr("normals were estimated from the points"));
  EXPECT_THAT(warnings("estimate"), Not(HasSubstr("taken from the scan's grid")));
}

TEST_F(BuildScan, APrincipalPointOutsideTheImageIsDoubted) {
  std::ofstream(file("ball.png"), std::ios::binary) << ball_png();
  const auto is_doubted = [&](const std::string& camera) {
    const auto json =
        nlohmann::ordered_json::parse(run("build " + file("ball.png") + " --intrinsics " + camera +
                                          " --depth-scale 10000 --units m --grid 60 --accept-implausible --json -o " + file("b.itf")));
    const auto warnings = json["warnings"].get<std::vector<std::string>>();
    return std::ranges::any_of(warnings, [](const std::string& w) { return w.starts_with("the principal point CX,CY lies outside"); });
  };
  EXPECT_FALSE(is_doubted("500,480,80.25,58.5"));
  EXPECT_TRUE(is_doubted("500,480,80.25,200"));
  EXPECT_TRUE(is_doubted("500,480,-1,58.5"));
}

TEST_F(BuildScan, ADepthImageNeedsACameraAndNothingElseDoes) {
  std::ofstream(file("ball.png"), std::ios::binary) << ball_png();
  EXPECT_THROW(run("build " + file("ball.png") + " -o " + file("b.itf")), InputError);
  for (const char* wrong :
       {"0,500,80,60", "500,-1,80,60", "nan,500,80,60", "500,500,inf,60", "1e999,500,80,60", "500,500,80", "500,500,80,60,1", "a,b,c,d"}) {
    EXPECT_THROW(run("build " + file("ball.png") + " --intrinsics " + wrong + " -o " + file("b.itf")), CLI::ParseError) << wrong;
  }
  for (const char* wrong : {"0", "-1", "nan", "1e99"}) {
    EXPECT_THROW(run("build " + file("ball.png") + " --intrinsics 500,480,80,60 --depth-scale " + wrong + " -o " + file("b.itf")),
                 CLI::ParseError)
        << wrong;
  }
  EXPECT_THROW(run("build " + file("ball.png") + " --depth-scale 5000 -o " + file("b.itf")), CLI::ParseError);
  EXPECT_THROW(run("build " + file("torus.ply") + " --intrinsics 500,480,80,60 -o " + file("b.itf")), InputError);
  EXPECT_FALSE(fs::exists(file("b.itf")));
}

TEST_F(BuildScan, AFilesViewpointTellsTheSideUnlessTheCommandLineDoes) {
  std::ofstream(file("stated.pcd")) << ball_pcd("0 0 -0.1 1 0 0 0");
  std::ofstream(file("default.pcd")) << ball_pcd("0 0 0 1 0 0 0");
  const std::string options = " --grid 40 --accept-implausible --json -o " + file("b.itf");
  const std::string sentence =
      "the sensor's place is the file's own, (0, 0, -0.1); --viewpoint names another one, and --no-viewpoint ignores it";
  const auto stated = nlohmann::ordered_json::parse(run("build " + file("stated.pcd") + options));
  EXPECT_THAT(stated["warnings"].get<std::vector<std::string>>(), ::testing::Contains(sentence));
  std::ofstream(file("turned.pcd")) << ball_pcd("0 0 -0.1 0.8 0 0.6 0");
  const auto turned = nlohmann::ordered_json::parse(run("build " + file("turned.pcd") + options));
  EXPECT_THAT(
      turned["warnings"].get<std::vector<std::string>>(),
      ::testing::Contains(sentence + ". The file says, too, that the sensor was turned: if its points are in the sensor's own frame, "
                                     "give --viewpoint 0 0 0"));
  const auto own = nlohmann::ordered_json::parse(run("build " + file("stated.pcd") + " --viewpoint 0 0 1" + options));
  EXPECT_THAT(own["warnings"].get<std::vector<std::string>>(), ::testing::Not(::testing::Contains(HasSubstr("the file's own"))));
  EXPECT_NE(own["hash"], stated["hash"]) << "the cup instead of the ball";
  EXPECT_THROW(run("build " + file("default.pcd") + options), InputError) << "nobody says where the sensor was";
  EXPECT_THROW(run("build --no-viewpoint " + file("stated.pcd") + options), InputError) << "the same";
}

}  // namespace
}  // namespace isotouch::commands
