/// The trace: what entered each tick and what left it (SPEC.md, section 3). Layout, encoding and the hash chain; files are for others.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "shared/device_model.h"
#include "shared/result.h"
#include "shared/tick_io.h"

namespace isotouch {

/// The record count of a file that has no end yet.
inline constexpr std::uint64_t kUnfinished = ~std::uint64_t{0};

struct TraceHeader {
  std::uint64_t record_count = 0;  ///< kUnfinished while the file is written, and for ever where its writer was killed
  std::uint64_t field_hash = 0;    ///< of the field's image; 0 = none was loaded, or any
  std::uint64_t settings_checksum =
      0;  ///< of everything that the controller was set up with, as `isotouch status` shows it; 0 = no controller
  bool has_outputs = false;
  std::uint32_t period_ns = static_cast<std::uint32_t>(rows::kPeriod.standard);
  TickSettings settings;
  DeviceModel device = libnifalcon_model();  ///< of a hand without a device only the play counts

  bool operator==(const TraceHeader&) const = default;
};

struct TraceRecord {
  Input input;
  Output output;
  std::uint64_t chain = 0;       ///< after this tick
  std::uint64_t arrival_ns = 0;  ///< of the sample, since the first record; outside the chain

  bool operator==(const TraceRecord&) const = default;
};

namespace trace_layout {

inline constexpr std::array<std::uint8_t, 4> kMagic = {'I', 'T', 'R', 'C'};
inline constexpr std::uint16_t kMajor = 3;
inline constexpr std::uint16_t kMinor = 0;

/// Lists the header's fields behind magic and version in the order of their bytes: for reading, writing and SPEC.md's table.
///
/// use       called as use(name, value); use.zeros(n) for reserved bytes
template <class Header, class Use>
constexpr void header_fields(Header& h, Use& use) {
  use("record_count", h.record_count);
  use("field_hash", h.field_hash);
  use("has_outputs", h.has_outputs);
  use.zeros(3);
  use("period_ns", h.period_ns);
  use("settings", h.settings);
  use.zeros(4);
  use("device", h.device);
  use("settings_checksum", h.settings_checksum);
  use.zeros(28);
}

/// The same of a record.
template <class Record, class Use>
constexpr void record_fields(Record& r, Use& use) {
  use("input.kind", r.input.kind);
  use("input.fresh", r.input.fresh);
  use("input.lines", r.input.lines);
  use("input.late", r.input.late);
  use("input.requests", r.input.requests);
  use("input.setting", r.input.change.setting);
  use("input.age", r.input.age);
  if ((r.input.requests & kRequestRestart) != 0 && r.input.change.setting == TickSetting::kNone) {
    use("input.heat", r.input.heat);
  } else if ((r.input.requests & kRequestMoved) != 0) {
    use("input.moved_to", r.input.moved_to);
  } else {
    use("input.value", r.input.change.raw);
  }
  use("input.field_generation", r.input.field_generation);
  if (r.input.kind == InputKind::kPosition) {
    use("input.hip", r.input.hip);
    use("input.buttons", r.input.buttons);
    use.zeros(3);
  } else {
    use("input.packet", r.input.packet);
  }
  use("hip", r.output.hip);
  use("proxy", r.output.proxy);
  use("force", r.output.force);
  use("commands", r.output.commands);
  use("state", r.output.state);
  use("status", r.output.status);
  use("faults", r.output.faults);
  use("packet_flags", r.output.packet_flags);
  use("buttons", r.output.buttons);
  use("input.author", r.input.author);
  use("chain", r.chain);
  use("arrival_ns", r.arrival_ns);
}

/// Bytes that a value takes in the layout.
template <class T>
constexpr std::size_t size_of() {
  if constexpr (std::is_same_v<T, TickSettings>) {
    return 4 * kTickSettings;
  } else if constexpr (std::is_same_v<T, DeviceModel>) {
    return kDeviceModelBytes;
  } else {
    return sizeof(T);  // integers, enumerations, arrays and vectors of them: none has padding
  }
}

/// One field of a layout, as `FieldList` finds it.
struct Field {
  std::string_view name;
  std::size_t offset = 0, size = 0;
};

/// Collects names, offsets and sizes.
struct FieldList {
  std::array<Field, 32> fields{};
  std::size_t count = 0;
  std::size_t end = 0;  ///< offset behind the last field

  template <class T>
  constexpr void operator()(std::string_view name, const T&) {
    fields[count++] = {name, end, size_of<T>()};
    end += size_of<T>();
  }
  constexpr void zeros(std::size_t bytes) { end += bytes; }
  constexpr Field find(std::string_view name) const {
    for (std::size_t i = 0; i < count; ++i) {
      if (fields[i].name == name) return fields[i];
    }
    return {};
  }
};

/// The fields of a record with this kind of input.
constexpr FieldList fields_of_record(InputKind kind) {
  TraceRecord record;
  record.input.kind = kind;
  FieldList list;
  record_fields(record, list);
  return list;
}

inline constexpr FieldList kPositionFields = fields_of_record(InputKind::kPosition);
inline constexpr FieldList kPacketFields = fields_of_record(InputKind::kPacket);

inline constexpr std::size_t kFieldsAt = 16;  ///< header: magic, version, sizes before it
inline constexpr std::size_t kHeaderBytes = 256;
inline constexpr std::size_t kChecksumAt = kHeaderBytes - 4;
inline constexpr std::size_t kHeaderChainAt = 36;  ///< of the header the bytes from the period to the device's end enter the chain
inline constexpr std::size_t kHeaderChainBytes = 4 + 4 * kTickSettings + 4 + kDeviceModelBytes;
inline constexpr std::size_t kRecordBytes = kPacketFields.end;
inline constexpr std::size_t kOutputAt = kPacketFields.find("hip").offset;
inline constexpr std::size_t kChainAt = kPacketFields.find("chain").offset;  ///< a record's bytes before it enter the chain

static_assert(kPositionFields.end == kRecordBytes && kPositionFields.find("hip").offset == kOutputAt);
static_assert(kRecordBytes == 104 && kOutputAt == 32 && kChainAt == 88);

}  // namespace trace_layout

using TraceHeaderBytes = std::array<std::uint8_t, trace_layout::kHeaderBytes>;
using TraceRecordBytes = std::array<std::uint8_t, trace_layout::kRecordBytes>;

/// fails     never
TraceHeaderBytes encode(const TraceHeader& header);

/// Checks the header's bytes and the size of the file that follows it.
///
/// fails     kTruncated, kBadMagic, kBadVersion, kBadHeader (a field outside its range), kBadModel, kBadSize (record count against file size),
///           kBadChecksum; kTruncated for an unfinished file, too
Result<TraceHeader> decode_header(std::span<const std::uint8_t> bytes, std::uint64_t file_bytes);

/// The same without the size of the file.
///
/// fails     as above, without kBadSize; the header of an unfinished file is taken
Result<TraceHeader> decode_header(std::span<const std::uint8_t> bytes);

/// tick      yes
TraceRecordBytes encode(const TraceRecord& record);

/// fails     kBadRecord: an undefined value or bit, a reserved byte that is not zero, a fresh sample with an age
Result<TraceRecord> decode_record(std::span<const std::uint8_t, trace_layout::kRecordBytes> bytes);

/// The first field in which two records differ, with its axis or number, as "force.x" or "commands[1]"; empty where they are the same. The chain and
/// arrival times do not count.
struct FieldName {
  std::array<char, 32> text{};
  std::size_t size = 0;

  std::string_view view() const { return {text.data(), size}; }
  explicit operator bool() const { return size > 0; }
};
FieldName differing_input(const Input& a, const Input& b);
FieldName differing_output(const Output& a, const Output& b);

/// The rolling hash over everything that a run saw and answered. Equal chains mean equal histories. The field is not in its seed, because a recording may
/// begin before there is one.
///
/// tick      yes: `extend` costs one XXH64 of 88 bytes
class Chain {
 public:
  explicit Chain(const TraceHeader& header);
  /// Takes in one tick and returns the chain after it, which is also what the record stores.
  std::uint64_t extend(const Input& input, const Output& output);
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_;
};

}  // namespace isotouch
