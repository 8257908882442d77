/// Points → field by the stages of `isotouch build`. The field enters through the other library's door, like any other.
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "host/build_library/isotouch_build.h"
#include "host/cloud/check.h"
#include "host/cloud/computable.h"
#include "host/cloud/model.h"
#include "host/cloud/placement.h"
#include "host/encoding/inside_samples.h"
#include "host/encoding/write_image.h"
#include "host/field/parallel.h"
#include "host/field/scan_field.h"
#include "host/field/scan_voxel.h"
#include "host/field/sound_scan.h"
#include "host/field_file/packed.h"
#include "host/library/call.h"
#include "shared/hash64.h"

using namespace isotouch;
using namespace isotouch::library;
using Eigen::Vector3d;

namespace {

constexpr const char* kName = "points";

isotouch_build_options default_options() {
  isotouch_build_options options{};
  options.band = field::kBand;
  options.fit_mm = cloud::PlacementOptions{}.fit_mm;
  return options;
}

void require_range(double value, double low, double high, const char* name) {
  if (value >= low && value <= high) return;  // false for NaN
  refuse(ISOTOUCH_BAD_ARGUMENT, std::string(name) + " must be from " + std::to_string(low) + " to " + std::to_string(high) +
                                    "; choose another value, or leave the default");
}

Vector3d viewpoint_of(const isotouch_build_options& options) { return {options.viewpoint[0], options.viewpoint[1], options.viewpoint[2]}; }

void require_valid(const isotouch_build_options& options) {
  require_finite(&options.voxel_mm, 1, "voxel_mm");
  if (options.voxel_mm != 0) require_range(options.voxel_mm, 1.0 / 64, 16, "voxel_mm");
  require_range(options.band, 1, 7.99, "band");
  if (options.stiffness_n_mm != 0) require_range(options.stiffness_n_mm, 0.001, 100, "stiffness_n_mm");
  require_range(options.fit_mm, 1, 1000, "fit_mm");
  if (options.mm_per_unit != 0) require_range(options.mm_per_unit, 1e-6, 1e6, "mm_per_unit");
  if (options.grid != 0) require_range(options.grid, 8, 4000, "grid");
  require_range(options.threads, 0, 1024, "threads");
  require_range(options.interpolation, ISOTOUCH_SPLINE, ISOTOUCH_TRILINEAR, "interpolation");
  require_range(options.has_viewpoint, 0, 1, "has_viewpoint");
  require_range(options.accept_implausible, 0, 1, "accept_implausible");
  require_range(options.reserved, 0, 0, "reserved");
  if (options.has_viewpoint != 0 && !cloud::is_computable(viewpoint_of(options)))
    refuse(ISOTOUCH_BAD_ARGUMENT, "viewpoint: its three numbers must lie within ±1e100");
}

std::vector<Vector3d> vectors(const double* numbers, std::size_t count) {
  std::vector<Vector3d> list;
  list.reserve(count);
  for (std::size_t i = 0; i < count; ++i) list.emplace_back(numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]);
  return list;
}

/// What names the source in the image: a hash of the positions.
std::uint64_t hash_of(const double* points, std::size_t count) {
  return hash64(reinterpret_cast<const std::uint8_t*>(points), 3 * count * sizeof *points);
}

/// A sentence that names options of the command, for a caller who sets a struct.
std::string in_options(std::string sentence) {
  constexpr std::pair<std::string_view, std::string_view> kNames[] = {{"--normals estimate", "no normals"},
                                                                      {"--viewpoint X Y Z", "viewpoint"},
                                                                      {"--viewpoint", "viewpoint"},
                                                                      {"--voxel", "voxel_mm"},
                                                                      {"--grid", "grid"},
                                                                      {"--band", "band"},
                                                                      {"--stiffness", "stiffness_n_mm"},
                                                                      {"--fit", "fit_mm"},
                                                                      {"--units", "mm_per_unit"}};
  for (const auto& [typed, set] : kNames) {
    for (std::size_t at = sentence.find(typed); at != std::string::npos; at = sentence.find(typed, at + set.size()))
      sentence.replace(at, typed.size(), set);
  }
  return sentence;
}

void copy_lines(const std::vector<std::string>& lines, char* to, std::size_t room) {
  if (room == 0) return;
  std::string text;
  for (const std::string& line : lines) text += in_options(line) + '\n';
  const std::size_t size = std::min(text.size(), room - 1);
  std::memcpy(to, text.data(), size);
  to[size] = 0;
}

std::string refusal(const field::Verdict& verdict) {
  std::string text = std::string(kName) + ": the field would probably be wrong: ";
  for (const std::string& reason : verdict.reasons) text += reason + "; ";
  return text + "set accept_implausible to make it all the same";
}

struct Built {
  std::vector<std::uint8_t> packed;
  std::vector<std::string> warnings;
};

Built built(cloud::Model model, std::uint64_t source_hash, const isotouch_build_options& options) {
  const bool estimate = model.normals.empty();
  cloud::CloudReport read;
  cloud::OrientedPoints points = cloud::check(kName, std::move(model), read);
  field::ScanOptions how{estimate, {}};
  how.name = kName;
  if (options.has_viewpoint != 0) how.viewpoint = viewpoint_of(options);
  field::SoundScan scan = field::sound_scan(std::move(points), how);

  Eigen::AlignedBox3d box;
  for (std::size_t i = 0; i < scan.measured; ++i) box.extend(scan.points.positions[i]);
  cloud::PlacementOptions size{{}, options.fit_mm};
  if (options.mm_per_unit != 0) size.mm_per_unit = options.mm_per_unit;
  const cloud::Placement placement = cloud::place(std::span(scan.points.positions.data(), scan.measured), size);
  field::GridWish wish;
  if (options.voxel_mm != 0) wish.voxel_mm = options.voxel_mm;
  if (options.grid != 0) wish.grid = static_cast<int>(options.grid);
  const auto [edge, too_fine] = field::scan_voxel(scan, box.sizes(), placement.scale, wish, scan.usual_grid(box.sizes()));
  scan.place(placement);

  Built done;
  done.warnings = read.warnings();
  if (estimate) done.warnings.emplace_back("normals were estimated from the points");
  for (const std::string& warning : scan.warnings()) done.warnings.push_back(warning);
  if (!too_fine.empty()) done.warnings.push_back(too_fine);
  field::Progress progress;
  field::ScanField made = field::scan_field(scan, edge, options.band, progress);
  for (const std::string& warning : made.repair.warnings()) done.warnings.push_back(warning);
  const InputError empty(std::string(kName) + ": " + field::kEmptyField);
  if (made.verdict.empty) throw empty;
  if (!made.verdict.plausible() && options.accept_implausible == 0) throw InputError(refusal(made.verdict));

  const std::vector<double>& stiffness = made.field.stiffness;
  const double own = stiffness.empty() ? 0.8 : *std::max_element(stiffness.begin(), stiffness.end());
  const encoding::FieldInfo info{options.stiffness_n_mm != 0 ? options.stiffness_n_mm : own,
                                 source_hash,
                                 Method::kDefault,
                                 static_cast<Interpolation>(options.interpolation),
                                 static_cast<std::uint32_t>(read.points),
                                 placement};
  encoding::SmallComponents small;
  field_file::OpenField open = encoding::write_field(std::move(made.field), info, &small);
  for (const std::string& warning : small.warnings()) done.warnings.push_back(warning);
  if (encoding::inside_samples(open.view) == 0) throw empty;
  for (const Eigen::Vector3i& cell : made.invented.cells) open.invented.mark(open.view, 4 * cell.x(), 4 * cell.y(), 4 * cell.z());
  done.packed = field_file::pack(open.view, open.invented);
  return done;
}

}  // namespace

isotouch_status isotouch_build_default(isotouch_build_options* options, size_t size) {
  return guarded(ISOTOUCH_BAD_DATA, [&] {
    require_struct(options, "options", size, "isotouch_build_options");
    *options = default_options();
  });
}

isotouch_status isotouch_build(size_t count, const double* points, const double* normals, const double* stiffness,
                               const isotouch_build_options* options, size_t size, isotouch_field* field, char* warnings, size_t room) {
  return guarded(ISOTOUCH_BAD_DATA, [&] {
    required(field, "field");
    if (room > 0) required(warnings, "warnings");
    require_optional(options, size, "isotouch_build_options");
    const isotouch_build_options wanted = options != nullptr ? *options : default_options();
    require_valid(wanted);
    require_count(count, 3 * sizeof *points, "points");
    require_finite(required(points, "points"), 3 * count, "points");
    cloud::Model model;
    model.is_array = true;
    model.positions = vectors(points, count);
    if (normals != nullptr) {
      require_finite(normals, 3 * count, "normals");
      model.normals = vectors(normals, count);
    }
    if (stiffness != nullptr) {
      require_finite(stiffness, count, "stiffness");
      model.stiffness.assign(stiffness, stiffness + count);
    }
    const field::ThreadLimit limit(wanted.threads);
    Built made;
    try {
      made = built(std::move(model), hash_of(points, count), wanted);
    } catch (const InputError& error) {
      throw InputError(in_options(error.what()));
    }
    isotouch_field handle = 0;
    if (const isotouch_status status = isotouch_field_read(made.packed.data(), made.packed.size(), &handle); status != ISOTOUCH_OK)
      refuse(status, isotouch_last_error());
    copy_lines(made.warnings, warnings, room);
    *field = handle;
  });
}
