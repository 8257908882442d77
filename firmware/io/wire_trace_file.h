/// Recordings at the wire as files (SPEC.md, section 5): written as a stream, read whole. A file stands under its name only when it is complete.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "firmware/loop/tick_record.h"
#include "shared/device_trace.h"

namespace isotouch::io {

/// Writes one recording to "NAME.part", and renames it at the end. Used by one thread.
class WireTraceWriter {
 public:
  WireTraceWriter() = default;
  /// As `finish`, with no field.
  ~WireTraceWriter();
  WireTraceWriter(const WireTraceWriter&) = delete;
  WireTraceWriter& operator=(const WireTraceWriter&) = delete;

  /// header    device, settings and period
  /// returns   one sentence why not; empty when it has begun, and only then it is open
  std::string begin(const std::string& path, const DeviceTraceHeader& header);

  /// returns   one sentence when the file takes no more, which may be so since some ticks before; what it took whole is kept by `finish`
  std::string append(const loop::TickRecord& tick);

  /// Completes the file with the records that arrived there whole. Without a record there will be none.
  ///
  /// blob_hash of the field that the ticks felt; 0 = none
  /// returns   one sentence why there is no file under its name, or why it holds less than was appended, and how much
  [[nodiscard]] std::string finish(std::uint64_t blob_hash);

  bool is_open() const { return file_ >= 0; }
  const std::string& path() const { return path_; }
  /// Appended; after `finish`, in the file.
  std::uint64_t records() const { return header_.run.record_count; }

 private:
  std::string part() const { return path_ + ".part"; }

  bool flush();
  std::uint64_t whole_records() const;

  int file_ = -1;
  int failed_ = 0;                     ///< errno of the write that the file did not take
  std::vector<std::uint8_t> waiting_;  ///< to be written
  std::string path_;
  DeviceTraceHeader header_;
  DeviceChain chain_{DeviceTraceHeader{}};
  std::int64_t first_ns_ = 0;
};

struct WireTrace {
  DeviceTraceHeader header;
  std::vector<DeviceTraceRecord> records;
};

/// returns   one sentence with file and place why not; empty when all is well
std::string read_wire_trace(const std::string& path, WireTrace& trace);

}  // namespace isotouch::io
