/// The trace: what entered each tick and what left it (SPEC.md, section 3). Encoding and the hash chain; files are their neighbours' business.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "shared/result.h"
#include "shared/tick_io.h"

namespace isotouch {

namespace trace_layout {
inline constexpr std::array<std::uint8_t, 4> kMagic = {'I', 'T', 'R', 'C'};
inline constexpr std::uint16_t kMajor = 1;
inline constexpr std::uint16_t kMinor = 1;
inline constexpr std::size_t kHeaderBytes = 96;
inline constexpr std::size_t kRecordBytes = 72;
inline constexpr std::size_t kChainBegin = 24;  ///< the header's bytes 24 to 63 seed the chain
inline constexpr std::size_t kChainEnd = 64;
inline constexpr std::size_t kFeelAt = 64;  ///< further settings, which enter the seed where they are not all zero
inline constexpr std::size_t kFeelBytes = 28;
inline constexpr std::size_t kRecordChainBytes = 56;  ///< a record's bytes 0 to 55 enter the chain
inline constexpr std::uint32_t kHasOutputs = 1U << 0;
inline constexpr std::uint32_t kEncoderCounts = 1U << 1;
}  // namespace trace_layout

using TraceHeaderBytes = std::array<std::uint8_t, trace_layout::kHeaderBytes>;
using TraceRecordBytes = std::array<std::uint8_t, trace_layout::kRecordBytes>;

struct TraceHeader {
  std::uint64_t record_count = 0;
  std::uint64_t blob_hash = 0;   ///< 0 = any
  std::uint64_t model_hash = 0;  ///< 0 = inputs are HIP positions
  std::uint32_t period_ns = 1'000'000;
  std::uint32_t flags = 0;
  TickSettings settings;

  bool has_outputs() const { return (flags & trace_layout::kHasOutputs) != 0; }
};

struct TraceRecord {
  TickInput input;
  TickOutput output;
  std::uint64_t chain = 0;
  std::uint64_t arrival_ns = 0;  ///< since the first record; outside the chain
};

/// fails     never
TraceHeaderBytes encode(const TraceHeader& header);

/// Checks the header's 96 bytes and the size of the file that follows it.
///
/// fails     kTruncated, kBadMagic, kBadVersion, kBadHeader (a field outside SPEC's range), kBadSize (record count against file size), kBadChecksum
Result<TraceHeader> decode_header(std::span<const std::uint8_t> bytes, std::uint64_t file_bytes);

/// tick      yes
TraceRecordBytes encode(const TraceRecord& record);

/// fails     kBadRecord: an undefined flag, a reserved byte that is not zero, a fresh sample with an age
Result<TraceRecord> decode_record(std::span<const std::uint8_t, trace_layout::kRecordBytes> bytes);

/// Bytes 16 to 63 of a header: counts, hashes, period, flags and settings stand there in every major version.
void store_run(const TraceHeader& header, std::uint8_t* bytes);
/// returns   false when the period or a setting is outside SPEC's range; flags are the version's business
bool load_run(const std::uint8_t* bytes, TraceHeader& header);

/// The kFeelBytes of further settings, SPEC.md 3.1; version 0 has zeros there.
void store_feel(const TickSettings& settings, std::uint8_t* bytes);
/// returns   false when a setting is outside SPEC's range
bool load_feel(const std::uint8_t* bytes, TickSettings& settings);
/// The chain's seed of a header: that of version 0, and the further settings where there are any.
std::uint64_t chain_seed(std::span<const std::uint8_t> always, const std::uint8_t* feel);

/// The major version of a trace that begins with these bytes.
///
/// fails     kBadMagic
Result<std::uint16_t> trace_major(std::span<const std::uint8_t> bytes);

/// The rolling hash over everything that a run saw and said. Equal chains mean equal histories.
///
/// tick      yes: `extend` costs one XXH64 of 56 bytes
class Chain {
 public:
  /// blob_hash   of the image that is really used, also when the trace says "any"
  Chain(const TraceHeader& header, std::uint64_t blob_hash);
  /// Takes in one tick and returns the chain after it, which is also what the record stores.
  std::uint64_t extend(const TickInput& input, const TickOutput& output);
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_;
};

}  // namespace isotouch
