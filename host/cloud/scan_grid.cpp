#include "host/cloud/scan_grid.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "host/cloud/model.h"

namespace isotouch::cloud {
namespace {

using Eigen::Vector3d;

constexpr double kAlongSight = 0.9698;  // squared sine of 80 degrees
constexpr int kMaxRadius = ScanGrid::kMaxRadius;
constexpr int kFewestNear = 5;           // of a cell and its eight neighbours; a straight rim has six, a corner four
constexpr std::size_t kOneIn = 5;        // normals may face away from the sensor; of an image hardly any do
constexpr double kAimedError = 0.05;     // of a normal, radians
constexpr double kQuantile = 0.8;        // of the third differences: the rest may be edges
constexpr double kInQuantile = 1.2816;   // standard deviations within which 80 % of a normal distribution lie
constexpr double kThirdOfNoise = 4.472;  // the standard deviation of p0 - 3 p1 + 3 p2 - p3, whose squares sum up to 20
constexpr double kOfDepth =
    0.0005;  // of the squared depth in a column: lenses leave up to 0.00013, wrong places in and behind an object 0.0018 and more
// The rows or columns of an unmirrored image are bent when both are exceeded. Lenses that move a corner 45 degrees beside the middle by 5 % leave up to 0.9
// of the squared depth, but 9e-6 of the squared distance; coordinates rounded to a pixel 0.018 and 1.6e-5. Rings round an axis through the origin have 0.23
// and 1e-4, if they go on for 54 degrees and lie within 67 degrees of the middle one.
constexpr double kBentOfDepth = 0.02;
constexpr double kBentOfSight = 1.6e-5;
// Of a mirrored image the squares off planes through the origin are this much larger: 1000 and 500 times for whole millimetres at 0.35 m and a wide lens,
// at most twice for wrong places.
constexpr double kMuchNearer = 10.0;
constexpr double kBeforeCamera = 0.2588;   // cosine of 75 degrees
constexpr std::size_t kOneBehindIn = 100;  // of the normals

/// The cells, and where a surface leads from one to the next.
class Cells {
 public:
  Cells(const std::vector<Vector3d>& positions, const ScanGrid& grid)
      : positions_(positions), grid_(grid), rows_(grid.cells.size() / grid.columns), links_(grid.cells.size(), 0) {
    for (std::size_t row = 0; row < rows_; ++row) {
      for (std::size_t column = 0; column < grid.columns; ++column) {
        const std::size_t cell = row * grid.columns + column;
        if (column + 1 < grid.columns) link(cell, cell + 1, kRight);
        if (row + 1 < rows_) link(cell, cell + grid.columns, kDown);
      }
    }
  }

  std::size_t rows() const { return rows_; }
  std::size_t columns() const { return grid_.columns; }
  bool has(std::size_t cell) const { return grid_.cells[cell] != ScanGrid::kNoReturn; }
  const Vector3d& place(std::size_t cell) const { return positions_[grid_.cells[cell]]; }
  bool beside_jump(std::size_t cell) const { return (links_[cell] & kJump) != 0; }
  bool joined_right(std::size_t cell) const { return (links_[cell] & kRight) != 0; }
  bool joined_down(std::size_t cell) const { return (links_[cell] & kDown) != 0; }

 private:
  static constexpr std::uint8_t kRight = 1, kDown = 2, kJump = 4;

  void link(std::size_t from, std::size_t to, std::uint8_t direction) {
    if (!has(from) || !has(to)) return;
    const Vector3d way = place(to) - place(from);
    const Vector3d sight = 0.5 * (place(from) + place(to)) - grid_.sensor;
    const double along = way.dot(sight);
    const bool is_one_behind =
        (place(from) - grid_.sensor).dot(place(to) - grid_.sensor) < 0.0;  // neighbours are seen in nearly one direction
    if (is_one_behind || along * along > kAlongSight * way.squaredNorm() * sight.squaredNorm()) {
      links_[from] |= kJump;
      links_[to] |= kJump;
    } else {
      links_[from] |= direction;
    }
  }

  const std::vector<Vector3d>& positions_;
  const ScanGrid& grid_;
  std::size_t rows_;
  std::vector<std::uint8_t> links_;
};

/// The noise of a place in widths of a cell.
double relative_noise(const Cells& cells) {
  std::vector<double> ratios;
  for (std::size_t row = 0; row < cells.rows(); ++row) {
    for (std::size_t column = 0; column + 3 < cells.columns(); ++column) {
      const std::size_t cell = row * cells.columns() + column;
      if (!cells.joined_right(cell) || !cells.joined_right(cell + 1) || !cells.joined_right(cell + 2)) continue;
      const Vector3d first = cells.place(cell + 1) - cells.place(cell), last = cells.place(cell + 3) - cells.place(cell + 2);
      const Vector3d between = cells.place(cell + 2) - cells.place(cell + 1);
      const double width = (first + between + last).norm() / 3.0;
      if (width > 0.0) ratios.push_back((first - 2.0 * between + last).norm() / width);
    }
  }
  if (ratios.empty()) return 0.0;
  const auto place = ratios.begin() + static_cast<std::ptrdiff_t>(kQuantile * static_cast<double>(ratios.size() - 1));
  std::nth_element(ratios.begin(), place, ratios.end());
  return *place / (kThirdOfNoise * kInQuantile);
}

/// Half the width of a window in which the normal's error is as small as aimed for.
int radius_for(double noise) {
  for (int radius = 1; radius < kMaxRadius; ++radius) {
    const int squares = (2 * radius + 1) * (2 * radius + 1) * radius * (radius + 1) / 3;  // of the columns from the middle, summed up
    if (noise <= kAimedError * std::sqrt(static_cast<double>(squares))) return radius;
  }
  return kMaxRadius;
}

/// The normal of the plane through a cell's surroundings, in the grid's winding and of any length; zero for an edge.
Vector3d normal(const Cells& cells, std::size_t row, std::size_t column, int radius) {
  const std::size_t middle = row * cells.columns() + column;
  if (cells.beside_jump(middle)) return Vector3d::Zero();
  // Reached are cells to which joined ones lead that never turn back.
  std::array<std::array<bool, 2 * kMaxRadius + 1>, 2 * kMaxRadius + 1> reached{};
  int near = 0;
  double count = 0, u_sum = 0, v_sum = 0;
  Vector3d p_sum = Vector3d::Zero(), up = Vector3d::Zero(), vp = Vector3d::Zero();
  const auto visit = [&](int u, int v) {
    const std::size_t across = column + static_cast<std::size_t>(u), down = row + static_cast<std::size_t>(v);  // below zero: very large
    if (across >= cells.columns() || down >= cells.rows()) return;
    const std::size_t cell = down * cells.columns() + across;
    const auto was = [&](int x, int y) {
      return reached[static_cast<std::size_t>(y + kMaxRadius)][static_cast<std::size_t>(x + kMaxRadius)];
    };
    const bool from_left = u > 0 && was(u - 1, v) && cells.joined_right(cell - 1);
    const bool from_right = u < 0 && was(u + 1, v) && cells.joined_right(cell);
    const bool from_above = v > 0 && was(u, v - 1) && cells.joined_down(cell - cells.columns());
    const bool from_below = v < 0 && was(u, v + 1) && cells.joined_down(cell);
    if (cell != middle && !from_left && !from_right && !from_above && !from_below) return;
    reached[static_cast<std::size_t>(v + kMaxRadius)][static_cast<std::size_t>(u + kMaxRadius)] = true;
    const Vector3d p = cells.place(cell) - cells.place(middle);
    near += std::abs(u) <= 1 && std::abs(v) <= 1 ? 1 : 0;
    count += 1.0;
    u_sum += u;
    v_sum += v;
    p_sum += p;
    up += u * p;
    vp += v * p;
  };
  const auto visit_row = [&](int v) {
    visit(0, v);
    for (int u = 1; u <= radius; ++u) {
      visit(u, v);
      visit(-u, v);
    }
  };
  visit_row(0);
  for (int v = 1; v <= radius; ++v) {
    visit_row(v);
    visit_row(-v);
  }
  if (near < kFewestNear) return Vector3d::Zero();
  // The slopes of the plane are the inverse of a positive matrix times these two, so their product has its direction.
  return (up - u_sum / count * p_sum).cross(vp - v_sum / count * p_sum);
}

/// How far the rows, or the columns, are from lying in planes through a place. One without depth lies in such a plane wherever the place is.
struct OffPlanes {
  double off_plane = 0, off_line = 0, sight = 0;  ///< sums of squared lengths

  bool are_planes() const { return off_plane < kOfDepth * off_line; }
  /// A lens bends them less, or has hardly any depth in them.
  bool are_bent() const { return off_plane > kBentOfDepth * off_line && off_plane > kBentOfSight * sight; }
};

OffPlanes off_planes(const Cells& cells, const Vector3d& sensor, bool is_by_rows) {
  const std::size_t lines = is_by_rows ? cells.rows() : cells.columns(), length = is_by_rows ? cells.columns() : cells.rows();
  OffPlanes result;
  for (std::size_t line = 0; line < lines; ++line) {
    Eigen::Matrix3d about_sensor = Eigen::Matrix3d::Zero();
    Vector3d sum = Vector3d::Zero();
    double count = 0.0;
    for (std::size_t i = 0; i < length; ++i) {
      const std::size_t cell = is_by_rows ? line * length + i : i * lines + line;
      if (!cells.has(cell)) continue;
      const Vector3d sight = cells.place(cell) - sensor;
      about_sensor += sight * sight.transpose();
      sum += sight;
      count += 1.0;
    }
    if (count == 0.0) continue;
    const Eigen::Matrix3d about_middle = about_sensor - sum * sum.transpose() / count;
    result.off_plane += Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(about_sensor, Eigen::EigenvaluesOnly).eigenvalues()[0];
    result.off_line += Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(about_middle, Eigen::EigenvaluesOnly).eigenvalues().head<2>().sum();
    result.sight += about_sensor.trace();
  }
  return result;
}

/// Do the cells lie well before a camera in that place? A few may be wrong.
bool are_before(const Cells& cells, const Vector3d& sensor) {
  Vector3d sum = Vector3d::Zero();
  const auto for_each_sight = [&](const auto& visit) {
    for (std::size_t cell = 0; cell < cells.rows() * cells.columns(); ++cell) {
      if (cells.has(cell)) visit((cells.place(cell) - sensor).normalized());
    }
  };
  for_each_sight([&](const Vector3d& sight) { sum += sight; });
  const Vector3d middle = sum.normalized();
  std::size_t count = 0, behind = 0;
  for_each_sight([&](const Vector3d& sight) {
    ++count;
    behind += sight.dot(middle) > kBeforeCamera ? 0U : 1U;
  });
  return kOneBehindIn * behind <= count;
}

/// Was the image seen from its sensor's place? In an image right is right and down is down, so that its winding faces away from the camera; but some cameras
/// deliver mirrored ones.
///
/// cells     only those that have a normal: what was written where nothing returned says nothing of the sensor
/// away      it does
bool is_believed(const Cells& cells, const ScanGrid& grid, bool away) {
  const auto columns = [&](const Vector3d& place) { return off_planes(cells, place, false); };
  const auto rows = [&](const Vector3d& place) { return off_planes(cells, place, true); };
  const auto is_camera = [&](const Vector3d& place) { return columns(place).are_planes() && rows(place).are_planes(); };
  switch (grid.known) {
    case ScanGrid::Known::kSurely: return true;
    case ScanGrid::Known::kStated:
    case ScanGrid::Known::kUsual: {
      if (is_camera(Vector3d::Zero()) && !is_camera(grid.sensor)) return false;
      if (away) return true;
      const OffPlanes through_sensor = columns(grid.sensor);  // the rows of a scanner that turns are cones
      return through_sensor.are_planes() ||
             (!through_sensor.are_bent() && kMuchNearer * through_sensor.off_plane < columns(Vector3d::Zero()).off_plane);
    }
    case ScanGrid::Known::kAssumed: break;
  }
  if (!are_before(cells, grid.sensor)) return false;
  return away ? !columns(grid.sensor).are_bent() && !rows(grid.sensor).are_bent() : is_camera(grid.sensor);
}

}  // namespace

std::optional<std::size_t> orient_by_grid(Model& model, const ScanGrid& grid, bool* is_elsewhere) {
  if (is_elsewhere != nullptr) *is_elsewhere = false;
  if (grid.columns < 2 || grid.cells.size() < 2 * grid.columns) return std::nullopt;
  const Cells cells(model.positions, grid);
  const int radius = radius_for(relative_noise(cells));
  std::vector<Vector3d> normals(model.positions.size(), Vector3d::Zero());
  ScanGrid with_normal = grid;
  std::size_t returns = 0, oriented = 0, facing = 0;
  for (std::size_t cell = 0; cell < grid.cells.size(); ++cell) {
    if (!cells.has(cell)) continue;
    ++returns;
    const Vector3d n = normal(cells, cell / grid.columns, cell % grid.columns, radius);
    const double length = n.norm();
    if (!(length > 0.0) || !std::isfinite(length)) {
      with_normal.cells[cell] = ScanGrid::kNoReturn;
      continue;
    }
    ++oriented;
    normals[grid.cells[cell]] = n / length;
    facing += n.dot(grid.sensor - cells.place(cell)) > 0.0 ? 1U : 0U;
  }
  const bool away = 2 * facing < oriented;
  const std::size_t outvoted = away ? facing : oriented - facing;
  if (2 * oriented < returns || kOneIn * outvoted >= oriented) return std::nullopt;
  if (!is_believed(Cells(model.positions, with_normal), with_normal, away)) {
    if (is_elsewhere != nullptr) *is_elsewhere = true;
    return std::nullopt;
  }
  if (away) {
    for (Vector3d& n : normals) n = -n;
  }
  model.normals = std::move(normals);
  return keep_points(model, [&](std::size_t i) { return !model.normals[i].isZero(0.0); });
}

}  // namespace isotouch::cloud
