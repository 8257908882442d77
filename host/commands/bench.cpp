/// isotouch bench: what a tick and a field cost.
#include <CLI/CLI.hpp>
#include <Eigen/Geometry>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "host/board_commands/number_in.h"
#include "host/board_commands/print_json.h"
#include "host/cloud/random.h"
#include "host/commands/commands.h"
#include "host/commands/field_bench.h"
#include "host/commands/growth_bench.h"
#include "host/commands/progress_bar.h"
#include "host/commands/tick_bench.h"
#include "host/encoding/write_image.h"
#include "host/evaluate/force_error.h"
#include "host/field/make_grid.h"
#include "host/field/sample_distance.h"
#include "host/field_file/open_field.h"
#include "host/motion/motion.h"
#include "host/published/build.h"
#include "host/published/levels.h"
#include "host/to_double.h"

namespace isotouch::commands {

namespace {

constexpr double kEdge = 0.34;  // mm a voxel, as in the paper
constexpr double kMargin = 4;   // voxels beside the band

/// A sphere that fills a grid with so many samples along each axis.
struct Sphere {
  field::Grid grid;
  double radius;  // mm

  explicit Sphere(int samples) : radius(kEdge * ((samples - 1) / 2.0 - field::kBand - kMargin)) {
    grid = field::make_grid(Eigen::Vector3d::Constant(-radius), Eigen::Vector3d::Constant(radius), kEdge, field::kBand + kMargin);
  }
  /// varied    with a stiffness for each brick
  field_file::OpenField field(bool varied = false) const {
    const auto distance = [this](const Eigen::Vector3d& p) { return p.norm() - radius; };
    field::BandField sampled = field::sample_distance(distance, grid, field::kBand);
    if (varied) {
      for (std::size_t brick = 0; brick < sampled.bricks.size(); ++brick)
        sampled.stiffness.push_back(0.5 + 0.001 * static_cast<double>(brick % 300));
    }
    return field_file::open_field(encoding::write_image(std::move(sampled), {}), "sphere");
  }
  published::LevelField levels() const {
    published::Indicator inside(grid, 0);
    for (int k = 0; k < grid.size.z(); ++k) {
      for (int j = 0; j < grid.size.y(); ++j) {
        for (int i = 0; i < grid.size.x(); ++i) inside.at(i, j, k) = grid.position({i, j, k}).norm() <= radius ? 1 : 0;
      }
    }
    field::Progress quiet;
    return published::peel(inside, quiet);
  }
  /// The same levels as the controller renders them, by the descent of the published method.
  static field_file::OpenField published_field(const published::LevelField& levels) {
    encoding::FieldInfo info;
    info.method = Method::kPublished;
    return field_file::open_field(encoding::write_image(published::to_band_field(levels), info), "sphere");
  }
  /// Anywhere on the sphere, four voxels deep at 300 mm/s: great circles that turn at random every 50 ms.
  Motion wander(int ticks) const {
    cloud::Random random(1);
    Motion motion;
    const double deep = radius - 4 * kEdge, angle = 0.3 / deep;
    Eigen::Vector3d at = Eigen::Vector3d::UnitX(), axis = Eigen::Vector3d::UnitZ();
    for (double height = radius + 1; height > deep; height -= 0.025) motion.push_back(height * at);
    for (int tick = 0; tick < ticks; ++tick) {
      if (tick % 50 == 0) axis = Eigen::AngleAxisd(random.uniform(-M_PI, M_PI), at) * axis;
      at = (Eigen::AngleAxisd(angle, axis) * at).normalized();
      motion.push_back(deep * at);
    }
    return motion;
  }
  /// Round the sphere four voxels deep: 8 s at each of 100, 200 and 300 mm/s.
  Motion slide() const {
    Motion motion;
    for (const double speed : {100.0, 200.0, 300.0}) {
      evaluate::SphereSlide way;
      way.radius = radius;
      way.depth = 4 * kEdge;
      way.speed = speed;
      way.turns = 8 * speed / (2 * M_PI * radius);
      evaluate::slide_on_sphere(
          way, [&](const Eigen::Vector3d& hip) -> Eigen::Vector3d { return motion.emplace_back(hip), Eigen::Vector3d::Zero(); });
    }
    return motion;
  }
};

/// The same hand that `isotouch trace make slide` writes.
Motion slide_on(const FieldView& field) {
  Motion motion;
  motion::MotionOptions options;
  options.kind = "slide";
  options.ticks = 24'000;
  motion::make_motion(&field, options, [&](const Input& input) { motion.push_back(to_double(input.hip)); });
  return motion;
}

void print(const std::string& what, const TickTimes& times) {
  std::printf("%-30s median %7.0f ns   p99 %7.0f ns   p99.9 %7.0f ns   (%zu ticks)\n", what.c_str(), times.median_ns, times.p99_ns,
              times.p999_ns, times.ticks);
}

nlohmann::ordered_json times_json(const TickTimes& times) {
  return {{"median_ns", times.median_ns}, {"p99_ns", times.p99_ns}, {"p999_ns", times.p999_ns}, {"ticks", times.ticks}};
}

/// A cold tick needs some 10 ms of writing before it, or 60 ms where the last cache is large, so there are fewer of them.
void bench_cold_tick(int ticks, bool as_json) {
  ProgressBar bar({{"motion", 3}, {"warm", 1}, {"cold", 15}, {"cold 1024", 15}}, ProgressBar::Drawn::kAtBegins);
  bar.begin("motion");
  const Sphere small(186), large(1024);
  const field_file::OpenField field = small.field(), large_field = large.field();
  const Motion motion = small.wander(ticks), large_motion = large.wander(ticks);
  bar.begin("warm");
  const TickTimes warm = time_device(field.view, motion);
  const TickTimes large_warm = time_core(large_field.view, large_motion);
  bar.begin("cold");
  const TickTimes cold = time_device(field.view, motion, {}, Caches::kCold);
  bar.begin("cold 1024");
  const TickTimes large_cold = time_core(large_field.view, large_motion, {}, Caches::kCold);
  bar.end();
  if (as_json) {
    const nlohmann::ordered_json json = {{"evicted_bytes", evicted_bytes()},
                                         {"device_warm", times_json(warm)},
                                         {"device_cold", times_json(cold)},
                                         {"grid_1024_warm", times_json(large_warm)},
                                         {"grid_1024_cold", times_json(large_cold)}};
    print_json(json);
    return;
  }
  print("counts to commands, warm", warm);
  print("counts to commands, cold", cold);
  print("HIP to force, 1024, warm", large_warm);
  print("HIP to force, 1024, cold", large_cold);
  std::printf("cold: %zu MiB were written before each tick; the hand wanders at random at 300 mm/s\n", evicted_bytes() >> 20);
}

void bench_tick(const std::vector<std::filesystem::path>& fields, bool as_json) {
  ProgressBar bar({{"motion", 0.5}, {"core", 1}, {"device", 1}, {"published", 8}, {"wide", 3}}, ProgressBar::Drawn::kAtBegins);
  bar.begin("motion");
  const Sphere small(186);
  const Sphere large(1024);
  const Motion motion = small.slide();
  const field_file::OpenField field = small.field();
  const field_file::OpenField varied = small.field(true);
  bar.begin("core");
  const TickTimes core = time_core(field.view, motion);
  const TickTimes felt = time_core(varied.view, motion, every_feature());
  bar.begin("device");
  const TickTimes device = time_device(field.view, motion);
  const TickTimes device_felt = time_device(varied.view, motion, every_feature());
  bar.begin("published");
  const published::LevelField levels = small.levels();
  const TickTimes published = time_published(levels, to_double(field.view.stiffness), motion);
  const TickTimes descent = time_core(Sphere::published_field(levels).view, motion);
  bar.begin("wide");
  const TickTimes wide = time_core(large.field().view, large.slide());
  bar.end();

  nlohmann::ordered_json json = {{"median_ns", core.median_ns},
                                 {"p99_ns", core.p99_ns},
                                 {"p999_ns", core.p999_ns},
                                 {"all_features_median_ns", felt.median_ns},
                                 {"device_median_ns", device.median_ns},
                                 {"device_all_features_median_ns", device_felt.median_ns},
                                 {"published_median_ns", published.median_ns},
                                 {"published_core_median_ns", descent.median_ns},
                                 {"grid_1024_median_ns", wide.median_ns},
                                 {"published_ratio", published.median_ns / core.median_ns}};
  if (!as_json) {
    print("HIP to force", core);
    print("  with every feature", felt);
    print("counts to commands", device);
    print("  with every feature", device_felt);
    print("HIP to force, 1024 grid", wide);
    print("published float, 186 grid", published);
    print("published in the core", descent);
    std::printf("published / core               %.1f\n1024 / 186 grid                %.2f\n", published.median_ns / core.median_ns,
                wide.median_ns / core.median_ns);
  }
  for (const std::filesystem::path& file : fields) {
    const field_file::OpenField given = field_file::open_field(file);
    const TickTimes times = time_core(given.view, slide_on(given.view));
    json["blobs"].push_back(
        {{"file", file.string()}, {"median_ns", times.median_ns}, {"p99_ns", times.p99_ns}, {"p999_ns", times.p999_ns}});
    if (!as_json) print(file.filename().string(), times);
  }
  if (as_json) print_json(json);
}

void bench_field(bool as_json) {
  ProgressBar bar({{"hydrant", 1}, {"owl", 1}, {"boy", 1}, {"bomberman", 1}, {"jaguar", 1}}, ProgressBar::Drawn::kAtBegins);
  const std::vector<FieldTimes> all = time_fields(bar);
  bar.end();
  nlohmann::ordered_json json = {{"objects", nlohmann::ordered_json::array()}};
  for (const FieldTimes& times : all) {
    const double ratio = times.published_seconds / times.seconds;
    json["objects"].push_back(
        {{"name", times.name}, {"seconds", times.seconds}, {"published_seconds", times.published_seconds}, {"ratio", ratio}});
    if (!as_json) {
      std::printf("%-10s %5zu points   %.3f s   published %.2f s   ratio %.1f\n", times.name.c_str(), times.points, times.seconds,
                  times.published_seconds, ratio);
    }
  }
  if (as_json) print_json(json);
}

nlohmann::ordered_json rows_json(const std::vector<GrowthRow>& rows) {
  auto json = nlohmann::ordered_json::array();
  for (const GrowthRow& row : rows) {
    nlohmann::ordered_json stages = nlohmann::ordered_json::object();
    for (const auto& [stage, seconds] : row.stages) stages[stage] = seconds;
    json.push_back({{"points", row.points},
                    {"grid", row.grid},
                    {"seconds", row.seconds},
                    {"cpu_seconds", row.cpu_seconds},
                    {"peak_bytes", row.peak_bytes},
                    {"image_bytes", row.image_bytes},
                    {"stored_samples", row.stored_samples},
                    {"ns_per_sample", row.nanoseconds_per_sample()},
                    {"stages", stages}});
  }
  return json;
}

void print(const char* title, const std::vector<GrowthRow>& rows) {
  std::printf("%s\n%8s %6s %8s %8s %9s %9s %10s %10s  ", title, "points", "grid", "s", "cpu s", "peak MiB", "image MB", "samples",
              "ns/sample");
  for (const auto& [stage, seconds] : rows.front().stages) std::printf(" %12s", stage.c_str());
  for (const GrowthRow& row : rows) {
    std::printf("\n%8zu %5d³ %8.3f %8.3f %9.1f %9.2f %10zu %10.1f  ", row.points, row.grid, row.seconds, row.cpu_seconds,
                static_cast<double>(row.peak_bytes) / (1 << 20), 1e-6 * static_cast<double>(row.image_bytes), row.stored_samples,
                row.nanoseconds_per_sample());
    for (const auto& [stage, seconds] : row.stages) std::printf(" %12.3f", seconds);
  }
  std::printf("\n");
}

void bench_growth(bool quick, bool as_json) {
  ProgressBar bar({{"4000 points", 1},
                   {"40000 points", 2},
                   {"400000 points", 8},
                   {"grid of 128", 0.5},
                   {"grid of 256", 1.5},
                   {"grid of 512", 5},
                   {"grid of 1024", 18}},
                  ProgressBar::Drawn::kAtBegins);
  const Growth growth = measure_growth(bar, quick);
  bar.end();
  if (as_json) {
    const nlohmann::ordered_json json = {{"points", rows_json(growth.points)}, {"grids", rows_json(growth.grids)}};
    print_json(json);
    return;
  }
  print("more points of a sphere on the default grid", growth.points);
  print("finer grids for one cloud", growth.grids);
}

}  // namespace

void add_bench(CLI::App& app) {
  struct Options {
    std::vector<std::filesystem::path> fields;
    bool cold = false;
    int ticks = 500;
    bool quick = false;
    bool json = false;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("bench", "Measure the time and memory that the tool takes on this machine");
  command->require_subcommand(1);
  CLI::App* tick = command->add_subcommand("tick",
                                           "Time of one tick, from HIP to force and from counts to motor commands, with warm caches, "
                                           "sliding 4 voxels deep on a sphere at 100 to 300 mm/s");
  CLI::Option* fields = tick->add_option("FIELD", options->fields, "time these fields too, sliding on each");
  CLI::Option* cold =
      tick->add_flag("--cold", options->cold, "with cold caches: 64 MiB, or more than the last cache holds, are written before each tick")
          ->excludes(fields);
  tick->add_option("--ticks", options->ticks, "cold ticks on each of two grids; a tick takes 10 ms, or 60 ms where the last cache is large")
      ->check(whole_number_in(20, 100'000))
      ->capture_default_str()
      ->needs(cold);
  tick->add_flag("--json", options->json, "print one JSON object");
  tick->callback(
      [options] { options->cold ? bench_cold_tick(options->ticks, options->json) : bench_tick(options->fields, options->json); });
  CLI::App* field = command->add_subcommand("field", "Time from a file of points to a verified field file, beside the published method");
  field->add_flag("--json", options->json, "print one JSON object");
  field->callback([options] { bench_field(options->json); });
  CLI::App* growth = command->add_subcommand("growth", "Time and memory of a build for more points, and for finer grids");
  growth->add_flag("--quick", options->quick, "the smallest cloud and the smallest grid alone, once each");
  growth->add_flag("--json", options->json, "print one JSON object");
  growth->callback([options] { bench_growth(options->quick, options->json); });
}

}  // namespace isotouch::commands
