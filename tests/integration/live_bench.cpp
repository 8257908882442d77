/// What a batch of a live field costs, on a mesh that is scanned point by point. For whoever changes that code; `live_plain` checks the bytes.
///
///     live_bench MESH GRID PRESENT BATCH clustered|scattered|frame COUNT THREADS
///
/// PRESENT points are there before; then COUNT batches of BATCH new points come. clustered: round a random place, one for each four square voxels;
/// scattered: anywhere; frame: half new ones all over one side, as a camera sees them that goes round the object, and half old ones that go,
/// which came ten batches ago. Prints milliseconds of apply and image, and work.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <deque>
#include <exception>
#include <string>
#include <vector>

#include "host/cloud/mesh.h"
#include "host/cloud/placement.h"
#include "host/cloud/random.h"
#include "host/cloud/read_mesh.h"
#include "host/field/make_grid.h"
#include "host/field/parallel.h"
#include "host/files/whole_file.h"
#include "host/live/live_field.h"

namespace {

using namespace isotouch;
using Eigen::Vector3d;

/// Points to draw from.
struct Scanned {
  cloud::OrientedPoints pool;

  explicit Scanned(const cloud::TriangleMesh& mesh) : pool(cloud::scatter_on_mesh(mesh, 200'000, 1)) {}
  void draw(cloud::Random& random, Vector3d& position, Vector3d& normal) const {
    const auto i = static_cast<std::size_t>(random.bits() % pool.size());
    position = pool.positions[i];
    normal = pool.normals[i];
  }
};

double cpu_ms() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return 1e3 * static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_nsec);
}
double wall_ms() { return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

void print(const char* what, std::vector<double> all) {
  std::sort(all.begin(), all.end());
  std::printf("%-12s p50 %7.2f  p99 %7.2f  max %7.2f\n", what, all[all.size() / 2], all[all.size() * 99 / 100], all.back());
}

int run(char** argv) {
  const int voxels = std::atoi(argv[2]), present = std::atoi(argv[3]), batch_size = std::atoi(argv[4]), count = std::atoi(argv[6]);
  const std::string kind = argv[5];
  const field::ThreadLimit limit(static_cast<unsigned>(std::atoi(argv[7])));
  cloud::MeshReport report;
  cloud::TriangleMesh mesh = cloud::read_mesh(cloud::SourceFile(argv[1], read_file(argv[1]), {}), report);
  const cloud::Placement placement = cloud::place(mesh.vertices, {std::nullopt, 70.0});
  Vector3d low = Vector3d::Constant(1e9), high = -low;
  for (Vector3d& v : mesh.vertices) {
    v = placement.to_workspace(v);
    low = low.cwiseMin(v);
    high = high.cwiseMax(v);
  }
  const field::Grid grid = field::make_grid(low, high, 70.0 / voxels, live::margin(field::kBand));
  const Scanned scanned(mesh);
  cloud::Random random(1);
  live::LiveField field(grid, field::kBand, {});
  std::deque<std::vector<live::Point>> frames;
  const auto fresh = [&](const auto& wanted) {
    for (;;) {
      Vector3d position, normal;
      scanned.draw(random, position, normal);
      if (!wanted(position, normal)) continue;
      if (const auto point = live::point_in(grid, position, normal)) return *point;
    }
  };
  live::Batch first;
  for (int n = 0; n < present; ++n) first.added.push_back(fresh([](const Vector3d&, const Vector3d&) { return true; }));
  const double before = cpu_ms();
  field.apply(first);
  std::printf("whole: %.1f ms of CPU, %zu samples, %zu bytes\n", cpu_ms() - before, field.verdict().samples, field.image().size());

  std::vector<double> apply, apply_cpu, image;
  live::Work sum;
  for (int n = 0; n < count; ++n) {
    live::Batch batch;
    Vector3d middle, towards;
    scanned.draw(random, middle, towards);
    if (kind == "frame") towards = {std::cos(0.02 * n), 0.0, std::sin(0.02 * n)};
    const double radius = grid.edge * std::sqrt(4.0 * batch_size / 3.14159);
    const int added = kind == "frame" ? batch_size / 2 : batch_size;
    for (int k = 0; k < added; ++k) {
      batch.added.push_back(fresh([&](const Vector3d& position, const Vector3d& normal) {
        if (kind == "clustered") return (position - middle).norm() < radius;
        return kind == "scattered" || normal.dot(towards) > 0.2;
      }));
    }
    if (kind == "frame") {
      frames.push_back(batch.added);
      if (frames.size() > 10) {
        batch.removed = frames.front();
        frames.pop_front();
      }
    }
    const double cpu = cpu_ms(), wall = wall_ms();
    const live::Work work = field.apply(batch);
    if (kind == "frame" && batch.removed.empty()) continue;  // not yet in its stride
    apply.push_back(wall_ms() - wall);
    apply_cpu.push_back(cpu_ms() - cpu);
    const double then = cpu_ms();
    field.image();
    image.push_back(cpu_ms() - then);
    sum.samples += work.samples, sum.models += work.models, sum.bricks += work.bricks, sum.changed += work.changed;
  }
  print("apply, wall", apply);
  print("apply, CPU", apply_cpu);
  print("image, CPU", image);
  const auto mean = [&apply](std::size_t all) { return all / apply.size(); };
  std::printf("a batch: %zu samples, %zu models, %zu bricks, %zu changed\n", mean(sum.samples), mean(sum.models), mean(sum.bricks),
              mean(sum.changed));
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 8) return std::fprintf(stderr, "usage: live_bench MESH GRID PRESENT BATCH clustered|scattered|frame COUNT THREADS\n"), 2;
  try {
    return run(argv);
  } catch (const std::exception& error) {
    return std::fprintf(stderr, "live_bench: %s\n", error.what()), 1;
  }
}
