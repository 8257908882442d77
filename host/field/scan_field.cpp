#include "host/field/scan_field.h"

#include <Eigen/Geometry>

#include "host/field/make_grid.h"

namespace isotouch::field {

ScanField scan_field(const SoundScan& scan, double edge, double band, Progress& progress) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& position : scan.points.positions) box.extend(position);
  const Grid grid = make_grid(box.min(), box.max(), edge, field_margin(band));
  ScanField result;
  result.field = build_field(scan.points, grid, band, progress, &result.repair, scan.measured, scan.smoothed ? scan.noise : 0.0);
  progress.begin("verdict");
  result.invented = invented_surface(result.field, scan);
  result.verdict = judge(result.field, scan, result.repair);
  result.verdict.invented_share = result.invented.share;
  progress.end();
  return result;
}

}  // namespace isotouch::field
