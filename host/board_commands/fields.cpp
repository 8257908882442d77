/// isotouch fields: what a controller has stored, and which one it renders.
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "host/board_commands/commands.h"
#include "host/board_commands/controller_options.h"
#include "host/board_commands/print_json.h"
#include "host/error.h"
#include "host/link/controller.h"
#include "host/trace/hash_text.h"

namespace isotouch::commands {

namespace {

struct FieldsOptions {
  std::string to, select;
  bool json = false;
};

/// The field that a hash or a name means.
std::uint64_t find(const std::vector<protocol::FieldEntry>& fields, const std::string& wanted) {
  std::vector<const protocol::FieldEntry*> found;
  for (const protocol::FieldEntry& field : fields) {
    if (trace::hash_text(field.image_hash) == wanted) return field.image_hash;
    if (field.name.view() == wanted) found.push_back(&field);
  }
  if (found.size() == 1) return found.front()->image_hash;
  if (found.empty())
    throw InputError("--select " + wanted + ": no stored field has this hash or name; the list without --select shows them");
  std::string hashes;
  for (const protocol::FieldEntry* field : found) hashes += " " + trace::hash_text(field->image_hash);
  throw InputError("--select " + wanted + ": several stored fields have this name; say which by its hash:" + hashes);
}

void print(const std::vector<protocol::FieldEntry>& fields, bool as_json) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const protocol::FieldEntry& field : fields) {
    const std::string hash = trace::hash_text(field.image_hash), name(field.name.view());
    if (as_json) {
      json.push_back({{"field_hash", hash}, {"name", name}, {"bytes", field.packed_bytes}, {"active", field.active != 0}});
    } else {
      std::printf("%s %s %8llu bytes  %s\n", field.active != 0 ? "*" : " ", hash.c_str(),
                  static_cast<unsigned long long>(field.packed_bytes), name.c_str());
    }
  }
  if (as_json) print_json(nlohmann::ordered_json{{"fields", json}});
}

void run(const FieldsOptions& options) {
  link::Controller controller(options.to);
  if (!options.select.empty()) (void)controller.select(find(controller.fields(), options.select));
  print(controller.fields(), options.json);
}

}  // namespace

void add_fields(CLI::App& app) {
  auto options = std::make_shared<FieldsOptions>();
  CLI::App* command =
      app.add_subcommand("fields", "List the fields stored on a controller and mark the active one, or make another one active");
  add_address(*command, options->to);
  command->add_option("--select", options->select, "hash or name of the stored field to make active");
  command->add_flag("--json", options->json, "print one JSON object");
  command->callback([options] { run(*options); });
}

}  // namespace isotouch::commands
