/// A mesh is scanned by touch, built from the points that were felt, and compared with itself: the paper's experiment as a test.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>

#include "tests/host/commands/run_command.h"
#include "tests/support/accuracy.h"
#include "tests/support/scratch_folder.h"

namespace isotouch {
namespace {

/// What a command prints with --json.
nlohmann::json run(const std::string& arguments) { return nlohmann::json::parse(commands::run_command(arguments)); }

struct RoundTrip {
  nlohmann::json scan, compare;
};

RoundTrip round_trip(const std::string& mesh, const ScratchFolder& folder, const std::string& scan_options,
                     const std::string& build_options) {
  const std::string at = folder.path().string() + "/scan";
  const auto scan = run("scan " + mesh + " -o " + at + ".ply --trace " + at + ".trace --json " + scan_options);
  run("build " + at + ".ply -o " + at + ".itf --json " + build_options);
  return {scan, run("compare " + at + ".itf " + mesh + " --json")};
}

TEST(ScanRoundTrip, ATorusFeltAllOverComesBack) {
  const ScratchFolder folder;
  const auto file = folder.path() / "torus.obj";
  {
    constexpr int kAround = 120, kTube = 60;
    std::ofstream out(file);
    out.precision(12);
    for (int i = 0; i < kAround; ++i) {
      for (int j = 0; j < kTube; ++j) {
        const double u = 2 * std::numbers::pi * i / kAround, v = 2 * std::numbers::pi * j / kTube;
        const double reach = 3 + 1.2 * std::cos(v);
        out << "v " << reach * std::cos(u) << ' ' << reach * std::sin(u) << ' ' << 1.2 * std::sin(v) << '\n';
      }
    }
    const auto number = [](int i, int j) { return i % kAround * kTube + j % kTube + 1; };
    for (int i = 0; i < kAround; ++i) {
      for (int j = 0; j < kTube; ++j) {
        out << "f " << number(i, j) << ' ' << number(i + 1, j) << ' ' << number(i + 1, j + 1) << ' ' << number(i, j + 1) << '\n';
      }
    }
  }
  const auto [scan, compare] = round_trip(file.string(), folder, "--seconds 150 --points 2000", "--grid 80");
  EXPECT_GT(scan["coverage"], 0.98);
  EXPECT_EQ(scan["points"], 2000);
  EXPECT_EQ(compare["lost"], 0);
  EXPECT_EQ(compare["components"], 1);
  EXPECT_THAT(compare["rms_voxel"].get<double>(), test::IsAccuracyOf(0.011));
  EXPECT_THAT(compare["normal_rms_deg"].get<double>(), test::IsAccuracyOf(3.0));
  EXPECT_LT(compare["hausdorff_voxel"], 1);
  EXPECT_NEAR(compare["volume_ratio"].get<double>(), 1, 0.002);
}

TEST(HeavyScanRoundTrip, RealMeshesComeBack) {
  const char* data = std::getenv("ISOTOUCH_DATA");
  if (data == nullptr) GTEST_SKIP() << "ISOTOUCH_DATA is not set";
  for (const std::string name : {"spot", "koala", "penguin"}) {
    const ScratchFolder folder;
    const auto [scan, compare] = round_trip(std::string(data) + "/meshes/" + name + ".ply", folder, "", "");
    EXPECT_GT(scan["coverage"], 0.95) << name;
    EXPECT_LT(compare["rms_voxel"], 0.15) << name;
    EXPECT_GT(compare["rms_voxel"], 0.02) << name;
    EXPECT_LT(compare["lost"], 200) << name;
    EXPECT_LT(compare["normal_rms_deg"], 8) << name;
    EXPECT_NEAR(compare["volume_ratio"].get<double>(), 1, 0.03) << name;
  }
}

}  // namespace
}  // namespace isotouch
