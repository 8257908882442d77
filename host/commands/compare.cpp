/// isotouch compare: a field against the closed mesh of its object.
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "host/board_commands/output.h"
#include "host/board_commands/print_json.h"
#include "host/cloud/mesh.h"
#include "host/cloud/read_mesh.h"
#include "host/commands/commands.h"
#include "host/commands/felt_table.h"
#include "host/commands/progress_bar.h"
#include "host/error.h"
#include "host/evaluate/compare_mesh.h"
#include "host/evaluate/felt_comparison.h"
#include "host/evaluate/felt_hands.h"
#include "host/evaluate/recorded_hand.h"
#include "host/evaluate/truth_comparison.h"
#include "host/evaluate/zero_surface.h"
#include "host/field/closed_mesh.h"
#include "host/field/does_not_fit.h"
#include "host/field/parallel.h"
#include "host/field/triangle_tree.h"
#include "host/field_file/open_field.h"
#include "host/to_double.h"
#include "host/trace/trace_file.h"
#include "host/view/picture.h"
#include "host/view/worst_picture.h"

namespace isotouch::commands {

namespace {

using evaluate::SurfaceError;
using evaluate::TruthComparison;

struct CompareOptions {
  std::filesystem::path field;
  std::filesystem::path mesh;
  std::filesystem::path beside;  ///< another program's mesh, in the cloud's frame; empty: none
  std::filesystem::path worst;   ///< the picture to write; empty: none
  bool floor = false;
  bool felt = false;
  std::vector<std::string> traces;  ///< hands for --felt
  std::uint64_t seed = 1;           ///< of the others
  unsigned threads = 0;             ///< 0: one for each processor
  bool json = false;
};

/// A field measured at points along their normals, and as a whole.
struct Measured {
  SurfaceError at_points;
  cloud::TriangleMesh surface;
  TruthComparison whole;
};

Measured measure(const FieldView& field, const evaluate::TrueSurface& mesh, ProgressBar& bar) {
  Measured measured;
  bar.begin("offsets");
  measured.at_points = evaluate::compare_with_mesh(field, mesh.outer);
  bar.begin("surface");
  measured.surface = evaluate::zero_surface(field);
  bar.begin("distances");
  measured.whole = evaluate::compare_surfaces(field, measured.surface, mesh);
  bar.end();
  return measured;
}

cloud::TriangleMesh read_truth(const std::filesystem::path& file) {
  try {
    return cloud::read_mesh(file);
  } catch (const cloud::NoFaces&) {
    throw cloud::NoFaces(file.string(),
                         "compare needs the closed mesh of the object; make one of a field with isotouch export FIELD --input-frame -o "
                         "mesh.ply");
  }
}

/// The mesh of a file, where the field's cloud is: sound as `build` wants it, and without holes.
cloud::TriangleMesh placed_mesh(const std::filesystem::path& file, const FieldView& field) {
  field::MeshRepair repair;
  cloud::TriangleMesh mesh = field::closed_mesh(read_truth(file), file.string(), repair);
  if (repair.holes > 0)
    throw InputError(file.string() + ": " + repair.warnings().front() + ", so it is no truth to compare with; close it first");
  for (const std::string& warning : repair.warnings()) std::fprintf(stderr, "isotouch: %s: %s\n", file.string().c_str(), warning.c_str());
  return cloud::placed(std::move(mesh), evaluate::placement_of(field));
}

/// The field of another mesh, with this one's voxel and band.
field_file::OpenField field_beside(const std::filesystem::path& file, const FieldView& field) {
  const cloud::TriangleMesh mesh = placed_mesh(file, field);
  try {
    return evaluate::field_of_mesh(mesh, to_double(field.edge), to_double(field.band), field.interpolation);
  } catch (const field::DoesNotFit& error) {
    throw InputError(file.string() + ": " + error.fact() + "; name a mesh of the same object, in the same frame and unit");
  }
}

/// How long the stages take, about.
std::vector<PlannedStage> plan_for(bool floor, bool beside) {
  const std::vector<PlannedStage> one = {{"offsets", 1}, {"surface", 1}, {"distances", 8}};
  std::vector<PlannedStage> all = one;
  if (floor) {
    all.push_back({"floor", 3});
    all.insert(all.end(), one.begin(), one.end());
  }
  if (beside) {
    all.push_back({"beside", 3});
    all.insert(all.end(), one.begin(), one.end());
  }
  return all;
}

nlohmann::ordered_json measured_json(const Measured& measured) {
  const auto& [error, surface, whole] = measured;
  return {{"rms_mm", error.rms_mm},
          {"rms_voxel", error.rms_voxel},
          {"p99_voxel", error.p99_voxel},
          {"max_voxel", error.max_voxel},
          {"normal_rms_deg", error.normal_rms_deg},
          {"lost", error.lost},
          {"mesh_to_field_rms_voxel", whole.mesh_to_field.rms_voxel},
          {"mesh_to_field_far", whole.mesh_to_field.far},
          {"field_to_mesh_rms_voxel", whole.field_to_mesh.rms_voxel},
          {"field_to_mesh_far", whole.field_to_mesh.far},
          {"hausdorff_voxel", whole.hausdorff_voxel()},
          {"hausdorff_at_most_voxel", whole.hausdorff_at_most_voxel()},
          {"hausdorff_from_mesh_voxel", whole.from_mesh_voxel()},
          {"hausdorff_from_blob_voxel", whole.from_field_voxel()},
          {"wrong_side_volume_pct", whole.wrong_side_pct},
          {"components", whole.pieces.size()},
          {"volume_ratio", whole.volume_ratio}};
}

std::string text(const Eigen::Vector3d& place) {
  char digits[96];
  std::snprintf(digits, sizeof digits, "(%.2f, %.2f, %.2f)", place.x(), place.y(), place.z());
  return digits;
}

void print(std::FILE* to, const char* name, const Measured& measured) {
  const auto& [error, surface, whole] = measured;
  std::fprintf(to, "%-6s rms %.4f mm = %.4f voxel, p99 %.4f, max %.3f voxel, normals rms %.2f°, lost %zu of %zu\n", name, error.rms_mm,
               error.rms_voxel, error.p99_voxel, error.max_voxel, error.normal_rms_deg, error.lost, error.lost + error.points);
  const auto& [there, back] = std::pair(whole.mesh_to_field, whole.field_to_mesh);
  std::fprintf(to, "       nearest distances rms: mesh to field %.4f voxel, %zu of %zu beyond %.0f; field to mesh %.4f voxel, %zu beyond\n",
               there.rms_voxel, there.far, evaluate::kSpreadPoints, evaluate::kFarVoxels, back.rms_voxel, back.far);
  std::fprintf(to, "       Hausdorff %.3f to %.3f voxel: mesh to field %.3f at %s mm, field to mesh %.3f at %s mm\n",
               whole.hausdorff_voxel(), whole.hausdorff_at_most_voxel(), whole.from_mesh_voxel(), text(whole.from_mesh.place).c_str(),
               whole.from_field_voxel(), text(whole.from_field.place).c_str());
  std::fprintf(to, "       wrong side %.3f %% of the volume, %.3f too much and %.3f missing; volume ratio %.4f; %zu component%s\n",
               whole.wrong_side_pct, whole.too_much_pct, whole.wrong_side_pct - whole.too_much_pct, whole.volume_ratio, whole.pieces.size(),
               whole.pieces.size() == 1 ? "" : "s");
}

void run(const CompareOptions& options) {
  std::FILE* to = text_stream(options.worst);
  const field_file::OpenField field = field_file::open_field(options.field);
  const evaluate::TrueSurface mesh = evaluate::true_surface(placed_mesh(options.mesh, field.view));
  ProgressBar bar(plan_for(options.floor, !options.beside.empty()));
  const Measured measured = measure(field.view, mesh, bar);

  nlohmann::ordered_json json = measured_json(measured);
  if (!options.json) print(to, "field", measured);
  if (options.floor) {
    bar.begin("floor");
    const field_file::OpenField exact = evaluate::floor_of_mesh(field.view, mesh.closed);
    const Measured floor = measure(exact.view, mesh, bar);
    json["floor"] = measured_json(floor);
    if (!options.json) print(to, "floor", floor);
  }
  if (!options.beside.empty()) {
    bar.begin("beside");
    const field_file::OpenField theirs = field_beside(options.beside, field.view);
    const Measured beside = measure(theirs.view, mesh, bar);
    json["beside"] = measured_json(beside);
    if (!options.json) print(to, "beside", beside);
  }
  if (!options.worst.empty()) {
    const bool on_truth = measured.whole.from_mesh.distance > measured.whole.from_field.distance;
    const evaluate::Farthest& worst = measured.whole.worst();
    view::write_picture(options.worst, view::worst_picture(field.view, measured.surface, mesh.outer, mesh.closed,
                                                           {worst.place, on_truth, worst.distance, measured.whole.voxel_mm},
                                                           {.title = options.field.stem().string()}));
  }
  if (options.json) print_json(json);
}

/// Draws the touch whose direction is worst.
void draw_felt(const CompareOptions& options, const FieldView& field, const evaluate::TrueSurface& truth,
               const evaluate::FeltPlace& worst) {
  const cloud::TriangleMesh surface = evaluate::zero_surface(field);
  const double distance = field::TriangleTree(surface).nearest(worst.god).distance;
  const view::WorstTouch touch{worst.hip, worst.god, worst.proxy, words_of(worst)};
  view::write_picture(options.worst, view::worst_picture(field, surface, truth.outer, truth.closed,
                                                         {worst.god, true, distance, to_double(field.edge), touch},
                                                         {.title = options.field.stem().string()}));
}

/// What hands feel of the field, beside the true surface.
void run_felt(const CompareOptions& options) {
  std::FILE* to = text_stream(options.worst);
  const field::ThreadLimit limit(options.threads);
  const field_file::OpenField field = field_file::open_field(options.field);
  const evaluate::TrueSurface mesh = evaluate::true_surface(placed_mesh(options.mesh, field.view));
  std::vector<evaluate::RecordedHand> recorded;
  for (const std::string& file : options.traces) recorded.push_back(evaluate::recorded_hand(trace::read_trace(file)));
  ProgressBar bar({{"hands", 5},
                   {"touch", 4},
                   {"floor", options.floor ? 5.0 : 0.0},
                   {"beside", options.beside.empty() ? 0.0 : 4.0},
                   {"picture", options.worst.empty() ? 0.0 : 1.0}});
  bar.begin("hands");
  const field::TriangleTree outer(mesh.outer), closed(mesh.closed);
  const evaluate::TrueTrees trees(outer, closed);
  const std::vector<evaluate::FeltHand> hands = evaluate::felt_hands(trees, recorded, {.seed = options.seed});
  bar.begin("touch");
  const evaluate::FeltComparison felt = evaluate::compare_felt(field.view, trees, hands);
  bar.end();
  nlohmann::ordered_json json = felt_json(felt);
  if (!options.json) print_felt(to, "field", felt);
  if (options.floor) {
    bar.begin("floor");
    const field_file::OpenField exact = evaluate::floor_of_mesh(field.view, mesh.closed);
    const evaluate::FeltComparison floor = evaluate::compare_felt(exact.view, trees, hands);
    bar.end();
    json["floor"] = felt_json(floor);
    if (!options.json) print_felt(to, "\nfloor", floor);
  }
  if (!options.beside.empty()) {
    bar.begin("beside");
    const evaluate::TrueSurface other = evaluate::true_surface(placed_mesh(options.beside, field.view));
    const field::TriangleTree other_outer(other.outer), other_closed(other.closed);
    const evaluate::FeltComparison beside = evaluate::compare_felt(field.view, {other_outer, other_closed}, trees, hands);
    bar.end();
    json["beside"] = felt_json(beside);
    if (!options.json) print_felt(to, "\nbeside", beside);
  }
  if (!options.worst.empty()) {
    bar.begin("picture");
    draw_felt(options, field.view, mesh, felt.worst_direction);
    bar.end();
  }
  if (options.json) print_json(json);
}

}  // namespace

void add_compare(CLI::App& app) {
  auto options = std::make_shared<CompareOptions>();
  CLI::App* command = app.add_subcommand("compare",
                                         "Compare a field with the closed mesh of its object: offsets at 20,000 points along the mesh's "
                                         "normals, the worst place of both surfaces, the volume on the wrong side");
  command->add_option("FIELD", options->field, "the field (.itf)")->required();
  command->add_option("MESH", options->mesh, "the true surface in the cloud's frame: PLY, OBJ or STL")->required();
  command->add_flag("--floor", options->floor, "also compare the mesh's exact distances on the field's grid: the errors of the grid alone");
  CLI::Option* felt =
      command->add_option("--felt", options->traces,
                          "instead, measure what hands feel: direction and force beside an exact god-object on the mesh, for eight "
                          "kinds of motion, and for the recorded hands that follow (.trace)");
  felt->expected(0, CLI::detail::expected_max_vector_size)->type_name("[TRACE...]");
  command->add_option(
      "--beside", options->beside,
      "also compare another closed mesh of the same object: on a grid with the field's voxel, or with --felt by a god-object on that "
      "mesh: PLY, OBJ or STL");
  add_output(*command, "--worst", options->worst, kPictures,
             "draw the worst place of the field; with --felt, the touch whose direction is worst");
  command->add_option("--seed", options->seed, "with --felt: seed of the places and motions")->needs(felt)->capture_default_str();
  command
      ->add_option("--threads", options->threads,
                   "with --felt: number of threads; by default one for each processor. The result does not depend on it")
      ->needs(felt);
  command->add_flag("--json", options->json, "print one JSON object");
  command->callback([options, felt] {
    require_apart(options->worst, options->json);
    options->felt = felt->count() > 0;
    std::erase(options->traces, "");
    options->felt ? run_felt(*options) : run(*options);
  });
}

}  // namespace isotouch::commands
