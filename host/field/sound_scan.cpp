#include "host/field/sound_scan.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <utility>

#include "host/cloud/placement.h"
#include "host/error.h"
#include "host/field/cut_plane.h"
#include "host/field/filtered_normals.h"
#include "host/field/hidden_share.h"
#include "host/field/line_of_sight.h"
#include "host/field/lone_parts.h"
#include "host/field/normal_voting.h"
#include "host/field/open_rim.h"
#include "host/field/orientation.h"
#include "host/field/outliers.h"
#include "host/field/parallel.h"
#include "host/field/quadric_fit.h"
#include "host/field/roughness.h"
#include "host/field/scan.h"
#include "host/field/scan_lines.h"
#include "host/field/sheet_back.h"
#include "host/field/turned_patches.h"

namespace isotouch::field {

namespace {

using cloud::OrientedPoints;
using Eigen::Vector3d;

constexpr double kMostCapped =
    0.06;  // of the surface: a hand cut at the wrist has 0.043, a ball cut in the middle 0.13 and more; nobody knows its other half
constexpr std::size_t kFewestPoints = 8;
constexpr double kBeside = 0.15;         // of the box's longest side: strays farther away have none like them at the surface
constexpr double kSheet = 0.4;           // of `Facing::one_sided`: a half sphere has 0.5, a box without its bottom at most 0.2
constexpr double kSureVote = 0.9;        // of `Facing::outward`, whatever the volume is
constexpr double kTilted = 0.12;         // 7 degrees
constexpr double kContradicted = 2.0;    // pairs are rougher than positions: the normals are to blame
constexpr double kNoisyNormals = 0.2;    // radians: sound clouds have 0.14 at most, normals tilted by 15 degrees 0.37
constexpr double kManyTurned = 0.02;     // of the normals, for another look at what is a sheet
constexpr double kRough = 0.05;          // spacings
constexpr double kSmooth = 0.7;          // cosine between normals on one face
constexpr double kOutlier = 4.0;         // standard deviations of a height
constexpr double kEqual = 0.9999;        // cosine between placeholders
constexpr double kNearlyAll = 0.99;      // of the normals
constexpr double kSteep = 0.5;           // sine: a step to the nearest point that so leaves the plane across the normal
constexpr double kManyOff = 0.1;         // of these steps: a ball has 0.5, terraces and a gentle relief have none
constexpr double kContradictory = 0.15;  // share of pairs of neighbours

std::unique_ptr<Scan> kept(const Scan& all, const std::vector<std::uint32_t>& samples) {
  OrientedPoints points;
  for (const std::uint32_t i : samples) {
    points.positions.push_back(all.positions()[i]);
    points.normals.push_back(all.normals()[i]);
    if (!all.stiffness().empty()) points.stiffness.push_back(all.stiffness()[i]);
  }
  return std::make_unique<Scan>(std::move(points));
}

/// Each sample's part of a surface, but for a factor that all have.
double surface_of(const Scan& scan, const std::vector<std::uint32_t>& samples) {
  double sum = 0.0;
  for (const std::uint32_t i : samples) sum += scan.spacing(i) * scan.spacing(i);
  return sum;
}

/// Where the file has no normals: the surface on which samples lie that are not connected, over that of the connected ones. Their normals were estimated with
/// those of a denser side, so that only now they have some.
///
/// connected   samples of the scan, ascending
double unknown_side(const Scan& scan, const std::vector<std::uint32_t>& connected) {
  std::vector<Vector3d> others;
  auto next = connected.begin();
  for (std::uint32_t i = 0; i < scan.size(); ++i) {
    if (next != connected.end() && *next == i) {
      ++next;
    } else {
      others.push_back(scan.positions()[i]);
    }
  }
  if (others.size() < Scan::kListed) return 0.0;
  const Scan alone({others, estimated_normals(others), {}});
  return surface_of(alone, on_a_surface(alone)) / surface_of(scan, connected);
}

/// How many of the points lie in the scan's box, or just beside it?
std::size_t in_box_of(const Scan& scan, const std::vector<Vector3d>& points) {
  Eigen::AlignedBox3d box;
  for (const Vector3d& p : scan.positions()) box.extend(p);
  const Vector3d margin = Vector3d::Constant(kBeside * box.sizes().maxCoeff());
  box.extend(box.max() + margin);
  box.extend(box.min() - margin);
  return static_cast<std::size_t>(std::count_if(points.begin(), points.end(), [&](const Vector3d& p) { return box.contains(p); }));
}

void turn_all(Scan& scan) {
  for (std::size_t i = 0; i < scan.size(); ++i) scan.turn_normal(i);
}

double median(std::vector<double> values) {
  const auto place = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) / 2);
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

/// Distance to the nearest sample, the median.
double median_nearest(const Scan& scan) {
  std::vector<double> nearest;
  for (std::size_t i = 0; i < scan.size(); ++i) nearest.push_back(std::sqrt(scan.around(i)[1].squared_distance));
  return median(std::move(nearest));
}

/// Would it be a closed surface if neighbours agreed? Then it only looks like a sheet, because a half of its normals point inward.
bool closed_by_neighbours(const Scan& scan) {
  Scan trial({scan.positions(), scan.normals(), {}});
  orient_by_neighbours(trial, false);
  const Facing facing = field::facing(trial);
  return facing.is_closed() && (facing.is_outward() || facing.is_inward());
}

InputError refusal(const ScanOptions& options, const std::string& sentence) {
  return InputError((options.name.empty() ? "" : options.name + ": ") + sentence);
}

/// The voxel that such a scan gets where nobody says how fine, the scan's unit.
double usual_voxel(const Scan& scan) {
  Eigen::AlignedBox3d box;
  for (const Vector3d& p : scan.positions()) box.extend(p);
  return box.sizes().maxCoeff() / default_grid(box.sizes(), median_nearest(scan));
}

/// scan      its normals agree with each other; nobody knows which of the two sides is outside
InputError one_side_only(const Scan& scan, const ScanOptions& options) {
  // Floats too coarse leave slices of an object, each of which looks like a sheet.
  const double rounded = float_step(scan.positions()) / usual_voxel(scan);
  if (rounded > kMostRoundedOfEstimated) return refusal(options, floats_too_coarse(rounded));
  const std::optional<CutPlane> end = cut_plane(scan, open_rim(scan));
  const bool may_be_table = end && end->is_flat();
  return refusal(options,
                 std::string("the points have no normals and show one side of an object only: ") +
                     (may_be_table ? "they end at the edge of a flat part; if that is a table or a wall, remove it, else " : "") +
                     "give the sensor's place with --viewpoint X Y Z, or scan all round; if several views were merged, save the scan with "
                     "outward normals" +
                     (options.sensor_doubt.empty() ? "" : "; " + options.sensor_doubt));
}

/// Do all normals look the same way, and leave the surface on which the points lie? Terraces seen from above have equal normals, too, but the nearest of
/// each point lies beside it.
bool are_placeholders(const Scan& scan) {
  const Vector3d& first = scan.normals().front();
  std::size_t equal = 0, off = 0;
  for (std::size_t i = 0; i < scan.size(); ++i) {
    equal += scan.normals()[i].dot(first) > kEqual ? 1U : 0U;
    const Vector3d step = scan.positions()[scan.around(i)[1].index] - scan.positions()[i];
    off += std::abs(step.dot(first)) > kSteep * step.norm() ? 1U : 0U;
  }
  const auto all = static_cast<double>(scan.size());
  return static_cast<double>(equal) > kNearlyAll * all && static_cast<double>(off) > kManyOff * all;
}

/// Gives the whole scan one outside.
Outside find_outside(Scan& scan, const ScanOptions& options, Facing& found) {
  if (options.viewpoint) {
    for (std::size_t i = 0; i < scan.size(); ++i) {
      if (scan.normals()[i].dot(*options.viewpoint - scan.positions()[i]) < 0.0) scan.turn_normal(i);
    }
    found = facing(scan);
    return Outside::kViewpoint;
  }
  found = facing(scan);
  const double contradicted = options.estimate ? 1.0 : contradictions(scan);
  const bool contradicts = contradicted > kContradictory;
  if (contradicts && !options.estimate) {
    // Two sides of a thin wall contradict each other rightly: the file knows more than neighbours do.
    const double behind = behind_each_other(scan);
    if (contradicted - std::abs(behind) < kContradictory && behind * found.outward > Facing::kClearVote * std::abs(behind)) {
      if (behind > 0.0) return Outside::kAsGiven;
      turn_all(scan);
      found = facing(scan);
      return Outside::kTurned;
    }
  }
  const bool sheet = found.one_sided > kSheet && !closed_by_neighbours(scan);
  const bool sure = found.outward > kSureVote && found.volume > -Facing::kClearVolume;  // an open thin wall encloses hardly anything
  if (!contradicts && (sheet || found.is_outward() || sure)) return Outside::kAsGiven;
  if (!contradicts && found.is_inward()) {
    turn_all(scan);
    found = facing(scan);
    return Outside::kTurned;
  }
  // Neighbours may know better; but only a clear answer is taken.
  OrientedPoints before{scan.positions(), scan.normals(), {}};
  const auto as_before = [&] {
    for (std::size_t i = 0; i < scan.size(); ++i) {
      if (scan.normals()[i].dot(before.normals[i]) < 0.0) scan.turn_normal(i);
    }
  };
  orient_by_neighbours(scan, contradicts && !options.estimate);  // whole sides that are turned outvote their few contradictions
  if (options.estimate) turn_lone_parts(scan, false);
  std::size_t turned = 0;
  for (std::size_t i = 0; i < scan.size(); ++i) turned += scan.normals()[i].dot(before.normals[i]) < 0.0 ? 1U : 0U;
  Facing after = facing(scan);
  if (after.is_inward() && after.one_sided < kSheet) {
    turn_all(scan);
    after = facing(scan);
  }
  const bool sheet_now = after.one_sided > kSheet;
  const bool agreed = contradictions(scan) < kContradictory;
  if (sheet_now && options.estimate) throw one_side_only(scan, options);
  if (agreed && (after.is_outward() || (sheet_now && 20 * turned < 9 * scan.size()))) {
    found = after;
    return turned == 0 ? Outside::kAsGiven : Outside::kNeighbours;
  }
  if (options.estimate) {
    found = after;
    return Outside::kDoubtful;
  }
  as_before();
  return Outside::kDoubtful;
}

/// Normals that the positions contradict, taken from the positions wherever these are smooth.
std::unique_ptr<Scan> with_normals_of_positions(const Scan& scan, double noise) {
  OrientedPoints points{scan.positions(), scan.normals(), scan.stiffness()};
  in_parallel(scan.size(), 64, [&](std::size_t begin, std::size_t end) {
    for (const std::uint32_t i : scan.together(begin, end)) {
      const QuadricFit fit = fit_quadric(scan.positions(), scan.around(i));
      if (fit.deviation > std::max(kRough * scan.spacing(i), 2.0 * noise)) continue;
      points.normals[i] = fit.normal.dot(scan.normals()[i]) < 0.0 ? Vector3d(-fit.normal) : fit.normal;
    }
  });
  return std::make_unique<Scan>(std::move(points));
}

/// How often a scan is smoothed.
std::size_t passes(double noise_spacing) { return noise_spacing < 0.02 ? 0 : noise_spacing < 0.1 ? 1 : noise_spacing < 0.2 ? 2 : 3; }

/// Moves every sample to where its neighbours expect it: their mean height over it, each measured on the circle through both places.
std::unique_ptr<Scan> smoothed(const Scan& scan, double noise) {
  OrientedPoints points{scan.positions(), scan.normals(), scan.stiffness()};
  in_parallel(scan.size(), 256, [&](std::size_t begin, std::size_t end) {
    for (const std::uint32_t i : scan.together(begin, end)) {
      const Vector3d &own = scan.positions()[i], &normal = scan.normals()[i];
      const auto around = scan.around(i);
      const double reach = around.back().squared_distance;
      double sum = 0.0, weights = 1.0;  // its own height is zero
      for (const Neighbour& n : around) {
        if (n.index == i) continue;
        const double alike = normal.dot(scan.normals()[n.index]);
        const double height = 0.5 * (normal + scan.normals()[n.index]).dot(scan.positions()[n.index] - own);
        if (alike < kSmooth || std::abs(height) > kOutlier * noise) continue;  // another face, or another sheet
        const double weight = 1.0 - 0.9 * n.squared_distance / reach;
        sum += weight * height;
        weights += weight;
      }
      points.positions[i] = own + sum / weights * normal;
    }
  });
  return std::make_unique<Scan>(std::move(points));
}

}  // namespace

SoundScan sound_scan(OrientedPoints points, const ScanOptions& options) {
  SoundScan result;
  result.is_estimated = options.estimate;
  const OrientedPoints given = points;
  if (options.estimate) points.normals = estimated_normals(points.positions);
  auto scan = std::make_unique<Scan>(std::move(points));
  const Sides sides = options.estimate ? Sides{connected(*scan)} : connected_sides(*scan);  // estimated normals have no side yet
  const std::vector<std::uint32_t>& samples = sides.samples;
  if (samples.size() < kFewestPoints) throw refusal(options, "hardly any of its points lies beside others on a surface; scan more densely");
  if (!options.estimate && are_placeholders(*scan))
    throw refusal(options, "all normals are equal, so they are placeholders; use --normals estimate");
  result.sparse = sides.sparse;
  if (options.estimate) result.unknown_side = unknown_side(*scan, samples);
  result.strays = scan->size() - samples.size();
  if (result.strays > 0) {
    scan = kept(*scan, samples);
    result.strays_among = in_box_of(*scan, given.positions) - scan->size();
    if (options.estimate) {
      OrientedPoints again{scan->positions(), estimated_normals(scan->positions()), scan->stiffness()};
      scan = std::make_unique<Scan>(std::move(again));
    }
  }
  Facing facing;
  result.outside = find_outside(*scan, options, facing);
  result.sensor_from = options.from;
  if (options.viewpoint) result.hidden = hidden_share(*scan, *options.viewpoint);
  std::size_t turned = options.estimate ? 0 : turn_outvoted(*scan);
  std::vector<std::uint32_t> alone;
  // What a person said about the sensor, or what nobody knows, is left as it is.
  const bool knows_side = result.outside != Outside::kViewpoint && result.outside != Outside::kDoubtful;
  if (!options.estimate && knows_side) {
    turned += turn_patches(*scan);
    alone = turn_lone_parts(*scan, true);
    turned += alone.size();
  }
  bool as_faced = turned == 0;
  // As they were, they may have made a sheet of what is none. A few strays do so, too, or the reverse: each stands for a large area.
  if (knows_side && facing.one_sided > kSheet && static_cast<double>(turned) > kManyTurned * static_cast<double>(scan->size()) &&
      field::facing(*scan).one_sided <= kSheet) {
    result.outside = find_outside(*scan, options, facing);
  }
  if (!options.estimate) {
    const auto is_turned = [&](std::uint32_t i) { return scan->normals()[i].dot(given.normals[samples[i]]) < 0.0; };
    for (std::uint32_t i = 0; i < samples.size(); ++i) {
      if (is_turned(i)) result.turned.push_back(i);
    }
    result.inside_out = static_cast<std::size_t>(std::count_if(alone.begin(), alone.end(), is_turned));
  }
  result.one_sided = facing.one_sided;
  result.contradicted = contradictions(*scan);
  result.rounding = rounding_step(scan->positions());
  result.coarsest = coarsest_axis(scan->positions());
  result.float_step = float_step(scan->positions());
  result.spacing = median_nearest(*scan);
  const Roughness rough = roughness(*scan, result.spacing);
  result.noise = rough.noise();
  result.tilt = rough.tilt;
  if (options.estimate) {
    result.layered = rough.layered;
    result.in_lines = share_in_lines(*scan);
  }
  if (!options.estimate && rough.of_normals > kNoisyNormals) {
    scan = std::make_unique<Scan>(OrientedPoints{scan->positions(), filtered_normals(*scan, rough.of_normals), scan->stiffness()});
    as_faced = false;
  }
  if (!options.estimate && rough.tilt > kTilted && rough.of_pairs > kContradicted * rough.of_positions) {
    scan = with_normals_of_positions(*scan, result.noise);
    as_faced = false;
  }
  for (std::size_t pass = 0; rough.is_noise() && pass < passes(result.noise / result.spacing); ++pass) {
    scan = smoothed(*scan, result.noise);
    result.smoothed = true;
    as_faced = false;
  }
  result.rim = open_rim(*scan);
  result.measured = scan->size();
  result.points = {scan->positions(), scan->normals(), scan->stiffness()};
  result.is_sheet = facing.one_sided > kSheet && result.outside != Outside::kDoubtful;
  result.enclosed = as_faced ? facing.enclosed : field::facing(*scan).enclosed;  // by the normals as they are now
  const std::optional<CutPlane> cut = cut_plane(*scan, result.rim);
  result.is_on_table = cut && cut->is_table();
  if (result.is_sheet) {
    result.points.append(sheet_back(*scan, line_of_sight(*scan, facing.front, options.viewpoint)));
    return result;
  }
  if (cut && cut->is_cut()) {
    OrientedPoints with_cap = result.points;
    with_cap.append(plane_cap(*scan, *cut));
    const Facing open = field::facing(*scan), closed = field::facing(Scan(with_cap));
    result.is_capped = open.area > (1.0 - kMostCapped) * closed.area;
    if (result.is_capped) {
      result.points = std::move(with_cap);
      result.rim.least_surrounded = cut->least_surrounded;
      result.rim.least_place = cut->least_place;
      result.enclosed = closed.enclosed;
    }
  }
  return result;
}

void SoundScan::place(const cloud::Placement& placement) {
  points = cloud::placed(points, placement);
  noise *= placement.scale;
  rim.length *= placement.scale;
  rim.longest *= placement.scale;
  rim.place = placement.to_workspace(rim.place);
  for (RimPlace& place : rim.along) place.length *= placement.scale;
  for (auto& link : rim.links) link = {placement.to_workspace(link[0]), placement.to_workspace(link[1])};
  spacing *= placement.scale;
  rounding *= placement.scale;
  coarsest.step *= placement.scale;
  float_step *= placement.scale;
  enclosed *= placement.scale * placement.scale * placement.scale;
}

void SoundScan::drop_invented() {
  points.positions.resize(measured);
  points.normals.resize(measured);
  if (!points.stiffness.empty()) points.stiffness.resize(measured);
}

std::vector<std::string> SoundScan::warnings() const {
  const auto times = [](std::size_t count, const char* one, const char* many) {
    return std::to_string(count) + ' ' + (count == 1 ? one : many);
  };
  std::vector<std::string> list;
  if (strays > 0)
    list.push_back(times(strays, "point", "points") + " far from the others, or beside a surface without belonging to it, left out");
  if (inside_out > 0)
    list.push_back(times(inside_out, "normal", "normals") + " of closed parts that hang on nothing pointed inwards and were turned");
  const std::size_t others = turned.size() - inside_out;
  switch (outside) {
    case Outside::kAsGiven:
      if (others > 0) list.push_back(times(others, "normal was", "normals were") + " turned because the neighbours contradict");
      break;
    case Outside::kViewpoint: break;
    case Outside::kTurned:
      list.push_back(std::string("the normals of a closed surface pointed inwards; ") + (turned.size() == measured ? "all" : "most") +
                     " were turned");
      break;
    case Outside::kNeighbours:
      if (others > 0)  // estimated normals had no side before
        list.push_back("the normals contradicted each other: " + times(others, "was", "were") + " turned so that neighbours agree");
      break;
    case Outside::kDoubtful:
      list.push_back(std::string("the normals do not agree on which side is outside, and neighbours do not decide it; ") +
                     (turned.empty() ? "they" : "all but " + std::to_string(turned.size())) + " are used as they are");
      break;
  }
  if (is_sheet) {
    list.push_back(std::string("only one side was scanned: the field closes it with walls and a back that nobody scanned") +
                   (is_on_table ? "; it ends at the edge of a flat part: if that is a table or a wall, remove it" : ""));
  }
  if (rim.samples > 0) {
    const auto rounded = [](double mm) { return std::to_string(std::lround(mm)); };
    list.push_back("the scan is open: its rims are about " + rounded(rim.length) + " mm long together, the longest round (" +
                   rounded(rim.place.x()) + ", " + rounded(rim.place.y()) + ", " + rounded(rim.place.z()) + ") mm in the workspace" +
                   (is_sheet    ? ""
                    : is_capped ? "; the field ends there in a plane that was not scanned"
                                : "; the field closes them with surface that was not scanned"));
  }
  return list;
}

}  // namespace isotouch::field
