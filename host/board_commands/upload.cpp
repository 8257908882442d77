/// isotouch upload: a field onto a running controller, or the patches of a recording, one after the other.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include "host/board_commands/commands.h"
#include "host/board_commands/controller_options.h"
#include "host/board_commands/interruption.h"
#include "host/board_commands/number_in.h"
#include "host/board_commands/print_json.h"
#include "host/error.h"
#include "host/field_file/image.h"
#include "host/field_file/open_field.h"
#include "host/field_file/packed.h"
#include "host/files/whole_file.h"
#include "host/link/controller.h"
#include "host/link/status.h"
#include "host/trace/hash_text.h"
#include "shared/patch_chain.h"

namespace isotouch::commands {

namespace {

struct UploadOptions {
  std::filesystem::path file;
  std::string to, name;
  std::optional<double> rate;
  bool json = false;
};

/// What the controller has taken.
struct Sent {
  std::uint64_t hash = 0;  ///< of the field that is felt
  std::uint64_t bytes = 0;
  std::uint32_t generation = 0;
  std::size_t patches = 0;
};

Sent send_field(link::Controller& controller, const UploadOptions& options, const field_file::OpenField& field) {
  const std::vector<std::uint8_t> packed = field_file::pack(field.view);  // without its marks, which are for people
  const std::string file_name = is_standard(options.file) ? "field" : options.file.stem().string();
  const std::string name = options.name.empty() ? file_name : options.name;
  const std::uint64_t hash = field.view.hash();
  const protocol::Accepted accepted = controller.upload({packed.size(), field.view.image.size(), hash, protocol::Text::of(name)}, packed);
  if (accepted.image_hash != hash) throw InputError(options.to + ": another field was taken over meanwhile; upload again");
  if (!options.json) std::printf("%s is loaded: hash %s, %zu bytes sent\n", name.c_str(), trace::hash_text(hash).c_str(), packed.size());
  return {hash, packed.size(), accepted.generation, 0};
}

/// The patches that are left for a field: from the first one that is for it. None are, where it is the one that the last patch leads to.
///
/// field     0 = the controller has none
/// fails     InputError: a patch is cut, changed or out of order; none of them is for that field
std::span<const std::uint8_t> patches_for(std::uint64_t field, std::span<const std::uint8_t> bytes, const UploadOptions& options) {
  const std::string file = options.file.string();
  const auto checked = [&file](const auto& result) {
    if (!result)
      throw InputError(file + ": " + describe(result.error()) + "; give the .patches that a controller wrote beside a recording");
    return *result;
  };
  const std::uint64_t first = checked(first_patch(bytes)).hash_before;
  (void)checked(check_patches(bytes, first));
  std::uint64_t last = first;
  for (std::span<const std::uint8_t> left = bytes; !left.empty();) {
    const FieldPatch patch = checked(first_patch(left));
    if (patch.hash_before == field) return left;
    last = patch.hash_after;
    left = left.subspan(patch.patch_bytes());
  }
  if (last == field) return {};
  if (field == 0) {
    throw InputError(options.to + ": the controller has no field; upload " + trace::hash_text(first) +
                     ", for which the first of the patches is, before");
  }
  throw InputError(file + ": none of its patches is for the field " + trace::hash_text(field) + " that the controller uses; upload " +
                   trace::hash_text(first) + ", for which the first one is, before");
}

using Clock = std::chrono::steady_clock;

/// Sleeps, but not on after an interruption.
void wait_until(Clock::time_point due, const Interruption& interruption) {
  constexpr std::chrono::milliseconds kAsks{50};
  while (!interruption.has_come() && Clock::now() < due) std::this_thread::sleep_until(std::min(due, Clock::now() + kAsks));
}

/// fails     EndedEarly: interrupted or refused behind the first patch, which is felt
Sent send_patches(link::Controller& controller, const UploadOptions& options, std::span<const std::uint8_t> bytes) {
  const Interruption interruption;
  const protocol::StatusReport before = controller.status();
  Sent sent{before.field_hash, 0, before.generation, 0};
  const Clock::time_point begin = Clock::now();
  std::span<const std::uint8_t> left = patches_for(before.field_hash, bytes, options);
  const std::size_t count = check_patches(left, before.field_hash)->count;
  try {
    while (!left.empty()) {
      const Result<FieldPatch> patch = first_patch(left);
      if (options.rate) {
        const std::chrono::duration<double> due(static_cast<double>(sent.patches) / *options.rate);
        wait_until(begin + std::chrono::duration_cast<Clock::duration>(due), interruption);
      }
      if (interruption.has_come()) throw InputError(options.to + ": interrupted");
      const protocol::Accepted accepted = controller.patch(left.first(patch->patch_bytes()));
      if (accepted.image_hash != patch->hash_after) throw InputError(options.to + ": another field was taken over meanwhile");
      sent = {patch->hash_after, sent.bytes + patch->patch_bytes(), accepted.generation, sent.patches + 1};
      left = left.subspan(patch->patch_bytes());
    }
  } catch (const InputError& error) {
    if (sent.patches == 0) throw;
    throw EndedEarly(std::string(error.what()) + "; " + std::to_string(sent.patches) + " of " + std::to_string(count) +
                     " patches were taken over before; begin anew, or upload the same file to go on from its field");
  }
  if (!options.json) {
    std::printf("%zu patches were taken over: hash %s, %llu bytes sent\n", sent.patches, trace::hash_text(sent.hash).c_str(),
                static_cast<unsigned long long>(sent.bytes));
  }
  return sent;
}

void run(const UploadOptions& options) {
  const std::vector<std::uint8_t> bytes = read_file(options.file);
  Sent sent;
  std::optional<link::Controller> controller;
  if (FieldPatch::has_magic(bytes)) {
    if (!options.name.empty()) throw CLI::ValidationError("--name", "patches keep the name of their field; leave it out");
    controller.emplace(options.to);
    sent = send_patches(*controller, options, bytes);
  } else {
    if (options.rate) throw CLI::ValidationError("--rate", "a field is sent at once; leave it out");
    const field_file::OpenField field = field_file::open_field(field_file::read_field(bytes, options.file.string()), options.file.string());
    controller.emplace(options.to);
    sent = send_field(*controller, options, field);
  }
  const protocol::StatusReport status = controller->status();
  const std::string sentence = link::sentence(status, controller->device());
  if (options.json) {
    const nlohmann::ordered_json json{{"field_hash", trace::hash_text(sent.hash)},
                                      {"bytes", sent.bytes},
                                      {"patches", sent.patches},
                                      {"generation", sent.generation},
                                      {"state", state_name(status.state)},
                                      {"sentence", sentence},
                                      {"faults", fault_names(status.faults)}};
    print_json(json);
  } else {
    std::printf("the state is %s\n", sentence.c_str());
  }
}

}  // namespace

void add_upload(CLI::App& app) {
  auto options = std::make_shared<UploadOptions>();
  CLI::App* command =
      app.add_subcommand("upload", "Send a field to a running controller; if anything fails, the previous field stays active");
  command->add_option("FIELD", options->file, "the field (.itf), or the patches of a recording (.patches)")->required();
  add_address(*command, options->to);
  command->add_option("--name", options->name, "name that the controller stores it under; by default the file's name")->check(field_name());
  command->add_option("--rate", options->rate, "patches per second; by default as fast as the controller takes them over")
      ->check(number_in(0.1, 1000.0));
  command->add_flag("--json", options->json, "print one JSON object");
  command->callback([options] { run(*options); });
}

}  // namespace isotouch::commands
