/// isotouch export: a field in the forms that others read.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "host/board_commands/choice.h"
#include "host/board_commands/output.h"
#include "host/cloud/mesh_bytes.h"
#include "host/commands/commands.h"
#include "host/commands/progress_bar.h"
#include "host/encoding/write_image.h"
#include "host/error.h"
#include "host/evaluate/compare_mesh.h"
#include "host/evaluate/fewer_triangles.h"
#include "host/evaluate/node_distances.h"
#include "host/evaluate/zero_surface.h"
#include "host/field_file/open_field.h"
#include "host/field_file/packed.h"
#include "host/files/whole_file.h"
#include "host/to_double.h"
#include "host/trace/hash_text.h"
#include "host/vdb/level_set.h"

namespace isotouch::commands {

namespace {

constexpr double kSecondsABrick = 5e-5;  // of a surface

using Bytes = std::vector<std::uint8_t>;

/// A field, and the frame that it is to be written in.
struct Exported {
  const FieldView& field;
  const field_file::Marks& invented;
  cloud::Placement frame;  ///< workspace = frame.scale * frame + frame.offset
  bool input_frame;
  std::filesystem::path out;

  double voxel() const { return to_double(field.edge) / frame.scale; }
  /// For people who look into the file.
  std::string comment() const {
    return "isotouch field " + trace::hash_text(field.hash()) + (input_frame ? ", in the scan's coordinates" : ", workspace mm");
  }
};

Bytes image(const Exported& from) { return {from.field.image.begin(), from.field.image.end()}; }

Bytes packed(const Exported& from) { return field_file::pack(from.field, from.invented); }

/// fails     InputError for a field of the published method: its levels are no distances
Bytes level_set(const Exported& from) {
  if (from.field.method == Method::kPublished)
    throw InputError(
        "a field of the published method holds levels, not distances, so no level set can be made of it; export its surface: .ply, .obj or "
        ".stl");
  const encoding::FieldInfo info = encoding::info_of(from.field);
  const auto number = [](double value) { return nlohmann::json(value).dump(); };
  const vdb::Notes notes = {{"isotouch_unit", from.input_frame ? "the scan's" : "mm"},
                            {"isotouch_field", trace::hash_text(from.field.hash())},
                            {"isotouch_source", trace::hash_text(info.source_hash)},
                            {"isotouch_scale", number(info.placement.scale)},  // workspace = scale * input + offset
                            {"isotouch_offset", number(info.placement.offset.x()) + " " + number(info.placement.offset.y()) + " " +
                                                    number(info.placement.offset.z())}};
  field::BandField nodes = evaluate::node_distances(from.field);
  nodes.grid.edge = from.voxel();
  nodes.grid.origin = from.frame.to_cloud(nodes.grid.origin);
  return vdb::write_level_set(nodes, is_standard(from.out) ? "field" : from.out.stem().string(), notes);
}

/// The zero surface.
cloud::TriangleMesh surface(const Exported& from) {
  cloud::TriangleMesh mesh = evaluate::zero_surface(from.field, evaluate::Corners::kApart);
  if (mesh.faces.empty()) throw InputError("the field has no surface: nothing is inside");
  mesh = evaluate::fewer_triangles(from.field, std::move(mesh));
  for (Eigen::Vector3d& vertex : mesh.vertices) vertex = from.frame.to_cloud(vertex);
  return mesh;
}

Bytes ply(const Exported& from) { return cloud::ply_bytes(surface(from), from.comment()); }

Bytes obj(const Exported& from) { return cloud::obj_bytes(surface(from), from.comment(), from.voxel() / 65536); }

Bytes stl(const Exported& from) { return cloud::stl_bytes(surface(from), from.out.string(), from.comment(), from.voxel() / 4096); }

/// How each form is written.
struct Writer {
  const Form* form;
  bool has_frames;  ///< also in the scan's coordinates
  Bytes (*bytes)(const Exported&);
};

constexpr std::array kWriters = {
    Writer{&forms::kField, false, packed}, Writer{&forms::kImage, false, image}, Writer{&forms::kLevelSet, true, level_set},
    Writer{&forms::kPly, true, ply},       Writer{&forms::kObj, true, obj},      Writer{&forms::kStl, true, stl}};

Forms written_forms() {
  Forms all;
  for (const Writer& writer : kWriters) all.push_back(writer.form);
  return all;
}

/// Their endings without the dots.
std::vector<std::string> form_names() {
  std::vector<std::string> names;
  for (const Writer& writer : kWriters) names.emplace_back(writer.form->ending.substr(1));
  return names;
}

struct ExportOptions {
  std::filesystem::path field;
  std::filesystem::path out;
  std::string format;
  bool input_frame = false;
};

void run(const ExportOptions& options) {
  const Form* form = form_of(options.out, written_forms(), options.format);  // before the work
  const Writer& writer = *std::find_if(kWriters.begin(), kWriters.end(), [&](const Writer& w) { return w.form == form; });
  if (options.input_frame && !writer.has_frames)
    throw CLI::ValidationError("--input-frame",
                               std::string(form->ending) + " is always in workspace mm; a surface or a level set need not be");
  const field_file::OpenField open = field_file::open_field(options.field);
  const cloud::Placement frame = options.input_frame ? evaluate::placement_of(open.view) : cloud::Placement{};
  ProgressBar bar({{"export", kSecondsABrick * open.view.brick_count}});
  bar.begin("export");
  const Bytes bytes = writer.bytes({open.view, open.invented, frame, options.input_frame, options.out});
  bar.end();
  write_file(options.out, bytes.data(), bytes.size());
}

}  // namespace

void add_export(CLI::App& app) {
  auto options = std::make_shared<ExportOptions>();
  CLI::App* command = app.add_subcommand("export", "Write a field in another format: its surface as a mesh, its distances as a level set");
  command->add_option("FIELD", options->field, "the field (.itf)")->required();
  command
      ->add_option("-o,--out", options->out,
                   "the file to write; its ending chooses the format: " + list_of(written_forms()) + "; - is standard output")
      ->required();
  command->add_option("--format", options->format, "the format, where the name does not say it")->check(one_of(form_names()));
  command->add_flag("--input-frame", options->input_frame,
                    "write surface or level set in the scan's own coordinates and units; by default in workspace mm");
  command->callback([options] { run(*options); });
}

}  // namespace isotouch::commands
