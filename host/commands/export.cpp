/// isotouch export: a field in the forms that others read.
#include <CLI/CLI.hpp>
#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "host/commands/commands.h"
#include "host/encoding/write_image.h"
#include "host/error.h"
#include "host/evaluate/node_distances.h"
#include "host/field_file/open_field.h"
#include "host/field_file/packed.h"
#include "host/files/whole_file.h"
#include "host/trace/hash_text.h"
#include "host/vdb/level_set.h"

namespace isotouch::commands {

namespace {

using field_file::OpenField;

void export_image(const OpenField& field, const std::filesystem::path& out) {
  write_file(out, field.view.image.data(), field.view.image.size());
}

void export_packed(const OpenField& field, const std::filesystem::path& out) {
  const std::vector<std::uint8_t> bytes = field_file::pack(field.view, field.invented);
  write_file(out, bytes.data(), bytes.size());
}

void export_level_set(const OpenField& field, const std::filesystem::path& out) {
  const encoding::FieldInfo info = encoding::info_of(field.view);
  const auto number = [](double value) { return nlohmann::json(value).dump(); };
  const vdb::Notes notes = {{"isotouch_unit", "mm"},
                            {"isotouch_field", trace::hash_text(field.view.hash())},
                            {"isotouch_source", trace::hash_text(info.source_hash)},
                            {"isotouch_scale", number(info.placement.scale)},  // workspace = scale * input + offset
                            {"isotouch_offset", number(info.placement.offset.x()) + " " + number(info.placement.offset.y()) + " " +
                                                    number(info.placement.offset.z())}};
  const std::vector<std::uint8_t> bytes = vdb::write_level_set(evaluate::node_distances(field.view), out.stem().string(), notes);
  write_file(out, bytes.data(), bytes.size());
}

/// One kind of file; its name's ending chooses it.
struct Form {
  std::string_view extension;
  const char* what;
  void (*write)(const OpenField& field, const std::filesystem::path& out);
};

constexpr std::array kForms = {
    Form{".itf", "packed, as build writes it", export_packed},
    Form{".itfi", "the memory image that a controller holds", export_image},
    Form{".vdb", "a level set of OpenVDB, mm in the workspace", export_level_set},
};

/// ".itfi (the memory image …), …": for help and refusals.
std::string known_forms() {
  std::string text;
  for (const Form& form : kForms) text.append(text.empty() ? "" : ", ").append(form.extension).append(" (").append(form.what).append(")");
  return text;
}

/// fails     InputError when no form has the file's extension
const Form& form_of(const std::filesystem::path& out) {
  for (const Form& form : kForms) {
    if (out.extension() == form.extension) return form;
  }
  throw InputError(out.string() + ": its name does not say which form to write; end it with " + known_forms());
}

}  // namespace

void add_export(CLI::App& app) {
  struct Options {
    std::filesystem::path field;
    std::filesystem::path out;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("export", "Write a field in another file format");
  command->add_option("FIELD", options->field, "the field (.itf)")->required();
  command->add_option("-o,--out", options->out, "the file to write; its extension chooses the format: " + known_forms())->required();
  command->callback([options] {
    const Form& form = form_of(options->out);  // before the work
    form.write(field_file::open_field(options->field), options->out);
  });
}

}  // namespace isotouch::commands
