#include "host/commands/growth_bench.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <nlohmann/json.hpp>
#include <span>

#include "host/cloud/forked_call.h"
#include "host/cloud/ply.h"
#include "host/cloud/shapes.h"
#include "host/commands/built_field.h"
#include "host/error.h"
#include "host/field/build_field.h"
#include "host/files/temporary_folder.h"

namespace isotouch::commands {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kClouds[] = {4'000, 40'000, 400'000};
constexpr int kGrids[] = {128, 256, 512, 1024};

/// What the copy of this process returned; its peak counts what this process holds, so that is little.
std::string ask_a_copy(const std::function<std::string()>& call, cloud::ForkedCall& trial) {
  trial = cloud::call_in_fork(call);
  if (trial.crashed || (trial.thrown.empty() && trial.answer.empty()))
    throw InputError("a process for the measurement did not come to its end; there may be too little memory");
  if (!trial.thrown.empty()) throw InputError(trial.thrown);
  return trial.answer;
}

/// Points with the same density all over, without any order.
void write_sphere(const std::filesystem::path& file, std::size_t points) {
  cloud::ForkedCall trial;
  ask_a_copy(
      [&] {
        cloud::write_ply(file, cloud::sample_shape(cloud::shape("sphere"), points), "isotouch bench growth");
        return std::string("done");
      },
      trial);
}

GrowthRow one_run(const BuildOptions& options) {
  cloud::ForkedCall trial;
  const auto build = [&] {
    const BuiltField built = built_field(options);
    const FieldView& view = built.field.view;
    return Json{{"points", built.report.points},
                {"grid", view.size[0]},
                {"seconds", built.report.seconds},
                {"image_bytes", view.image.size()},
                {"stored_samples", image_layout::kSamplesPerBrick * view.brick_count},
                {"stages", built.report.stages}}
        .dump();
  };
  const Json json = Json::parse(ask_a_copy(build, trial));
  GrowthRow row;
  json.at("points").get_to(row.points);
  json.at("grid").get_to(row.grid);
  json.at("seconds").get_to(row.seconds);
  json.at("image_bytes").get_to(row.image_bytes);
  json.at("stored_samples").get_to(row.stored_samples);
  json.at("stages").get_to(row.stages);
  row.peak_bytes = trial.peak_bytes;
  row.cpu_seconds = trial.cpu_seconds;
  return row;
}

GrowthRow median_run(BuildOptions options, int count) {
  options.quiet = true;
  std::vector<GrowthRow> runs;
  for (int run = 0; run < count; ++run) runs.push_back(one_run(options));
  std::sort(runs.begin(), runs.end(), [](const GrowthRow& a, const GrowthRow& b) { return a.seconds < b.seconds; });
  return runs[runs.size() / 2];
}

}  // namespace

Growth measure_growth(ProgressBar& bar, bool quick) {
  const int runs = quick ? 1 : kGrowthRuns;
  const TemporaryFolder folder;
  BuildOptions options;
  options.out = folder.path / "sphere.itf";
  Growth growth;
  for (const std::size_t points : std::span(kClouds).first(quick ? 1 : std::size(kClouds))) {
    options.input = folder.path / (std::to_string(points) + ".ply");
    bar.begin(std::to_string(points) + " points");
    write_sphere(options.input, points);
    growth.points.push_back(median_run(options, runs));
  }
  options.input = folder.path / (std::to_string(kClouds[0]) + ".ply");
  for (const int samples : std::span(kGrids).first(quick ? 1 : std::size(kGrids))) {
    bar.begin("grid of " + std::to_string(samples));
    options.grid = samples - 1 - static_cast<int>(2 * field::field_margin(options.band_voxels()));
    growth.grids.push_back(median_run(options, runs));
  }
  return growth;
}

}  // namespace isotouch::commands
