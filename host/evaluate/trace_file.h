/// Trace files (shared/SPEC.md, sections 3 and 5): read whole and checked once, written as a stream of any length.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <span>
#include <vector>

#include "shared/device_trace.h"
#include "shared/trace.h"

namespace isotouch::evaluate {

/// Major version 1: where the hand is goes in.
struct HipFormat {
  using Header = TraceHeader;
  using Record = TraceRecord;
  static constexpr std::uint16_t kMajor = trace_layout::kMajor;
  static constexpr std::size_t kHeaderBytes = trace_layout::kHeaderBytes;
  static constexpr std::size_t kRecordBytes = trace_layout::kRecordBytes;
  static constexpr std::size_t kOutputAt = 16;
  static constexpr std::size_t kChainAt = trace_layout::kRecordChainBytes;
  static const TraceHeader& run(const Header& header) { return header; }
  static TraceHeader& run(Header& header) { return header; }
  static Result<Header> decode(std::span<const std::uint8_t> bytes, std::uint64_t file_bytes) { return decode_header(bytes, file_bytes); }
  static Result<Record> decode(std::span<const std::uint8_t, kRecordBytes> bytes) { return decode_record(bytes); }
  /// The chain before the first record.
  static std::uint64_t first_chain(const Header& header) { return Chain(header, header.blob_hash).value(); }
};

/// Major version 2: a device's packets go in.
struct WireFormat {
  using Header = DeviceTraceHeader;
  using Record = DeviceTraceRecord;
  static constexpr std::uint16_t kMajor = device_trace_layout::kMajor;
  static constexpr std::size_t kHeaderBytes = device_trace_layout::kHeaderBytes;
  static constexpr std::size_t kRecordBytes = device_trace_layout::kRecordBytes;
  static constexpr std::size_t kOutputAt = device_trace_layout::kOutputAt;
  static constexpr std::size_t kChainAt = device_trace_layout::kChainAt;
  static const TraceHeader& run(const Header& header) { return header.run; }
  static TraceHeader& run(Header& header) { return header.run; }
  static Result<Header> decode(std::span<const std::uint8_t> bytes, std::uint64_t file_bytes) {
    return decode_device_header(bytes, file_bytes);
  }
  static Result<Record> decode(std::span<const std::uint8_t, kRecordBytes> bytes) { return decode_device_record(bytes); }
  static std::uint64_t first_chain(const Header& header) { return DeviceChain(header).value(); }
};

/// The major version of a trace file.
///
/// fails     InputError naming the file: it is none, or of a version that this program does not know
std::uint16_t trace_major(const std::filesystem::path& file);

/// The records of one file. After `read` every record is known to be well formed.
template <class Format>
class TraceFile {
 public:
  /// Reads and checks the whole file: header, size, every record; without outputs, that nothing stands where they would be.
  ///
  /// fails     InputError naming the file, and the record and its byte where there is one
  static TraceFile read(const std::filesystem::path& file);

  /// Of records in memory.
  ///
  /// file      where they come from, for sentences
  /// header    its record count is ignored and counted instead
  TraceFile(std::filesystem::path file, const typename Format::Header& header, std::span<const typename Format::Record> records);

  const typename Format::Header& header() const { return header_; }
  /// For sentences about it.
  const std::filesystem::path& file() const { return file_; }
  std::size_t size() const { return bytes_.size() / Format::kRecordBytes; }

  /// tick      0 to size() - 1
  typename Format::Record record(std::size_t tick) const;
  /// The recorded chain after a tick: one look-up, so that a bisection need not decode.
  std::uint64_t chain(std::size_t tick) const;
  /// Does the record's chain follow from its own bytes and the chain before it? If not, the bytes were changed after they were recorded.
  bool chain_follows(std::size_t tick) const;

 private:
  TraceFile() = default;
  const std::uint8_t* at(std::size_t tick) const { return bytes_.data() + tick * Format::kRecordBytes; }

  std::filesystem::path file_;
  typename Format::Header header_;
  std::vector<std::uint8_t> bytes_;  ///< the records, without the header
};

/// Writes records beside `file` and renames at the end: the old file or the whole new one, never a part.
template <class Format>
class TraceFileWriter {
 public:
  /// header    its record count is ignored and counted instead
  /// fails     InputError naming the file
  TraceFileWriter(std::filesystem::path file, const typename Format::Header& header);
  /// Without `finish` nothing remains.
  ~TraceFileWriter();
  TraceFileWriter(const TraceFileWriter&) = delete;
  TraceFileWriter& operator=(const TraceFileWriter&) = delete;

  void append(const typename Format::Record& record);
  /// Has a write failed? What is appended then is lost.
  bool is_full() const { return !out_; }
  /// fails     InputError naming the file, also for what failed earlier
  void finish();
  struct Kept {
    std::uint64_t records = 0;
    std::uint64_t chain = 0;  ///< of the last one
  };
  /// For what cannot be made again: when the disk is full, the whole records that it took.
  /// fails     InputError naming the file, when it took none
  Kept finish_with_what_fits();

 private:
  void write_pending();

  std::filesystem::path file_;
  std::filesystem::path part_;
  std::ofstream out_;                  ///< without a buffer: what the file holds after a failure is a beginning of what was written
  std::vector<std::uint8_t> pending_;  ///< its buffer
  typename Format::Header header_;
  std::uint64_t chain_ = 0;  ///< of the last record
  bool finished_ = false;
};

using Trace = TraceFile<HipFormat>;
using TraceWriter = TraceFileWriter<HipFormat>;
using DeviceTrace = TraceFile<WireFormat>;
using DeviceTraceWriter = TraceFileWriter<WireFormat>;

}  // namespace isotouch::evaluate
