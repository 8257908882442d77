/// Points as plain text: XYZ, PWN, NPTS and their like.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "host/cloud/model.h"

namespace isotouch::cloud {

/// Takes one point a line, `x y z nx ny nz`, separated by blanks, tabs, commas or semicolons. A first line of names, perhaps behind `#` or `//`,
/// says where these columns (point_columns.h) are among others; where its names are separated by commas, semicolons or tabs, so are the cells below it, and
/// those that are not used may be empty. A first line with a single whole number is the count of points; after it, positions and normals may also stand in
/// two blocks of three numbers a line, as in the oldest PWN files. Empty lines and lines that begin with `#` or `//` are skipped.
///
/// returns   points with normals; without normals when the lines hold `x y z` only
/// fails     InputError with the line: no number, a coordinate that is not finite (a normal becomes zero), another number of columns,
///           another count than stated, a column that is named twice, names of only a part of a normal
Model read_xyz(const std::string& name, std::span<const std::uint8_t> bytes);

}  // namespace isotouch::cloud
