/// PCD files of the Point Cloud Library: ascii, binary and compressed.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "host/cloud/model.h"

namespace isotouch::cloud {

/// Takes place, normal and stiffness (point_columns.h) of any number type; other fields are skipped. Points without finite coordinates are no points. Of
/// points with normals those without a finite one are left out, too; when none has one, there are no normals. A place that more than 81 pixels of an
/// image without normals have is a constant that stands where nothing returned, and no point.
///
/// returns   a model, with a grid when HEIGHT is above 1 and there are no normals. The sensor stood at the translation of VIEWPOINT, in the points'
///           own frame: PCL's normal estimation takes it so. In the origin it says nothing
/// fails     InputError with the line, or with the point for binary files: as `read_pcd_header`; a body that is too short or too long, a packed body
///           that does not unpack to what the header declares, no number; no point with finite coordinates, unless it is an image
/// source    "The PCD (Point Cloud Data) file format", pointclouds.org; PCL's PCDReader for the compressed form
Model read_pcd(const std::string& name, std::span<const std::uint8_t> bytes);

}  // namespace isotouch::cloud
