/// Level sets there and back: OpenVDB's own sphere, felt as the core samples it; a field, exported and read again.
#include <gtest/gtest.h>
#include <openvdb/io/File.h>
#include <openvdb/openvdb.h>
#include <openvdb/tools/LevelSetSphere.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>

#include "firmware/core/field_sampler.h"
#include "host/cloud/ply.h"
#include "host/cloud/random.h"
#include "host/cloud/shapes.h"
#include "host/encoding/write_image.h"
#include "host/evaluate/compare_mesh.h"
#include "host/evaluate/zero_surface.h"
#include "host/field_file/open_field.h"
#include "host/files/whole_file.h"
#include "host/to_double.h"
#include "host/vdb/level_set.h"
#include "tests/host/commands/run_command.h"
#include "tests/support/accuracy.h"
#include "tests/support/field_image.h"
#include "tests/support/scratch_folder.h"

namespace isotouch {
namespace {

using commands::run_command;
using Eigen::Vector3d;

Vec3<Voxel> index_of(const field_file::OpenField& field, const Vector3d& place) {
  return to_fixed<Voxel>(Vector3d((place - to_double(field.view.origin)) / to_double(field.view.edge)));
}

struct Errors {
  double distance_voxel = 0;
  double normal_deg = 0;
};

/// The largest errors of the core's distance and gradient within half a voxel of a sphere round the origin.
Errors against_sphere(const field_file::OpenField& field, double radius) {
  cloud::Random random(11);
  const double edge = to_double(field.view.edge);
  Errors worst;
  for (int i = 0; i < 5000; ++i) {
    Vector3d way;
    do {
      way = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    } while (way.norm() > 1 || way.norm() < 0.1);
    const Vector3d place = (radius + random.uniform(-0.5, 0.5) * edge) * way.normalized();
    const core::FieldSample sample = core::sample_field(field.view, index_of(field, place));
    const double cosine = to_double(sample.gradient).normalized().dot(way.normalized());
    worst.distance_voxel = std::max(worst.distance_voxel, std::abs(to_double(sample.distance) - (place.norm() - radius) / edge));
    worst.normal_deg = std::max(worst.normal_deg, std::acos(std::min(1.0, cosine)) * 180 / M_PI);
  }
  return worst;
}

/// The largest difference of what the core samples at the nodes of a field, and there in another, whose object was moved; voxels.
double largest_difference(const FieldView& first, const field_file::OpenField& second) {
  const Vector3d move = encoding::info_of(second.view).placement.offset;
  double worst = 0;
  for (std::int32_t n = 0; n < first.size[0] * first.size[1] * first.size[2]; ++n) {
    const Eigen::Vector3i node(n % first.size[0], n / first.size[0] % first.size[1], n / first.size[0] / first.size[1]);
    const Vector3d place = to_double(first.origin) + to_double(first.edge) * node.cast<double>() + move;
    const double there = to_double(core::sample_field(second.view, index_of(second, place)).distance);
    worst =
        std::max(worst, std::abs(there - to_double(core::sample_field(first, to_fixed<Voxel>(Vector3d(node.cast<double>()))).distance)));
  }
  return worst;
}

class LevelSetAcross : public ::testing::Test {
 protected:
  std::string file(const std::string& name) const { return (folder_.path() / name).string(); }

  /// A sphere of radius 7 round (1, 2, 3), by the library itself.
  void make_sphere(const std::string& name, double turn = 0) const {
    openvdb::initialize();
    const auto grid = openvdb::tools::createLevelSetSphere<openvdb::FloatGrid>(7.0F, openvdb::Vec3f(1, 2, 3), 0.2F, 3.0F);
    grid->transform().postRotate(turn, openvdb::math::Z_AXIS);
    openvdb::io::File(file(name)).write({grid});
  }

  void expect_true_export(const std::string& name) const;

 private:
  ScratchFolder folder_;
};

TEST_F(LevelSetAcross, ASphereOfOpenvdbIsFeltAsASphere) {
  make_sphere("a.vdb");
  run_command("build " + file("a.vdb") + " -o " + file("a.itf") + " --units mm");
  const auto field = field_file::open_field(file("a.itf"));
  EXPECT_NEAR(to_double(field.view.edge), 0.2, 1e-6);
  EXPECT_EQ(to_double(field.view.band), 3);
  const Errors errors = against_sphere(field, 7);
  EXPECT_THAT(errors.distance_voxel, test::IsAccuracyOf(0.001));
  EXPECT_THAT(errors.normal_deg, test::IsAccuracyOf(0.1));
}

TEST_F(LevelSetAcross, ATurnedOrRefinedSphereIsStillFeltAsOne) {
  make_sphere("a.vdb", 0.4);
  for (const char* size : {"", " --voxel 0.13mm", " --grid 50"}) {
    run_command("build " + file("a.vdb") + " -o " + file("a.itf") + " --units mm" + size);
    const Errors errors = against_sphere(field_file::open_field(file("a.itf")), 7);
    EXPECT_LT(errors.distance_voxel, 0.02) << size;
    EXPECT_LT(errors.normal_deg, 0.5) << size;
  }
}

/// Exports the field `name`.itf as `name`.vdb, and compares every value of it with what the core samples there.
void LevelSetAcross::expect_true_export(const std::string& name) const {
  run_command("export " + file(name + ".itf") + " -o " + file(name + ".vdb"));
  const auto field = field_file::open_field(file(name + ".itf"));
  openvdb::io::File reader(file(name + ".vdb"));
  reader.open(false);
  const auto grid = openvdb::gridPtrCast<openvdb::FloatGrid>(reader.readGrid(name));
  ASSERT_TRUE(grid);
  EXPECT_EQ(grid->getGridClass(), openvdb::GRID_LEVEL_SET);
  const double edge = to_double(field.view.edge);
  const double band_mm = to_double(field.view.band) * edge;
  EXPECT_EQ(grid->background(), static_cast<float>(band_mm));
  EXPECT_EQ(grid->metaValue<std::string>("isotouch_unit"), "mm");
  int active = 0;
  double worst_mm = 0;
  for (std::int32_t k = 0; k < field.view.size[2]; ++k) {
    for (std::int32_t j = 0; j < field.view.size[1]; ++j) {
      for (std::int32_t i = 0; i < field.view.size[0]; ++i) {
        const openvdb::Vec3d world = grid->indexToWorld(openvdb::Coord(i, j, k));
        const Vector3d place = to_double(field.view.origin) + edge * Vector3d(i, j, k);
        ASSERT_NEAR((Vector3d(world.x(), world.y(), world.z()) - place).norm(), 0, 1e-12);
        const double felt = to_double(core::sample_field(field.view, index_of(field, place)).distance) * edge;
        const double held = std::clamp(felt, -band_mm, band_mm);
        worst_mm = std::max(worst_mm, std::abs(static_cast<double>(grid->tree().getValue(openvdb::Coord(i, j, k))) - held));
        ASSERT_EQ(grid->tree().isValueOn(openvdb::Coord(i, j, k)), std::abs(felt) < band_mm);
        if (std::abs(felt) < band_mm) ++active;
      }
    }
  }
  EXPECT_GT(active, 5'000);
  EXPECT_LT(worst_mm, 1e-6 * band_mm);
}

TEST_F(LevelSetAcross, AnExportHoldsWhatTheCoreSamplesAtEveryNode) {
  make_sphere("a.vdb");
  run_command("build " + file("a.vdb") + " -o " + file("b.itf") + " --fit 40mm");
  expect_true_export("b");
}

TEST_F(LevelSetAcross, AFieldThatJumpsOverTheBandKeepsItsSidesThereAndBack) {
  // A ball of which everything outside of a cap is far outside: from a sample inside, the cap is one step away.
  test::FieldOptions options = test::trilinear_options();
  options.largest_slope = 6;
  for (const int cap : {12, 13, 14, 15}) {  // at every place in a brick
    const auto distance = [&](const test::Point& p) {
      const double d = std::hypot(p[0] - 23.3, p[1] - 23.6, p[2] - 23.9) - 13;
      return p[0] <= cap && d > 0 ? 9 : d;
    };
    const test::FieldImage image({48, 48, 48}, distance, options);
    write_file(file("a.itf"), image.view().image.data(), image.view().image.size());
    expect_true_export("a");
    run_command("build " + file("a.vdb") + " -o " + file("b.itf") + " --units mm --interpolation trilinear");
    EXPECT_LT(largest_difference(image.view(), field_file::open_field(file("b.itf"))), 0.01) << cap;
  }
}

TEST_F(LevelSetAcross, ALiveFieldKeepsItsSidesThereAndBack) {
  const cloud::OrientedPoints points = cloud::sample_shape(cloud::shape("owl"), 8'000);
  Eigen::AlignedBox3d box;
  for (const Vector3d& p : points.positions) box.extend(p);
  cloud::OrientedPoints seen;  // all but a belt on one side: round the hole the field jumps
  for (std::size_t i = 0; i < points.positions.size(); ++i) {
    const double height = (points.positions[i].y() - box.center().y()) / box.sizes().y();
    if (std::abs(height) < 0.12 && points.normals[i].x() > 0.3) continue;
    seen.positions.push_back(points.positions[i]);
    seen.normals.push_back(points.normals[i]);
  }
  cloud::write_ply(file("seen.ply"), seen);
  run_command("build " + file("seen.ply") + " -o " + file("a.itf") + " --method live --grid 60 --accept-implausible");
  expect_true_export("a");
  const auto field = field_file::open_field(file("a.itf"));
  const vdb::LevelSet set = vdb::LevelSet::read(file("a.vdb"));
  ASSERT_TRUE(set.samples);
  double worst = 0;
  for (const field::Brick& brick : set.samples->bricks) {
    for (int n = 0; n < 64; ++n) {
      const Vector3d place = set.samples->grid.position(4 * brick.cell + Eigen::Vector3i(n & 3, n >> 2 & 3, n >> 4));
      const double there = std::clamp(static_cast<double>(brick.distance[static_cast<std::size_t>(n)]), -set.half_width, set.half_width);
      worst = std::max(worst, std::abs(there - to_double(core::sample_field(field.view, index_of(field, place)).distance)));
    }
  }
  EXPECT_LT(worst, 1e-4);
}

TEST_F(LevelSetAcross, AFieldComesBackFromAnExportToAFiveHundredthOfAVoxel) {
  make_sphere("a.vdb");
  run_command("build " + file("a.vdb") + " -o " + file("a.itf") + " --fit 40mm");
  run_command("export " + file("a.itf") + " -o " + file("b.vdb"));
  run_command("build " + file("b.vdb") + " -o " + file("b.itf") + " --units mm");
  const auto first = field_file::open_field(file("a.itf"));
  const auto second = field_file::open_field(file("b.itf"));
  EXPECT_EQ(second.view.edge.raw(), first.view.edge.raw());
  cloud::Random random(12);
  double worst = 0;
  int compared = 0;
  for (int i = 0; i < 20'000; ++i) {
    const Vector3d place(random.uniform(-20, 20), random.uniform(-20, 20), random.uniform(-20, 20));
    const Vector3d moved = place - encoding::info_of(second.view).placement.to_workspace(Vector3d::Zero());
    const double a = to_double(core::sample_field(first.view, index_of(first, moved)).distance);
    if (std::abs(a) > 0.5) continue;
    worst = std::max(worst, std::abs(to_double(core::sample_field(second.view, index_of(second, place)).distance) - a));
    ++compared;
  }
  EXPECT_GT(compared, 500);
  EXPECT_THAT(worst,
              test::IsAccuracyOf(0.002));  // the nodes are the same to rounding; three steps of the prefilter find their spline to this
}

TEST_F(LevelSetAcross, AnExportInTheScansFrameComesBackWithoutAShift) {
  cloud::OrientedPoints points = cloud::sample_shape(cloud::shape("owl"), 3000);
  for (Vector3d& p : points.positions) p = 0.0021 * p + Vector3d(431250.5, -5400321.25, 812.0625);  // metres, as a surveyor has them
  cloud::write_ply(file("far.ply"), points);
  for (const std::string size : {" --units m", " --fit 53mm"}) {
    run_command("build " + file("far.ply") + " -o " + file("a.itf") + " --grid 70" + size);
    run_command("export " + file("a.itf") + " -o " + file("a.vdb") + " --input-frame");
    run_command("build " + file("a.vdb") + " -o " + file("b.itf") + size);
    const auto first = field_file::open_field(file("a.itf"));
    const auto second = field_file::open_field(file("b.itf"));
    const cloud::Placement there = evaluate::placement_of(first.view), here = evaluate::placement_of(second.view);
    double worst = 0;
    Vector3d sum = Vector3d::Zero();
    const cloud::TriangleMesh surface = evaluate::zero_surface(first.view);
    ASSERT_GT(surface.vertices.size(), 50'000U);
    for (const Vector3d& corner : surface.vertices) {
      const core::FieldSample sample = core::sample_field(second.view, index_of(second, here.to_workspace(there.to_cloud(corner))));
      worst = std::max(worst, std::abs(to_double(sample.distance)));
      sum += to_double(sample.distance) * to_double(sample.gradient);
    }
    EXPECT_THAT(worst, test::IsAccuracyOf(0.04)) << size << ": at sharp creases the prefilter's three steps leave this, in every frame";
    EXPECT_LT(sum.norm() / static_cast<double>(surface.vertices.size()), 1e-4) << size << ": all of it is shifted";
    EXPECT_NEAR(here.scale / there.scale, 1, 0.02) << "the scan's own units";
  }
}

}  // namespace
}  // namespace isotouch
