#include "host/farm/task.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <functional>
#include <set>

#include "host/error.h"
#include "host/farm/json_lines.h"
#include "host/field_file/open_field.h"
#include "host/files/file_nature.h"
#include "host/files/whole_file.h"
#include "host/trace/hash_text.h"
#include "host/trace/recorded_patches.h"
#include "host/trace/replay.h"
#include "host/trace/trace_diff.h"
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

/// In the order of their names. Of a link its target's name, which may be meant for another machine.
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

/// Adds a word to a program's command, as it is given to the system.
void add_word(Program& program, const std::string& word, const fs::path& folder, Digest& content, const std::string& place) {
  content.add(word);
  const fs::path named = named_by(word, folder);
  program.command.push_back(named.empty() ? word : fs::absolute(named).string());
  if (named.empty()) return;
  if (!fs::exists(named)) throw InputError(place + ": " + named.string() + " is not there; build it, or correct the command");
  if (!fs::is_regular_file(named) && !fs::is_directory(named)) return;
  program.files.push_back({named, hash_of(named)});
  content.add(program.files.back().hash);
}

/// Of a recording that is cut off, programs would be asked about a part, and nobody about the rest.
void require_whole(const trace::Trace& trace) {
  if (!trace.cut_off().empty())
    throw InputError(trace.cut_off() + "; copy it again, or keep what there is with isotouch replay --check -o, and name that file");
}

/// Fills in the hashes of a recording's files, and its patches.
void add_hashes(Recording& recording, const trace::Trace& trace) {
  if (trace::patch_bytes(trace)) recording.patches.path = trace::patches_of(recording.trace.path);
  for (NamedFile* file : {&recording.field, &recording.trace, &recording.patches})
    if (!file->path.empty()) file->hash = hash_of(file->path);
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

std::string hash_of(const fs::path& file) {
  Digest digest;
  try {
    if (fs::is_directory(file)) {
      add_folder(file, digest);
    } else {
      digest.add(read_file(file));
    }
  } catch (const fs::filesystem_error& error) {
    throw InputError(error.path1().string() + ": cannot be read: " + error.code().message());
  }
  return digest.text();
}

void require_same(const NamedFile& file) {
  if (hash_of(file.path) == file.hash) return;
  if (nature_of(file.path) == FileNature::kPointer) throw InputError(file.path.string() + kIsPointer);
  throw InputError(file.path.string() +
                   " is no longer the file of the table; remove the recording's line, and add it anew with isotouch farm add");
}

std::vector<NamedFile> files_of(const Recording& recording) {
  std::vector<NamedFile> files = {recording.field, recording.trace};
  if (!recording.patches.path.empty()) files.push_back(recording.patches);
  return files;
}

Recording as_recorded(Recording recording) {
  const trace::Trace trace = trace::read_trace(recording.trace.path);
  require_whole(trace);
  trace::require_a_recording(trace);
  const std::uint64_t named = trace.header().field_hash;
  const field_file::OpenField field = field_file::open_field(recording.field.path);
  if (named != 0 && named != field.view.hash())
    throw InputError(recording.trace.path.string() + ": " + describe(Error::kWrongField) + ", " + trace::hash_text(named) +
                     "; give that one");
  trace::require_a_beginning(trace);
  add_hashes(recording, trace);
  recording.expected = trace::hash_text(trace.record(trace.size() - 1).chain);
  return recording;
}

std::vector<Recording> read_recordings(const fs::path& file) {
  std::vector<Recording> all;
  std::set<std::string> names;
  each_line(file, [&](const Line& line) {
    const auto named = [&](const char* key, const char* hash) { return NamedFile{file.parent_path() / line.text(key), line.hash(hash)}; };
    all.push_back({line.text("name"), named("field", "field_hash"), named("trace", "trace_hash"),
                   line.has("patches") ? named("patches", "patches_hash") : NamedFile{}, line.hash("expected"), line.text("device"),
                   line.text("origin")});
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
    Program program{line.text("processor"), line.text("commit"), line.text("compiler"), line.text("rung"), {}, {}, {}};
    if (!names.insert({program.processor, program.commit, program.compiler, program.rung}).second)
      throw InputError(line.place() + ": processor, commit, compiler and rung are those of a line above; leave one of the two out");
    Digest content;
    for (const std::string& word : line.texts("command")) add_word(program, word, file.parent_path(), content, line.place());
    if (std::ranges::all_of(program.files, [](const NamedFile& named) { return fs::is_directory(named.path); }))
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
  const field_file::OpenField field = field_file::open_field(recording.field.path);
  const trace::Trace trace = trace::read_trace(recording.trace.path);
  require_whole(trace);
  const trace::ReplayReport report = trace::replay(field.view, trace, true);
  if (report.first_difference) {
    throw InputError(recording.trace.path.string() + ": tick " + std::to_string(report.first_difference->tick) +
                     " does not answer as recorded; add a recording that `isotouch replay --check` accepts");
  }
  const auto beside = [&](const fs::path& file) { return fs::proximate(fs::absolute(file), fs::absolute(table).parent_path()).string(); };
  Recording found = recording;
  add_hashes(found, trace);
  nlohmann::ordered_json line = {{"name", found.name},
                                 {"field", beside(found.field.path)},
                                 {"trace", beside(found.trace.path)},
                                 {"field_hash", found.field.hash},
                                 {"trace_hash", found.trace.hash},
                                 {"expected", trace::hash_text(report.hash)},
                                 {"device", trace::hash_text(hash(trace.header().device))},
                                 {"origin", found.origin}};
  if (!found.patches.path.empty()) line["patches"] = beside(found.patches.path), line["patches_hash"] = found.patches.hash;
  for (const auto& [key, value] : line.items()) {
    if (!is_printable(value.get_ref<const std::string&>()))
      throw InputError(recording.trace.path.string() + ": " + key + " is no UTF-8 or holds a control character; rename it");
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
  for (const NamedFile& file : files_of(recording)) digest.add(file.hash);
  for (const std::string* text :
       {&recording.expected, &program.content, &program.processor, &program.commit, &program.compiler, &program.rung})
    digest.add(*text);
  return digest.text();
}

}  // namespace isotouch::farm
