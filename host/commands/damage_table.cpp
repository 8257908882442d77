#include "host/commands/damage_table.h"

#include <cstdio>
#include <utility>

#include "host/evaluate/damage.h"
#include "host/evaluate/zero_surface.h"

namespace isotouch::commands {

std::vector<DamageRow> damage_rows(const evaluate::ShapeTrial& trial) {
  std::vector<DamageRow> rows;
  for (const evaluate::Damage& damage : evaluate::kDamages) {
    DamageRow row;
    row.shape = trial.shape.name;
    row.damage = damage.name;
    const field_file::OpenField field = evaluate::trial_field(evaluate::damaged_trial(trial, damage), Method::kDefault, &row.repair);
    row.error = evaluate::surface_error(field.view, trial.truth);
    row.components = evaluate::pieces(evaluate::zero_surface(field.view)).size();
    rows.push_back(std::move(row));
  }
  return rows;
}

nlohmann::ordered_json to_json(const std::vector<DamageRow>& rows) {
  auto json = nlohmann::ordered_json::array();
  for (const DamageRow& row : rows) {
    json.push_back({{"name", row.shape},
                    {"damage", row.damage},
                    {"rms_voxel", row.error.rms_voxel},
                    {"p99_voxel", row.error.p99_voxel},
                    {"normal_rms_deg", row.error.normal_rms_deg},
                    {"lost", row.error.lost},
                    {"components", row.components},
                    {"normals_turned", row.repair.turned},
                    {"pieces_dropped", row.repair.debris.pieces},
                    {"cavities_filled", row.repair.debris.cavities}});
  }
  return json;
}

void print(const std::vector<DamageRow>& rows) {
  std::printf(
      "the same from damaged scans: noise of 2 %% of the spacing, 1 %% outliers in and round the box, 6 %% of the normals flipped\n");
  std::printf("  %-10s %-9s %9s %9s %11s %6s %11s %14s %19s\n", "shape", "damage", "rms vox", "p99 vox", "normal rms", "lost", "components",
              "normals turned", "unsupported dropped");
  for (const DamageRow& row : rows) {
    std::printf("  %-10s %-9s %9.4f %9.4f %10.3f° %6zu %11zu %14zu %19zu\n", row.shape.c_str(), row.damage.c_str(), row.error.rms_voxel,
                row.error.p99_voxel, row.error.normal_rms_deg, row.error.lost, row.components, row.repair.turned,
                row.repair.debris.pieces + row.repair.debris.cavities);
  }
}

}  // namespace isotouch::commands
