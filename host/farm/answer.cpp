#include "host/farm/answer.h"

#include <sys/utsname.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <nlohmann/json.hpp>
#include <string_view>

#include "host/error.h"
#include "host/files/whole_file.h"
#include "host/trace/hash_text.h"
#include "shared/printable.h"

namespace isotouch::farm {
namespace {

namespace fs = std::filesystem;

constexpr Answer::Outcome kOutcomes[] = {Answer::Outcome::kEqual, Answer::Outcome::kDiffers, Answer::Outcome::kFailed};
constexpr int kDiffersCode = 3;  // as `isotouch replay --check` and replay_plain end

fs::path file_of(const fs::path& answers, const std::string& address) {
  return answers / address.substr(0, 2) / (address.substr(2) + ".json");
}

Answer failed(std::string why) {
  constexpr std::size_t kMaxBytes = 300;
  make_printable(why, ' ');
  Answer answer;
  answer.said = why.substr(0, kMaxBytes);
  return answer;
}

/// The last line that is not empty.
std::string last_line(std::string_view text) {
  const std::size_t end = text.find_last_not_of(" \t\r\n");
  if (end == std::string_view::npos) return {};
  text = text.substr(0, end + 1);
  return std::string(text.substr(text.find_last_of('\n') + 1));
}

std::string change_of(const fs::path& file, const std::string& hash) {
  return hash_of_file(file) == hash ? "" : file.string() + " is no longer the file of the table";
}

/// Of what a program printed: the object in it, or the last line that is one.
nlohmann::json object_in(std::string_view printed) {
  const std::size_t begin = printed.find('{'), end = printed.rfind('}');
  if (begin == std::string_view::npos || end == std::string_view::npos || end < begin) return {};
  nlohmann::json whole = nlohmann::json::parse(printed.substr(begin, end + 1 - begin), nullptr, false);
  if (whole.is_object()) return whole;
  const std::string line = last_line(printed.substr(0, end + 1));
  return nlohmann::json::parse(line, nullptr, false);
}

/// fails     nlohmann::json::exception: no whole number from 0 on
std::uint64_t count_in(const nlohmann::json& number) {
  if (!number.is_number_unsigned()) throw nlohmann::json::type_error::create(302, "no count", nullptr);
  return number.get<std::uint64_t>();
}

/// fails     nlohmann::json::exception: no time
double seconds_in(const nlohmann::json& number) {
  const double seconds = number;
  if (seconds < 0) throw nlohmann::json::type_error::create(302, "no time", nullptr);
  return seconds;
}

/// The first tick that differs, as a number or in an object; null: none.
std::optional<std::uint64_t> tick_in(const nlohmann::json& json) {
  if (json.is_null()) return std::nullopt;
  return count_in(json.is_object() ? json.at("tick") : json);
}

Answer judged(const EndedProgram& ended, const std::string& expected) {
  const std::string code = "it ended with " + std::to_string(ended.code);
  if (!ended.stopped.empty()) return failed(ended.stopped);
  if (ended.code != 0 && ended.code != kDiffersCode) {
    const std::string why = last_line(ended.complained);
    return failed(why.empty() ? code : code + ": " + why);
  }
  const nlohmann::json json = object_in(ended.printed);
  if (!json.is_object()) return failed(code + " and printed no JSON object");
  try {
    Answer answer;
    answer.hash = json.at("hash");
    answer.ticks = count_in(json.at("ticks"));
    if (const auto found = json.find("seconds"); found != json.end()) answer.seconds = seconds_in(*found);
    if (const auto found = json.find("first_difference"); found != json.end()) answer.first_different = tick_in(*found);
    if (!trace::is_hash_text(answer.hash)) return failed("its hash has not 16 hexadecimal digits");
    if (answer.ticks == 0) return failed("it replayed no tick");
    const bool equal = ended.code == 0 && answer.hash == expected && !answer.first_different;
    answer.outcome = equal ? Answer::Outcome::kEqual : Answer::Outcome::kDiffers;
    return answer;
  } catch (const nlohmann::json::exception&) {
    return failed("hash, ticks, seconds or first_difference are missing or of another kind in what it printed");
  }
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

Answer ask(const Recording& recording, const Program& program, const Patience& patience) {
  try {
    for (const std::string& change : {change_of(recording.field, recording.field_hash), change_of(recording.trace, recording.trace_hash)})
      if (!change.empty()) return failed(change);
    std::vector<std::string> words = program.command;
    words.push_back(fs::absolute(recording.field).string());
    words.push_back(fs::absolute(recording.trace).string());
    return judged(run_program(words, patience), recording.expected);
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
  const std::string address = address_of(recording, program);
  if (answer.outcome == Answer::Outcome::kFailed) {  // somebody else may have the answer meanwhile
    const std::optional<Answer> now = kept_answer(answers, address);
    if (now && now->outcome != Answer::Outcome::kFailed) return;
  }
  const fs::path file = file_of(answers, address);
  std::error_code error;
  fs::create_directories(file.parent_path(), error);
  if (error) throw InputError(file.parent_path().string() + ": the folder cannot be made: " + error.message());
  const std::string text = json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + '\n';
  static std::atomic<unsigned> number = 0;  // others may keep the same answer at the same time
  const fs::path own =
      file.parent_path() / (address + "." + system.nodename + "-" + std::to_string(::getpid()) + "-" + std::to_string(++number));
  write_file(own, text);
  fs::rename(own, file, error);
  if (error) throw InputError(file.string() + ": cannot be written: " + error.message());
}

std::optional<Answer> kept_answer(const fs::path& answers, const std::string& address) {
  const fs::path file = file_of(answers, address);
  std::error_code none;
  if (!fs::is_regular_file(file, none)) return std::nullopt;
  const auto bytes = read_file(file);
  const nlohmann::json json = nlohmann::json::parse(bytes.begin(), bytes.end(), nullptr, false);
  if (!json.is_object()) return std::nullopt;
  try {
    Answer answer;
    const std::string outcome = json.at("outcome");
    const auto* found = std::ranges::find(kOutcomes, outcome, [](Answer::Outcome o) { return std::string(name_of(o)); });
    if (found == std::end(kOutcomes)) return std::nullopt;
    answer.outcome = *found;
    answer.ticks = count_in(json.at("ticks"));
    answer.seconds = seconds_in(json.at("seconds"));
    answer.hash = json.at("hash");
    answer.first_different = tick_in(json.at("first_different"));
    answer.said = json.at("said");
    if (answer.outcome != Answer::Outcome::kFailed && !trace::is_hash_text(answer.hash)) return std::nullopt;
    return answer;
  } catch (const nlohmann::json::exception&) {
    return std::nullopt;
  }
}

}  // namespace isotouch::farm
