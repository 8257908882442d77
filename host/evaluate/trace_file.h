/// Trace files (shared/SPEC.md, section 3): read whole and checked once, written as a stream of any length.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <vector>

#include "shared/trace.h"

namespace isotouch::evaluate {

/// The records of one file. After `read` every record is known to be well formed.
class Trace {
 public:
  /// Reads and checks the whole file: header, size, every record; without outputs, that nothing stands where they would be.
  ///
  /// fails     InputError naming the file, and the record and its byte where there is one
  static Trace read(const std::filesystem::path& file);

  const TraceHeader& header() const { return header_; }
  /// For sentences about it.
  const std::filesystem::path& file() const { return file_; }
  std::size_t size() const { return bytes_.size() / trace_layout::kRecordBytes; }

  /// tick      0 to size() - 1
  TraceRecord record(std::size_t tick) const;
  /// The recorded chain after a tick: one look-up, so that a bisection need not decode.
  std::uint64_t chain(std::size_t tick) const;
  /// Does the record's chain follow from its own bytes and the chain before it? If not, the bytes were changed after they were recorded.
  bool chain_follows(std::size_t tick) const;

 private:
  const std::uint8_t* at(std::size_t tick) const { return bytes_.data() + tick * trace_layout::kRecordBytes; }

  std::filesystem::path file_;
  TraceHeader header_;
  std::vector<std::uint8_t> bytes_;  ///< the records, without the header
};

/// Writes records beside `file` and renames at the end: the old file or the whole new one, never a part.
class TraceWriter {
 public:
  /// header    its record count is ignored and counted instead
  /// fails     InputError naming the file
  TraceWriter(std::filesystem::path file, const TraceHeader& header);
  /// Without `finish` nothing remains.
  ~TraceWriter();
  TraceWriter(const TraceWriter&) = delete;
  TraceWriter& operator=(const TraceWriter&) = delete;

  void append(const TraceRecord& record);
  /// fails     InputError naming the file, also for what failed earlier
  void finish();

 private:
  std::filesystem::path file_;
  std::filesystem::path part_;
  std::ofstream out_;
  TraceHeader header_;
  bool finished_ = false;
};

}  // namespace isotouch::evaluate
