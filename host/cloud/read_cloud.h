/// A file → oriented points that everything after may trust.
#pragma once

#include "host/cloud/check.h"
#include "host/cloud/oriented_points.h"
#include "host/cloud/source_file.h"

namespace isotouch::cloud {

/// Reads PLY (ply.h), OBJ (obj.h), PCD (pcd.h), a depth image (depth_image.h) or text (xyz.h), by the file's first bytes or its ending (file_kind.h), and
/// checks the cloud (check.h).
///
/// without_normals   as if the file had none
/// returns           points in the file's order and units, unit outward normals, no two at one place
/// fails             InputError, one sentence: file, place, what is wrong, what to do
OrientedPoints read_cloud(const SourceFile& file, CloudReport& report, bool without_normals = false);

/// The same of a frame of a scan that goes on (`check_frame`). Its points may have no normals, and may not be enough for a body.
///
/// returns           normals of a length from 1/2 to 2, or zero
Model read_frame(const SourceFile& file);

}  // namespace isotouch::cloud
