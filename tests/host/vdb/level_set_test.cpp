#include "host/vdb/level_set.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <openvdb/io/File.h>
#include <openvdb/openvdb.h>
#include <openvdb/tools/LevelSetSphere.h>
#include <openvdb/tools/LevelSetUtil.h>
#include <openvdb/tools/SignedFloodFill.h>
#include <pthread.h>
#include <unistd.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <functional>

#include "host/error.h"
#include "host/files/whole_file.h"
#include "host/vdb/level_set_field.h"
#include "tests/support/accuracy.h"
#include "tests/support/scratch_folder.h"

namespace isotouch::vdb {
namespace {

using Eigen::Vector3d;
using openvdb::FloatGrid;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
namespace fs = std::filesystem;

constexpr float kRadius = 5;
constexpr float kEdge = 0.25F;

FloatGrid::Ptr sphere(float half_width = 3) {
  openvdb::initialize();
  auto grid = openvdb::tools::createLevelSetSphere<FloatGrid>(kRadius, openvdb::Vec3f(1, 2, 3), kEdge, half_width);
  grid->setName("ball");
  return grid;
}

fs::path save(const ScratchFolder& folder, const openvdb::GridCPtrVec& grids) {
  const fs::path file = folder.path() / "a.vdb";
  openvdb::io::File(file.string()).write(grids);
  return file;
}

double exact(const Vector3d& world) { return (world - Vector3d(1, 2, 3)).norm() - static_cast<double>(kRadius); }

std::string refusal(const std::function<void()>& action) {
  try {
    action();
  } catch (const InputError& e) {
    return e.what();
  }
  return "no refusal";
}

/// Every known sample against the sphere; how many there were.
int expect_sphere(const field::BandField& field) {
  int compared = 0;
  for (const field::Brick& brick : field.bricks) {
    for (int n = 0; n < 64; ++n) {
      const auto d = static_cast<double>(brick.distance[static_cast<std::size_t>(n)]);
      if (std::abs(d) >= field.band) continue;
      const Vector3d place = field.grid.position(4 * brick.cell + Eigen::Vector3i(n & 3, n >> 2 & 3, n >> 4));
      EXPECT_NEAR(d * field.grid.edge, exact(place), 1e-5) << place.transpose();
      ++compared;
    }
  }
  return compared;
}

TEST(LevelSet, SamplesAreTheSpheresOwnDistances) {
  const ScratchFolder folder;
  const LevelSet set = LevelSet::read(save(folder, {sphere()}));
  EXPECT_DOUBLE_EQ(set.edge, 0.25);
  EXPECT_DOUBLE_EQ(set.half_width, 3);
  EXPECT_EQ(set.format, "OpenVDB level set 'ball'");
  EXPECT_THAT(set.warnings, IsEmpty());
  ASSERT_TRUE(set.samples);
  EXPECT_EQ(expect_sphere(*set.samples), static_cast<int>(set.active_voxels));
  EXPECT_GT(set.active_voxels, 10'000U);
  ASSERT_GT(set.crossings.size(), 5'000U);
  double farthest = 0;
  for (const Vector3d& place : set.crossings) farthest = std::max(farthest, std::abs(exact(place)));
  EXPECT_LT(farthest, 0.0125);  // the sagitta along an edge between two samples, as seen from the surface
  EXPECT_GT(farthest, 0.0005);
}

TEST(LevelSet, StandardInputIsNoFileOfThatName) {
  const ScratchFolder folder;
  const auto bytes = read_file(save(folder, {sphere()}));
  folder.write("-", "another file");
  const fs::path before = fs::current_path();
  fs::current_path(folder.path());
  std::string said = refusal([&] { EXPECT_GT(LevelSet::read("-", bytes, {}).active_voxels, 10'000U); });
  EXPECT_EQ(said, "no refusal");
  fs::current_path(before);
}

TEST(LevelSet, PermutedAndMirroredAxesKeepTheSamples) {
  const ScratchFolder folder;
  const auto grid = sphere();
  const auto map = grid->transform().baseMap()->getAffineMap()->getMat4();
  openvdb::Mat4d turn(0.0, 0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.3, 0.2, 0.1,
                      1.0);  // x to -z, y to x, z to y, and moved
  grid->setTransform(openvdb::math::Transform::createLinearTransform(map * turn));
  const LevelSet set = LevelSet::read(save(folder, {grid}));
  ASSERT_TRUE(set.samples);
  int compared = 0;
  for (const field::Brick& brick : set.samples->bricks) {
    for (int n = 0; n < 64; ++n) {
      const auto d = static_cast<double>(brick.distance[static_cast<std::size_t>(n)]);
      if (std::abs(d) >= 3) continue;
      const Vector3d w = set.samples->grid.position(4 * brick.cell + Eigen::Vector3i(n & 3, n >> 2 & 3, n >> 4)) - Vector3d(0.3, 0.2, 0.1);
      ASSERT_NEAR(d * 0.25, exact({-w.z(), w.x(), w.y()}), 1e-5);
      ++compared;
    }
  }
  EXPECT_EQ(compared, static_cast<int>(set.active_voxels));
}

TEST(LevelSet, OnAnotherGridItIsInterpolatedToAThousandthOfItsVoxel) {
  const ScratchFolder folder;
  const auto grid = sphere();
  auto map = grid->transform().baseMap()->getAffineMap()->getMat4();
  map.postRotate(openvdb::math::Z_AXIS, 0.3);
  grid->setTransform(openvdb::math::Transform::createLinearTransform(map));
  const LevelSet set = LevelSet::read(save(folder, {grid}));
  EXPECT_FALSE(set.samples);
  EXPECT_DOUBLE_EQ(set.edge, 0.25);
  const Vector3d centre(std::cos(0.3) - 2 * std::sin(0.3), std::sin(0.3) + 2 * std::cos(0.3), 3);
  const cloud::Placement placement{2.0, -2.0 * centre};
  field::Grid target{Vector3d::Constant(-18), 0.4, Eigen::Vector3i::Constant(91)};
  const Interpolation interpolation(set);
  const double band = known_band(interpolation, set, placement, target.edge);
  EXPECT_DOUBLE_EQ(band, 4.5 * 0.25 * 2 / 0.4);
  const field::BandField field = resampled_field(interpolation, set, placement, target, band);
  double worst_near = 0, worst_within = 0, worst_far = 0;
  int compared = 0;
  for (const field::Brick& brick : field.bricks) {
    for (int n = 0; n < 64; ++n) {
      const auto d = static_cast<double>(brick.distance[static_cast<std::size_t>(n)]);
      const Vector3d place = target.position(4 * brick.cell + Eigen::Vector3i(n & 3, n >> 2 & 3, n >> 4));
      const double truth = (place.norm() - 10) / target.edge;
      if (std::abs(truth) > 0.01) {
        ASSERT_EQ(d < 0, truth < 0) << place.transpose();
      }
      if (std::abs(d) >= band) continue;
      const double own_voxels = target.edge / 2 / 0.25;  // of the level set, per voxel of the target
      const double away = std::abs(d) * own_voxels;
      double& worst = away < 1 ? worst_near : away < 3 ? worst_within : worst_far;
      worst = std::max(worst, std::abs(d - truth) * own_voxels);
      ++compared;
    }
  }
  EXPECT_GT(compared, 10'000);
  EXPECT_THAT(worst_near, test::IsAccuracyOf(0.001));
  EXPECT_THAT(worst_within, test::IsAccuracyOf(0.02));
  EXPECT_THAT(worst_far, test::IsAccuracyOf(0.1));
}

TEST(LevelSet, TheFirstNameOfSeveralIsTakenAndTold) {
  const ScratchFolder folder;
  const auto other = sphere();
  other->setName("other");
  const auto fog = sphere();
  openvdb::tools::sdfToFogVolume(*fog);
  fog->setName("smoke");
  const fs::path file = save(folder, {fog, sphere(), other});
  const LevelSet set = LevelSet::read(file);
  EXPECT_EQ(set.format, "OpenVDB level set 'ball'");
  EXPECT_THAT(set.warnings, ElementsAre(HasSubstr("of 2 level sets the first was taken, 'ball'")));
  EXPECT_EQ(LevelSet::read(file, "other").format, "OpenVDB level set 'other'");
  EXPECT_THAT(refusal([&] { LevelSet::read(file, "smoke"); }), HasSubstr("a.vdb: grid 'smoke' is a fog volume"));
  EXPECT_THAT(refusal([&] { LevelSet::read(file, "cow"); }), HasSubstr("there is no grid 'cow' in it; there is 'ball', 'other', 'smoke'"));
}

TEST(LevelSet, WhatIsNoneIsRefusedInASentence) {
  const ScratchFolder folder;
  const auto why = [&](const openvdb::GridBase::Ptr& grid) { return refusal([&] { LevelSet::read(save(folder, {grid})); }); };
  openvdb::initialize();
  const auto unmarked = sphere();
  unmarked->setGridClass(openvdb::GRID_UNKNOWN);
  EXPECT_THAT(why(unmarked), HasSubstr("without the class 'level set'"));
  const auto vectors = openvdb::Vec3SGrid::create();
  vectors->setGridClass(openvdb::GRID_STAGGERED);
  EXPECT_THAT(why(vectors), HasSubstr("a staggered grid"));
  const auto nothing = FloatGrid::create(0.75F);
  nothing->setGridClass(openvdb::GRID_LEVEL_SET);
  EXPECT_THAT(why(nothing), HasSubstr("is empty"));
  const auto stretched = sphere();
  stretched->transform().postScale(openvdb::Vec3d(1, 1, 2));
  EXPECT_THAT(why(stretched), HasSubstr("voxels that are not cubes"));
  const auto number = sphere();
  number->tree().setValue(number->tree().cbeginValueOn().getCoord(), std::nanf(""));
  EXPECT_THAT(why(number), HasSubstr("a value that is no number at ("));
  const auto torn = sphere();
  torn->tree().setValueOff(openvdb::Coord(100, 0, 0), -0.75F);
  EXPECT_THAT(why(torn), HasSubstr("jumps from inside to outside at ("));
  const auto block = sphere();
  block->tree().addTile(1, openvdb::Coord(1000, 0, 0), 0.1F, true);
  EXPECT_THAT(why(block), HasSubstr("a block of constant distance"));
  const auto narrow = FloatGrid::create(0.99F * kEdge);
  narrow->setGridClass(openvdb::GRID_LEVEL_SET);
  narrow->setTransform(openvdb::math::Transform::createLinearTransform(static_cast<double>(kEdge)));
  narrow->tree().setValueOn(openvdb::Coord(0), -0.1F);
  EXPECT_THAT(why(narrow), HasSubstr("has a background of 0.2475"));
  const auto outside = sphere();
  for (auto value = outside->beginValueAll(); value; ++value) value.setValue(std::abs(*value));
  EXPECT_THAT(why(outside), HasSubstr("has no surface: all of it is on one side"));
  for (const std::int32_t far : {1 << 30, -(1 << 30), INT32_MAX - 64, INT32_MIN + 64}) {
    const auto moved = sphere();
    moved->clear();
    const auto own = sphere();
    for (auto value = own->cbeginValueOn(); value; ++value) moved->tree().setValueOn(value.getCoord() + openvdb::Coord(0, far, 0), *value);
    openvdb::tools::signedFloodFill(moved->tree());
    EXPECT_THAT(why(moved), HasSubstr("has a value more than 536,870,912 voxels from its origin")) << far;
  }
  const auto large = sphere();
  large->transform().postScale(1e12);
  EXPECT_THAT(why(large), HasSubstr("reaches farther than 1e12 from the origin"));
  const auto away = sphere();
  away->transform().postTranslate(openvdb::Vec3d(0, -1e13, 0));
  EXPECT_THAT(why(away), HasSubstr("reaches farther than 1e12 from the origin"));
  EXPECT_THAT(refusal([&] { LevelSet::read(folder.write("b.vdb", "no volume")); }), HasSubstr("b.vdb: OpenVDB cannot read it: "));
}

TEST(LevelSet, HalfFloatsAndDoublesAreRead) {
  const ScratchFolder folder;
  const auto half = sphere();
  half->setSaveFloatAsHalf(true);
  const LevelSet set = LevelSet::read(save(folder, {half}));
  EXPECT_THAT(set.warnings, ElementsAre(HasSubstr("half floats")));
  EXPECT_EQ(set.half_width, 3);
  openvdb::initialize();
  const auto doubles = openvdb::tools::createLevelSetSphere<openvdb::DoubleGrid>(kRadius, openvdb::Vec3f(1, 2, 3), kEdge, 3);
  const LevelSet exact_set = LevelSet::read(save(folder, {doubles}));
  ASSERT_TRUE(exact_set.samples);
  EXPECT_GT(expect_sphere(*exact_set.samples), 10'000);
}

TEST(LevelSet, AFileThatWasCutIsRefused) {
  const ScratchFolder folder;
  const auto bytes = read_file(save(folder, {sphere()}));
  int refused = 0;
  for (std::size_t size = 0; size < bytes.size(); size += bytes.size() / 97 + 1) {
    const fs::path cut = folder.write("cut.vdb", std::string(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size)));
    EXPECT_THAT(refusal([&] { LevelSet::read(cut); }), HasSubstr("cut.vdb: ")) << size;
    ++refused;
  }
  EXPECT_GT(refused, 90);
}

/// OpenVDB is tried in a copy of this process, which ends here as if the library had crashed it.
TEST(LevelSet, AFileThatCrashesTheLibraryIsRefused) {
  static bool crashes = false;
  ASSERT_EQ(::pthread_atfork(nullptr, nullptr,
                             [] {
                               if (crashes) ::_exit(EXIT_FAILURE);
                             }),
            0);
  const ScratchFolder folder;
  const fs::path file = save(folder, {sphere()});
  crashes = true;
  EXPECT_THAT(refusal([&] { LevelSet::read(file); }), HasSubstr("a.vdb: the file is damaged: reading it crashes OpenVDB"));
  crashes = false;
}

TEST(LevelSet, WhatIsWrittenComesBackWithEveryValue) {
  const ScratchFolder folder;
  const LevelSet first = LevelSet::read(save(folder, {sphere()}));
  ASSERT_TRUE(first.samples);
  const auto bytes = write_level_set(*first.samples, "again", {{"made_by", "a test"}});
  const LevelSet second = LevelSet::read(folder.write("b.vdb", std::string(bytes.begin(), bytes.end())));
  ASSERT_TRUE(second.samples);
  EXPECT_EQ(second.active_voxels, first.active_voxels);
  EXPECT_EQ(second.format, "OpenVDB level set 'again'");
  ASSERT_EQ(second.samples->bricks.size(), first.samples->bricks.size());
  EXPECT_GT(expect_sphere(*second.samples), 10'000);
  const fs::path file = folder.path() / "b.vdb";
  openvdb::io::File reader(file.string());
  reader.open(false);
  const auto grid = openvdb::gridPtrCast<FloatGrid>(reader.readGrid("again"));
  EXPECT_EQ(grid->metaValue<std::string>("made_by"), "a test");
  EXPECT_EQ(grid->tree().getValue(openvdb::Coord(23, 23, 23)), -0.75F);  // the middle
}

TEST(LevelSet, AFileIsKnownByItsFirstBytesOrItsName) {
  const ScratchFolder folder;
  fs::rename(save(folder, {sphere()}), folder.path() / "a.bin");
  EXPECT_TRUE(is_vdb_file("a.bin", read_file(folder.path() / "a.bin")));
  EXPECT_TRUE(is_vdb_file("-", read_file(folder.path() / "a.bin")));
  EXPECT_TRUE(is_vdb_file("b.vdb", {}));
  EXPECT_FALSE(is_vdb_file("c.ply", read_file(folder.write("c.ply", "ply\n"))));
  EXPECT_FALSE(is_vdb_file("none.ply", {}));
}

}  // namespace
}  // namespace isotouch::vdb
