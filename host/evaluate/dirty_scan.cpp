#include "host/evaluate/dirty_scan.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <utility>

#include "host/cloud/check.h"
#include "host/cloud/random.h"
#include "host/encoding/write_image.h"
#include "host/error.h"
#include "host/evaluate/compare_mesh.h"
#include "host/evaluate/damage.h"
#include "host/evaluate/surface_error.h"
#include "host/evaluate/zero_surface.h"
#include "host/field/nearest.h"
#include "host/field/scan_field.h"
#include "host/field_file/open_field.h"
#include "host/motion/felt_surface.h"

namespace isotouch::evaluate {

namespace {

using cloud::OrientedPoints;
using cloud::Random;
using Eigen::Vector3d;

constexpr double kVoxel = 0.34;  // mm; a shape's unit is a voxel
constexpr std::size_t kDense = 100'000;
constexpr std::size_t kTruths = 10'000;
constexpr double kOff = 2.0;             // voxels from the surface, where sides are asked
constexpr double kLost = kSearchVoxels;  // what a place without a crossing counts
constexpr double kClear = 1.0;           // voxels: nearer to the true surface, to first order, no side is asked
constexpr std::size_t kSpaced = 7;       // a point and its six neighbours: the farthest says how far apart points are there
constexpr double kMostWrongSide = 0.01;
constexpr double kMostVolume = 0.05;
const Vector3d kEye = Vector3d(2, 3, 6) / 7;

/// Does the body hide this place of its surface from the eye?
bool hidden(const cloud::Shape& shape, const Vector3d& place, const Vector3d& normal) {
  if (normal.dot(kEye) < 0.1) return true;
  const double far = (shape.high - shape.low).norm();
  Vector3d at = place + 0.5 * normal;
  for (double way = 0.0; way < far;) {
    const double step = shape.distance(at + way * kEye);
    if (step < 0.01) return true;
    way += std::max(step, 0.05);
  }
  return false;
}

OrientedPoints seen(const DirtyScan& scan, const OrientedPoints& points) {
  if (!scan.one_sided) return points;
  OrientedPoints result;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (hidden(scan.shape, points.positions[i], points.normals[i])) continue;
    result.positions.push_back(points.positions[i]);
    result.normals.push_back(points.normals[i]);
  }
  return result;
}

struct Dirtied {
  OrientedPoints points;
  std::size_t own;  ///< the first so many are of the object, the others strays
};

Dirtied dirtied(const OrientedPoints& clean, const Dirt& dirt, std::uint64_t seed) {
  const double spacing = cloud::median_spacing(clean.positions);
  OrientedPoints points = clean;
  Random random(seed);
  const Vector3d diagonal = Vector3d(1, 2, 3).normalized();
  const auto along = [&](const Vector3d& p) { return diagonal.dot(p); };
  if (dirt.thinned < 1 || dirt.hole > 0) {
    Vector3d top = clean.positions[0];
    double middle = 0.0;
    for (const Vector3d& p : clean.positions) {
      if (along(p) > along(top)) top = p;
      middle += p.x() / static_cast<double>(clean.size());
    }
    points = {};
    for (std::size_t i = 0; i < clean.size(); ++i) {
      const Vector3d& p = clean.positions[i];
      if (dirt.hole > 0 && (p - top).norm() < dirt.hole * spacing) continue;
      if (dirt.thinned < 1 && p.x() > middle && random.uniform() > dirt.thinned) continue;
      points.positions.push_back(p);
      points.normals.push_back(clean.normals[i]);
    }
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    Vector3d& normal = points.normals[i];
    if (dirt.layer > 0) points.positions[i] += (random.uniform() < 0.5 ? 0.5 : -0.5) * dirt.layer * spacing * normal;
    if (dirt.tilt_deg > 0) {
      const double size = dirt.tilt_deg / 57.29577951308232;
      const Vector3d u = normal.unitOrthogonal();
      normal = (normal + size * random.gaussian() * u + size * random.gaussian() * normal.cross(u)).normalized();
    }
  }
  return {damaged(points, {"", dirt.noise, dirt.strays, dirt.flipped}, seed + 7), points.size()};
}

/// How fast a shape's function changes at a place, across its surface: as a distance, or less where it is none. The larger of both sides, because
/// between two surfaces it grows towards both.
double slope_at(const cloud::Shape& shape, const Vector3d& place, double distance) {
  if (shape.exact_distance) return 1.0;
  constexpr double kStep = 0.01;  // voxels
  const Vector3d step = kStep * shape.normal(place);
  return std::max(std::abs(shape.distance(place + step) - distance), std::abs(shape.distance(place - step) - distance)) / kStep;
}

/// Of places beside the scanned part of the surface: no farther from a point than this point's neighbours are.
double wrong_side(const motion::FeltSurface& felt, const cloud::Shape& shape, const OrientedPoints& truth,
                  const std::vector<Vector3d>& measured) {
  const field::Nearest scan(measured);
  std::vector<field::Neighbour> found;
  std::size_t asked = 0, wrong = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    scan.nearest(truth.positions[i], 1, found);
    const double away = found[0].squared_distance;
    scan.nearest(measured[found[0].index], kSpaced, found);
    if (away > found.back().squared_distance) continue;
    for (const double off : {-kOff, kOff}) {
      const Vector3d place = truth.positions[i] + off * truth.normals[i];
      const double distance = shape.distance(place);
      if (std::abs(distance) < kClear * slope_at(shape, place, distance)) continue;
      ++asked;
      wrong += (felt.sample(kVoxel * place).distance < 0) != (distance < 0) ? 1U : 0U;
    }
  }
  return asked > 0 ? static_cast<double>(wrong) / static_cast<double>(asked) : 0.0;
}

/// What a scan is of, and how it is measured.
struct Subject {
  const DirtyScan& scan;
  OrientedPoints truth;
  double volume;
};

/// Measures a field, ours or another's.
void measure(const Subject& subject, const field_file::OpenField& open, const Dirtied& dirtied, DirtySurface& result) {
  const cloud::Shape& shape = subject.scan.shape;
  OrientedPoints in_workspace = subject.truth;
  for (Vector3d& p : in_workspace.positions) p *= kVoxel;
  const SurfaceError error = crossings_near(open.view, in_workspace);
  result.surface_rms =
      std::sqrt((error.rms_voxel * error.rms_voxel * static_cast<double>(error.points) + kLost * kLost * static_cast<double>(error.lost)) /
                static_cast<double>(subject.truth.size()));
  const auto first = dirtied.points.positions.begin();
  result.wrong_side =
      wrong_side(motion::FeltSurface(open.view), shape, subject.truth, {first, first + static_cast<std::ptrdiff_t>(dirtied.own)});
  const cloud::TriangleMesh surface = zero_surface(open.view);
  const std::vector<Piece> parts = pieces(surface);
  result.pieces = parts.size();
  if (subject.scan.one_sided) return;
  double squares = 0.0;
  for (const Vector3d& vertex : surface.vertices) {
    const double d = shape.distance(vertex / kVoxel);
    squares += d * d;
  }
  result.truth_rms = surface.vertices.empty() ? kLost : std::sqrt(squares / static_cast<double>(surface.vertices.size()));
  result.volume = evaluate::volume(parts) / (subject.volume * kVoxel * kVoxel * kVoxel);
}

DirtySurface measured_beside(const Subject& subject, const Dirtied& dirtied, const Reconstruct& reconstruct) {
  DirtySurface result;
  std::optional<field_file::OpenField> open;
  try {
    cloud::TriangleMesh mesh = reconstruct(dirtied.points);
    for (Vector3d& vertex : mesh.vertices) vertex *= kVoxel;
    open = field_of_mesh(mesh, kVoxel, field::kBand, Interpolation::kSpline);
  } catch (const InputError& error) {
    result.refused = error.what();
  }
  if (open) measure(subject, *open, dirtied, result);
  return result;
}

DirtyRow measured(const Subject& subject, const Dirtied& dirtied, const Dirt& dirt, const Reconstruct& beside) {
  const DirtyScan& scan = subject.scan;
  DirtyRow row;
  row.scan = scan.name();
  row.dirt = dirt.name;
  field::Progress progress;
  OrientedPoints placed = dirtied.points;
  for (Vector3d& p : placed.positions) p *= kVoxel;
  if (dirt.no_normals) placed.normals.assign(placed.size(), Vector3d::UnitZ());
  field::ScanOptions options{dirt.no_normals, std::nullopt};
  if (dirt.no_normals && scan.one_sided) options.viewpoint = 1000.0 * kEye;
  std::optional<field_file::OpenField> open;
  try {
    const field::SoundScan sound = field::sound_scan(std::move(placed), options);
    const field::ScanField built = field::scan_field(sound, kVoxel, field::kBand, progress);
    row.verdict = built.verdict;
    open = field_file::open_field(encoding::write_image(built.field, {}), row.scan);
  } catch (const InputError& error) {
    row.refused = error.what();
  }
  if (open) measure(subject, *open, dirtied, row);
  if (beside && !dirt.no_normals) row.beside = measured_beside(subject, dirtied, beside);
  return row;
}

std::string per_cent(double share) {
  char text[32];
  std::snprintf(text, sizeof text, "%.0f %%", 100.0 * share);
  return text;
}

}  // namespace

bool DirtySurface::wrong() const {
  return surface_rms >= kLost || wrong_side > kMostWrongSide || (volume && std::abs(*volume - 1.0) > kMostVolume);
}

double true_volume(const cloud::Shape& shape) {
  if (shape.volume) return *shape.volume;
  constexpr std::size_t kFewest = 1'000'000, kMost = 10'000'000, kInside = 100'000;
  Random random(4);
  std::size_t drawn = 0, inside = 0;
  for (; drawn < kFewest || (inside < kInside && drawn < kMost); ++drawn) {
    Vector3d place;
    for (int axis = 0; axis < 3; ++axis) place[axis] = random.uniform(shape.low[axis], shape.high[axis]);
    inside += shape.distance(place) < 0.0 ? 1U : 0U;
  }
  return static_cast<double>(inside) / static_cast<double>(drawn) * (shape.high - shape.low).prod();
}

void Tally::count(const DirtyRow& row) {
  if (!row.beside || !row.refused.empty() || !row.beside->refused.empty()) return;
  ++both;
  surface += row.surface_rms < row.beside->surface_rms ? 1U : 0U;
  if (!row.truth_rms || !row.beside->truth_rms) return;
  ++both_whole;
  truth += *row.truth_rms < *row.beside->truth_rms ? 1U : 0U;
}

std::vector<Dirt> all_dirt() {
  std::vector<Dirt> all = {{.name = "clean"}};
  for (const double share : {0.01, 0.02, 0.05, 0.1, 0.2}) all.push_back({.name = "strays " + per_cent(share), .strays = share});
  for (const bool dense : {false, true}) {
    for (const double noise : {0.01, 0.05, 0.1, 0.25, 0.5}) {
      all.push_back({.name = (dense ? "dense, noise " : "noise ") + per_cent(noise), .noise = noise, .dense = dense});
    }
  }
  for (const int degrees : {5, 15, 30})
    all.push_back({.name = "tilt " + std::to_string(degrees) + "°", .tilt_deg = static_cast<double>(degrees)});
  for (const double share : {0.06, 0.2, 0.4}) all.push_back({.name = "flipped " + per_cent(share), .flipped = share});
  all.push_back({.name = "half thinned", .thinned = 0.3});
  for (const double layer : {0.3, 1.0}) all.push_back({.name = "layers " + std::to_string(layer).substr(0, 3), .layer = layer});
  for (const int hole : {2, 5, 10, 20}) all.push_back({.name = "hole " + std::to_string(hole), .hole = static_cast<double>(hole)});
  all.push_back({.name = "no normals", .no_normals = true});
  return all;
}

std::vector<DirtyScan> dirty_scans(std::vector<cloud::Shape> bodies) {
  if (bodies.empty()) {
    for (const std::string& name : cloud::shape_names()) bodies.push_back(cloud::shape(name));
  }
  std::vector<DirtyScan> scans;
  for (const bool one_sided : {false, true}) {
    for (const cloud::Shape& body : bodies) scans.push_back({body, one_sided});
  }
  return scans;
}

void dirty_rows(const DirtyScan& scan, std::span<const Dirt> dirt, const std::function<void(const DirtyRow&)>& show,
                const Reconstruct& beside, std::uint64_t seed) {
  if (dirt.empty()) return;
  const std::size_t factor = scan.one_sided ? 2 : 1;
  const OrientedPoints sparse = seen(scan, cloud::sample_shape(scan.shape, factor * scan.shape.default_points, seed));
  OrientedPoints dense;
  const Subject subject{scan, seen(scan, cloud::scatter_on_shape(scan.shape, factor * kTruths, seed + 1'000'000)),
                        scan.one_sided ? 1.0 : true_volume(scan.shape)};
  for (const Dirt& kind : dirt) {
    if (kind.dense && dense.size() == 0) dense = seen(scan, cloud::scatter_on_shape(scan.shape, factor * kDense, seed + 2'000'000));
    show(measured(subject, dirtied(kind.dense ? dense : sparse, kind, seed + 3'000'000), kind, beside));
  }
}

}  // namespace isotouch::evaluate
