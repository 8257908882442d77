/// Ticks as they come from the loop → records of a trace file.
#pragma once

#include <cstdint>
#include <string>

#include "firmware/loop/tick_record.h"
#include "shared/files/refusal.h"
#include "shared/files/trace_writer.h"
#include "shared/trace.h"

namespace isotouch::recording {

/// From ticks to records: goes on with the chain, and counts arrival times from the first.
class RecordMaker {
 public:
  explicit RecordMaker(const TraceHeader& header) : chain_(header) {}
  TraceRecord operator()(const loop::TickRecord& tick);

 private:
  Chain chain_;
  std::int64_t first_ns_ = 0;
  bool begun_ = false;
};

/// Writes one recording to a file; see `files::TraceWriter`. Used by one thread.
class TickWriter {
 public:
  /// header    device, settings and period
  /// returns   none when it has begun, and only then it is open
  Refusal begin(const std::string& path, const TraceHeader& header, files::Leftover leftover = files::Leftover::kReplace);

  /// returns   the file takes no more, which may be so since some ticks before; `finish` keeps what it took whole
  Refusal append(const loop::TickRecord& tick);

  /// The hash of the field that the ticks feel, as soon as it is known: for the file of a program that is killed.
  void name_field(std::uint64_t hash) { file_.set_field_hash(hash); }

  /// Completes the file with the records that arrived there whole. Without a record there is none.
  ///
  /// field_hash  of the field that the ticks felt; 0 = none
  /// returns     why there is no file under its name, or why it holds less than was appended, and how much
  Refusal finish(std::uint64_t field_hash);

  /// Leaves nothing behind.
  void discard() { file_.discard(); }

  bool is_open() const { return file_.is_open(); }
  const std::string& path() const { return file_.path(); }
  /// Appended; after `finish`, in the file.
  std::uint64_t records() const { return file_.records(); }

 private:
  files::TraceWriter file_;
  RecordMaker records_{TraceHeader{}};
};

}  // namespace isotouch::recording
