#include "host/field/scan_field.h"

#include <Eigen/Geometry>
#include <utility>

#include "host/field/make_grid.h"
#include "host/field/spacings.h"

namespace isotouch::field {

BuiltScan built_scan(const SoundScan& scan, double edge, double band, Progress& progress) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& position : scan.points.positions) box.extend(position);
  const Grid grid = make_grid(box.min(), box.max(), edge, field_margin(band));
  BuiltScan built;
  built.field =
      build_field(scan.points, grid, band, progress, &built.repair, {scan.measured, scan.is_sheet, scan.smoothed ? scan.noise : 0.0});
  return built;
}

JudgedScan judged_scan(const BuiltScan& built, const SoundScan& scan) {
  const Spacings spacings(scan.points);
  JudgedScan judged;
  judged.invented = invented_surface(built.field, scan, spacings);
  judged.verdict = judge(built.field, scan, built.repair, spacings);
  judged.verdict.invented_share = judged.invented.share;
  return judged;
}

ScanField scan_field(const SoundScan& scan, double edge, double band, Progress& progress) {
  BuiltScan built = built_scan(scan, edge, band, progress);
  progress.begin("verdict");
  JudgedScan judged = judged_scan(built, scan);
  progress.end();
  return {std::move(built.field), built.repair, std::move(judged.verdict), std::move(judged.invented)};
}

}  // namespace isotouch::field
