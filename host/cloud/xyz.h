/// Points as plain text: XYZ, PWN, NPTS and their like.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "host/cloud/model.h"

namespace isotouch::cloud {

/// Takes one point a line, `x y z nx ny nz`, separated by blanks, tabs, commas or semicolons. A first line of names, perhaps behind `#` or `//`, says
/// where these columns (point_columns.h) are among others; where its names are separated by commas, semicolons or tabs, so are the cells below it,
/// and those that are not used may be empty. Below names with tabs, cells may also be separated by blanks. A first line with a single whole number is
/// the count of points; after it, positions and normals may also stand in two blocks of three numbers a line, as in the oldest PWN files. Empty lines
/// and lines that begin with `#` or `//` are skipped.
///
/// returns   points with normals; without normals when the lines hold `x y z` only
/// fails     InputError with the line: no number, a coordinate that is not finite (a normal becomes zero), another number of columns,
///           another count than stated, a column that is named twice, names of only a part of a normal, a remark with names in another order than
///           x y z nx ny nz for which the first line has too many or too few numbers
Model read_xyz(const std::string& name, std::span<const std::uint8_t> bytes);

/// The positions only: the first three numbers of a line, or those that a line of names calls x, y and z. Whatever else a line holds does not count.
std::vector<Eigen::Vector3d> read_xyz_positions(const std::string& name, std::span<const std::uint8_t> bytes);

}  // namespace isotouch::cloud
