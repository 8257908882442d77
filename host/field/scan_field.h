/// From a scan in order to a judged field: the grid round it, the distances, the verdict.
#pragma once

#include "host/field/band_field.h"
#include "host/field/build_field.h"
#include "host/field/invented_surface.h"
#include "host/field/progress.h"
#include "host/field/sound_scan.h"
#include "host/field/verdict.h"

namespace isotouch::field {

struct BuiltScan {
  BandField field;
  Repair repair;
};

struct JudgedScan {
  Verdict verdict;
  InventedSurface invented;
};

struct ScanField {
  BandField field;
  Repair repair;
  Verdict verdict;
  InventedSurface invented;
};

/// scan      workspace, mm
/// edge      of a voxel, mm
/// band      half width, voxels, 1 to 7.99
/// fails     InputError of `make_grid` and `build_field`
BuiltScan built_scan(const SoundScan& scan, double edge, double band, Progress& progress);
JudgedScan judged_scan(const BuiltScan& built, const SoundScan& scan);

/// One after the other; `progress` is told of the verdict, too.
ScanField scan_field(const SoundScan& scan, double edge, double band, Progress& progress);

}  // namespace isotouch::field
