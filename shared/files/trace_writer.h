/// Writes a trace file as a stream. A file stands under its name only when it is complete.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "shared/files/part_file.h"
#include "shared/files/refusal.h"
#include "shared/trace.h"

namespace isotouch::files {

/// What to keep of a file that takes no more, because the disk is full.
enum class Keep : std::uint8_t {
  kAllOrNothing,
  kWhatFits,  ///< the whole records that it took
};

/// Writes to "NAME.part", and renames it at the end: the old file or the whole new one. A symbolic link stays, and what it leads to is replaced. Where the
/// program is killed, the part holds a valid header of an unfinished file and all records but the last few hundred. Used by one thread.
class TraceWriter {
 public:
  TraceWriter() = default;
  /// As `discard`.
  ~TraceWriter();
  TraceWriter(const TraceWriter&) = delete;
  TraceWriter& operator=(const TraceWriter&) = delete;

  /// header    its record count is ignored and counted instead
  /// leftover  what to do with a part of somebody who was killed
  /// returns   why not, also for a header that could not be read again; none when it has begun, and only then it is open
  Refusal begin(const std::string& path, const TraceHeader& header, Leftover leftover = Leftover::kReplace);
  /// The same into an empty file that is open for reading and writing, and is kept open by its owner. It gets no other name.
  ///
  /// path      for sentences
  Refusal begin(const std::string& path, const TraceHeader& header, int file);

  /// Where it is not open, nothing happens.
  ///
  /// returns   the file takes no more, which may be so since some records before
  Refusal append(const TraceRecord& record);

  /// Completes the file. Without a record there is none, unless all or nothing is wanted.
  ///
  /// returns   why there is no file under its name, or why it holds less than was appended, and how much
  Refusal finish(Keep keep);
  /// Leaves nothing behind.
  void discard();

  /// Of the header, also of the one that an unfinished file has.
  void set_field_hash(std::uint64_t hash);

  bool is_open() const { return file_ >= 0; }
  /// Has a write failed? What is appended then is lost.
  bool is_full() const { return failed_ != 0; }
  const std::string& path() const { return path_; }
  /// Appended; after `finish`, in the file.
  std::uint64_t records() const { return header_.record_count; }
  /// Of the last of them; 0 without one.
  std::uint64_t chain() const { return chain_; }

 private:
  Refusal check(const std::string& path, const TraceHeader& header);
  Refusal write_header();
  std::string part() const { return target_ + ".part"; }
  TraceHeaderBytes unfinished() const;
  bool flush();
  bool cut_to_whole_records();

  int file_ = -1;
  int failed_ = 0;                     ///< errno of the write that the file did not take
  std::vector<std::uint8_t> waiting_;  ///< to be written
  std::string path_;
  std::string target_;  ///< behind the links of path_; empty: the file is somebody else's
  TraceHeader header_;
  std::uint64_t chain_ = 0;
};

}  // namespace isotouch::files
