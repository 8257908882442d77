/// Recorded motion, with forces where they are wanted, in a text table: a header line with the columns' names, then a row a sample.
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <vector>

namespace isotouch::motion {

struct TimedPoint {
  double time = 0;                                  ///< s, since the first sample
  Eigen::Vector3d position;                         ///< mm
  Eigen::Vector3d force = Eigen::Vector3d::Zero();  ///< N, on the hand; zero where none was read
};

/// Which column is what, by the names in the header line, and the units of all.
struct MotionColumns {
  std::string time = "t_s";
  std::string x = "x_mm";
  std::string y = "y_mm";
  std::string z = "z_mm";
  std::string fx = "fx_N";
  std::string fy = "fy_N";
  std::string fz = "fz_N";
  bool with_forces = false;  ///< read them, N
  std::string time_unit;     ///< s ms us ns; empty: the last word of the column's name (t_s, "stamp [ns]"), else s
  std::string length_unit;   ///< mm cm m in; empty: the last words of the columns' names, which must agree, else mm
  // A name of one word has no unit, and must not be another one than s, mm or N. Of a longer one, a last word that is no known unit is refused, as in t_min,
  // x_um, pose.x and fx_kN. A force's may be its axis, behind "force" or its unit: force_x, F_N_x, but not F_mN_x.
};

/// How many mm a unit of length has: mm cm m in.
///
/// fails     InputError: another unit
double millimetres_in(const std::string& unit);

/// Reads `t=NAME,x=NAME,y=NAME,z=NAME,fx=NAME,fy=NAME,fz=NAME`; what is not named keeps its default.
///
/// fails     InputError with the form that is expected
MotionColumns parse_columns(const std::string& text);

/// Separators are commas, semicolons or tabs, whichever the header line has; empty lines and lines that begin with # are skipped.
///
/// returns   at least two samples, by rising time
/// fails     InputError with file and line: no such column, another number of fields than the header has, not a finite number, time that
///           does not rise, fewer than two rows, an unknown unit, a line of more than 64 KiB
std::vector<TimedPoint> read_motion_csv(const std::filesystem::path& file, const MotionColumns& columns);

}  // namespace isotouch::motion
