#include "host/commands/dirty_table.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

#include "host/board_commands/print_json.h"
#include "host/cloud/mesh.h"
#include "host/cloud/ply.h"
#include "host/cloud/read_mesh.h"
#include "host/commands/progress_bar.h"
#include "host/commands/verdict_text.h"
#include "host/error.h"
#include "host/evaluate/mesh_shape.h"
#include "host/field/closed_mesh.h"
#include "host/files/temporary_folder.h"

namespace isotouch::commands {

namespace {

using evaluate::DirtyRow;
using evaluate::DirtySurface;

std::string text(const std::optional<double>& figure) {
  if (!figure) return "-";
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.3f", *figure);
  return digits;
}

void print(const char* scan, const char* dirt, const DirtySurface& surface, const char* judgement) {
  std::printf("  %-19s %-16s ", scan, dirt);
  if (!surface.refused.empty()) {
    std::printf("refused: %s", surface.refused.c_str());
  } else {
    std::printf("%8.3f %8s %7zu %8s %9.2f %%  %s", surface.surface_rms, text(surface.truth_rms).c_str(), surface.pieces,
                text(surface.volume).c_str(), 100 * surface.wrong_side, judgement);
  }
}

void print(const DirtyRow& row) {
  print(row.scan.c_str(), row.dirt.c_str(), row,
        row.believed_wrong()      ? "PLAUSIBLE, BUT WRONG"
        : row.verdict.plausible() ? "plausible"
        : row.wrong()             ? "wrong, and known"
                                  : "in doubt");
  for (const std::string& reason : row.verdict.reasons) std::printf("; %s", reason.c_str());
  std::printf("\n");
  if (row.beside) {
    print("", "  beside", *row.beside, "");
    std::printf("\n");
  }
  std::fflush(stdout);
}

nlohmann::ordered_json figure_json(const std::optional<double>& figure) {
  return figure ? nlohmann::ordered_json(*figure) : nlohmann::ordered_json(nullptr);
}

nlohmann::ordered_json surface_json(const DirtySurface& surface) {
  nlohmann::ordered_json json = {{"refused", surface.refused}};
  if (!surface.refused.empty()) {
    for (const char* figure : {"surface_rms_voxel", "truth_rms_voxel", "pieces", "volume", "wrong_side", "wrong"}) json[figure] = nullptr;
    return json;
  }
  json["surface_rms_voxel"] = surface.surface_rms;
  json["truth_rms_voxel"] = figure_json(surface.truth_rms);
  json["pieces"] = surface.pieces;
  json["volume"] = figure_json(surface.volume);
  json["wrong_side"] = surface.wrong_side;
  json["wrong"] = surface.wrong();
  return json;
}

/// Runs a command on files, as a shell would.
evaluate::Reconstruct program(const std::string& command, const std::filesystem::path& folder) {
  return [command, points = folder / "points.ply", mesh = folder / "mesh.ply"](const cloud::OrientedPoints& cloud) {
    std::filesystem::remove(mesh);
    cloud::write_ply(points, cloud);
    if (std::system((command + " '" + points.string() + "' '" + mesh.string() + "' >&2").c_str()) != 0)
      throw InputError(command + ": failed, or is no command");
    field::MeshRepair repair;
    return field::closed_mesh(cloud::read_mesh(mesh), command, repair);
  };
}

/// The dirt of a scan's rows that contain a text.
std::vector<evaluate::Dirt> chosen_dirt(const evaluate::DirtyScan& scan, const std::string& only) {
  std::vector<evaluate::Dirt> chosen = evaluate::all_dirt();
  std::erase_if(chosen, [&](const evaluate::Dirt& dirt) { return (scan.name() + ' ' + dirt.name).find(only) == std::string::npos; });
  return chosen;
}

}  // namespace

nlohmann::ordered_json to_json(const DirtyRow& row) {
  nlohmann::ordered_json json = {{"scan", row.scan}, {"dirt", row.dirt}};
  json.update(surface_json(row));
  json["verdict"] = row.refused.empty() ? to_json(row.verdict) : nlohmann::ordered_json(nullptr);
  if (row.beside) json["beside"] = surface_json(*row.beside);
  return json;
}

std::size_t print_dirty(const DirtyChoice& choice, bool json) {
  std::vector<cloud::Shape> bodies;
  for (const std::filesystem::path& mesh : choice.meshes)
    bodies.push_back(evaluate::mesh_shape(cloud::read_mesh(mesh), mesh.stem().string()));
  std::optional<TemporaryFolder> folder;
  evaluate::Reconstruct other;
  if (!choice.beside.empty()) other = program(choice.beside, folder.emplace().path);
  evaluate::Tally tally;
  std::size_t believed = 0, wrong = 0, doubted = 0, all = 0;
  auto list = nlohmann::ordered_json::array();
  const std::vector<evaluate::DirtyScan> scans = evaluate::dirty_scans(std::move(bodies));
  std::vector<std::vector<evaluate::Dirt>> chosen;
  for (const evaluate::DirtyScan& scan : scans) chosen.push_back(chosen_dirt(scan, choice.only));
  if (std::all_of(chosen.begin(), chosen.end(), [](const auto& dirt) { return dirt.empty(); }))
    throw UsageError("--only: no row of the dirty scans contains '" + choice.only + "'; a row is, for example, '" + scans[0].name() + ' ' +
                     evaluate::all_dirt()[0].name + "'");
  if (!json) {
    std::printf(
        "dirty scans; surface: truth to field, truth: field to truth, rms voxels; volume over the true one; wrong side two voxels off\n");
    std::printf("  %-19s %-16s %8s %8s %7s %8s %11s  %s\n", "scan", "dirt", "surface", "truth", "pieces", "volume", "wrong side",
                "verdict");
  }
  std::vector<PlannedStage> plan;
  for (const evaluate::DirtyScan& scan : scans) plan.push_back({scan.name(), 1});
  ProgressBar bar(plan);
  for (std::size_t i = 0; i < scans.size(); ++i) {
    bar.begin(scans[i].name());
    evaluate::dirty_rows(
        scans[i], chosen[i],
        [&](const DirtyRow& row) {
          ++all;
          believed += row.believed_wrong() ? 1U : 0U;
          wrong += !row.refused.empty() || row.wrong() ? 1U : 0U;
          doubted += row.refused.empty() && !row.wrong() && !row.verdict.plausible() ? 1U : 0U;
          tally.count(row);
          json ? list.push_back(to_json(row)) : bar.aside([&] { print(row); });
        },
        other, choice.seed);
  }
  bar.end();
  if (json) {
    print_json(nlohmann::ordered_json{{"dirty", list}, {"wrong_but_plausible", believed}});
  } else {
    std::printf("%zu builds: %zu wrong or refused, %zu of them called plausible; %zu right, but in doubt; detached pieces are not judged\n",
                all, wrong, believed, doubted);
    if (other) {
      std::printf("of %zu that both built we are nearer in %zu from truth to surface; of the %zu whole ones in %zu from surface to truth\n",
                  tally.both, tally.surface, tally.both_whole, tally.truth);
    }
  }
  return believed;
}

}  // namespace isotouch::commands
