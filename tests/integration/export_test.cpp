/// What `isotouch export` writes for other programs lies where the field lies, in both frames, and comes back there.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "host/cloud/ply.h"
#include "host/cloud/read_mesh.h"
#include "host/cloud/shapes.h"
#include "host/error.h"
#include "host/evaluate/compare_mesh.h"
#include "host/evaluate/zero_surface.h"
#include "host/field/parallel.h"
#include "host/field_file/open_field.h"
#include "host/files/whole_file.h"
#include "host/motion/felt_surface.h"
#include "shared/bytes.h"
#include "shared/crc32.h"
#include "tests/host/commands/run_command.h"
#include "tests/support/accuracy.h"
#include "tests/support/scratch_folder.h"

namespace isotouch {
namespace {

using commands::run_command;
using Eigen::Vector3d;

/// The largest distance of a mesh's corners from a field's surface, in its voxels.
double farthest_corner(const cloud::TriangleMesh& mesh, const FieldView& field) {
  const motion::FeltSurface felt(field);
  double worst = 0;
  for (const Vector3d& corner : mesh.vertices) worst = std::max(worst, std::abs(felt.sample(corner).distance) / felt.voxel_mm());
  return worst;
}

class Export : public ::testing::Test {
 protected:
  std::string file(const std::string& name) const { return (folder_.path() / name).string(); }

  /// Points of the hydrant in metres, as a surveyor's instrument gives them: far from the origin.
  void build_far_away(const std::string& size) const {
    cloud::OrientedPoints points = cloud::sample_shape(cloud::shape("hydrant"), 3000);
    for (Vector3d& p : points.positions) p = 0.0021 * p + Vector3d(431250.5, -5400321.25, 812.0625);
    cloud::write_ply(file("far.ply"), points);
    run_command("build " + file("far.ply") + " -o " + file("far.itf") + " --grid 70 " + size);
  }
  /// Compares a field with a mesh in the frame of its scan.
  nlohmann::json compare(const std::string& field, const std::string& mesh) const {
    return nlohmann::json::parse(run_command("compare " + file(field) + ' ' + file(mesh) + " --json"));
  }

 private:
  ScratchFolder folder_;
};

TEST_F(Export, ASurfaceIsClosedAndLiesOnItsFieldInEveryFormat) {
  build_far_away("--units m");
  const auto field = field_file::open_field(file("far.itf"));
  const std::vector<evaluate::Piece> pieces = evaluate::pieces(evaluate::zero_surface(field.view));
  for (const char* name : {"a.ply", "a.obj", "a.stl"}) {
    run_command("export " + file("far.itf") + " -o " + file(name));
    const cloud::TriangleMesh mesh = cloud::read_mesh(file(name));
    ASSERT_NO_THROW(cloud::require_closed(mesh, name));
    for (std::size_t face = 0; face < mesh.faces.size(); ++face) ASSERT_GT(cloud::face_normal(mesh, face).norm(), 0.5) << name;
    EXPECT_THAT(farthest_corner(mesh, field.view), test::IsAccuracyOf(0.004)) << name;
    const std::vector<evaluate::Piece> written = evaluate::pieces(mesh);
    EXPECT_EQ(written.size(), pieces.size()) << name;
    EXPECT_NEAR(evaluate::volume(written) / evaluate::volume(pieces), 1, 3e-3) << name;
  }
}

TEST_F(Export, InTheScansFrameASurfaceLiesOnItsPoints) {
  build_far_away("--fit 53mm");
  for (const char* name : {"a.ply", "a.obj"}) {
    run_command("export " + file("far.itf") + " -o " + file(name) + " --input-frame");
    const nlohmann::json found = compare("far.itf", name);
    EXPECT_LE(found["lost"], 4) << "of 20,000, at creases";
    EXPECT_THAT(found["hausdorff_voxel"].get<double>(), test::IsAccuracyOf(0.3)) << name << ": chords at sharp creases";
    EXPECT_THAT(found["rms_voxel"].get<double>(), test::IsAccuracyOf(0.045)) << name;
  }
}

TEST_F(Export, AFieldBuiltFromItsSurfaceIsTheSameToATenthOfAVoxel) {
  build_far_away("--units m");
  run_command("export " + file("far.itf") + " -o " + file("a.ply"));
  run_command("build " + file("a.ply") + " --units mm --grid 90 -o " + file("again.itf"));
  const nlohmann::json there = compare("again.itf", "a.ply");
  EXPECT_LT(there["lost"], 40) << "of 20,000: the chain is thinner than a voxel";
  EXPECT_LT(there["rms_voxel"], 0.1);
  EXPECT_GT(there["rms_voxel"], 0.001) << "edges of triangles are rounded";
}

TEST_F(Export, TheBytesDoNotDependOnTheThreads) {
  build_far_away("--units m");
  for (const std::string ending : {".ply", ".stl"}) {
    for (const unsigned threads : {1U, 2U, 7U}) {
      const field::ThreadLimit limit(threads);
      run_command("export " + file("far.itf") + " -o " + file(std::to_string(threads) + ending));
    }
    EXPECT_EQ(read_file(file("1" + ending)), read_file(file("2" + ending)));
    EXPECT_EQ(read_file(file("1" + ending)), read_file(file("7" + ending)));
  }
}

TEST_F(Export, AFieldWithoutDistancesHasNoLevelSet) {
  cloud::write_ply(file("torus.ply"), cloud::sample_shape(cloud::shape("torus"), 1000));
  run_command("build " + file("torus.ply") + " -o " + file("a.itf") + " --grid 40 --method published");
  EXPECT_THROW(run_command("export " + file("a.itf") + " -o " + file("a.vdb")), InputError);
  EXPECT_FALSE(std::filesystem::exists(file("a.vdb")));
  run_command("export " + file("a.itf") + " -o " + file("a.ply"));
}

TEST_F(Export, AnImpossiblePlacementIsRefusedWhereverTheScansFrameIsAskedFor) {
  build_far_away("--fit 53mm");
  run_command("export " + file("far.itf") + " -o " + file("far.itfi"));
  write_file(file("places.csv"), "431250.5,-5400321.25,812.0625\n");
  const std::vector<std::uint8_t> bytes = read_file(file("far.itfi"));
  const std::string sample = "sample " + file("a.itfi") + ' ' + file("places.csv") + " --input-frame";
  const auto place = [&](double scale, double offset) {
    using namespace image_layout;
    std::vector<std::uint8_t> moved = bytes;
    store_le(&moved[kScaleAt], std::bit_cast<std::uint64_t>(scale));
    for (const std::size_t axis : {0U, 1U, 2U}) store_le(&moved[kOffsetAt + 8 * axis], std::bit_cast<std::uint64_t>(offset));
    store_le(&moved[kChecksumAt], crc32(&moved[kTotalBytesAt], moved.size() - kTotalBytesAt));
    write_file(file("a.itfi"), moved.data(), moved.size());
  };
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  for (const auto& [scale, offset] :
       std::vector<std::pair<double, double>>{{0, 0}, {-1, 0}, {NAN, 0}, {kInfinite, 0}, {1, NAN}, {1e-320, 0}, {1e-13, 0}, {1, 1e15}}) {
    place(scale, offset);
    EXPECT_THROW(run_command(sample), InputError) << scale << ' ' << offset;
    EXPECT_THROW(run_command("export " + file("a.itfi") + " -o " + file("a.obj") + " --input-frame"), InputError) << scale << ' ' << offset;
  }
  place(1e-10, 0);  // of a scan in small units
  run_command(sample);
  run_command("export " + file("a.itfi") + " -o " + file("a.obj") + " --input-frame");
  EXPECT_GT(cloud::read_mesh(file("a.obj")).faces.size(), 1000U);
  place(1e5, 0);
  write_file(file("places.csv"), "1e305,0,0\n");
  EXPECT_THROW(run_command(sample), InputError);
}

TEST_F(Export, WhatHasNoOtherFrameSaysSo) {
  build_far_away("--units m");
  EXPECT_THROW(run_command("export " + file("far.itf") + " -o " + file("a.itfi") + " --input-frame"), CLI::ValidationError);
  EXPECT_THROW(run_command("export " + file("far.itf") + " -o " + file("a.stl") + " --input-frame"), InputError) << "half a metre apart";
  EXPECT_FALSE(std::filesystem::exists(file("a.stl")));
}

}  // namespace
}  // namespace isotouch
