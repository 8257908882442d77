#include "host/trace/trace_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "host/error.h"
#include "host/files/file_nature.h"
#include "host/files/whole_file.h"

namespace isotouch::trace {

namespace {

void or_throw(const Refusal& refusal) {
  if (refusal) throw InputError(refusal.sentence());
}

InputError refused(const std::filesystem::path& file, const Refusal& refusal) {
  switch (nature_of(file)) {
    case FileNature::kField: return InputError(file.string() + ": is a field, no trace; name a recording");
    case FileNature::kPatches: return InputError(file.string() + ": holds patches, no trace; name the recording beside it");
    case FileNature::kPointer: return InputError(file.string() + kIsPointer);
    case FileNature::kTrace:
    case FileNature::kUnknown: break;
  }
  return InputError(refusal.sentence());
}

/// An empty file without a name, which goes with the program.
int nameless_file() {
  std::string pattern = (std::filesystem::temp_directory_path() / "isotouch-XXXXXX").string();
  const int file = ::mkostemp(pattern.data(), O_CLOEXEC);
  if (file < 0) throw InputError(pattern + ": no file can be made there: " + std::strerror(errno) + "; free space, or set TMPDIR");
  ::unlink(pattern.c_str());
  return file;
}

}  // namespace

Trace read_trace(const std::filesystem::path& file, Damaged damaged) {
  Trace trace;
  if (is_standard(file)) claim_standard_input();
  if (const Refusal refusal = files::read_trace(is_standard(file) ? "/dev/stdin" : file.string(), trace)) throw refused(file, refusal);
  if (!trace.damage().empty() && damaged == Damaged::kRefuse) throw InputError(trace.damage());
  for (const std::string& sentence : {trace.cut_off(), trace.damage()}) {
    if (!sentence.empty()) std::fprintf(stderr, "isotouch: %s\n", sentence.c_str());
  }
  return trace;
}

Trace read_trace(const std::filesystem::path& file, InputKind kind) {
  Trace trace = read_trace(file);
  if (trace.kind() == kind) return trace;
  throw InputError(file.string() +
                   (kind == InputKind::kPacket
                        ? ": holds positions of a hand, this needs the packets of a device; make some with isotouch trace to-packets"
                        : ": is a recording of packets already; use it as it is, or name a trace that trace make or trace import wrote"));
}

TraceWriter::TraceWriter(const std::filesystem::path& file, const TraceHeader& header, files::Leftover leftover)
    : aside_(is_standard(file) ? nameless_file() : -1) {
  or_throw(aside_.number < 0 ? writer_.begin(file.string(), header, leftover) : writer_.begin(file.string(), header, aside_.number));
}

void TraceWriter::finish() {
  or_throw(writer_.finish(files::Keep::kAllOrNothing));
  pass_on();
}

void TraceWriter::pass_on() const {
  if (aside_.number < 0) return;
  std::vector<std::uint8_t> bytes(std::size_t{1} << 20);
  off_t from = 0;
  for (ssize_t size = 0; (size = ::pread(aside_.number, bytes.data(), bytes.size(), from)) != 0; from += size) {
    if (size < 0) throw InputError(std::string("-: what was put aside cannot be read again: ") + std::strerror(errno));
    write_file("-", bytes.data(), static_cast<std::size_t>(size));
  }
}

TraceWriter::Kept TraceWriter::finish_with_what_fits() {
  const Refusal refusal = writer_.finish(files::Keep::kWhatFits);
  if (writer_.records() == 0) throw InputError(refusal ? refusal.sentence() : writer_.path() + ": nothing was recorded");
  pass_on();
  return {writer_.records(), writer_.chain()};
}

}  // namespace isotouch::trace
