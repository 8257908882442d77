#include "host/farm/answer.h"

#include <sys/utsname.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "host/error.h"
#include "host/farm/ended_program.h"
#include "host/files/whole_file.h"

namespace isotouch::farm {
namespace {

namespace fs = std::filesystem;

constexpr Answer::Outcome kOutcomes[] = {Answer::Outcome::kEqual, Answer::Outcome::kDiffers, Answer::Outcome::kFailed};
constexpr int kDiffersCode = 3;  // as `isotouch replay --check` and replay_plain end

fs::path file_of(const fs::path& answers, const std::string& address) {
  return answers / address.substr(0, 2) / (address.substr(2) + ".json");
}

Answer failed(const std::string& why) {
  Answer answer;
  answer.said = why.substr(0, why.find('\n'));
  return answer;
}

std::string change_of(const fs::path& file, const std::string& hash) {
  return hash_of_file(file) == hash ? "" : file.string() + " is no longer the file of the table";
}

/// The first tick that differs: a number, or an object with a "tick".
std::optional<std::uint64_t> tick_in(const nlohmann::json& json) {
  const nlohmann::json& tick = json.is_object() ? json.value("tick", nlohmann::json()) : json;
  return tick.is_number_unsigned() ? std::optional(tick.get<std::uint64_t>()) : std::nullopt;
}

/// Of what a program printed: its last line that is a JSON object.
nlohmann::json object_in(const std::string& printed) {
  const std::size_t begin = printed.find('{');
  return begin == std::string::npos ? nlohmann::json() : nlohmann::json::parse(printed.substr(begin), nullptr, false);
}

Answer judged(const EndedProgram& ended, const std::string& expected) {
  const nlohmann::json json = object_in(ended.printed);
  const auto hash = json.is_object() ? json.find("hash") : json.end();
  if ((ended.code != 0 && ended.code != kDiffersCode) || !json.is_object() || hash == json.end() || !hash->is_string())
    return failed(ended.complained.empty() ? "it ended with " + std::to_string(ended.code) + " and printed no hash" : ended.complained);
  Answer answer;
  answer.hash = *hash;
  if (const auto found = json.find("ticks"); found != json.end() && found->is_number_unsigned()) answer.ticks = *found;
  if (const auto found = json.find("seconds"); found != json.end() && found->is_number()) answer.seconds = *found;
  if (answer.ticks == 0) return failed("it replayed no tick");
  if (const auto found = json.find("first_difference"); found != json.end()) answer.first_different = tick_in(*found);
  const bool equal = ended.code == 0 && answer.hash == expected && !answer.first_different;
  answer.outcome = equal ? Answer::Outcome::kEqual : Answer::Outcome::kDiffers;
  return answer;
}

}  // namespace

const char* name_of(Answer::Outcome outcome) {
  switch (outcome) {
    case Answer::Outcome::kEqual: return "equal";
    case Answer::Outcome::kDiffers: return "differs";
    case Answer::Outcome::kFailed: break;
  }
  return "failed";
}

Answer ask(const Recording& recording, const Program& program) {
  try {
    for (const std::string& change : {change_of(recording.field, recording.field_hash), change_of(recording.trace, recording.trace_hash)})
      if (!change.empty()) return failed(change);
    std::vector<std::string> words = program.command;
    words.push_back(fs::absolute(recording.field).string());
    words.push_back(fs::absolute(recording.trace).string());
    return judged(run_program(words), recording.expected);
  } catch (const InputError& error) {
    return failed(error.what());
  }
}

void keep(const fs::path& answers, const Recording& recording, const Program& program, const Answer& answer) {
  utsname system{};
  ::uname(&system);
  const nlohmann::ordered_json json = {
      {"recording", recording.name},
      {"processor", program.processor},
      {"commit", program.commit},
      {"compiler", program.compiler},
      {"rung", program.rung},
      {"outcome", name_of(answer.outcome)},
      {"ticks", answer.ticks},
      {"seconds", answer.seconds},
      {"hash", answer.hash},
      {"first_different", answer.first_different ? nlohmann::json(*answer.first_different) : nlohmann::json()},
      {"said", answer.said},
      {"host", system.nodename},
      {"kernel", system.release}};
  const fs::path file = file_of(answers, address_of(recording, program));
  std::error_code error;
  fs::create_directories(file.parent_path(), error);
  if (error) throw InputError(file.parent_path().string() + ": the folder cannot be made: " + error.message());
  const std::string text = json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + '\n';
  write_file(file, reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
}

std::optional<Answer> kept_answer(const fs::path& answers, const std::string& address) {
  const fs::path file = file_of(answers, address);
  if (!fs::is_regular_file(file)) return std::nullopt;
  const auto bytes = read_file(file);
  const nlohmann::json json = nlohmann::json::parse(bytes.begin(), bytes.end(), nullptr, false);
  if (!json.is_object()) return std::nullopt;
  try {
    Answer answer;
    const std::string outcome = json.at("outcome");
    const auto* found = std::ranges::find(kOutcomes, outcome, [](Answer::Outcome o) { return std::string(name_of(o)); });
    if (found == std::end(kOutcomes)) return std::nullopt;
    answer.outcome = *found;
    answer.ticks = json.at("ticks");
    answer.seconds = json.at("seconds");
    answer.hash = json.at("hash");
    if (!json.at("first_different").is_null()) answer.first_different = json.at("first_different").get<std::uint64_t>();
    answer.said = json.at("said");
    return answer;
  } catch (const nlohmann::json::exception&) {
    return std::nullopt;
  }
}

}  // namespace isotouch::farm
