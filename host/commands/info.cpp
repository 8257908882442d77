/// isotouch info: what a field says of itself.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "host/board_commands/print_json.h"
#include "host/board_commands/print_key.h"
#include "host/commands/commands.h"
#include "host/commands/progress_bar.h"
#include "host/encoding/certificate.h"
#include "host/encoding/dense_bytes.h"
#include "host/encoding/write_image.h"
#include "host/evaluate/zero_surface.h"
#include "host/field_file/described_field.h"
#include "host/field_file/marks.h"
#include "host/files/whole_file.h"
#include "host/to_double.h"
#include "host/trace/hash_text.h"
#include "shared/bytes.h"
#include "shared/certificate.h"

namespace isotouch::commands {

namespace {

using field_file::DescribedField;

std::string version(const FieldView& view) {
  const std::uint8_t* at = view.image.data();
  return std::to_string(load_le<std::uint16_t>(at + image_layout::kMajorAt)) + "." +
         std::to_string(load_le<std::uint16_t>(at + image_layout::kMinorAt));
}

std::vector<evaluate::Piece> surface_pieces(const FieldView& view) {
  constexpr double kSecondsABrick = 3e-5;
  ProgressBar bar({{"surface", kSecondsABrick * view.brick_count}});
  bar.begin("surface");
  return evaluate::pieces(evaluate::zero_surface(view));
}

/// What --surface adds.
void add_surface(const FieldView& view, nlohmann::ordered_json& json) {
  const std::vector<evaluate::Piece> pieces = surface_pieces(view);
  json["components"] = pieces.size();
  json["volume_mm3"] = evaluate::volume(pieces);
  json["area_mm2"] = evaluate::area(pieces);
}

void print_surface(const FieldView& view) {
  const std::vector<evaluate::Piece> pieces = surface_pieces(view);
  std::printf("surface      %zu component%s, %.6g mm³ inside, %.6g mm²\n", pieces.size(), pieces.size() == 1 ? "" : "s",
              evaluate::volume(pieces), evaluate::area(pieces));
  constexpr std::size_t kShown = 8;
  for (std::size_t i = 1; i < std::min(pieces.size(), kShown); ++i) {
    const evaluate::Piece& piece = pieces[i];
    std::printf("             %s of %.4g mm³ at (%.2f, %.2f, %.2f) mm\n", piece.volume < 0 ? "a cavity" : "another piece",
                std::abs(piece.volume), piece.place.x(), piece.place.y(), piece.place.z());
  }
  if (pieces.size() > kShown) std::printf("             and %zu smaller ones\n", pieces.size() - kShown);
}

/// The least and the largest of the surface, N/mm.
struct StiffnessRange {
  double least, largest;

  bool varies = false;

  explicit StiffnessRange(const DescribedField& field) : least(to_double(field.header.stiffness)), largest(least) {
    varies = field.whole && field.whole->view.stiffness_parts != nullptr;
    if (!varies || field.header.brick_count == 2) return;
    const std::uint8_t* parts = field.whole->view.stiffness_parts;
    least *= static_cast<double>(*std::min_element(parts + 2, parts + field.header.brick_count)) / image_layout::kFullStiffness;
  }
};

/// Of what is at hand; a controller asks all of it.
CertificateCheck certificate_check(const DescribedField& field) {
  const Loop loop = assumed_loop(field.header);
  return field.whole ? check_certificate(field.whole->view, loop, {}) : check_certificate_header(field.header, loop, {});
}

bool has_invented(const DescribedField& field) { return field.whole && field.whole->invented.any(); }

double invented_share(const DescribedField& field) { return field_file::share_of(field.whole->invented, field.whole->view); }

nlohmann::ordered_json field_json(const DescribedField& field, bool with_surface) {
  const FieldView& view = field.header;
  const encoding::Certificate promise = encoding::certificate_of(view);
  const nlohmann::ordered_json certificate = {{"largest_slope", promise.largest_slope},
                                              {"quantisation_voxel", promise.quantisation_voxel},
                                              {"thinnest_wall_voxel", promise.thinnest_wall_voxel},
                                              {"stiffness_n_per_mm", promise.stiffness_n_per_mm},
                                              {"period_ns", promise.period_ns},
                                              {"damping_n_s_mm", promise.damping_n_s_mm},
                                              {"delay_ticks", promise.delay_ticks}};
  nlohmann::ordered_json json = {{"bytes", field.image_bytes},
                                 {"voxel_mm", to_double(view.edge)},
                                 {"grid", view.size},
                                 {"band_voxels", to_double(view.band)},
                                 {"interpolation", view.interpolation == Interpolation::kSpline ? "spline" : "trilinear"},
                                 {"bricks", view.brick_count},
                                 {"hash", trace::hash_text(field.hash)},
                                 {"version", version(view)},
                                 {"wire_bytes", field.packed_bytes},
                                 {"dense_float_bytes", encoding::dense_float_bytes(view)},
                                 {"certificate", certificate}};
  const StiffnessRange stiffness(field);
  json["stiffness_n_per_mm"] = {{"least", stiffness.least}, {"largest", stiffness.largest}};
  if (has_invented(field)) json["invented_share"] = invented_share(field);
  if (with_surface) add_surface(field.whole->view, json);
  return json;
}

void print_text(const DescribedField& field) {
  const FieldView& view = field.header;
  const encoding::FieldInfo info = encoding::info_of(view);
  const Eigen::Vector3d origin = to_double(view.origin);
  const Eigen::Vector3d far =
      origin + to_double(view.edge) * (Eigen::Vector3d(view.size[0], view.size[1], view.size[2]) - Eigen::Vector3d::Ones());
  const auto& [scale, offset] = info.placement;
  std::printf("version      %s\n", version(view).c_str());
  std::printf("bytes        %zu in memory, %zu packed in the file and for upload; a dense grid of 32-bit floats would take %ju\n",
              field.image_bytes, field.packed_bytes, std::uintmax_t{encoding::dense_float_bytes(view)});
  std::printf("hash         %s\n", trace::hash_text(field.hash).c_str());
  std::printf("source hash  %s\n", trace::hash_text(info.source_hash).c_str());
  std::printf("method       %s, from %u points\n", info.method == Method::kPublished ? "published" : "default", info.point_count);
  std::printf("between      samples: %s\n", view.interpolation == Interpolation::kSpline ? "quadratic B-spline" : "trilinear");
  std::printf("grid         %d × %d × %d samples\n", view.size[0], view.size[1], view.size[2]);
  std::printf("voxel        %.6f mm\n", to_double(view.edge));
  std::printf("workspace    (%.3f, %.3f, %.3f) to (%.3f, %.3f, %.3f) mm\n", origin.x(), origin.y(), origin.z(), far.x(), far.y(), far.z());
  std::printf("band         ±%g voxels = ±%.3f mm\n", to_double(view.band), to_double(view.band) * to_double(view.edge));
  const StiffnessRange stiffness(field);
  if (!stiffness.varies) {
    std::printf("stiffness    %.4g N/mm\n", stiffness.largest);
  } else {
    std::printf("stiffness    %.3g to %.3g N/mm over the surface\n", stiffness.least, stiffness.largest);
  }
  std::printf("transform    workspace mm = %.9g · input + (%.9g, %.9g, %.9g)\n", scale, offset.x(), offset.y(), offset.z());
  const encoding::Certificate promise = encoding::certificate_of(view);
  if (promise.largest_slope > 0.0) {
    std::printf("slope        at most %.3f; rounding moves the surface by %.5f voxel at most\n", promise.largest_slope,
                promise.quantisation_voxel);
    if (promise.thinnest_wall_voxel > 0.0) {
      std::printf("thinnest     wall of about %.1f voxels = %.2f mm\n", promise.thinnest_wall_voxel,
                  promise.thinnest_wall_voxel * to_double(view.edge));
    } else {
      std::printf("thinnest     no wall below %g voxels\n", 2.0 * to_double(view.band));
    }
    std::printf("advisable    up to %.2f N/mm at %.0f Hz, %.4g N·s/m of device damping, a delay of %u tick%s\n", promise.stiffness_n_per_mm,
                1e9 / promise.period_ns, 1000.0 * promise.damping_n_s_mm, promise.delay_ticks, promise.delay_ticks == 1 ? "" : "s");
    if (const CertificateCheck check = certificate_check(field); !check.accepted) {
      std::printf("             %s\n", describe(check.error));
    }
  }
  std::printf("bricks       %u of 4 × 4 × 4 samples, in %u nodes\n", view.brick_count, view.node_count);
  if (has_invented(field)) {
    std::printf("invented     %.1f %% of the surface, where nobody scanned; `isotouch render surface` shows it\n",
                100.0 * invented_share(field));
  }
}

}  // namespace

void add_info(CLI::App& app) {
  struct Options {
    std::filesystem::path field;
    bool surface = false;
    bool json = false;
    std::string key;  ///< only this value of the JSON object
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("info", "Print what a field file holds");
  command->add_option("FIELD", options->field, "the field (.itf)")->required();
  command->add_flag("--surface", options->surface, "also measure the whole surface: number of pieces, volume inside, area");
  command->add_flag("--json", options->json, "print one JSON object");
  command->add_option("--key", options->key, "print only the value with this key of the JSON object, such as hash");
  command->callback([options] {
    const std::vector<std::uint8_t> file = read_file(options->field);
    const DescribedField field = field_file::describe_field(file, options->field.string(), options->surface);
    if (!options->key.empty()) return print_key(field_json(field, options->surface), options->key);
    if (options->json) {
      print_json(field_json(field, options->surface));
      return;
    }
    print_text(field);
    if (options->surface) print_surface(field.whole->view);
  });
}

}  // namespace isotouch::commands
