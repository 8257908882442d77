/// The one table of quantities: unit, fraction bits, range and resolution of everything that both sides exchange.
///
///   type        unit           fraction bits   range            resolution
///   Mm          millimetre     20              ±2047 mm         0.95 nm
///   Voxel       voxel edge     16              ±32767 voxels    1.5e-5 voxel
///   Newton      newton         16              ±32767 N         15 µN
///   Stiffness   N/mm           16              ±32767 N/mm      1.5e-5 N/mm
///   Damping     N·s/mm         24              ±127 N·s/mm      6e-8 N·s/mm
///   MmPerVoxel  mm a voxel     20              ±2047 mm         0.95 nm
///   VoxelPerMm  voxels a mm    24              ±127 /mm         6e-8 /mm
///   PerSecond   1/s            8               ±8388607 /s      0.004 /s
///   Ratio       one            30              ±2               9.3e-10
///   MmPerS      mm/s           12              ±524 m/s         0.25 µm/s
///   NewtonMm    N·mm           12              ±524 N·m         0.25 µN·m
///   NewtonMmPerWord  N·mm      24              ±127 N·mm        6e-8 N·mm
#pragma once

#include "shared/fixed.h"

namespace isotouch {

using Mm = Fixed<Unit<1, 0, 0, 0>, 20>;
using Voxel = Fixed<Unit<0, 0, 0, 1>, 16>;
using Newton = Fixed<Unit<0, 1, 0, 0>, 16>;
using Stiffness = Fixed<Unit<-1, 1, 0, 0>, 16>;
using Damping = Fixed<Unit<-1, 1, 1, 0>, 24>;
using MmPerVoxel = Fixed<Unit<1, 0, 0, -1>, 20>;
using VoxelPerMm = Fixed<Unit<-1, 0, 0, 1>, 24>;
using PerSecond = Fixed<Unit<0, 0, -1, 0>, 8>;
using Ratio = Fixed<Unit<0, 0, 0, 0>, 30>;
using MmPerS = Fixed<Unit<1, 0, -1, 0>, 12>;
using NewtonMm = Fixed<Unit<1, 1, 0, 0>, 12>;
using NewtonMmPerWord = Fixed<Unit<1, 1, 0, 0>, 24>;

}  // namespace isotouch
