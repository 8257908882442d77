/// isotouch upload: a field onto a running controller.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "host/board_commands/commands.h"
#include "host/board_commands/controller_options.h"
#include "host/error.h"
#include "host/field_file/open_field.h"
#include "host/field_file/packed.h"
#include "host/files/whole_file.h"
#include "host/link/controller.h"
#include "host/trace/hash_text.h"

namespace isotouch::commands {

namespace {

struct UploadOptions {
  std::filesystem::path field;
  std::string to, name;
  bool json = false;
};

void run(const UploadOptions& options) {
  const field_file::OpenField field = field_file::open_field(options.field);
  const std::vector<std::uint8_t> packed = field_file::pack(field.view);  // without its marks, which are for people
  const std::string file_name = is_standard(options.field) ? "field" : options.field.stem().string();
  const std::string name = options.name.empty() ? file_name : options.name;
  const std::uint64_t hash = field.view.hash();
  link::Controller controller(options.to);
  const protocol::Accepted accepted = controller.upload({packed.size(), field.view.image.size(), hash, protocol::Text::of(name)}, packed);
  if (accepted.image_hash != hash) throw InputError(options.to + ": another field was taken over meanwhile; upload again");
  const protocol::StatusReport status = controller.status();
  if (options.json) {
    const nlohmann::ordered_json json{{"field_hash", trace::hash_text(hash)}, {"bytes", packed.size()},
                                      {"generation", accepted.generation},    {"state", state_name(status.state)},
                                      {"sentence", state_text(status)},       {"faults", fault_names(status.faults)}};
    std::printf("%s\n", json.dump(2).c_str());
  } else {
    std::printf("%s is loaded: hash %s, %zu bytes sent\nthe state is %s\n", name.c_str(), trace::hash_text(hash).c_str(), packed.size(),
                state_text(status).c_str());
  }
}

}  // namespace

void add_upload(CLI::App& app) {
  auto options = std::make_shared<UploadOptions>();
  CLI::App* command =
      app.add_subcommand("upload", "Send a field to a running controller; if anything fails, the previous field stays active");
  command->add_option("FIELD", options->field, "the field (.itf)")->required();
  add_address(*command, options->to);
  command->add_option("--name", options->name, "name that the controller stores it under; by default the file's name");
  command->add_flag("--json", options->json, "print one JSON object");
  command->callback([options] { run(*options); });
}

}  // namespace isotouch::commands
