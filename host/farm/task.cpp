#include "host/farm/task.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <functional>
#include <set>

#include "host/error.h"
#include "host/farm/json_lines.h"
#include "host/field_file/open_field.h"
#include "host/files/whole_file.h"
#include "host/trace/hash_text.h"
#include "host/trace/replay.h"
#include "host/trace/trace_file.h"
#include "shared/files/scoped_file.h"
#include "shared/hash64.h"
#include "shared/printable.h"

namespace isotouch::farm {
namespace {

namespace fs = std::filesystem;

/// Text and numbers that enter a hash one after the other.
class Digest {
 public:
  void add(const std::vector<std::uint8_t>& bytes) { value_ = hash64(bytes.data(), bytes.size(), value_); }
  void add(const std::string& text) { value_ = hash64(reinterpret_cast<const std::uint8_t*>(text.data()), text.size(), value_); }
  std::string text() const { return trace::hash_text(value_); }

 private:
  std::uint64_t value_ = 0;
};

template <class Row>
void require_rows(const fs::path& file, const std::vector<Row>& rows, const char* what) {
  if (rows.empty()) throw InputError(file.string() + ": it lists no " + what + "; write one JSON object a line");
}

/// A word that begins with ./ is a file or folder beside the table; other words name nothing.
fs::path named_by(const std::string& word, const fs::path& folder) { return word.starts_with("./") ? folder / word.substr(2) : fs::path(); }

/// The names and bytes of all files below a folder, in the order of their names. Of a link its target's name, which may be meant for another machine.
void add_folder(const fs::path& folder, Digest& content) {
  std::set<fs::path> all;
  for (const fs::directory_entry& each : fs::recursive_directory_iterator(folder)) all.insert(each.path());
  for (const fs::path& each : all) {
    content.add(each.lexically_relative(folder).string());
    if (fs::is_symlink(each)) {
      content.add(fs::read_symlink(each).string());
    } else if (fs::is_regular_file(each)) {
      content.add(read_file(each));
    }
  }
}

/// A word of a command as it is given to the system.
std::string resolved(const std::string& word, const fs::path& folder, Digest& content, const std::string& place) {
  content.add(word);
  const fs::path named = named_by(word, folder);
  if (named.empty()) return word;
  if (!fs::exists(named)) throw InputError(place + ": " + named.string() + " is not there; build it, or correct the command");
  if (fs::is_regular_file(named)) content.add(read_file(named));
  if (fs::is_directory(named)) add_folder(named, content);
  return fs::absolute(named).string();
}

/// Adds a line to a table that others may add to at the same time.
///
/// check     called while nobody else adds one; may throw
void append_line(const fs::path& table, std::string line, const std::function<void()>& check) {
  const auto fail = [&] { return InputError(table.string() + ": cannot be written: " + std::strerror(errno)); };
  const ScopedFile file(::open(table.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666));
  if (file.number < 0 || ::flock(file.number, LOCK_EX) != 0) throw fail();
  check();
  const off_t size = ::lseek(file.number, 0, SEEK_END);
  char last = '\n';
  if (size > 0 && ::pread(file.number, &last, 1, size - 1) != 1) throw fail();
  line = (last == '\n' ? "" : "\n") + line + '\n';
  if (::write(file.number, line.data(), line.size()) == static_cast<ssize_t>(line.size())) return;
  const InputError failed = fail();
  if (::ftruncate(file.number, size) != 0) throw fail();
  throw failed;
}

}  // namespace

std::string hash_of_file(const fs::path& file) {
  Digest digest;
  digest.add(read_file(file));
  return digest.text();
}

std::string recorded_hash(const fs::path& file) {
  const trace::Trace trace = trace::read_trace(file);
  if (!trace.header().has_outputs || trace.size() == 0)
    throw InputError(file.string() + ": it has no outputs to compare with; record it anew, or make them with isotouch replay -o");
  return trace::hash_text(trace.record(trace.size() - 1).chain);
}

std::vector<Recording> read_recordings(const fs::path& file) {
  std::vector<Recording> all;
  std::set<std::string> names;
  each_line(file, [&](const Line& line) {
    const fs::path folder = file.parent_path();
    all.push_back({line.text("name"), folder / line.text("field"), folder / line.text("trace"), line.hash("field_hash"),
                   line.hash("trace_hash"), line.hash("expected"), line.text("device"), line.text("origin")});
    if (!names.insert(all.back().name).second)
      throw InputError(line.place() + ": there are two recordings with the name '" + all.back().name + "'; rename one");
  });
  require_rows(file, all, "recordings");
  return all;
}

std::vector<Program> read_programs(const fs::path& file) {
  std::vector<Program> all;
  std::set<std::vector<std::string>> names;
  each_line(file, [&](const Line& line) {
    Program program{line.text("processor"), line.text("commit"), line.text("compiler"), line.text("rung"), {}, {}};
    if (!names.insert({program.processor, program.commit, program.compiler, program.rung}).second)
      throw InputError(line.place() + ": processor, commit, compiler and rung are those of a line above; leave one of the two out");
    Digest content;
    bool is_named = false;
    for (const std::string& word : line.texts("command")) {
      program.command.push_back(resolved(word, file.parent_path(), content, line.place()));
      is_named = is_named || fs::is_regular_file(named_by(word, file.parent_path()));
    }
    if (!is_named)
      throw InputError(
          line.place() +
          ": no word of the command names a file by ./, so a new build would be taken for the old one; put the program beside the table");
    program.content = content.text();
    all.push_back(std::move(program));
  });
  require_rows(file, all, "programs");
  return all;
}

void add_recording(const fs::path& table, const Recording& recording) {
  if (recording.name.empty() || recording.origin.empty()) throw InputError("a recording needs a name and an origin; give both a text");
  const field_file::OpenField field = field_file::open_field(recording.field);
  const trace::Trace trace = trace::read_trace(recording.trace);
  const trace::ReplayReport report = trace::replay(field.view, trace, true);
  if (report.first_difference) {
    throw InputError(recording.trace.string() + ": tick " + std::to_string(report.first_difference->tick) +
                     " does not answer as recorded; add a recording that `isotouch replay --check` accepts");
  }
  const auto beside = [&](const fs::path& file) { return fs::proximate(fs::absolute(file), fs::absolute(table).parent_path()).string(); };
  const nlohmann::ordered_json line = {{"name", recording.name},
                                       {"field", beside(recording.field)},
                                       {"trace", beside(recording.trace)},
                                       {"field_hash", hash_of_file(recording.field)},
                                       {"trace_hash", hash_of_file(recording.trace)},
                                       {"expected", trace::hash_text(report.hash)},
                                       {"device", trace::hash_text(hash(trace.header().device))},
                                       {"origin", recording.origin}};
  for (const auto& [key, value] : line.items()) {
    if (!is_printable(value.get_ref<const std::string&>()))
      throw InputError(recording.trace.string() + ": " + key + " is no UTF-8 or holds a control character; rename it");
  }
  append_line(table, line.dump(), [&] {
    if (fs::file_size(table) == 0) return;
    for (const Recording& known : read_recordings(table)) {
      if (known.name == recording.name)
        throw InputError(table.string() + ": a recording with the name '" + recording.name + "' is there; choose another with --name");
    }
  });
}

std::string address_of(const Recording& recording, const Program& program) {
  Digest digest;
  for (const std::string* text : {&recording.field_hash, &recording.trace_hash, &recording.expected, &program.content, &program.processor,
                                  &program.commit, &program.compiler, &program.rung})
    digest.add(*text);
  return digest.text();
}

}  // namespace isotouch::farm
