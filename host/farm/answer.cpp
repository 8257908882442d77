#include "host/farm/answer.h"

#include <sys/utsname.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "host/error.h"
#include "host/files/json_text.h"
#include "host/files/whole_file.h"
#include "host/trace/hash_text.h"
#include "shared/printable.h"

namespace isotouch::farm {
namespace {

namespace fs = std::filesystem;

using Outcome = Answer::Outcome;

constexpr Outcome kKept[] = {Outcome::kEqual, Outcome::kDiffers, Outcome::kFailed};
constexpr int kDiffersCode = 3;  // as `isotouch replay --check` and replay_plain end

/// Where the answers of a task are.
struct Place {
  fs::path equal, differs, failed;  ///< a file, a folder, a file

  Place(const fs::path& answers, const std::string& address) {
    equal = answers / address.substr(0, 2) / (address.substr(2) + ".json");
    differs = fs::path(equal).replace_extension(".differs");
    failed = fs::path(equal).replace_extension(".failed.json");
  }
  fs::path of(const Answer& answer) const {
    if (answer.outcome == Outcome::kEqual) return equal;
    if (answer.outcome == Outcome::kFailed) return failed;
    return differs / (answer.hash + (answer.first_different ? "-" + std::to_string(*answer.first_different) : "") + ".json");
  }
};

Answer with_reason(Outcome outcome, std::string why) {
  constexpr std::size_t kMaxBytes = 300;
  make_printable(why, ' ');
  Answer answer;
  answer.outcome = outcome;
  answer.said = why.substr(0, kMaxBytes);
  return answer;
}

Answer failed(const std::string& why) { return with_reason(Outcome::kFailed, why); }

/// The last line that is not empty.
std::string last_line(std::string_view text) {
  const std::size_t end = text.find_last_not_of(" \t\r\n");
  if (end == std::string_view::npos) return {};
  text = text.substr(0, end + 1);
  return std::string(text.substr(text.find_last_of('\n') + 1));
}

void require_same_program(const NamedFile& file) {
  if (hash_of(file.path) != file.hash)
    throw InputError(file.path.string() + " is no longer the program of the table; run the farm again with the new one");
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
    answer.outcome = equal ? Outcome::kEqual : Outcome::kDiffers;
    return answer;
  } catch (const nlohmann::json::exception&) {
    return failed("hash, ticks, seconds or first_difference are missing or of another kind in what it printed");
  }
}

/// Is it what `judged` makes of a program's words?
bool can_be(const Answer& answer, const std::string& expected) {
  if (answer.outcome == Outcome::kFailed) return true;
  if (!trace::is_hash_text(answer.hash) || answer.ticks == 0) return false;
  return answer.outcome == Outcome::kDiffers || (answer.hash == expected && !answer.first_different);
}

InputError unreadable(const fs::path& file, const std::error_code& error) {
  return InputError(file.string() + ": cannot be read: " + error.message());
}

bool is_missing(const std::error_code& error) {
  return error == std::errc::no_such_file_or_directory || error == std::errc::not_a_directory;
}

/// The answers in a folder; none: there is no such folder.
std::set<fs::path> files_in(const fs::path& folder) {
  std::set<fs::path> files;
  std::error_code error;
  for (fs::directory_iterator each(folder, error), end; !error && each != end; each.increment(error)) {
    if (each->path().extension() == ".json") files.insert(each->path());
  }
  if (error && !is_missing(error)) throw unreadable(folder, error);
  return files;
}

std::optional<Answer> answer_in(const fs::path& file, const std::string& expected) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (status.type() == fs::file_type::not_found) return std::nullopt;
  if (error) throw unreadable(file, error);
  const auto bytes = read_file(file);
  const nlohmann::json json = nlohmann::json::parse(bytes.begin(), bytes.end(), nullptr, false);
  if (!json.is_object()) return std::nullopt;
  try {
    Answer answer;
    const std::string outcome = json.at("outcome");
    const auto* found = std::ranges::find(kKept, outcome, [](Outcome o) { return std::string(name_of(o)); });
    if (found == std::end(kKept)) return std::nullopt;
    answer.outcome = *found;
    answer.ticks = count_in(json.at("ticks"));
    answer.seconds = seconds_in(json.at("seconds"));
    answer.hash = json.at("hash");
    answer.first_different = tick_in(json.at("first_different"));
    if (answer.outcome == Outcome::kFailed) answer.said = failed(json.at("said")).said;
    answer.host = json.value("host", "");
    return can_be(answer, expected) ? std::optional(answer) : std::nullopt;
  } catch (const nlohmann::json::exception&) {
    return std::nullopt;
  }
}

/// Of answers that do not all say the same.
Answer contradiction(const std::vector<Answer>& all) {
  std::string why;
  for (const Answer& answer : all) {
    why += (why.empty() ? "answers contradict: " : ", ") + std::string(name_of(answer.outcome));
    if (answer.first_different) why += " in tick " + std::to_string(*answer.first_different);
    if (answer.outcome == Outcome::kDiffers) why += " with hash " + answer.hash;
    why += " on " + answer.host;
  }
  return with_reason(Outcome::kContradicts, why);
}

}  // namespace

const char* name_of(Outcome outcome) {
  switch (outcome) {
    case Outcome::kEqual: return "equal";
    case Outcome::kDiffers: return "differs";
    case Outcome::kContradicts: return "contradicts";
    case Outcome::kFailed: break;
  }
  return "failed";
}

Answer ask(const Recording& recording, const Program& program, const Patience& patience) {
  try {
    std::vector<std::string> words = program.command;
    for (const NamedFile& file : files_of(recording)) {
      require_same(file);
      words.push_back(fs::absolute(file.path).string());
    }
    const EndedProgram ended = run_program(words, patience);
    for (const NamedFile& file : program.files) require_same_program(file);
    return judged(ended, recording.expected);
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
  const fs::path file = Place(answers, address).of(answer);
  std::error_code error;
  fs::create_directories(file.parent_path(), error);
  if (error) throw InputError(file.parent_path().string() + ": the folder cannot be made: " + error.message());
  const std::string text = json_text(json) + '\n';
  static std::atomic<unsigned> number = 0;  // others may keep the same answer at the same time
  const fs::path own =
      file.parent_path() / (address + "." + system.nodename + "-" + std::to_string(::getpid()) + "-" + std::to_string(++number));
  write_file(own, text);
  fs::rename(own, file, error);
  if (error) throw InputError(file.string() + ": cannot be written: " + error.message());
}

std::optional<Answer> kept_answer(const fs::path& answers, const Recording& recording, const Program& program) {
  const Place place(answers, address_of(recording, program));
  std::vector<Answer> all;
  for (const fs::path& file : files_in(place.differs)) {  // in order, so that everybody says the same
    std::optional<Answer> answer = answer_in(file, recording.expected);
    if (!answer)
      throw InputError(file.string() + ": its name is that of an answer that differs, but it holds none; copy it again, or remove it");
    all.push_back(std::move(*answer));
  }
  for (const fs::path& file : {place.equal, place.failed}) {
    if (std::optional<Answer> answer = answer_in(file, recording.expected)) all.push_back(std::move(*answer));
  }
  const bool is_known = std::ranges::any_of(all, [](const Answer& answer) { return answer.outcome != Outcome::kFailed; });
  if (is_known) std::erase_if(all, [](const Answer& answer) { return answer.outcome == Outcome::kFailed; });
  if (all.empty()) return std::nullopt;
  const auto says_the_same = [&](const Answer& answer) { return place.of(answer) == place.of(all.front()); };
  return std::ranges::all_of(all, says_the_same) ? all.front() : contradiction(all);
}

}  // namespace isotouch::farm
