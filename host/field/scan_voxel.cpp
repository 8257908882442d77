#include "host/field/scan_voxel.h"

#include <array>
#include <cstdio>

#include "host/field/default_grid.h"

namespace isotouch::field {

ScanVoxel scan_voxel(const SoundScan& sound, const Eigen::Vector3d& sides, double scale, const GridWish& wish, int usual) {
  const double side = sides.maxCoeff(), spacing = sound.spacing * scale;
  ScanVoxel voxel{wish.voxel_mm.value_or(side * scale / wish.grid.value_or(usual)), {}};
  if ((wish.voxel_mm || wish.grid) && spacing > kUselessVoxels * voxel.edge_mm) {
    std::array<char, 200> text{};
    std::snprintf(
        text.data(), text.size(),
        "the grid is finer than the scan supports: neighbouring points are %.3g mm apart, a voxel is %.3g mm; --grid %d shows as much",
        spacing, voxel.edge_mm, finest_grid(side, sound.spacing));
    voxel.warning = text.data();
  }
  return voxel;
}

}  // namespace isotouch::field
