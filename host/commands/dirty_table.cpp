#include "host/commands/dirty_table.h"

#include <cstdio>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "host/cloud/read_mesh.h"
#include "host/commands/progress_bar.h"
#include "host/commands/verdict_text.h"
#include "host/evaluate/dirty_scan.h"
#include "host/evaluate/mesh_shape.h"

namespace isotouch::commands {

namespace {

using evaluate::DirtyRow;

void print(const DirtyRow& row) {
  std::printf("  %-19s %-16s ", row.scan.c_str(), row.dirt.c_str());
  if (!row.refused.empty()) {
    std::printf("refused: %s\n", row.refused.c_str());
    return;
  }
  std::printf("%8.3f %8.3f %7zu %8.3f %9.2f %%  %s", row.surface_rms, row.truth_rms, row.pieces, row.volume, 100 * row.wrong_side,
              row.believed_wrong()      ? "PLAUSIBLE, BUT WRONG"
              : row.verdict.plausible() ? "plausible"
              : row.wrong()             ? "wrong, and known"
                                        : "in doubt");
  for (const std::string& reason : row.verdict.reasons) std::printf("; %s", reason.c_str());
  std::printf("\n");
  std::fflush(stdout);
}

nlohmann::ordered_json row_json(const DirtyRow& row) {
  return {{"scan", row.scan},
          {"dirt", row.dirt},
          {"refused", row.refused},
          {"surface_rms_voxel", row.surface_rms},
          {"truth_rms_voxel", row.truth_rms},
          {"pieces", row.pieces},
          {"volume", row.volume},
          {"wrong_side", row.wrong_side},
          {"wrong", row.wrong()},
          {"verdict", to_json(row.verdict)}};
}

}  // namespace

std::size_t print_dirty(const DirtyChoice& choice, bool json) {
  std::vector<cloud::Shape> bodies;
  for (const std::filesystem::path& mesh : choice.meshes)
    bodies.push_back(evaluate::mesh_shape(cloud::read_mesh(mesh), mesh.stem().string()));
  std::size_t believed = 0, wrong = 0, doubted = 0, all = 0;
  auto list = nlohmann::ordered_json::array();
  if (!json) {
    std::printf(
        "dirty scans; surface: truth to field, truth: field to truth, rms voxels; volume over the true one; wrong side two voxels off\n");
    std::printf("  %-19s %-16s %8s %8s %7s %8s %11s  %s\n", "scan", "dirt", "surface", "truth", "pieces", "volume", "wrong side",
                "verdict");
  }
  const std::vector<evaluate::DirtyScan> scans = evaluate::dirty_scans(std::move(bodies));
  std::vector<PlannedStage> plan;
  for (const evaluate::DirtyScan& scan : scans) plan.push_back({scan.name(), 1});
  ProgressBar bar(plan);
  for (const evaluate::DirtyScan& scan : scans) {
    bar.begin(scan.name());
    std::vector<evaluate::Dirt> dirt;
    for (evaluate::Dirt& kind : evaluate::all_dirt()) {
      if ((scan.name() + ' ' + kind.name).find(choice.only) != std::string::npos) dirt.push_back(std::move(kind));
    }
    evaluate::dirty_rows(
        scan, dirt,
        [&](const DirtyRow& row) {
          ++all;
          believed += row.believed_wrong() ? 1U : 0U;
          wrong += !row.refused.empty() || row.wrong() ? 1U : 0U;
          doubted += row.refused.empty() && !row.wrong() && !row.verdict.plausible() ? 1U : 0U;
          json ? list.push_back(row_json(row)) : bar.aside([&] { print(row); });
        },
        choice.seed);
  }
  bar.end();
  if (json) {
    std::printf("%s\n", nlohmann::ordered_json{{"dirty", list}, {"wrong_but_plausible", believed}}.dump(2).c_str());
  } else {
    std::printf("%zu builds: %zu wrong or refused, %zu of them called plausible; %zu right, but in doubt\n", all, wrong, believed, doubted);
  }
  return believed;
}

}  // namespace isotouch::commands
