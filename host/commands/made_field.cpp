#include "host/commands/made_field.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "host/cloud/mesh.h"
#include "host/cloud/read_cloud.h"
#include "host/cloud/read_mesh.h"
#include "host/commands/progress_bar.h"
#include "host/error.h"
#include "host/field/brick_stiffness.h"
#include "host/field/closed_mesh.h"
#include "host/field/default_grid.h"
#include "host/field/make_grid.h"
#include "host/field/mesh_distance.h"
#include "host/field/mesh_field.h"
#include "host/field/nearest.h"
#include "host/field/scan_field.h"
#include "host/field/scan_voxel.h"
#include "host/files/whole_file.h"
#include "host/live/face_sensor.h"
#include "host/live/live_field.h"
#include "host/live/space.h"
#include "host/published/build.h"
#include "host/vdb/level_set.h"
#include "host/vdb/level_set_field.h"

namespace isotouch::commands {

namespace {

cloud::PlacementOptions placement_options(const BuildOptions& options) {
  cloud::PlacementOptions size{std::nullopt, options.fit_mm};
  if (!options.units.empty()) size.mm_per_unit = cloud::mm_per_unit(options.units);
  return size;
}

cloud::Placement placement(const BuildOptions& options, std::span<const Eigen::Vector3d> positions) {
  return cloud::place(positions, placement_options(options));
}

Eigen::AlignedBox3d box_of(std::span<const Eigen::Vector3d> positions) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& position : positions) box.extend(position);
  return box;
}

/// The grid round placed positions.
field::Grid grid_round(double edge, std::span<const Eigen::Vector3d> positions, double margin) {
  const Eigen::AlignedBox3d box = box_of(positions);
  return field::make_grid(box.min(), box.max(), edge, margin);
}
field::Grid grid_round(const BuildOptions& options, std::span<const Eigen::Vector3d> positions, double margin) {
  const Eigen::Vector3d sides = box_of(positions).sizes();
  return grid_round(options.voxel_mm.value_or(sides.maxCoeff() / options.grid.value_or(field::default_grid(sides, 0))), positions, margin);
}

/// fails     UsageError when a method of points was asked for something else
void require_default_method(const BuildOptions& options, const char* what) {
  if (options.method != BuildMethod::kDefault) {
    throw UsageError(options.input.string() + ": the " + (options.method == BuildMethod::kLive ? "live" : "published") +
                     " method works on points with normals, this is " + what + "; leave --method out");
  }
}

/// fails     UsageError when something is said about normals, which what is no cloud does not need
void require_no_normals(const BuildOptions& options, const char* what) {
  const auto refuse = [&](const char* option) {
    throw UsageError(options.input.string() + ": " + option + " is for the normals of points, this is " + what + "; leave it out");
  };
  if (options.estimate_normals) refuse("--normals");
  if (options.sensor.viewpoint) refuse("--viewpoint");
  if (options.sensor.ignores_viewpoint) refuse("--no-viewpoint");
}

/// Says where the file, and not the person, puts the sensor.
std::string sensor_sentence(const Eigen::Vector3d& place, const cloud::CloudReport& read) {
  if (read.sensor.is_assumed) {
    return (read.sensor.refuted_place
                ? "the image was not seen from the file's own place of the sensor, " + cloud::in_brackets(*read.sensor.refuted_place)
                : std::string("the file does not say where the sensor stood")) +
           ", so its camera is taken to stand at " + cloud::in_brackets(place) + "; --viewpoint names another place";
  }
  return "the sensor's place is the file's own, " + cloud::in_brackets(place) +
         "; --viewpoint names another one, and --no-viewpoint ignores it" +
         (read.sensor.is_turned && !read.edges
              ? ". The file says, too, that the sensor was turned: if its points are in the sensor's own frame, give --viewpoint 0 0 0"
              : "");
}

/// Leaves the points outside out. Stiffness of points is not kept in step: a live field has none.
///
/// returns   how many are left
std::size_t keep_within(const Eigen::AlignedBox3d& box, cloud::OrientedPoints& points, std::vector<std::string>& warnings) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!box.contains(points.positions[i])) continue;
    points.positions[kept] = points.positions[i];
    points.normals[kept++] = points.normals[i];
  }
  if (kept < points.size()) warnings.push_back(std::to_string(points.size() - kept) + " points lie outside the box and were left out");
  points.positions.resize(kept);
  points.normals.resize(kept);
  return kept;
}

/// How many faces the file of a cloud has, if they form a closed surface.
std::size_t closed_faces(const cloud::SourceFile& source, std::size_t faces) {
  if (faces == 0) return 0;
  try {
    cloud::MeshReport read;
    field::MeshRepair repair;
    (void)field::closed_mesh(cloud::read_mesh(source, read), source.name(), repair);
    return repair.holes == 0 ? faces : 0;
  } catch (const InputError&) {
    return 0;
  }
}

/// A live field takes the points as they are: whatever a whole scan would say of one of them is not known while it is scanned.
Made from_live_points(const cloud::SourceFile& source, const BuildOptions& options, BuildReport& report, field::Progress& progress) {
  cloud::CloudReport read;
  cloud::OrientedPoints points = cloud::read_cloud(source, read);
  report.closed_faces = closed_faces(source, read.unused_faces);
  if (options.estimate_normals.value_or(false) || !read.has_normals) {
    throw InputError(options.input.string() +
                     (read.has_normals ? ": the live method estimates no normals, it takes those of the file; leave --normals estimate out"
                                       : ": its points have no normals, which the live method takes as they are; leave --method out"));
  }
  progress.begin("live");
  live::face_sensor({options.sensor.viewpoint, read.sensor.place, read.edges.has_value()}, points.positions, points.normals);
  report.format = read.format;
  report.points = read.points;
  report.warnings = read.warnings();
  if (!points.stiffness.empty())
    report.warnings.emplace_back("the live method has one stiffness for all, those of the points are left out");
  if (options.box) report.points = keep_within(*options.box, points, report.warnings);
  const double band = options.band_voxels();
  const live::Space space = live::space_for(options.box.value_or(box_of(points.positions)),
                                            {placement_options(options), false, options.voxel_mm, options.grid, band});
  report.placement = space.placement;
  for (Eigen::Vector3d& position : points.positions) position = report.placement.to_workspace(position);
  encoding::FieldInfo info;
  info.stiffness_n_per_mm = options.stiffness.value_or(info.stiffness_n_per_mm);
  info.placement = report.placement;
  live::LiveField field(space.grid, band, info);
  live::Batch batch;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (const auto point = live::point_in(space.grid, points.positions[i], points.normals[i])) batch.added.push_back(*point);
  }
  field.apply(batch);
  report.live_verdict = field.verdict();
  report.source_hash = field.source_hash();
  Made made;
  made.live = field_file::open_field(field.image(), options.input.string());
  made.live_points = std::move(points);
  progress.end();
  return made;
}

Made from_cloud(const cloud::SourceFile& source, const BuildOptions& options, BuildReport& report, field::Progress& progress) {
  cloud::CloudReport read;
  cloud::OrientedPoints points = cloud::read_cloud(source, read, options.estimate_normals.value_or(false));
  report.closed_faces = closed_faces(source, read.unused_faces);
  progress.begin("outside");
  field::ScanOptions how{options.estimate_normals.value_or(!read.has_normals), options.sensor.viewpoint};
  how.sensor_doubt = read.sensor_doubt();
  how.name = options.input.string();
  const bool is_own_camera = options.sensor.camera && (!how.viewpoint || how.viewpoint->isZero());
  how.from = is_own_camera            ? field::SensorFrom::kDepthImage
             : how.viewpoint          ? field::SensorFrom::kPerson
             : read.sensor.is_assumed ? field::SensorFrom::kAssumption
                                      : field::SensorFrom::kFile;
  if (!how.viewpoint && (how.estimate || read.edges)) how.viewpoint = read.sensor.place;
  if (!how.viewpoint && how.estimate && is_own_camera) how.viewpoint = Eigen::Vector3d::Zero();  // also with --no-viewpoint
  if (!how.estimate && !read.has_normals)
    throw InputError(options.input.string() + ": its points have no normals; leave --normals file out");
  field::SoundScan sound = field::sound_scan(std::move(points), how);
  progress.end();
  const std::span measured(sound.points.positions.data(), sound.measured);
  report.placement = placement(options, measured);
  report.format = read.format;
  report.source_hash = read.source_hash;
  report.points = read.points;
  report.warnings = read.warnings(!how.estimate);
  if (how.estimate) report.warnings.emplace_back("normals were estimated from the points");
  if (how.viewpoint && !options.sensor.viewpoint && !is_own_camera) report.warnings.push_back(sensor_sentence(*how.viewpoint, read));
  const Eigen::Vector3d sides = box_of(measured).sizes();
  const int usual = options.method == BuildMethod::kDefault ? sound.usual_grid(sides) : field::kCoarseGrid;
  const auto [edge, too_fine] = field::scan_voxel(sound, sides, report.placement.scale, {options.voxel_mm, options.grid}, usual);
  if (!too_fine.empty()) report.warnings.push_back(too_fine);
  sound.place(report.placement);
  for (const std::string& warning : sound.warnings()) report.warnings.push_back(warning);

  if (options.method == BuildMethod::kPublished) {
    sound.drop_invented();
    const published::Built built = published::build(sound.points, grid_round(edge, sound.points.positions, published::kMargin), progress);
    Made made{published::to_band_field(built.levels), built.inside_nodes, std::move(sound)};
    const cloud::OrientedPoints& placed = made.scan->points;
    if (!placed.stiffness.empty()) {
      std::vector<Eigen::Vector3d> places;
      for (const Eigen::Vector3d& p : placed.positions) places.push_back(made.field.grid.to_index(p));
      made.field.stiffness = field::brick_stiffness(made.field.bricks, placed.stiffness, field::Nearest(places));
    }
    return made;
  }
  field::BuiltScan built = field::built_scan(sound, edge, options.band_voxels(), progress);
  for (const std::string& warning : built.repair.warnings()) report.warnings.push_back(warning);
  return {std::move(built.field), std::nullopt, std::move(sound), built.repair};
}

Made from_mesh(const cloud::SourceFile& source, const BuildOptions& options, BuildReport& report, field::Progress& progress) {
  require_default_method(options, "a mesh");
  require_no_normals(options, "a mesh");
  cloud::MeshReport read;
  const cloud::TriangleMesh file = [&] {
    try {
      return cloud::read_mesh(source, read);
    } catch (const cloud::NoFaces&) {
      if (options.as != SourceKind::kMesh) throw;
      throw cloud::NoFaces(source.name(), "leave out --as mesh");
    }
  }();
  progress.begin("check");
  field::MeshRepair repair;
  const cloud::TriangleMesh in_file = field::closed_mesh(file, options.input.string(), repair);
  if (!options.as && repair.holes > 0 && !read.format.starts_with("STL")) {  // more likely a scan with some faces than a body
    throw InputError(
        options.input.string() + ": its " + std::to_string(file.vertices.size()) +
        " points have no normals, and its faces are not closed; use --as cloud to have normals estimated from the points, or --as mesh to "
        "have the holes closed");
  }
  report.placement = placement(options, in_file.vertices);
  report.format = read.format;
  report.source_hash = read.source_hash;
  report.points = file.vertices.size();

  progress.begin("tree");
  const field::MeshDistance distance(cloud::placed(in_file, report.placement));
  repair.crossing = distance.crossings().faces;
  repair.coarse = distance.coarse_parts();
  repair.cross = report.placement.to_cloud(distance.crossings().first);
  report.warnings = repair.warnings();
  progress.begin("bricks");
  const double band = options.band_voxels();
  Made made{field::mesh_field(distance, grid_round(options, distance.mesh().vertices, field::mesh_margin(band)), band)};
  made.mesh = distance.mesh();
  progress.end();
  return made;
}

/// The band that a level set is known in: as asked for, or the usual one where there are as many.
double band_within(const BuildOptions& options, double known) {
  known = std::min(known, 7.99);
  if (known < 1.0 || options.band.value_or(1.0) > known) {
    throw InputError(options.input.string() + ": the level set has distances only " + std::to_string(known) +
                     " of these voxels to each side of its surface, but " + (known < 1.0 ? "at least 1 is" : "more are") +
                     " needed; choose a smaller --band or --voxel, or make its band wider");
  }
  return options.band.value_or(std::min(field::kBand, known));
}

Made from_level_set(std::span<const std::uint8_t> bytes, const BuildOptions& options, BuildReport& report, field::Progress& progress) {
  require_default_method(options, "a level set");
  require_no_normals(options, "a level set");
  if (options.sensor.camera)
    throw UsageError(options.input.string() + ": --intrinsics describes a depth camera, this is a level set; leave it out");
  const vdb::LevelSet set = vdb::LevelSet::read(options.input, bytes, options.grid_name);
  report.placement = placement(options, set.crossings);
  report.format = set.format;
  report.source_hash = set.source_hash;
  report.points = set.active_voxels;
  report.warnings = set.warnings;
  progress.begin("bricks");
  Made made;
  if (set.samples && !options.voxel_mm && !options.grid) {
    made.field = vdb::own_field(set, report.placement, band_within(options, set.half_width));
  } else {
    BuildOptions own = options;  // turned axes alone: voxels of the same size
    if (!options.voxel_mm && !options.grid) own.voxel_mm = report.placement.scale * set.edge;
    std::vector<Eigen::Vector3d> surface = set.crossings;
    for (Eigen::Vector3d& place : surface) place = report.placement.to_workspace(place);
    const vdb::Interpolation interpolation(set);
    field::Grid grid = grid_round(own, surface, 0);
    const double band = band_within(options, vdb::known_band(interpolation, set, report.placement, grid.edge));
    grid = grid_round(own, surface, field::mesh_margin(band));
    made.field = vdb::resampled_field(interpolation, set, report.placement, grid, band);
  }
  progress.end();
  return made;
}

}  // namespace

std::vector<PlannedStage> plan_for(SourceKind kind, BuildMethod method) {
  switch (kind) {
    case SourceKind::kCloud: break;
    case SourceKind::kMesh:
      return {{"read", 0.1}, {"check", 0.2}, {"tree", 0.3}, {"bricks", 2}, {"image", 0.4}, {"pack", 0.1}, {"write", 0.02}};
    case SourceKind::kLevelSet: return {{"read", 0.5}, {"bricks", 0.5}, {"image", 0.4}, {"pack", 0.1}, {"write", 0.02}};
  }
  if (method == BuildMethod::kLive) return {{"read", 0.1}, {"live", 1}, {"pack", 0.1}, {"write", 0.02}};
  if (method == BuildMethod::kPublished)
    return {{"read", 0.1}, {"outside", 1}, {"radii", 0.1}, {"indicator", 6}, {"levels", 3}, {"image", 0.4}, {"pack", 0.1}, {"write", 0.02}};
  return {{"read", 0.1},  {"outside", 1},   {"local models", 2}, {"surface", 0.3}, {"bricks", 1},
          {"image", 0.5}, {"verdict", 0.1}, {"pack", 0.1},       {"write", 0.02}};
}

std::string better_as_mesh(const BuildReport& report) {
  if (report.closed_faces == 0) return {};
  return "its " + std::to_string(report.closed_faces) + " faces form a closed surface and were not used; take them with --as mesh";
}

Made make_field(const BuildOptions& options, BuildReport& report, ProgressBar& bar, field::Progress& progress) {
  progress.begin("read");
  std::vector<std::uint8_t> bytes = read_file(options.input);
  const bool is_level_set = options.as ? *options.as == SourceKind::kLevelSet : vdb::is_vdb_file(options.input, bytes);
  if (is_level_set) {
    report.kind = SourceKind::kLevelSet;
    bar.plan(plan_for(report.kind, options.method));
    return from_level_set(bytes, options, report, progress);
  }
  if (!options.grid_name.empty()) {
    throw UsageError(options.input.string() + ": --grid-name names a grid of an OpenVDB file, this is none; leave it out");
  }
  const cloud::SourceFile source(options.input, std::move(bytes), options.sensor);
  report.kind = options.as ? *options.as : source.is_mesh() ? SourceKind::kMesh : SourceKind::kCloud;
  bar.plan(plan_for(report.kind, options.method));
  if (report.kind == SourceKind::kMesh) return from_mesh(source, options, report, progress);
  try {
    return options.method == BuildMethod::kLive ? from_live_points(source, options, report, progress)
                                                : from_cloud(source, options, report, progress);
  } catch (const InputError& refused) {
    const std::string better = better_as_mesh(report);
    if (better.empty()) throw;
    throw InputError(source.name() + ": " + better + "; as a cloud: " + refused.what());
  }
}

}  // namespace isotouch::commands
