/// Trace files for the host tool: `shared/files` with its sentences thrown as InputError.
#pragma once

#include <cstdint>
#include <filesystem>

#include "shared/files/scoped_file.h"
#include "shared/files/trace_file.h"
#include "shared/files/trace_writer.h"

namespace isotouch::trace {

using Trace = files::TraceFile;

/// What to do with a recording whose bytes were changed after they were recorded.
enum class Damaged {
  kRefuse,
  kReport,  ///< a sentence on standard error: for who looks for the damage
};

/// Of a file that was cut off, what is whole; a sentence on standard error says so.
///
/// file      `-` is standard input
/// fails     InputError naming the file, and the record and its byte where there is one
Trace read_trace(const std::filesystem::path& file, Damaged damaged = Damaged::kRefuse);

/// The same of a trace whose inputs are of this kind.
///
/// fails     also InputError: the inputs are of the other kind
Trace read_trace(const std::filesystem::path& file, InputKind kind);

/// Writes records beside `file` and renames at the end: the old file or the whole new one, never a part. Standard output (`-`) gets it at the end:
/// the header says how many records follow.
class TraceWriter {
 public:
  /// header    its record count is ignored and counted instead
  /// leftover  what to do with a part of somebody who was killed
  /// fails     InputError naming the file
  TraceWriter(const std::filesystem::path& file, const TraceHeader& header, files::Leftover leftover = files::Leftover::kReplace);

  void append(const TraceRecord& record) { (void)writer_.append(record); }  // `finish` says what went wrong
  /// Has a write failed? What is appended then is lost.
  bool is_full() const { return writer_.is_full(); }
  /// fails     InputError naming the file, also for what failed earlier; then nothing remains of it
  void finish();
  struct Kept {
    std::uint64_t records = 0;
    std::uint64_t chain = 0;  ///< of the last one
  };
  /// For what cannot be made again: when the disk is full, the whole records that it took.
  ///
  /// fails     InputError naming the file, when it took none
  Kept finish_with_what_fits();

 private:
  void pass_on() const;

  ScopedFile aside_;  ///< for standard output; else none is open
  files::TraceWriter writer_;
};

}  // namespace isotouch::trace
