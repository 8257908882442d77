/// The trace at the wire, major version 2 (SPEC.md, section 5): the device's packets as they came, and what the tick of a device answered. Encoding
/// and the hash chain; files are their neighbours' business.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "shared/device_io.h"
#include "shared/device_model.h"
#include "shared/result.h"
#include "shared/trace.h"

namespace isotouch {

namespace device_trace_layout {
inline constexpr std::uint16_t kMajor = 2;
inline constexpr std::uint16_t kMinor = 1;
inline constexpr std::size_t kHeaderBytes = 224;
inline constexpr std::size_t kRecordBytes = 96;
inline constexpr std::size_t kModelAt = 64;
inline constexpr std::size_t kFeelAt = 192;
inline constexpr std::size_t kChecksumAt = 220;
inline constexpr std::size_t kChainBegin = 32;  ///< the header's bytes 32 to 191 seed the chain: model, period, settings
inline constexpr std::size_t kChainEnd = 192;
inline constexpr std::size_t kRecordChainBytes = 80;  ///< a record's bytes 0 to 79 enter the chain
inline constexpr std::size_t kOutputAt = 24;          ///< inputs stand before it
inline constexpr std::size_t kSettingAt = 76;         ///< an input among the outputs: there was room
inline constexpr std::size_t kChainAt = 80;
}  // namespace device_trace_layout

using DeviceTraceHeaderBytes = std::array<std::uint8_t, device_trace_layout::kHeaderBytes>;
using DeviceTraceRecordBytes = std::array<std::uint8_t, device_trace_layout::kRecordBytes>;

struct DeviceTraceHeader {
  TraceHeader run;  ///< its model_hash is that of `device`; blob_hash 0 = no field was loaded, or any blob
  DeviceModel device;

  bool has_outputs() const { return run.has_outputs(); }
};

struct DeviceTraceRecord {
  DeviceInput input;
  DeviceOutput output;
  std::uint64_t chain = 0;
  std::uint64_t arrival_ns = 0;  ///< since the first record; outside the chain
};

/// fails     never; writes the hash of `header.device`, whatever `run` says
DeviceTraceHeaderBytes encode(const DeviceTraceHeader& header);

/// Checks the header's 224 bytes and the size of the file that follows it.
///
/// fails     as `decode_header`, and kBadModel
Result<DeviceTraceHeader> decode_device_header(std::span<const std::uint8_t> bytes, std::uint64_t file_bytes);

/// tick      yes
DeviceTraceRecordBytes encode(const DeviceTraceRecord& record);

/// fails     kBadRecord: an undefined flag, a setting that is none or outside its range, a fresh packet with an age
Result<DeviceTraceRecord> decode_device_record(std::span<const std::uint8_t, device_trace_layout::kRecordBytes> bytes);

/// The rolling hash over everything that a run saw and said. The blob is not in its seed, because a recording may begin before there is one.
///
/// tick      yes: `extend` costs one XXH64 of 80 bytes
class DeviceChain {
 public:
  explicit DeviceChain(const DeviceTraceHeader& header);
  /// Takes in one tick and returns the chain after it, which is also what the record stores.
  std::uint64_t extend(const DeviceInput& input, const DeviceOutput& output);
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_;
};

}  // namespace isotouch
