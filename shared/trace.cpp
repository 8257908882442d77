#include "shared/trace.h"

#include <algorithm>

#include "shared/bytes.h"
#include "shared/crc32.h"
#include "shared/hash64.h"
#include "shared/vec3_bytes.h"

namespace isotouch {

using namespace trace_layout;

void store_run(const TraceHeader& header, std::uint8_t* bytes) {
  store_le(bytes + 16, header.record_count);
  store_le(bytes + 24, header.blob_hash);
  store_le(bytes + 32, header.model_hash);
  store_le(bytes + 40, header.period_ns);
  store_le(bytes + 44, header.flags);
  store_le(bytes + 48, header.settings.stiffness.raw());
  store_le(bytes + 52, header.settings.damping.raw());
  store_le(bytes + 56, header.settings.force_limit.raw());
  store_le(bytes + 60, header.settings.ramp_ticks);
}

bool load_run(const std::uint8_t* bytes, TraceHeader& header) {
  header.record_count = load_le<std::uint64_t>(bytes + 16);
  header.blob_hash = load_le<std::uint64_t>(bytes + 24);
  header.model_hash = load_le<std::uint64_t>(bytes + 32);
  header.period_ns = load_le<std::uint32_t>(bytes + 40);
  header.flags = load_le<std::uint32_t>(bytes + 44);
  header.settings.stiffness = Stiffness::from_raw(load_le<std::int32_t>(bytes + 48));
  header.settings.damping = Damping::from_raw(load_le<std::int32_t>(bytes + 52));
  header.settings.force_limit = Newton::from_raw(load_le<std::int32_t>(bytes + 56));
  header.settings.ramp_ticks = load_le<std::uint32_t>(bytes + 60);
  return header.settings.stiffness >= Stiffness{} && header.settings.stiffness <= Stiffness::of(100) &&
         header.settings.damping >= Damping{} && header.settings.force_limit > Newton{} && header.settings.force_limit <= Newton::of(100) &&
         header.settings.ramp_ticks <= 100'000 && header.period_ns >= 100'000 && header.period_ns <= 4'000'000;
}

void store_feel(const TickSettings& settings, std::uint8_t* bytes) {
  store_le(bytes, settings.friction.raw());
  store_le(bytes + 4, settings.friction_damping.raw());
  store_le(bytes + 8, settings.hand_damping.raw());
  store_le(bytes + 12, settings.passivity.raw());
  store_le(bytes + 16, settings.device_damping.raw());
  store_le(bytes + 20, settings.weight.raw());
  store_le(bytes + 24, settings.delay_ticks);
}

bool load_feel(const std::uint8_t* bytes, TickSettings& settings) {
  settings.friction = Ratio::from_raw(load_le<std::int32_t>(bytes));
  settings.friction_damping = Damping::from_raw(load_le<std::int32_t>(bytes + 4));
  settings.hand_damping = Damping::from_raw(load_le<std::int32_t>(bytes + 8));
  settings.passivity = Damping::from_raw(load_le<std::int32_t>(bytes + 12));
  settings.device_damping = Damping::from_raw(load_le<std::int32_t>(bytes + 16));
  settings.weight = Newton::from_raw(load_le<std::int32_t>(bytes + 20));
  settings.delay_ticks = load_le<std::uint32_t>(bytes + 24);
  bool valid = settings.friction >= Ratio{} && settings.friction <= kMostFriction && settings.delay_ticks <= kMostDelay;
  for (const Damping damping : {settings.friction_damping, settings.hand_damping, settings.passivity, settings.device_damping}) {
    valid &= damping >= Damping{} && damping <= kMostDamping;
  }
  return valid && settings.weight >= -kMostWeight && settings.weight <= kMostWeight;
}

std::uint64_t chain_seed(std::span<const std::uint8_t> always, const std::uint8_t* feel) {
  const std::uint64_t seed = hash64(always.data(), always.size());
  const bool more = std::any_of(feel, feel + kFeelBytes, [](std::uint8_t byte) { return byte != 0; });
  return more ? hash64(feel, kFeelBytes, seed) : seed;
}

Result<std::uint16_t> trace_major(std::span<const std::uint8_t> bytes) {
  if (bytes.size() < 6 || !std::equal(kMagic.begin(), kMagic.end(), bytes.begin())) return Error::kBadMagic;
  return load_le<std::uint16_t>(bytes.data() + 4);
}

TraceHeaderBytes encode(const TraceHeader& header) {
  TraceHeaderBytes bytes{};
  std::uint8_t* at = bytes.data();
  std::copy(kMagic.begin(), kMagic.end(), at);
  store_le(at + 4, kMajor);
  store_le(at + 6, kMinor);
  store_le(at + 8, static_cast<std::uint32_t>(kHeaderBytes));
  store_le(at + 12, static_cast<std::uint32_t>(kRecordBytes));
  store_run(header, at);
  store_feel(header.settings, at + kFeelAt);
  store_le(at + 92, crc32(at, 92));
  return bytes;
}

Result<TraceHeader> decode_header(std::span<const std::uint8_t> bytes, std::uint64_t file_bytes) {
  const std::uint8_t* at = bytes.data();
  if (bytes.size() < kMagic.size() || !std::equal(kMagic.begin(), kMagic.end(), at)) return Error::kBadMagic;
  if (bytes.size() < kHeaderBytes) return Error::kTruncated;
  if (load_le<std::uint16_t>(at + 4) != kMajor) return Error::kBadVersion;
  if (load_le<std::uint32_t>(at + 92) != crc32(at, 92)) return Error::kBadChecksum;
  if (load_le<std::uint32_t>(at + 8) != kHeaderBytes || load_le<std::uint32_t>(at + 12) != kRecordBytes) return Error::kBadHeader;

  TraceHeader header;
  if (!load_run(at, header) || !load_feel(at + kFeelAt, header.settings)) return Error::kBadHeader;
  if ((header.flags & ~(kHasOutputs | kEncoderCounts)) != 0) return Error::kBadHeader;
  const std::uint64_t record_bytes = file_bytes - kHeaderBytes;
  if (header.record_count > record_bytes / kRecordBytes) return Error::kTruncated;
  if (header.record_count * kRecordBytes != record_bytes) return Error::kBadSize;
  return header;
}

TraceRecordBytes encode(const TraceRecord& record) {
  TraceRecordBytes bytes{};
  std::uint8_t* at = bytes.data();
  store_vec3(at, record.input.hip);
  store_le(at + 12, record.input.buttons);
  store_le(at + 13, static_cast<std::uint8_t>(record.input.fresh ? 1 : 0));
  store_le(at + 14, record.input.age);
  store_vec3(at + 16, record.output.proxy);
  store_vec3(at + 28, record.output.force);
  for (std::size_t i = 0; i < 3; ++i) store_le(at + 40 + 2 * i, record.output.words[i]);
  store_le(at + 46, record.output.state);
  store_le(at + 48, record.output.status);
  store_le(at + 56, record.chain);
  store_le(at + 64, record.arrival_ns);
  return bytes;
}

Result<TraceRecord> decode_record(std::span<const std::uint8_t, kRecordBytes> bytes) {
  const std::uint8_t* at = bytes.data();
  TraceRecord record;
  record.input.hip = load_vec3<Mm>(at);
  record.input.buttons = at[12];
  record.input.fresh = (at[13] & 1U) != 0;
  record.input.age = load_le<std::uint16_t>(at + 14);
  record.output.proxy = load_vec3<Mm>(at + 16);
  record.output.force = load_vec3<Newton>(at + 28);
  for (std::size_t i = 0; i < 3; ++i) record.output.words[i] = load_le<std::int16_t>(at + 40 + 2 * i);
  record.output.state = load_le<std::uint16_t>(at + 46);
  record.output.status = load_le<std::uint32_t>(at + 48);
  record.chain = load_le<std::uint64_t>(at + 56);
  record.arrival_ns = load_le<std::uint64_t>(at + 64);
  const bool undefined = record.input.buttons > 0x0F || at[13] > 1 || load_le<std::uint32_t>(at + 52) != 0;
  if (undefined || (record.input.fresh && record.input.age != 0)) return Error::kBadRecord;
  return record;
}

Chain::Chain(const TraceHeader& header, std::uint64_t blob_hash) {
  TraceHeader used = header;
  used.blob_hash = blob_hash;
  used.flags |= kHasOutputs;
  const TraceHeaderBytes bytes = encode(used);
  value_ = chain_seed(std::span(bytes).subspan(kChainBegin, kChainEnd - kChainBegin), bytes.data() + kFeelAt);
}

std::uint64_t Chain::extend(const TickInput& input, const TickOutput& output) {
  const TraceRecordBytes bytes = encode(TraceRecord{input, output, 0, 0});
  value_ = hash64(bytes.data(), kRecordChainBytes, value_);
  return value_;
}

}  // namespace isotouch
