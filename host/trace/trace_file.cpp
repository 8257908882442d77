#include "host/trace/trace_file.h"

#include <string>

#include "host/error.h"

namespace isotouch::trace {

namespace {

void or_throw(const Refusal& refusal) {
  if (refusal) throw InputError(refusal.sentence());
}

}  // namespace

Trace read_trace(const std::filesystem::path& file) {
  Trace trace;
  or_throw(files::read_trace(file.string(), trace));
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

TraceWriter::TraceWriter(const std::filesystem::path& file, const TraceHeader& header) { or_throw(writer_.begin(file.string(), header)); }

void TraceWriter::finish() { or_throw(writer_.finish(files::Keep::kAllOrNothing)); }

TraceWriter::Kept TraceWriter::finish_with_what_fits() {
  const Refusal refusal = writer_.finish(files::Keep::kWhatFits);
  if (writer_.records() == 0) throw InputError(refusal ? refusal.sentence() : writer_.path() + ": nothing was recorded");
  return {writer_.records(), writer_.chain()};
}

}  // namespace isotouch::trace
