/// Each limit of a verdict from both sides: one figure of a sound build changes, and the others stay.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <functional>

#include "host/cloud/shapes.h"
#include "host/field/scan_field.h"
#include "host/field/spacings.h"
#include "host/field/verdict.h"

namespace isotouch::field {
namespace {

using Eigen::Vector3d;
using ::testing::Contains;
using ::testing::Each;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr double kVoxel = 1.6;

/// A sphere and what was made of it.
struct Build {
  SoundScan sound = sound_scan(cloud::sample_shape(cloud::shape("sphere"), 3000));
  BandField field;
  Repair repair;
  Verdict verdict;

  Build() {
    Progress progress;
    ScanField built = scan_field(sound, kVoxel, kBand, progress);
    field = std::move(built.field);
    repair = built.repair;
    verdict = std::move(built.verdict);
  }

  std::size_t of_points(double share) const { return static_cast<std::size_t>(std::lround(share * static_cast<double>(sound.measured))); }
  /// Moves a share of the points outwards.
  void lift(double share, double voxels) {
    for (std::size_t i = 0; i < of_points(share); ++i) sound.points.positions[i] += voxels * kVoxel * sound.points.normals[i];
  }
};

const Build& sphere() {
  static const Build build;
  return build;
}

struct Limit {
  const char* sentence;  ///< a part of it
  double within, beyond;
  std::function<void(Build&, double)> set;
};

TEST(VerdictLimits, EachFigureIsRefusedBeyondItsOwn) {
  const Limit limits[] = {
      {"lie off the surface", 0.029, 0.031, [](Build& b, double x) { b.lift(x, 3); }},
      {"walls thinner than two voxels", 0.84, 0.86, [](Build& b, double x) { b.lift(x, 0.7); }},
      {"walls thinner than two voxels", 0.4, 0.5, [](Build& b, double x) { b.lift(1, x); }},
      {"point against the surface", 0.019, 0.021,
       [](Build& b, double x) {
         for (std::size_t i = 0; i < b.of_points(x); ++i) b.sound.points.normals[i] *= -1;
       }},
      {"had to be turned", 0.249, 0.251, [](Build& b, double x) { b.sound.turned.resize(b.of_points(x)); }},
      {"decided by neighbours", 0.0099, 0.0101,
       [](Build& b, double x) {
         b.sound.outside = Outside::kNeighbours;
         b.sound.contradicted = x;
       }},
      {"lie behind others", 0.079, 0.081, [](Build& b, double x) { b.sound.hidden = x; }},
      {"are strays", 0.29, 0.31, [](Build& b, double x) { b.sound.strays = b.of_points(x / (1 - x)); }},
      {"were left out form a surface", 0.149, 0.151, [](Build& b, double x) { b.sound.unknown_side = x; }},
      {"much sparser than the one on the other side", 0.0097, 0.0103,
       [](Build& b, double x) {
         b.sound.sparse = b.of_points(x);
         b.sound.hidden = 0.1;  // it only explains what else is wrong
       }},
      {"do not expect them; remove strays", 0, 1,
       [](Build& b, double x) {
         b.repair.surprising = 0.1;
         b.sound.strays = static_cast<std::size_t>(x);
       }},
      {"surrounds them, or remove them", 0.21, 0.19, [](Build& b, double x) { b.sound.rim.patches = b.of_points(x); }},
      {"points scatter by", 0.79, 0.81, [](Build& b, double x) { b.sound.noise = x * b.sound.spacing; }},
      {"form patches", 0.0047, 0.0053, [](Build& b, double x) { b.sound.rim.patches = b.of_points(x); }},
      {"no smooth surface explains", 0.39, 0.41, [](Build& b, double x) { b.repair.unexplained = x; }},
      {"another layer", 0.029, 0.031, [](Build& b, double x) { b.repair.twice_enclosed = x; }},
      {"do not expect them", 0.019, 0.021, [](Build& b, double x) { b.repair.surprising = x; }},
      {"of the volume that the points enclose", 1.079, 1.081,
       [](Build& b, double x) { b.sound.enclosed *= b.verdict.volume_of_enclosed / x; }},
      {"hardly any volume", 0.0101, 0.0099,
       [](Build& b, double x) {  // invented points far out
         for (std::size_t i = 0; i < b.sound.measured; ++i) {
           b.sound.points.positions.emplace_back(std::cbrt(b.verdict.volume_of_hull / x) * b.sound.points.positions[i]);
           b.sound.points.normals.emplace_back(b.sound.points.normals[i]);
         }
       }},
      {"larger than the hull", 1.04, 1.06,
       [](Build& b, double x) {
         for (Vector3d& p : b.sound.points.positions) p *= std::cbrt(b.verdict.volume_of_hull / x);
       }},
      {"pieces and cavities that no points support", 0.049, 0.051,
       [](Build& b, double x) {
         b.repair.debris.pieces = b.of_points(0.03);
         b.repair.debris.cavities = b.of_points(x - 0.03);
       }},
  };
  const Spacings spacings(sphere().sound.points);
  for (const Limit& limit : limits) {
    const auto reasons = [&](double figure) {
      Build build = sphere();
      limit.set(build, figure);
      return judge(build.field, build.sound, build.repair, spacings).reasons;
    };
    EXPECT_THAT(reasons(limit.within), Each(Not(HasSubstr(limit.sentence)))) << limit.within;
    EXPECT_THAT(reasons(limit.beyond), Contains(HasSubstr(limit.sentence))) << limit.beyond;
  }
}

/// What one view sees has shadows, so that it may have larger gaps.
TEST(VerdictLimits, AGapMayBeLargerInAScanOfOneSide) {
  struct Case {
    bool is_sheet;
    double most;
    double within, beyond;  ///< heights of a cap that nobody scanned, in radii
  };
  for (const Case& c : {Case{false, 0.01, 0.077, 0.08}, {true, 0.025, 0.12, 0.125}}) {
    Build build = sphere();
    build.sound.is_sheet = c.is_sheet;
    const auto reasons = [&](double cap) {
      cloud::OrientedPoints seen;
      for (std::size_t i = 0; i < build.sound.measured; ++i) {
        if (build.sound.points.normals[i].z() > 1 - cap) continue;
        seen.positions.push_back(build.sound.points.positions[i]);
        seen.normals.push_back(build.sound.points.normals[i]);
      }
      const Verdict verdict = judge(build.field, build.sound, build.repair, Spacings(seen));
      EXPECT_NEAR(verdict.gap_share, c.most, 0.002);
      return verdict.reasons;
    };
    EXPECT_THAT(reasons(c.within), Each(Not(HasSubstr("closes gaps")))) << c.most;
    EXPECT_THAT(reasons(c.beyond), Contains(HasSubstr("closes gaps"))) << c.most;
  }
}

}  // namespace
}  // namespace isotouch::field
