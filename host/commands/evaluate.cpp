/// isotouch evaluate: accuracy of surface, normals and force on the objects whose answer is known, each beside its floor.
#include <algorithm>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "host/board_commands/print_json.h"
#include "host/commands/commands.h"
#include "host/commands/damage_table.h"
#include "host/commands/dirty_table.h"
#include "host/commands/progress_bar.h"
#include "host/error.h"
#include "host/evaluate/force_error.h"
#include "host/evaluate/published_table.h"
#include "host/evaluate/shape_trial.h"
#include "host/evaluate/surface_error.h"
#include "host/to_double.h"

namespace isotouch::commands {

namespace {

using evaluate::ForceError;
using evaluate::SurfaceError;
using Json = nlohmann::ordered_json;

constexpr const char* kShapes[] = {"sphere", "torus", "box", "plate", "capsules"};
constexpr double kSpeeds[] = {100, 300, 1000};  // mm/s; the last one is shown and not judged
constexpr std::size_t kJudged = 2;

struct ShapeRow {
  std::string name;
  SurfaceError error;
  SurfaceError floor;
};

struct MethodResult {
  std::vector<ShapeRow> shapes;
  std::vector<ForceError> forces;  ///< at kSpeeds
  std::vector<DamageRow> damage;   ///< of the default method alone
};

/// The shapes whose name contains a text.
std::vector<std::string> chosen_shapes(const std::string& only) {
  std::vector<std::string> chosen;
  std::string all;
  for (const std::string name : kShapes) {
    if (name.find(only) != std::string::npos) chosen.push_back(name);
    all += (all.empty() ? "" : ", ") + name;
  }
  if (chosen.empty()) throw UsageError("--only: no object's name contains '" + only + "'; the objects are " + all);
  return chosen;
}

/// One method on these shapes.
MethodResult measure(const std::vector<std::string>& shapes, Method method, ProgressBar& bar) {
  MethodResult result;
  for (const std::string& name : shapes) {
    bar.begin(name);
    const evaluate::ShapeTrial trial = evaluate::shape_trial(name);
    const field_file::OpenField built = evaluate::trial_field(trial, method);
    const field_file::OpenField floor = evaluate::floor_field(trial);
    result.shapes.push_back({name, evaluate::surface_error(built.view, trial.truth), evaluate::surface_error(floor.view, trial.truth)});
    if (method == Method::kDefault) {
      for (DamageRow& row : damage_rows(trial)) result.damage.push_back(std::move(row));
    }
    if (trial.shape.name != "sphere") continue;
    for (const double speed : kSpeeds) {
      const evaluate::SphereSlide slide = evaluate::trial_slide(built.view, speed);
      result.forces.push_back(evaluate::force_error(evaluate::slide_on_sphere(slide, evaluate::core_force(built.view, slide.period_s))));
    }
  }
  return result;
}

ForceError judged(const std::vector<ForceError>& forces) {
  ForceError worst = forces[0];
  for (std::size_t i = 1; i < kJudged; ++i) {
    worst.magnitude_rms_pct = std::max(worst.magnitude_rms_pct, forces[i].magnitude_rms_pct);
    worst.direction_max_deg = std::max(worst.direction_max_deg, forces[i].direction_max_deg);
  }
  return worst;
}

Json method_json(const MethodResult& result) {
  Json json;
  json["shapes"] = Json::array();
  for (const ShapeRow& row : result.shapes) {
    json["shapes"].push_back({{"name", row.name},
                              {"rms_voxel", row.error.rms_voxel},
                              {"p99_voxel", row.error.p99_voxel},
                              {"max_voxel", row.error.max_voxel},
                              {"normal_rms_deg", row.error.normal_rms_deg},
                              {"lost", row.error.lost},
                              {"floor_rms_voxel", row.floor.rms_voxel},
                              {"floor_normal_rms_deg", row.floor.normal_rms_deg}});
  }
  json["force"] = nullptr;
  if (!result.forces.empty()) {
    const ForceError force = judged(result.forces);
    json["force"] = {{"magnitude_rms_pct", force.magnitude_rms_pct}, {"direction_max_deg", force.direction_max_deg}};
  }
  json["force_at"] = Json::array();
  for (std::size_t i = 0; i < result.forces.size(); ++i) {
    json["force_at"].push_back({{"mm_per_s", kSpeeds[i]},
                                {"magnitude_rms_pct", result.forces[i].magnitude_rms_pct},
                                {"direction_max_deg", result.forces[i].direction_max_deg}});
  }
  if (!result.damage.empty()) json["damage"] = to_json(result.damage);
  return json;
}

void print(const MethodResult& result, const char* title) {
  std::printf("%s\n", title);
  std::printf("  %-10s %9s %9s %9s %11s %6s %11s %13s\n", "shape", "rms vox", "p99 vox", "max vox", "normal rms", "lost", "floor rms",
              "floor normal");
  for (const ShapeRow& row : result.shapes) {
    std::printf("  %-10s %9.4f %9.4f %9.3f %10.3f° %6zu %11.4f %12.3f°\n", row.name.c_str(), row.error.rms_voxel, row.error.p99_voxel,
                row.error.max_voxel, row.error.normal_rms_deg, row.error.lost, row.floor.rms_voxel, row.floor.normal_rms_deg);
  }
  for (std::size_t i = 0; i < result.forces.size(); ++i) {
    std::printf("  sphere, 4 voxels deep at %4.0f mm/s: force magnitude rms %.4f %%, direction max %.4f° over %zu ticks\n", kSpeeds[i],
                result.forces[i].magnitude_rms_pct, result.forces[i].direction_max_deg, result.forces[i].ticks);
  }
  if (!result.damage.empty()) print(result.damage);
}

Json row_json(const evaluate::PaperRow& row) {
  Json json{{"points", row.points}, {"inside_nodes", row.inside_nodes}, {"seconds", row.seconds}, {"grid", nullptr}};
  if (!row.grid.isZero()) json["grid"] = {row.grid.x(), row.grid.y(), row.grid.z()};
  return json;
}

Json table_json(const std::vector<evaluate::PublishedRow>& table) {
  Json json = Json::array();
  for (const evaluate::PublishedRow& row : table) {
    json.push_back({{"name", row.name},
                    {"points", row.points},
                    {"inside_nodes", row.inside_nodes},
                    {"seconds", row.seconds},
                    {"grid", {row.grid.x(), row.grid.y(), row.grid.z()}},
                    {"paper", row_json(row.paper)}});
  }
  return json;
}

std::string grid_text(const Eigen::Vector3i& grid) {
  if (grid.isZero()) return "-";
  return std::to_string(grid.x()) + " × " + std::to_string(grid.y()) + " × " + std::to_string(grid.z());
}

void print(const std::vector<evaluate::PublishedRow>& table) {
  std::printf("the paper's Table 1 (Core 2 Quad, 2.66 GHz), and ours: our objects of its point counts, on this machine\n");
  std::printf("  %-10s %6s %6s   %12s %12s   %14s %8s   %-16s %s\n", "object", "points", "ours", "inside nodes", "ours", "field time (s)",
              "ours", "grid", "ours");
  for (const auto& [paper, name, points, inside_nodes, seconds, grid] : table) {
    std::printf("  %-10s %6zu %6zu   %12zu %12zu   %14.2f %8.2f   ", name.c_str(), paper.points, points, paper.inside_nodes, inside_nodes,
                paper.seconds, seconds);
    const std::string theirs = grid_text(paper.grid);
    const int sign_bytes = paper.grid.isZero() ? 0 : 2;  // each × takes two bytes and one column
    std::printf("%-*s %s\n", 16 + sign_bytes, theirs.c_str(), grid_text(grid).c_str());
  }
}

/// One stage a shape and method; the published method builds once, ours also from damaged scans.
std::vector<PlannedStage> plan_for(const std::vector<std::string>& shapes, bool published) {
  std::vector<PlannedStage> plan;
  for (int method = 0; method < (published ? 2 : 1); ++method) {
    for (const std::string& name : shapes) plan.push_back({name, 1});
  }
  if (published) plan.push_back({"Table 1", 5});
  return plan;
}

void run(const std::string& only, bool json, bool published) {
  const std::vector<std::string> shapes = chosen_shapes(only);
  ProgressBar bar(plan_for(shapes, published));
  const MethodResult ours = measure(shapes, Method::kDefault, bar);
  std::optional<MethodResult> theirs;
  std::vector<evaluate::PublishedRow> table;
  if (published) {
    theirs = measure(shapes, Method::kPublished, bar);
    bar.begin("Table 1");
    table = evaluate::published_table();
  }
  bar.end();
  if (json) {
    Json all = method_json(ours);
    if (theirs) {
      all["published"] = method_json(*theirs);
      all["published"]["table1"] = table_json(table);
    }
    print_json(all);
    return;
  }
  print(ours, "default method, 3,756 points, one voxel = one unit of the shape");
  if (theirs) {
    print(*theirs, "published method, surface through the core's sampler, force by the core's integers, which descend as published");
    print(table);
  }
}

}  // namespace

void add_evaluate(CLI::App& app) {
  struct Options {
    bool json = false;
    bool published = false;
    bool dirty = false;
    DirtyChoice choice;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command =
      app.add_subcommand("evaluate", "Measure the accuracy of surface, normals and force on objects whose exact answer is known");
  command->add_flag("--published", options->published, "also measure the published method, and print the paper's Table 1 beside ours");
  command->add_flag("--json", options->json, "print one JSON object");
  CLI::Option* dirty = command->add_flag(
      "--dirty", options->dirty,
      "measure dirty scans instead: strays, noise, turned normals, holes; exit code 3 when a wrong field is called plausible");
  command->add_option("--only", options->choice.only,
                      "the objects whose name contains this text; of the dirty scans those whose row contains it, such as 'owl strays'");
  command->add_option("--mesh", options->choice.meshes, "dirty scans of these closed meshes instead of the project's own objects")
      ->needs(dirty);
  command->add_option("--seed", options->choice.seed, "for other points and other dirt of the same kinds; 1 unless given")->needs(dirty);
  command
      ->add_option(
          "--beside", options->choice.beside,
          "a command that turns oriented points into a closed mesh, run as COMMAND POINTS.ply MESH.ply: measured on the same scans")
      ->needs(dirty);
  command->callback([options] {
    if (!options->dirty) return run(options->choice.only, options->json, options->published);
    const std::size_t wrong = print_dirty(options->choice, options->json);
    if (wrong > 0) throw ComparisonFailed(std::to_string(wrong) + " wrong fields were called plausible");
  });
}

}  // namespace isotouch::commands
