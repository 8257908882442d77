/// A trace file in memory (SPEC.md, section 3): read whole, checked once.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "shared/files/refusal.h"
#include "shared/trace.h"

namespace isotouch::files {

/// The records of one file. After `read_trace` every record is known to be well formed, and all have one kind of input.
class TraceFile {
 public:
  TraceFile() = default;
  /// Of records in memory.
  ///
  /// path      where they come from, for sentences
  /// header    its record count is ignored and counted instead
  TraceFile(std::string path, const TraceHeader& header, std::span<const TraceRecord> records);

  const TraceHeader& header() const { return header_; }
  const std::string& path() const { return path_; }
  /// Where the patches of its field are; empty: beside it.
  const std::string& patches() const { return patches_; }
  void set_patches(std::string path) { patches_ = std::move(path); }
  /// One sentence where the file ends before it should: how much of it there is, and what is missing. Else empty.
  const std::string& cut_off() const { return cut_off_; }
  /// One sentence where a record's chain does not follow, as its bytes were changed after they were recorded. Else empty.
  const std::string& damage() const { return damage_; }
  std::size_t size() const { return bytes_.size() / trace_layout::kRecordBytes; }
  /// Of all inputs; an empty trace counts as one of positions.
  InputKind kind() const { return size() == 0 ? InputKind::kPosition : record(0).input.kind; }

  /// tick      0 to size() - 1
  TraceRecord record(std::size_t tick) const;
  /// The recorded chain after a tick: one look-up, so that a bisection need not decode.
  std::uint64_t chain(std::size_t tick) const;
  /// Does the record's chain follow from its own bytes and the chain before it? If not, the bytes were changed after they were recorded.
  bool chain_follows(std::size_t tick) const;

 private:
  void drop_what_is_torn(std::uint64_t promised);

  friend Refusal read_trace(const std::string& path, TraceFile& trace);
  std::span<const std::uint8_t, trace_layout::kRecordBytes> at(std::size_t tick) const;

  std::string path_, patches_, cut_off_, damage_;
  TraceHeader header_;
  std::vector<std::uint8_t> bytes_;  ///< the records, without the header
};

/// Reads and checks a whole file: header, size, every record; without outputs, that nothing stands where they would be. Of a file that was cut off, by a
/// kill or a full disk, the records up to the first that is not whole or does not follow from those before it; `cut_off` says so. Of a whole file all records;
/// whether they follow from each other, `damage` says.
///
/// returns   file and place, what is wrong and what to do
Refusal read_trace(const std::string& path, TraceFile& trace);

}  // namespace isotouch::files
