/// A hand that rests on an object and trembles as recorded hands do: how far the force is from the exact one for the same HIP, beside the
/// published method on the same grid.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "firmware/core/render.h"
#include "host/encoding/write_image.h"
#include "host/evaluate/descent_tick.h"
#include "host/evaluate/god_object.h"
#include "host/field/make_grid.h"
#include "host/field/sample_distance.h"
#include "host/field_file/open_field.h"
#include "host/motion/motion_csv.h"
#include "host/motion/resample.h"
#include "host/published/levels.h"
#include "host/to_double.h"
#include "tests/host/evaluate/box_mesh.h"

namespace isotouch {
namespace {

using Eigen::Vector3d;

constexpr double kEdge = 0.34, kStiffness = 0.8, kForce = 1.0;  // mm a voxel, N/mm, N
constexpr double kDepth = kForce / kStiffness;
constexpr double kHalf = 14, kFloor = -4;  // mm: a block from whose upper octant a room is cut; three walls meet in its corner

double from_block(const Vector3d& p) {
  const Vector3d out = p.cwiseAbs() - Vector3d::Constant(kHalf);
  const double block = out.cwiseMax(0).norm() + std::min(out.maxCoeff(), 0.0);
  const Vector3d in_room = p - Vector3d::Constant(kFloor);
  const double walls = in_room.minCoeff() > 0 ? in_room.minCoeff() : -(-in_room).cwiseMax(0).norm();
  return std::max(block, walls);
}

cloud::TriangleMesh block_mesh() {
  const double h = kHalf, f = kFloor;
  cloud::TriangleMesh mesh;
  for (const auto& part :
       {evaluate::box({-h, -h, -h}, {h, h, f}), evaluate::box({-h, -h, f}, {f, h, h}), evaluate::box({f, -h, f}, {h, f, h})}) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), part.vertices.begin(), part.vertices.end());
    for (const auto& [a, b, c] : part.faces) mesh.faces.push_back({a + first, b + first, c + first});
  }
  return mesh;
}

/// What is left of a recording when everything slower than about 4 Hz is taken off, mm, a millisecond apart.
std::vector<Vector3d> tremor_of(const std::filesystem::path& file) {
  std::vector<Vector3d> path;
  motion::resample(motion::read_motion_csv(file, {}), 1'000'000, [&](const Input& in, const auto&) { path.push_back(to_double(in.hip)); });
  constexpr std::size_t kReach = 50;
  std::vector<Vector3d> sums(path.size() + 1, Vector3d::Zero());
  for (std::size_t i = 0; i < path.size(); ++i) sums[i + 1] = sums[i] + path[i];
  std::vector<Vector3d> tremor;
  for (std::size_t i = kReach; i + kReach < path.size(); ++i) {
    tremor.push_back(path[i] - (sums[i + kReach + 1] - sums[i - kReach]) / (2.0 * kReach + 1));
  }
  return tremor;
}

struct Place {
  const char* name;
  Vector3d surface;  ///< of the object, where the hand rests
  Vector3d outward;  ///< opposite to where it presses
  double bound;      ///< N
  double fillet;     ///< N, at most: what the crease's fillet holds the hand off (DECISIONS.md, 9); a constant force, no buzz
};

const Place kPlaces[] = {
    {"flat", {5, 5, kFloor}, {0, 0, 1}, 0.02, 0},
    {"edge", {-kHalf, 5, kHalf}, Vector3d(-1, 0, 1.01).normalized(), 0.05, 0},
    {"two voxels beside an edge", {-kHalf + 0.7, 5, kHalf}, {0, 0, 1}, 0.05, 0},
    {"three voxels beside a corner", {-kHalf + 1, -kHalf + 1, kHalf}, {0, 0, 1}, 0.05, 0},
    {"edge between two walls", {kFloor, 5, kFloor}, Vector3d(1, 0, 1).normalized(), 0.05, 0.17},
    {"corner of three walls", {kFloor, kFloor, kFloor}, Vector3d(1, 1, 1).normalized(), 0.05, 0.42},
};

/// Sums of squared differences of force, N².
struct Error {
  double square = 0;
  Vector3d sum = Vector3d::Zero();
  std::size_t ticks = 0;
  void add(const Vector3d& difference) { square += difference.squaredNorm(), sum += difference, ++ticks; }
  double rms() const { return std::sqrt(square / static_cast<double>(ticks)); }
  double offset() const { return sum.norm() / static_cast<double>(ticks); }
  /// What is left of the rms without the offset.
  double buzz() const { return std::sqrt(std::max(rms() * rms() - offset() * offset(), 0.0)); }
};

TEST(CalmHeavy, ATremblingHandAtRestFeelsTheExactForce) {
  const char* data = std::getenv("ISOTOUCH_DATA");
  if (data == nullptr) GTEST_SKIP() << "ISOTOUCH_DATA is not set";

  const field::Grid grid = field::make_grid(Vector3d::Constant(-kHalf), Vector3d::Constant(kHalf), kEdge, field::kBand + 4);
  const field_file::OpenField field =
      field_file::open_field(encoding::write_image(field::sample_distance(from_block, grid, field::kBand), {}), "block");
  published::Indicator inside(grid, 0);
  for (int k = 0; k < grid.size.z(); ++k) {
    for (int j = 0; j < grid.size.y(); ++j) {
      for (int i = 0; i < grid.size.x(); ++i) inside.at(i, j, k) = from_block(grid.position({i, j, k})) <= 0 ? 1 : 0;
    }
  }
  field::Progress quiet;
  const published::LevelField levels = published::peel(inside, quiet);
  const cloud::TriangleMesh mesh = block_mesh();
  const field::TriangleTree tree(mesh);

  int recordings = 0;
  for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(data) / "traces")) {
    const std::string name = entry.path().filename().string();
    if (entry.path().extension() != ".csv") continue;
    ++recordings;
    const std::vector<Vector3d> tremor = tremor_of(entry.path());
    double size = 0;
    for (const Vector3d& t : tremor) size += t.squaredNorm() / static_cast<double>(tremor.size());
    for (const Place& place : kPlaces) {
      TickSettings settings;
      settings.stiffness = Stiffness::of(kStiffness);
      const core::PositionModel model = core::make_position_model(libnifalcon_model(), settings, 1'000'000, field.view);
      core::PositionState state;
      evaluate::DescentTick published(levels, static_cast<float>(kStiffness));
      evaluate::GodObject exact(tree, place.surface + 3 * place.outward);
      Error ours, theirs;
      constexpr int kApproach = 400;
      for (std::size_t t = 0; t < tremor.size() + kApproach; ++t) {
        const double height = t < kApproach ? 3 - (3 + kDepth) * static_cast<double>(t) / kApproach : -kDepth;
        const Vector3d shake = t < kApproach ? Vector3d(Vector3d::Zero()) : tremor[t - kApproach];
        const Input in = position_input(to_fixed<Mm>(place.surface + height * place.outward + shake));
        const Vector3d hip = to_double(in.hip);
        const Vector3d force = kStiffness * (exact.follow(hip) - hip);
        const Vector3d felt = to_double(core::render_position(in, field.view, model, state).force);
        const Vector3d beside = published.force(hip.cast<float>()).cast<double>();
        if (t < kApproach + 50) continue;
        ours.add(felt - force);
        theirs.add(beside - force);
      }
      const double felt_error = place.fillet > 0 ? ours.buzz() : ours.rms();
      std::printf("%-27s tremor %.3f mm  %-28s  %.4f N%s, offset %.4f   published %.4f N, offset %.4f\n", name.c_str(), std::sqrt(size),
                  place.name, felt_error, place.fillet > 0 ? " beside it" : "", ours.offset(), theirs.rms(), theirs.offset());
      EXPECT_LT(felt_error, place.bound) << name << ", " << place.name;
      if (place.fillet > 0) {
        EXPECT_LT(ours.offset(), place.fillet) << name << ", " << place.name;
        EXPECT_GT(ours.offset(), 0.85 * place.fillet) << name << ", " << place.name;
        EXPECT_LT(ours.buzz(), theirs.buzz()) << name << ", " << place.name;
      } else {
        EXPECT_LT(ours.rms(), theirs.rms() / 5) << name << ", " << place.name;
      }
    }
  }
  EXPECT_GE(recordings, 7);
}

}  // namespace
}  // namespace isotouch
