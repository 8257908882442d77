/// STL files, ascii and binary: triangles without shared vertices.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "host/cloud/model.h"

namespace isotouch::cloud {

/// A file of 84 + 50 n bytes that states n triangles is binary, even if blanks or zeros follow; any other must be ascii. The normals in it are not used.
///
/// returns   three positions for each face
/// fails     InputError with the line or the triangle: neither kind, a number that is none or not finite, a triangle that is not whole
Model read_stl(const std::string& name, std::span<const std::uint8_t> bytes);

}  // namespace isotouch::cloud
