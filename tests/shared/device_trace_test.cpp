#include "shared/device_trace.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "shared/bytes.h"
#include "shared/crc32.h"
#include "shared/hash64.h"

namespace isotouch {
namespace {

using namespace device_trace_layout;

DeviceTraceHeader some_header() {
  DeviceTraceHeader header;
  header.device = martin_hillier_model();
  header.run.record_count = 3;
  header.run.blob_hash = 0x1122334455667788;
  header.run.model_hash = hash(header.device);
  header.run.period_ns = 500'000;
  header.run.flags = trace_layout::kHasOutputs;
  header.run.settings = {Stiffness::of(2), Damping::of(0.001), Newton::of(7.5), 40, Ratio::of(0.5)};
  header.run.settings.delay_ticks = 3;
  return header;
}

DeviceTraceRecord some_record() {
  DeviceTraceRecord record;
  record.input.packet = encode(FalconReply{{1447, -1447, 12}, 4, 7});
  record.input.fresh = false;
  record.input.age = 0x0203;
  record.input.commands = kCommandResume;
  record.input.field_generation = 0x04050607;
  record.input.change = {TickSetting::kFriction, 0x0A0B0C0D};
  record.output.hip = {Mm::from_raw(1), Mm::from_raw(-2), Mm::from_raw(3)};
  record.output.tick = {{Mm::from_raw(7), Mm::from_raw(-8), Mm::from_raw(9)},
                        {Newton::from_raw(-10), Newton::from_raw(11), Newton::from_raw(12)},
                        {-13, 14, -15},
                        0x1617,
                        0x18191A1B};
  record.output.faults = 0x1C1D;
  record.output.packet_flags = 0x0E;
  record.output.buttons = 0x0B;
  record.chain = 0x2122232425262728;
  record.arrival_ns = 0x3132333435363738;
  return record;
}

std::uint64_t file_bytes(const DeviceTraceHeader& header) { return 224 + 96 * header.run.record_count; }

void repair(DeviceTraceHeaderBytes& bytes) { store_le(bytes.data() + 220, crc32(bytes.data(), 220)); }

TEST(DeviceTrace, TheHeaderStandsAsTheSpecificationDrawsIt) {
  const DeviceTraceHeaderBytes bytes = encode(some_header());
  const std::uint8_t* at = bytes.data();
  EXPECT_EQ(std::string(at, at + 4), "ITRC");
  EXPECT_EQ(load_le<std::uint16_t>(at + 4), 2);
  EXPECT_EQ(load_le<std::uint16_t>(at + 6), 1);
  EXPECT_EQ(load_le<std::uint32_t>(at + 8), 224U);
  EXPECT_EQ(load_le<std::uint32_t>(at + 12), 96U);
  EXPECT_EQ(load_le<std::uint64_t>(at + 16), 3U);
  EXPECT_EQ(load_le<std::uint64_t>(at + 24), 0x1122334455667788U);
  EXPECT_EQ(load_le<std::uint64_t>(at + 32), hash64(at + 64, 128));
  EXPECT_EQ(load_le<std::uint32_t>(at + 40), 500'000U);
  EXPECT_EQ(load_le<std::uint32_t>(at + 44), 1U);
  EXPECT_EQ(load_le<std::int32_t>(at + 48), 2 << 16);
  EXPECT_EQ(load_le<std::uint32_t>(at + 60), 40U);
  const DeviceModelBytes model = encode(martin_hillier_model());
  EXPECT_TRUE(std::equal(model.begin(), model.end(), at + 64));
  EXPECT_EQ(load_le<std::int32_t>(at + 192), 1 << 29);
  EXPECT_TRUE(std::all_of(at + 196, at + 216, [](std::uint8_t b) { return b == 0; }));
  EXPECT_EQ(load_le<std::uint32_t>(at + 216), 3U);
  EXPECT_EQ(load_le<std::uint32_t>(at + 220), crc32(at, 220));
}

TEST(DeviceTrace, TheRecordStandsAsTheSpecificationDrawsIt) {
  const DeviceTraceRecordBytes bytes = encode(some_record());
  const std::uint8_t* at = bytes.data();
  const FalconPacket packet = some_record().input.packet;
  EXPECT_TRUE(std::equal(packet.begin(), packet.end(), at));
  EXPECT_EQ(at[16], 0);
  EXPECT_EQ(at[17], 2 | 4 << 3);
  EXPECT_EQ(load_le<std::uint16_t>(at + 18), 0x0203);
  EXPECT_EQ(load_le<std::uint32_t>(at + 20), 0x04050607U);
  for (std::size_t i = 0; i < 9; ++i) EXPECT_EQ(load_le<std::int32_t>(at + 24 + 4 * i), (std::array{1, -2, 3, 7, -8, 9, -10, 11, 12})[i]);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(load_le<std::int16_t>(at + 60 + 2 * i), (std::array{-13, 14, -15})[i]);
  EXPECT_EQ(load_le<std::uint16_t>(at + 66), 0x1617);
  EXPECT_EQ(load_le<std::uint32_t>(at + 68), 0x18191A1BU);
  EXPECT_EQ(load_le<std::uint16_t>(at + 72), 0x1C1D);
  EXPECT_EQ(at[74], 0x0E);
  EXPECT_EQ(at[75], 0x0B);
  EXPECT_EQ(load_le<std::uint32_t>(at + 76), 0x0A0B0C0DU);
  EXPECT_EQ(load_le<std::uint64_t>(at + 80), 0x2122232425262728U);
  EXPECT_EQ(load_le<std::uint64_t>(at + 88), 0x3132333435363738U);
}

TEST(DeviceTrace, WhatIsEncodedIsDecoded) {
  const DeviceTraceHeader header = some_header();
  const Result<DeviceTraceHeader> read = decode_device_header(encode(header), file_bytes(header));
  ASSERT_TRUE(read) << describe(read.error());
  EXPECT_EQ(encode(*read), encode(header));
  EXPECT_EQ(read->device, header.device);
  EXPECT_TRUE(read->has_outputs());
  DeviceTraceRecord record = some_record();
  for (const bool fresh : {false, true}) {
    record.input.fresh = fresh;
    record.input.age = fresh ? 0 : 65535;
    const Result<DeviceTraceRecord> again = decode_device_record(encode(record));
    ASSERT_TRUE(again);
    EXPECT_EQ(encode(*again), encode(record));
    EXPECT_EQ(again->input, record.input);
    EXPECT_EQ(again->output, record.output);
  }
}

TEST(DeviceTrace, LinesAndLatenessShareAByteWithFresh) {
  for (unsigned byte = 0; byte < 256; ++byte) {
    DeviceTraceRecord record = some_record();
    record.input.fresh = (byte & 1) != 0;
    record.input.age = 0;
    record.input.lines = static_cast<std::uint8_t>((byte >> 1) & 3);
    record.input.late = static_cast<std::uint8_t>(byte >> 3);
    EXPECT_EQ(encode(record)[16], byte);
    EXPECT_EQ(decode_device_record(encode(record))->input, record.input);
  }
  DeviceTraceRecord record = some_record();
  record.input.late = 200;
  EXPECT_EQ(encode(record)[16] >> 3, kMostLate);
}

TEST(DeviceTrace, EveryMalformedHeaderIsRefusedForItsReason) {
  struct Malformed {
    std::string what;
    Error expected;
    std::function<void(std::uint8_t*)> spoil;  ///< the checksum is made right afterwards
  };
  const std::vector<Malformed> cases = {
      {"another magic", Error::kBadMagic, [](std::uint8_t* h) { h[3] = 'X'; }},
      {"the version before", Error::kBadVersion, [](std::uint8_t* h) { store_le<std::uint16_t>(h + 4, 1); }},
      {"the next major version", Error::kBadVersion, [](std::uint8_t* h) { store_le<std::uint16_t>(h + 4, 3); }},
      {"another header length", Error::kBadHeader, [](std::uint8_t* h) { store_le(h + 8, 96U); }},
      {"another record length", Error::kBadHeader, [](std::uint8_t* h) { store_le(h + 12, 72U); }},
      {"one record too many", Error::kTruncated, [](std::uint8_t* h) { store_le<std::uint64_t>(h + 16, 4); }},
      {"2^64 - 1 records", Error::kTruncated, [](std::uint8_t* h) { store_le(h + 16, ~std::uint64_t{0}); }},
      {"one record too few", Error::kBadSize, [](std::uint8_t* h) { store_le<std::uint64_t>(h + 16, 2); }},
      {"another model's hash", Error::kBadModel, [](std::uint8_t* h) { h[32] ^= 1; }},
      {"another model", Error::kBadModel, [](std::uint8_t* h) { h[64] ^= 1; }},
      {"a model without arms", Error::kBadModel, [](std::uint8_t* h) { store_le(h + 64, 0); }},
      {"a period of 0", Error::kBadHeader, [](std::uint8_t* h) { store_le(h + 40, 0U); }},
      {"an undefined flag", Error::kBadHeader, [](std::uint8_t* h) { store_le(h + 44, 2U); }},
      {"a force limit of 0", Error::kBadHeader, [](std::uint8_t* h) { store_le(h + 56, 0); }},
  };
  for (const Malformed& malformed : cases) {
    DeviceTraceHeaderBytes bytes = encode(some_header());
    malformed.spoil(bytes.data());
    repair(bytes);
    const Result<DeviceTraceHeader> read = decode_device_header(bytes, file_bytes(some_header()));
    ASSERT_FALSE(read) << malformed.what;
    EXPECT_EQ(read.error(), malformed.expected) << malformed.what << ": " << describe(read.error());
  }
}

TEST(DeviceTrace, EveryLengthButTheRightOneAndEveryFlippedBitIsRefused) {
  DeviceTraceHeaderBytes bytes = encode(some_header());
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    const std::vector<std::uint8_t> head(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
    const Result<DeviceTraceHeader> read = decode_device_header(head, size);
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error(), size < 6 ? Error::kBadMagic : Error::kTruncated) << size;
  }
  const std::uint64_t right = file_bytes(some_header());
  for (std::uint64_t size = 224; size < right + 100; ++size)
    EXPECT_EQ(decode_device_header(bytes, size).has_value(), size == right) << size;
  for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
    bytes[bit / 8] ^= static_cast<std::uint8_t>(1U << (bit % 8));
    EXPECT_FALSE(decode_device_header(bytes, right)) << bit;
    bytes[bit / 8] ^= static_cast<std::uint8_t>(1U << (bit % 8));
  }
}

TEST(DeviceTrace, ARecordWithAnUndefinedValueIsRefused) {
  const auto refused_at = [](std::size_t offset, std::uint8_t value) {
    DeviceTraceRecordBytes bytes = encode(some_record());
    bytes[offset] = value;
    const Result<DeviceTraceRecord> read = decode_device_record(bytes);
    return !read && read.error() == Error::kBadRecord;
  };
  EXPECT_TRUE(refused_at(16, 1)) << "a fresh packet with an age";
  EXPECT_TRUE(refused_at(17, 9 << 3)) << "an unknown setting";
  EXPECT_TRUE(refused_at(79, 0x60)) << "a friction above 1.5";
  EXPECT_TRUE(refused_at(17, 0)) << "a value of no setting";
  EXPECT_TRUE(refused_at(79, 0x80)) << "a friction below 0";
  EXPECT_FALSE(refused_at(0, 0)) << "a malformed packet is an input like any other";
}

TEST(DeviceTrace, TheChainSeesEverythingButTheBlobAndTheArrival) {
  const auto chain_of = [](const DeviceTraceHeader& header, const DeviceTraceRecord& record) {
    return DeviceChain(header).extend(record.input, record.output);
  };
  const DeviceTraceHeader header = some_header();
  const DeviceTraceRecord record = some_record();
  DeviceTraceHeaderBytes head = encode(header);
  EXPECT_EQ(chain_of(header, record), hash64(encode(record).data(), 80, hash64(head.data() + 192, 28, hash64(head.data() + 32, 160))));

  std::set<std::uint64_t> seen = {chain_of(header, record)};
  std::size_t changes = 1;
  const auto changed_header = [&](auto change) {
    DeviceTraceHeader other = header;
    change(other);
    seen.insert(chain_of(other, record));
    ++changes;
  };
  changed_header([](DeviceTraceHeader& h) { h.device.led_idle ^= 1; });
  changed_header([](DeviceTraceHeader& h) { h.run.period_ns += 1; });
  changed_header([](DeviceTraceHeader& h) { h.run.settings.stiffness = Stiffness::of(3); });
  changed_header([](DeviceTraceHeader& h) { h.run.settings.delay_ticks = 2; });
  for (std::size_t bit = 0; bit < 8 * 80; ++bit) {
    DeviceTraceRecordBytes bytes = encode(record);
    bytes[bit / 8] ^= static_cast<std::uint8_t>(1U << (bit % 8));
    const Result<DeviceTraceRecord> other = decode_device_record(bytes);
    if (!other) continue;
    seen.insert(chain_of(header, *other));
    ++changes;
  }
  EXPECT_EQ(seen.size(), changes);
  EXPECT_GT(changes, 580U);

  DeviceTraceRecord later = record;
  later.arrival_ns += 1;
  later.chain += 1;
  DeviceTraceHeader longer = header;
  longer.run.record_count += 1;
  longer.run.blob_hash += 1;
  longer.run.flags = 0;
  EXPECT_EQ(chain_of(longer, later), chain_of(header, record));
}

}  // namespace
}  // namespace isotouch
