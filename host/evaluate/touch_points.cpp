#include "host/evaluate/touch_points.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "host/cloud/poisson_disk.h"
#include "host/error.h"
#include "host/field/nearest.h"
#include "host/to_double.h"

namespace isotouch::evaluate {

using cloud::OrientedPoints;
using Eigen::Vector3d;

namespace {

constexpr std::uint32_t kUnfit = kFollowing | kHeldInside | kRamping | kForceLimited | kInputClamped;
constexpr double kCellsAcross = 96;   // of the first, coarse look at the area
constexpr double kCellsAPlane = 1.5;  // cubic cells that a plane in any direction meets, per cell's side squared, on average
constexpr double kSameSide = 0.8;     // cosine between normals of touches that are averaged

using Cell = std::array<std::int64_t, 3>;  // z, y, x

/// The indices sorted by the cubic cell that they lie in, ties by themselves.
std::vector<std::pair<Cell, std::size_t>> in_cells(const OrientedPoints& points, double edge) {
  std::vector<std::pair<Cell, std::size_t>> sorted;
  sorted.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto index = [&](int axis) { return static_cast<std::int64_t>(std::floor(points.positions[i][axis] / edge)); };
    sorted.emplace_back(Cell{index(2), index(1), index(0)}, i);
  }
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

double area_of_cells(const OrientedPoints& points, double edge) {
  const auto cells = in_cells(points, edge);
  std::size_t count = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) count += i == 0 || cells[i].first != cells[i - 1].first ? 1U : 0U;
  return static_cast<double>(count) / kCellsAPlane * edge * edge;
}

/// The area that so many points cover, seen as finely as they will lie: gaps between strokes that are narrower than that do not count.
double touched_area(const OrientedPoints& touches, std::size_t points) {
  Eigen::AlignedBox3d box;
  for (const Vector3d& position : touches.positions) box.extend(position);
  double area = area_of_cells(touches, std::max(box.sizes().maxCoeff() / kCellsAcross, 1e-3));
  for (int look = 0; look < 4; ++look) area = area_of_cells(touches, std::max(std::sqrt(area / static_cast<double>(points)), 1e-3));
  return area;
}

/// One point for all of a cell that look the same way: mean position, mean direction.
OrientedPoints averaged(const OrientedPoints& touches, double edge) {
  struct Group {
    Vector3d position, normal;  // sums
    double count;
  };
  OrientedPoints places;
  std::vector<Group> groups;
  const auto flush = [&] {
    for (const Group& group : groups) {
      places.positions.push_back(group.position / group.count);
      places.normals.push_back(group.normal.normalized());
    }
    groups.clear();
  };
  const auto cells = in_cells(touches, edge);
  for (std::size_t n = 0; n < cells.size(); ++n) {
    if (n > 0 && cells[n].first != cells[n - 1].first) flush();
    const Vector3d& position = touches.positions[cells[n].second];
    const Vector3d& normal = touches.normals[cells[n].second];
    const auto alike = [&](const Group& group) { return group.normal.dot(normal) > kSameSide * group.normal.norm(); };
    const auto found = std::find_if(groups.begin(), groups.end(), alike);
    if (found == groups.end()) {
      groups.push_back({position, normal, 1});
    } else {
      found->position += position;
      found->normal += normal;
      found->count += 1;
    }
  }
  flush();
  return places;
}

}  // namespace

TouchReader::TouchReader(std::string name, const TickSettings& settings, double least_force_n, double wall)
    : name_(std::move(name)), least_force_n_(least_force_n), wall_(wall) {
  set(settings);
}

void TouchReader::require_no_friction() const {
  if (settings_.friction == Ratio{} && settings_.friction_damping == Damping{}) return;
  throw InputError(name_ + ": " + (settings_.friction > Ratio{} ? "friction" : "friction_damping") +
                   " is set, which moves the proxy along the surface, so touches do not show where that is; set it to 0 and touch anew");
}

/// A field that is patched in a tick that was lost cannot be told from another one.
void TouchReader::follow_field(const Input& input) {
  const std::uint32_t loaded = input.field_generation;
  if (loaded == 0) return;
  is_another_ = is_another_ || (has_touched_ && generation_ != 0 && loaded != generation_ && (input.requests & kRequestMoved) == 0);
  generation_ = loaded;
}

void TouchReader::set(const TickSettings& settings) {
  settings_ = settings;
  require_no_friction();
}

TouchKind TouchReader::read(const TraceRecord& record, Touch& touch) {
  const Output& out = record.output;
  follow_field(record.input);
  if (record.input.change.setting != TickSetting::kNone) {
    RawSettings raw = raw_settings(settings_);
    raw[index_of(record.input.change.setting)] = record.input.change.raw;
    set(from_raw(raw));
  }
  if ((out.status & kStale) != 0 || !record.input.fresh) return TouchKind::kUnfit;  // an old sample does not show free space, either
  if ((out.status & kContact) == 0) return TouchKind::kFree;
  if ((out.status & kUnfit) != 0) return TouchKind::kUnfit;
  Vector3d force = to_double(out.force);
  if (record.input.kind == InputKind::kPacket && !force.isZero(0)) force.y() -= to_double(settings_.weight);
  if (!(force.norm() >= least_force_n_)) return TouchKind::kWeak;
  Vector3d way = to_double(out.proxy - out.hip);
  if (way.isZero(0)) {
    ++proxyless_;
    if (!(wall_ > 0)) return TouchKind::kUnfit;
    way = force / wall_;
  }
  if (is_another_)
    throw InputError(name_ +
                     ": another field was loaded while the hand touched, so the touches are of two objects; touch one of them anew");
  has_touched_ = true;
  touch = {to_double(out.hip) + way, way.normalized()};
  return TouchKind::kTouch;
}

void TouchReader::refuse_proxyless() const {
  throw InputError(
      name_ +
      ": it has forces and no proxies, so nobody knows how deep the hand was; import it with --stiffness, the stiffness of the "
      "wall that was touched");
}

OrientedPoints thinned(const OrientedPoints& touches, std::size_t points, TouchReport& report) {
  const double area = touched_area(touches, points);
  const double wanted_mm = std::sqrt(area / static_cast<double>(points));
  const OrientedPoints places = averaged(touches, std::max(wanted_mm / 4, 1e-6));
  report.places = places.size();
  // A place at the rim of its cell may hold one touch only, so each that is kept is averaged once more over the touches round it.
  const field::Nearest near(touches.positions);
  std::vector<field::Neighbour> found;
  OrientedPoints kept;
  for (const std::size_t i : cloud::spread_out(places, area, points)) {
    Vector3d position = places.positions[i], normal = places.normals[i];
    double count = 1;
    near.within(position, wanted_mm / 5, found);
    for (const field::Neighbour& touch : found) {
      if (touches.normals[touch.index].dot(places.normals[i]) <= kSameSide) continue;
      position += touches.positions[touch.index];
      normal += touches.normals[touch.index];
      count += 1;
    }
    kept.positions.emplace_back(position / count);
    kept.normals.emplace_back(normal.normalized());
  }
  report.points = kept.size();
  report.spacing_mm = std::sqrt(area / static_cast<double>(std::max<std::size_t>(kept.size(), 1)));
  return kept;
}

OrientedPoints touch_points(const trace::Trace& trace, const TouchOptions& options, TouchReport& report) {
  const std::string name = trace.path();
  const TraceHeader& header = trace.header();
  if (!header.has_outputs) throw InputError(name + ": it holds no forces; record them with isotouch replay, or import them with --forces");

  report = {};
  report.ticks = trace.size();
  OrientedPoints touches;
  TouchReader reader(name, header.settings, options.least_force_n, options.stiffness_n_per_mm);
  for (std::size_t tick = 0; tick < trace.size(); ++tick) {
    Touch touch;
    switch (reader.read(trace.record(tick), touch)) {
      case TouchKind::kFree: ++report.free; break;
      case TouchKind::kUnfit: ++report.unfit; break;
      case TouchKind::kWeak: ++report.weak; break;
      case TouchKind::kTouch: {
        touches.positions.push_back(touch.position);
        touches.normals.push_back(touch.normal);
      }
    }
  }
  report.touches = touches.size();
  if (options.stiffness_n_per_mm > 0 && report.touches > reader.proxyless())
    throw InputError(name + ": its proxies show where the surface was; leave --stiffness out");
  if (touches.size() == 0) {
    if (reader.proxyless() > 0) reader.refuse_proxyless();
    throw InputError(name + ": not one of its " + std::to_string(report.ticks) +
                     " ticks touches anything with enough force to show where the surface is");
  }
  return thinned(touches, options.points, report);
}

}  // namespace isotouch::evaluate
