#include "shared/device_trace.h"

#include <algorithm>

#include "shared/bytes.h"
#include "shared/crc32.h"
#include "shared/hash64.h"
#include "shared/vec3_bytes.h"

namespace isotouch {

using namespace device_trace_layout;

namespace {

constexpr std::uint8_t kEveryCommand = kCommandStop | kCommandResume | kCommandRestart;  // bits 0 to 2 of byte 17
constexpr int kSettingShift = 3;                                                         // above them, the setting that changes

/// Byte 16 of a record: bit 0 fresh, bits 1 and 2 lines, bits 3 to 7 late.
std::uint8_t pack_conditions(const DeviceInput& in) {
  return static_cast<std::uint8_t>((in.fresh ? 1U : 0U) | ((in.lines & 3U) << 1) | (unsigned{std::min(in.late, kMostLate)} << 3));
}

void unpack_conditions(std::uint8_t byte, DeviceInput& in) {
  in.fresh = (byte & 1U) != 0;
  in.lines = (byte >> 1) & 3U;
  in.late = static_cast<std::uint8_t>(byte >> 3);
}

}  // namespace

DeviceTraceHeaderBytes encode(const DeviceTraceHeader& header) {
  DeviceTraceHeaderBytes bytes{};
  std::uint8_t* at = bytes.data();
  std::copy(trace_layout::kMagic.begin(), trace_layout::kMagic.end(), at);
  store_le(at + 4, kMajor);
  store_le(at + 6, kMinor);
  store_le(at + 8, static_cast<std::uint32_t>(kHeaderBytes));
  store_le(at + 12, static_cast<std::uint32_t>(kRecordBytes));
  TraceHeader run = header.run;
  run.model_hash = hash(header.device);
  store_run(run, at);
  const DeviceModelBytes model = encode(header.device);
  std::copy(model.begin(), model.end(), at + kModelAt);
  store_feel(run.settings, at + kFeelAt);
  store_le(at + kChecksumAt, crc32(at, kChecksumAt));
  return bytes;
}

Result<DeviceTraceHeader> decode_device_header(std::span<const std::uint8_t> bytes, std::uint64_t file_bytes) {
  const Result<std::uint16_t> major = trace_major(bytes);
  if (!major) return major.error();
  if (*major != kMajor) return Error::kBadVersion;
  if (bytes.size() < kHeaderBytes) return Error::kTruncated;
  const std::uint8_t* at = bytes.data();
  if (load_le<std::uint32_t>(at + kChecksumAt) != crc32(at, kChecksumAt)) return Error::kBadChecksum;
  if (load_le<std::uint32_t>(at + 8) != kHeaderBytes || load_le<std::uint32_t>(at + 12) != kRecordBytes) return Error::kBadHeader;

  DeviceTraceHeader header;
  if (!load_run(at, header.run) || !load_feel(at + kFeelAt, header.run.settings)) return Error::kBadHeader;
  if ((header.run.flags & ~trace_layout::kHasOutputs) != 0) return Error::kBadHeader;
  DeviceModelBytes model{};
  std::copy_n(at + kModelAt, model.size(), model.begin());
  const Result<DeviceModel> device = decode_model(model);
  if (!device) return device.error();
  header.device = *device;
  if (header.run.model_hash != hash(header.device)) return Error::kBadModel;

  const std::uint64_t record_bytes = file_bytes - kHeaderBytes;
  if (header.run.record_count > record_bytes / kRecordBytes) return Error::kTruncated;
  if (header.run.record_count * kRecordBytes != record_bytes) return Error::kBadSize;
  return header;
}

DeviceTraceRecordBytes encode(const DeviceTraceRecord& record) {
  DeviceTraceRecordBytes bytes{};
  std::uint8_t* at = bytes.data();
  std::copy(record.input.packet.begin(), record.input.packet.end(), at);
  store_le(at + 16, pack_conditions(record.input));
  store_le(at + 17, static_cast<std::uint8_t>(record.input.commands | static_cast<unsigned>(record.input.change.setting) << kSettingShift));
  store_le(at + 18, record.input.age);
  store_le(at + 20, record.input.field_generation);
  store_le(at + kSettingAt, record.input.change.raw);
  store_vec3(at + 24, record.output.hip);
  store_vec3(at + 36, record.output.tick.proxy);
  store_vec3(at + 48, record.output.tick.force);
  for (std::size_t i = 0; i < 3; ++i) store_le(at + 60 + 2 * i, record.output.tick.words[i]);
  store_le(at + 66, record.output.tick.state);
  store_le(at + 68, record.output.tick.status);
  store_le(at + 72, record.output.faults);
  store_le(at + 74, record.output.packet_flags);
  store_le(at + 75, record.output.buttons);
  store_le(at + kChainAt, record.chain);
  store_le(at + 88, record.arrival_ns);
  return bytes;
}

Result<DeviceTraceRecord> decode_device_record(std::span<const std::uint8_t, kRecordBytes> bytes) {
  const std::uint8_t* at = bytes.data();
  DeviceTraceRecord record;
  std::copy_n(at, record.input.packet.size(), record.input.packet.begin());
  unpack_conditions(at[16], record.input);
  record.input.commands = at[17] & kEveryCommand;
  record.input.change = {static_cast<TickSetting>(at[17] >> kSettingShift), load_le<std::int32_t>(at + kSettingAt)};
  record.input.age = load_le<std::uint16_t>(at + 18);
  record.input.field_generation = load_le<std::uint32_t>(at + 20);
  record.output.hip = load_vec3<Mm>(at + 24);
  record.output.tick.proxy = load_vec3<Mm>(at + 36);
  record.output.tick.force = load_vec3<Newton>(at + 48);
  for (std::size_t i = 0; i < 3; ++i) record.output.tick.words[i] = load_le<std::int16_t>(at + 60 + 2 * i);
  record.output.tick.state = load_le<std::uint16_t>(at + 66);
  record.output.tick.status = load_le<std::uint32_t>(at + 68);
  record.output.faults = load_le<std::uint16_t>(at + 72);
  record.output.packet_flags = at[74];
  record.output.buttons = at[75];
  record.chain = load_le<std::uint64_t>(at + kChainAt);
  record.arrival_ns = load_le<std::uint64_t>(at + 88);
  const bool undefined = !is_valid(record.input.change);
  if (undefined || (record.input.fresh && record.input.age != 0)) return Error::kBadRecord;
  return record;
}

DeviceChain::DeviceChain(const DeviceTraceHeader& header) {
  DeviceTraceHeader used = header;
  used.run.flags |= trace_layout::kHasOutputs;
  const DeviceTraceHeaderBytes bytes = encode(used);
  value_ = chain_seed(std::span(bytes).subspan(kChainBegin, kChainEnd - kChainBegin), bytes.data() + kFeelAt);
}

std::uint64_t DeviceChain::extend(const DeviceInput& input, const DeviceOutput& output) {
  const DeviceTraceRecordBytes bytes = encode(DeviceTraceRecord{input, output, 0, 0});
  value_ = hash64(bytes.data(), kRecordChainBytes, value_);
  return value_;
}

}  // namespace isotouch
