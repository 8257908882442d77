#include "shared/trace.h"

#include <algorithm>
#include <concepts>
#include <type_traits>

#include "shared/bytes.h"
#include "shared/crc32.h"
#include "shared/hash64.h"
#include "shared/vec3_bytes.h"

namespace isotouch {

using namespace trace_layout;

namespace {

constexpr std::uint8_t kAllRequests = kRequestStop | kRequestResume | kRequestRestart | kRequestMoved | kRequestPaused;

/// Writes the fields of a layout one behind the other.
struct FieldWriter {
  std::uint8_t* at;

  void operator()(std::string_view, bool value) { *at++ = value ? 1 : 0; }
  template <std::integral T>
  void operator()(std::string_view, T value) {
    store_le(at, value);
    at += sizeof(T);
  }
  template <class T>
  requires std::is_enum_v<T>
  void operator()(std::string_view name, T value) { (*this)(name, static_cast<std::underlying_type_t<T>>(value)); }
  template <class Q>
  void operator()(std::string_view, const Vec3<Q>& value) {
    store_vec3(at, value);
    at += 12;
  }
  template <class T, std::size_t N>
  void operator()(std::string_view name, const std::array<T, N>& values) {
    for (const T value : values) (*this)(name, value);
  }
  void operator()(std::string_view name, const TickSettings& settings) { (*this)(name, raw_settings(settings)); }
  void operator()(std::string_view name, const DeviceModel& device) { (*this)(name, encode(device)); }
  void zeros(std::size_t bytes) { at = std::fill_n(at, bytes, std::uint8_t{0}); }
};

/// Reads them. What cannot be a value of its type makes `error`.
struct FieldReader {
  const std::uint8_t* at;
  bool good = true;
  Error error = Error::kBadHeader;

  void operator()(std::string_view, bool& value) {
    good = good && *at <= 1;
    value = *at++ != 0;
  }
  template <std::integral T>
  void operator()(std::string_view, T& value) {
    value = load_le<T>(at);
    at += sizeof(T);
  }
  template <class T>
  requires std::is_enum_v<T>
  void operator()(std::string_view name, T& value) {
    std::underlying_type_t<T> raw{};
    (*this)(name, raw);
    value = static_cast<T>(raw);
  }
  template <class Q>
  void operator()(std::string_view, Vec3<Q>& value) {
    value = load_vec3<Q>(at);
    at += 12;
  }
  template <class T, std::size_t N>
  void operator()(std::string_view name, std::array<T, N>& values) {
    for (T& value : values) (*this)(name, value);
  }
  void operator()(std::string_view name, TickSettings& settings) {
    RawSettings raw{};
    (*this)(name, raw);
    settings = from_raw(raw);
    good = good && is_valid(settings);
  }
  void operator()(std::string_view name, DeviceModel& device) {
    DeviceModelBytes bytes{};
    (*this)(name, bytes);
    const Result<DeviceModel> read = decode_model(bytes);
    if (read) device = *read;
    if (!read && good) error = read.error();
    good = good && read.has_value();
  }
  void zeros(std::size_t bytes) {
    good = good && std::all_of(at, at + bytes, [](std::uint8_t byte) { return byte == 0; });
    at += bytes;
  }
};

/// A tick that takes a patch over neither forgets what was before nor changes a setting, and there is a field.
bool is_move_alone(const Input& in) {
  const bool alone = (in.requests & kRequestRestart) == 0 && in.change.setting == TickSetting::kNone && in.field_generation != 0;
  return (in.requests & kRequestMoved) == 0 || alone;
}

/// What parts of a field are called.
void name_part(const Field& field, std::size_t byte, FieldName& name) {
  name.size = std::min(field.name.size(), name.text.size() - 3);
  std::copy_n(field.name.begin(), name.size, name.text.begin());
  const auto add = [&](char c) { name.text[name.size++] = c; };
  if (field.size == 12) {
    add('.'), add(static_cast<char>('x' + (byte - field.offset) / 4));
  } else if (field.name == "commands") {
    add('['), add(static_cast<char>('0' + (byte - field.offset) / 2)), add(']');
  }
}

/// The first field from `begin` on in which two encoded records of a kind differ.
FieldName first_difference(const TraceRecordBytes& a, const TraceRecordBytes& b, InputKind kind, std::size_t begin) {
  FieldName name;
  const FieldList& list = kind == InputKind::kPosition ? kPositionFields : kPacketFields;
  const auto differs =
      std::mismatch(a.begin() + static_cast<std::ptrdiff_t>(begin), a.begin() + kChainAt, b.begin() + static_cast<std::ptrdiff_t>(begin));
  const auto byte = static_cast<std::size_t>(differs.first - a.begin());
  for (std::size_t i = 0; i < list.count && byte < kChainAt; ++i) {
    const Field& field = list.fields[i];
    if (byte >= field.offset && byte < field.offset + field.size) name_part(field, byte, name);
  }
  return name;
}

}  // namespace

TraceHeaderBytes encode(const TraceHeader& header) {
  TraceHeaderBytes bytes{};
  std::uint8_t* at = bytes.data();
  std::copy(kMagic.begin(), kMagic.end(), at);
  store_le(at + 4, kMajor);
  store_le(at + 6, kMinor);
  store_le(at + 8, static_cast<std::uint32_t>(kHeaderBytes));
  store_le(at + 12, static_cast<std::uint32_t>(kRecordBytes));
  FieldWriter writer{at + kFieldsAt};
  header_fields(header, writer);
  store_le(at + kChecksumAt, crc32(at, kChecksumAt));
  return bytes;
}

Result<TraceHeader> decode_header(std::span<const std::uint8_t> bytes) {
  const std::uint8_t* at = bytes.data();
  if (bytes.size() < 6 || !std::equal(kMagic.begin(), kMagic.end(), at)) return Error::kBadMagic;
  if (load_le<std::uint16_t>(at + 4) != kMajor) return Error::kBadVersion;
  if (bytes.size() < kHeaderBytes) return Error::kTruncated;
  if (load_le<std::uint32_t>(at + kChecksumAt) != crc32(at, kChecksumAt)) return Error::kBadChecksum;
  if (load_le<std::uint32_t>(at + 8) != kHeaderBytes || load_le<std::uint32_t>(at + 12) != kRecordBytes) return Error::kBadHeader;

  TraceHeader header;
  FieldReader reader{at + kFieldsAt};
  header_fields(header, reader);
  if (!reader.good) return reader.error;
  if (!raw_range(rows::kPeriod).holds(header.period_ns)) return Error::kBadHeader;
  return header;
}

Result<TraceHeader> decode_header(std::span<const std::uint8_t> bytes, std::uint64_t file_bytes) {
  const Result<TraceHeader> read = decode_header(bytes);
  if (!read) return read.error();
  const TraceHeader& header = *read;
  const std::uint64_t record_bytes = file_bytes - kHeaderBytes;
  if (header.record_count > record_bytes / kRecordBytes) return Error::kTruncated;
  if (header.record_count * kRecordBytes != record_bytes) return Error::kBadSize;
  return header;
}

TraceRecordBytes encode(const TraceRecord& record) {
  TraceRecordBytes bytes;
  FieldWriter writer{bytes.data()};
  record_fields(record, writer);
  return bytes;
}

Result<TraceRecord> decode_record(std::span<const std::uint8_t, kRecordBytes> bytes) {
  TraceRecord record;
  FieldReader reader{bytes.data()};
  record_fields(record, reader);
  const Input& in = record.input;
  const bool defined = in.kind <= InputKind::kPacket && (in.requests & ~kAllRequests) == 0 &&
                       static_cast<std::size_t>(guard_verdict(in.lines)) < kGuardVerdicts && in.late <= kMaxLate && in.buttons <= 0x0F &&
                       is_valid(in.change) && is_move_alone(in);
  if (!reader.good || !defined || (in.fresh && in.age != 0)) return Error::kBadRecord;
  return record;
}

FieldName differing_input(const Input& a, const Input& b) {
  FieldName name;
  if (a.kind != b.kind) {
    name_part(kPacketFields.fields[0], 0, name);
    return name;
  }
  return first_difference(encode(TraceRecord{a, {}, 0, 0}), encode(TraceRecord{b, {}, 0, 0}), a.kind, 0);
}

FieldName differing_output(const Output& a, const Output& b) {
  return first_difference(encode(TraceRecord{{}, a, 0, 0}), encode(TraceRecord{{}, b, 0, 0}), InputKind::kPacket, kOutputAt);
}

Chain::Chain(const TraceHeader& header) {
  const TraceHeaderBytes bytes = encode(header);
  value_ = hash64(bytes.data() + kHeaderChainAt, kHeaderChainBytes);
}

std::uint64_t Chain::extend(const Input& input, const Output& output) {
  const TraceRecordBytes bytes = encode(TraceRecord{input, output, 0, 0});
  value_ = hash64(bytes.data(), kChainAt, value_);
  return value_;
}

}  // namespace isotouch
