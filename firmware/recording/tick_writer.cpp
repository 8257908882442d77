#include "firmware/recording/tick_writer.h"

namespace isotouch::recording {

TraceRecord RecordMaker::operator()(const loop::TickRecord& tick) {
  if (!begun_) first_ns_ = tick.arrival_ns;
  begun_ = true;
  const std::int64_t since_ns = tick.arrival_ns > first_ns_ ? tick.arrival_ns - first_ns_ : 0;
  return {tick.in, tick.out, chain_.extend(tick.in, tick.out), static_cast<std::uint64_t>(since_ns)};
}

Refusal TickWriter::begin(const std::string& path, const TraceHeader& header, files::Leftover leftover) {
  TraceHeader written = header;
  written.field_hash = 0;
  written.has_outputs = true;
  records_ = RecordMaker(written);
  return file_.begin(path, written, leftover);
}

Refusal TickWriter::append(const loop::TickRecord& tick) { return is_open() ? file_.append(records_(tick)) : std::string(); }

Refusal TickWriter::finish(std::uint64_t field_hash) {
  file_.set_field_hash(field_hash);
  return file_.finish(files::Keep::kWhatFits);
}

}  // namespace isotouch::recording
