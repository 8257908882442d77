/// The doors of a farm: tables of recordings and programs, and kept answers, by the first byte. Others write these files.
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <optional>
#include <string>

#include "host/error.h"
#include "host/farm/report.h"
#include "host/farm/task.h"
#include "host/files/whole_file.h"
#include "host/trace/hash_text.h"
#include "tests/fuzz/input.h"

using namespace isotouch;
namespace fs = std::filesystem;

namespace {

constexpr const char* kHash = "abcdef0123456789";

const farm::Recording& recording() {
  static const farm::Recording one{"a", {"a.itf", kHash}, {"a.trace", kHash}, {}, kHash, "device", "origin"};
  return one;
}

const farm::Program& program() {
  static const farm::Program one{"x86-64", "1", "gcc", "0", {"./program"}, kHash, {}};
  return one;
}

/// Where its answer is kept that is equal.
fs::path answer_in(const fs::path& folder) {
  const std::string address = farm::address_of(recording(), program());
  return folder / "answers" / address.substr(0, 2) / (address.substr(2) + ".json");
}

/// A folder with a program, as tables name them.
const fs::path& folder() {
  static const fs::path made = [] {
    const fs::path path = "/tmp/isotouch-fuzz-" + std::to_string(::getpid());
    fs::create_directories(answer_in(path).parent_path());
    write_file(path / "program", "x");
    return path;
  }();
  return made;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 1) return 0;
  const fs::path table = folder() / "table";
  const bool is_answer = data[0] % 4 == 2;
  write_file(is_answer ? answer_in(folder()) : table, data + 1, size - 1);
  try {
    if (is_answer) {
      const std::optional<farm::Answer> answer = farm::kept_answer(folder() / "answers", recording(), program());
      if (!answer) return 0;
      const std::vector<farm::Row> rows{{&recording(), &program(), answer}};
      fuzz::hold(farm::count(rows).all() == 1, "an answer counts once");
      static_cast<void>(farm::to_html(rows));
      static_cast<void>(farm::to_csv(rows));
      for (const farm::Speed& speed : farm::speeds(rows))
        fuzz::hold(std::isfinite(speed.ticks) && std::isfinite(speed.seconds), "a speed is a number");
      for (const farm::Change& change : farm::changes(rows)) static_cast<void>(farm::in_words(change));
      fuzz::hold(answer->outcome == farm::Answer::Outcome::kFailed || trace::is_hash_text(answer->hash), "an answer has its hash");
    } else if (data[0] % 4 == 1) {
      for (const farm::Program& each : farm::read_programs(table)) {
        fuzz::hold(!each.command.empty(), "a program has a command");
        static_cast<void>(farm::address_of(recording(), each));
      }
    } else {
      const auto recordings = farm::read_recordings(table);
      fuzz::hold(!recordings.empty(), "a table lists something");
      for (const farm::Recording& each : recordings) fuzz::hold(trace::is_hash_text(each.expected), "a recording has its hash");
    }
  } catch (const InputError& error) {
    fuzz::hold(std::string_view(error.what()).find('\n') == std::string_view::npos, "what is wrong is said in one line");
  }
  return 0;
}
