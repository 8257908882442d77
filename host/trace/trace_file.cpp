#include "host/trace/trace_file.h"

#include <unistd.h>

#include <cstdio>
#include <string>
#include <system_error>
#include <vector>

#include "host/error.h"
#include "host/files/whole_file.h"

namespace isotouch::trace {

namespace {

void or_throw(const Refusal& refusal) {
  if (refusal) throw InputError(refusal.sentence());
}

/// A file of this process's own.
std::filesystem::path aside() { return std::filesystem::temp_directory_path() / ("isotouch-" + std::to_string(::getpid()) + ".trace"); }

}  // namespace

Trace read_trace(const std::filesystem::path& file) {
  Trace trace;
  if (is_standard(file)) claim_standard_input();
  or_throw(files::read_trace(is_standard(file) ? "/dev/stdin" : file.string(), trace));
  if (!trace.cut_off().empty()) std::fprintf(stderr, "isotouch: %s\n", trace.cut_off().c_str());
  return trace;
}

Trace read_trace(const std::filesystem::path& file, InputKind kind) {
  Trace trace = read_trace(file);
  if (trace.kind() == kind) return trace;
  throw InputError(file.string() +
                   (kind == InputKind::kPacket
                        ? ": holds positions of a hand, this needs the packets of a device; make some with isotouch trace to-packets"
                        : ": holds the packets of a device, this needs positions of a hand"));
}

TraceWriter::TraceWriter(const std::filesystem::path& file, const TraceHeader& header) : to_standard_(is_standard(file)) {
  or_throw(writer_.begin(to_standard_ ? aside().string() : file.string(), header));
}

void TraceWriter::finish() {
  or_throw(writer_.finish(files::Keep::kAllOrNothing));
  pass_on();
}

void TraceWriter::pass_on() const {
  if (!to_standard_) return;
  const std::vector<std::uint8_t> bytes = read_file(aside());
  std::error_code ignored;
  std::filesystem::remove(aside(), ignored);
  write_file("-", bytes.data(), bytes.size());
}

TraceWriter::Kept TraceWriter::finish_with_what_fits() {
  const Refusal refusal = writer_.finish(files::Keep::kWhatFits);
  if (writer_.records() == 0) throw InputError(refusal ? refusal.sentence() : writer_.path() + ": nothing was recorded");
  pass_on();
  return {writer_.records(), writer_.chain()};
}

}  // namespace isotouch::trace
