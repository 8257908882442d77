#include "shared/trace.h"

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

TraceHeader some_header() {
  TraceHeader header;
  header.record_count = 3;
  header.blob_hash = 0x1122334455667788;
  header.model_hash = 0x99AABBCCDDEEFF00;
  header.period_ns = 500'000;
  header.flags = trace_layout::kHasOutputs | trace_layout::kEncoderCounts;
  header.settings = {Stiffness::of(2), Damping::of(0.001), Newton::of(7.5), 40, Ratio::of(0.5)};
  header.settings.friction_damping = Damping::of(0.002);
  header.settings.hand_damping = Damping::of(0.003);
  header.settings.passivity = Damping::of(0.004);
  header.settings.device_damping = Damping::of(0.005);
  header.settings.weight = Newton::of(-0.75);
  header.settings.delay_ticks = 3;
  return header;
}

TraceRecord some_record() {
  TraceRecord record;
  record.input = {{Mm::from_raw(0x01020304), Mm::from_raw(-5), Mm::from_raw(6)}, 0x0B, false, 0x0203};
  record.output = {{Mm::from_raw(7), Mm::from_raw(-8), Mm::from_raw(9)},
                   {Newton::from_raw(-10), Newton::from_raw(11), Newton::from_raw(12)},
                   {-13, 14, -15},
                   0x1617,
                   0x18191A1B};
  record.chain = 0x2122232425262728;
  record.arrival_ns = 0x3132333435363738;
  return record;
}

std::uint64_t file_bytes(const TraceHeader& header) { return 96 + 72 * header.record_count; }

TEST(Trace, TheHeaderStandsAsTheSpecificationDrawsIt) {
  const TraceHeaderBytes bytes = encode(some_header());
  const std::uint8_t* at = bytes.data();
  EXPECT_EQ(std::string(at, at + 4), "ITRC");
  EXPECT_EQ(load_le<std::uint16_t>(at + 4), 1);
  EXPECT_EQ(load_le<std::uint16_t>(at + 6), 1);
  EXPECT_EQ(load_le<std::uint32_t>(at + 8), 96U);
  EXPECT_EQ(load_le<std::uint32_t>(at + 12), 72U);
  EXPECT_EQ(load_le<std::uint64_t>(at + 16), 3U);
  EXPECT_EQ(load_le<std::uint64_t>(at + 24), 0x1122334455667788U);
  EXPECT_EQ(load_le<std::uint64_t>(at + 32), 0x99AABBCCDDEEFF00U);
  EXPECT_EQ(load_le<std::uint32_t>(at + 40), 500'000U);
  EXPECT_EQ(load_le<std::uint32_t>(at + 44), 3U);
  EXPECT_EQ(load_le<std::int32_t>(at + 48), 2 << 16);
  EXPECT_EQ(load_le<std::int32_t>(at + 52), Damping::of(0.001).raw());
  EXPECT_EQ(load_le<std::int32_t>(at + 56), 15 << 15);
  EXPECT_EQ(load_le<std::uint32_t>(at + 60), 40U);
  EXPECT_EQ(load_le<std::int32_t>(at + 64), 1 << 29);
  EXPECT_EQ(load_le<std::int32_t>(at + 68), Damping::of(0.002).raw());
  EXPECT_EQ(load_le<std::int32_t>(at + 72), Damping::of(0.003).raw());
  EXPECT_EQ(load_le<std::int32_t>(at + 76), Damping::of(0.004).raw());
  EXPECT_EQ(load_le<std::int32_t>(at + 80), Damping::of(0.005).raw());
  EXPECT_EQ(load_le<std::int32_t>(at + 84), -3 << 14);
  EXPECT_EQ(load_le<std::uint32_t>(at + 88), 3U);
  EXPECT_EQ(load_le<std::uint32_t>(at + 92), crc32(at, 92));
}

TEST(Trace, TheRecordStandsAsTheSpecificationDrawsIt) {
  const TraceRecordBytes bytes = encode(some_record());
  const std::uint8_t* at = bytes.data();
  EXPECT_EQ(load_le<std::int32_t>(at), 0x01020304);
  EXPECT_EQ(load_le<std::int32_t>(at + 4), -5);
  EXPECT_EQ(load_le<std::int32_t>(at + 8), 6);
  EXPECT_EQ(at[12], 0x0B);
  EXPECT_EQ(at[13], 0);
  EXPECT_EQ(load_le<std::uint16_t>(at + 14), 0x0203);
  for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(load_le<std::int32_t>(at + 16 + 4 * i), (std::array{7, -8, 9, -10, 11, 12})[i]);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(load_le<std::int16_t>(at + 40 + 2 * i), (std::array{-13, 14, -15})[i]);
  EXPECT_EQ(load_le<std::uint16_t>(at + 46), 0x1617);
  EXPECT_EQ(load_le<std::uint32_t>(at + 48), 0x18191A1BU);
  EXPECT_EQ(load_le<std::uint32_t>(at + 52), 0U);
  EXPECT_EQ(load_le<std::uint64_t>(at + 56), 0x2122232425262728U);
  EXPECT_EQ(load_le<std::uint64_t>(at + 64), 0x3132333435363738U);
}

TEST(Trace, WhatIsEncodedIsDecoded) {
  const TraceHeader header = some_header();
  const Result<TraceHeader> read = decode_header(encode(header), file_bytes(header));
  ASSERT_TRUE(read) << describe(read.error());
  EXPECT_EQ(encode(*read), encode(header));
  EXPECT_EQ(read->settings, header.settings);
  EXPECT_TRUE(read->has_outputs());

  TraceRecord record = some_record();
  for (const bool fresh : {false, true}) {
    record.input.fresh = fresh;
    record.input.age = fresh ? 0 : 65535;
    const Result<TraceRecord> again = decode_record(encode(record));
    ASSERT_TRUE(again);
    EXPECT_EQ(encode(*again), encode(record));
    EXPECT_EQ(again->output, record.output);
    EXPECT_EQ(again->input.hip, record.input.hip);
  }
}

TEST(Trace, AnEmptyTraceAndANewerMinorVersionAreRead) {
  TraceHeader header;
  EXPECT_TRUE(decode_header(encode(header), 96));
  TraceHeaderBytes bytes = encode(header);
  store_le<std::uint16_t>(bytes.data() + 6, 5);
  store_le(bytes.data() + 92, crc32(bytes.data(), 92));
  EXPECT_TRUE(decode_header(bytes, 96));
}

TEST(Trace, EveryMalformedHeaderIsRefusedForItsReason) {
  struct Malformed {
    std::string what;
    Error expected;
    std::function<void(std::uint8_t*)> spoil;  ///< the checksum is made right afterwards
  };
  const std::vector<Malformed> cases = {
      {"another magic", Error::kBadMagic, [](std::uint8_t* h) { h[3] = 'X'; }},
      {"a blob", Error::kBadMagic, [](std::uint8_t* h) { h[2] = 'F', h[3] = 'B'; }},
      {"the next major version", Error::kBadVersion, [](std::uint8_t* h) { store_le<std::uint16_t>(h + 4, 2); }},
      {"another header length", Error::kBadHeader, [](std::uint8_t* h) { store_le(h + 8, 100U); }},
      {"another record length", Error::kBadHeader, [](std::uint8_t* h) { store_le(h + 12, 0U); }},
      {"one record too many", Error::kTruncated, [](std::uint8_t* h) { store_le<std::uint64_t>(h + 16, 4); }},
      {"2^64 - 1 records", Error::kTruncated, [](std::uint8_t* h) { store_le(h + 16, ~std::uint64_t{0}); }},
      {"a record count that overflows to the right size", Error::kTruncated,
       [](std::uint8_t* h) { store_le(h + 16, (std::uint64_t{1} << 61) + 3); }},
      {"one record too few", Error::kBadSize, [](std::uint8_t* h) { store_le<std::uint64_t>(h + 16, 2); }},
      {"a friction above 1.5", Error::kBadHeader, [](std::uint8_t* h) { store_le(h + 64, kMostFriction.raw() + 1); }},
      {"a damping below 0", Error::kBadHeader, [](std::uint8_t* h) { store_le(h + 72, -1); }},
      {"a damping above 0.1", Error::kBadHeader, [](std::uint8_t* h) { store_le(h + 80, kMostDamping.raw() + 1); }},
      {"a weight below -5 N", Error::kBadHeader, [](std::uint8_t* h) { store_le(h + 84, (-kMostWeight).raw() - 1); }},
      {"a delay of 8", Error::kBadHeader, [](std::uint8_t* h) { store_le(h + 88, 8U); }},
      {"a period of 0", Error::kBadHeader, [](std::uint8_t* h) { store_le(h + 40, 0U); }},
      {"a period below 0.1 ms", Error::kBadHeader, [](std::uint8_t* h) { store_le(h + 40, 99'999U); }},
      {"a period above 4 ms", Error::kBadHeader, [](std::uint8_t* h) { store_le(h + 40, 4'000'001U); }},
      {"an undefined flag", Error::kBadHeader, [](std::uint8_t* h) { store_le(h + 44, 4U); }},
      {"a negative stiffness", Error::kBadHeader, [](std::uint8_t* h) { store_le(h + 48, -1); }},
      {"a stiffness above 100 N/mm", Error::kBadHeader, [](std::uint8_t* h) { store_le(h + 48, (100 << 16) + 1); }},
      {"a negative damping", Error::kBadHeader, [](std::uint8_t* h) { store_le(h + 52, -1); }},
      {"a force limit of 0", Error::kBadHeader, [](std::uint8_t* h) { store_le(h + 56, 0); }},
      {"a negative force limit", Error::kBadHeader, [](std::uint8_t* h) { store_le(h + 56, INT32_MIN); }},
      {"an endless ramp", Error::kBadHeader, [](std::uint8_t* h) { store_le(h + 60, ~0U); }},
  };
  for (const Malformed& malformed : cases) {
    TraceHeaderBytes bytes = encode(some_header());
    malformed.spoil(bytes.data());
    store_le(bytes.data() + 92, crc32(bytes.data(), 92));
    const Result<TraceHeader> read = decode_header(bytes, file_bytes(some_header()));
    ASSERT_FALSE(read) << malformed.what;
    EXPECT_EQ(read.error(), malformed.expected) << malformed.what << ": " << describe(read.error());
  }
}

TEST(Trace, EveryLengthButTheRightOneIsRefused) {
  const TraceHeaderBytes bytes = encode(some_header());
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    const std::vector<std::uint8_t> head(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
    const Result<TraceHeader> read = decode_header(head, size);
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error(), size < 4 ? Error::kBadMagic : Error::kTruncated) << size;
  }
  const std::uint64_t right = file_bytes(some_header());
  for (std::uint64_t size = 96; size < right + 100; ++size) EXPECT_EQ(decode_header(bytes, size).has_value(), size == right) << size;
}

TEST(Trace, EveryFlippedBitOfTheHeaderIsSeen) {
  TraceHeaderBytes bytes = encode(some_header());
  for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
    bytes[bit / 8] ^= static_cast<std::uint8_t>(1U << (bit % 8));
    EXPECT_FALSE(decode_header(bytes, file_bytes(some_header()))) << bit;
    bytes[bit / 8] ^= static_cast<std::uint8_t>(1U << (bit % 8));
  }
}

TEST(Trace, ARecordWithAnUndefinedValueIsRefused) {
  const TraceRecordBytes good = encode(some_record());
  const auto refused_at = [&](std::size_t offset, std::uint8_t value) {
    TraceRecordBytes bytes = good;
    bytes[offset] = value;
    const Result<TraceRecord> read = decode_record(bytes);
    return !read && read.error() == Error::kBadRecord;
  };
  EXPECT_TRUE(refused_at(12, 0x10)) << "a fifth button";
  EXPECT_TRUE(refused_at(13, 2)) << "an undefined bit beside fresh";
  EXPECT_TRUE(refused_at(13, 1)) << "a fresh sample with an age";
  for (std::size_t offset = 52; offset < 56; ++offset) EXPECT_TRUE(refused_at(offset, 1)) << "a reserved byte";
}

TEST(Trace, TheChainIsTheHashThatTheSpecificationStates) {
  TraceHeader header = some_header();
  header.blob_hash = 0;
  header.flags = 0;
  Chain chain(header, 0xABCDEF);
  TraceHeaderBytes used = encode(header);
  store_le<std::uint64_t>(used.data() + 24, 0xABCDEF);
  store_le<std::uint32_t>(used.data() + 44, 1);
  std::uint64_t expected = hash64(used.data() + 64, 28, hash64(used.data() + 24, 40));
  EXPECT_EQ(chain.value(), expected);
  TraceHeader plain = header;  // as version 0 knew it
  plain.settings = {Stiffness::of(2), Damping::of(0.001), Newton::of(7.5), 40};
  EXPECT_EQ(Chain(plain, 0xABCDEF).value(), hash64(used.data() + 24, 40));
  const TraceRecord record = some_record();
  for (int tick = 0; tick < 3; ++tick) {
    expected = hash64(encode(record).data(), 56, expected);
    EXPECT_EQ(chain.extend(record.input, record.output), expected);
    EXPECT_EQ(chain.value(), expected);
  }
}

TEST(Trace, TheChainSeesInputsSettingsAndOutputsAndNothingElse) {
  const auto chain_of = [](const TraceHeader& header, const TraceRecord& record, std::uint64_t blob = 5) {
    return Chain(header, blob).extend(record.input, record.output);
  };
  const TraceHeader header = some_header();
  const TraceRecord record = some_record();
  std::set<std::uint64_t> seen = {chain_of(header, record), chain_of(header, record, 6)};
  std::size_t changes = 2;
  const auto changed_header = [&](auto change) {
    TraceHeader other = header;
    change(other);
    seen.insert(chain_of(other, record));
    ++changes;
  };
  changed_header([](TraceHeader& h) { h.model_hash ^= 1; });
  changed_header([](TraceHeader& h) { h.period_ns += 1; });
  changed_header([](TraceHeader& h) { h.settings.stiffness = Stiffness::of(3); });
  changed_header([](TraceHeader& h) { h.settings.damping = Damping{}; });
  changed_header([](TraceHeader& h) { h.settings.force_limit = Newton::of(7); });
  changed_header([](TraceHeader& h) { h.settings.ramp_ticks += 1; });
  changed_header([](TraceHeader& h) { h.settings.friction = {}; });
  changed_header([](TraceHeader& h) { h.settings.friction_damping = {}; });
  changed_header([](TraceHeader& h) { h.settings.hand_damping = {}; });
  changed_header([](TraceHeader& h) { h.settings.passivity = {}; });
  changed_header([](TraceHeader& h) { h.settings.device_damping = {}; });
  changed_header([](TraceHeader& h) { h.settings.weight = {}; });
  changed_header([](TraceHeader& h) { h.settings.delay_ticks = 0; });
  // Every bit of a record up to byte 51 is input or output: the next four are reserved.
  for (std::size_t bit = 0; bit < 8 * 52; ++bit) {
    TraceRecordBytes bytes = encode(record);
    bytes[bit / 8] ^= static_cast<std::uint8_t>(1U << (bit % 8));
    const Result<TraceRecord> other = decode_record(bytes);
    if (!other) continue;  // an undefined button, or the flags
    seen.insert(chain_of(header, *other));
    ++changes;
  }
  EXPECT_EQ(seen.size(), changes);
  EXPECT_GT(changes, 400U);

  TraceRecord later = record;
  later.arrival_ns += 1;
  later.chain += 1;
  TraceHeader longer = header;
  longer.record_count += 1;
  longer.blob_hash += 1;  // the chain takes the blob that was really used
  EXPECT_EQ(chain_of(longer, later), chain_of(header, record));
}

}  // namespace
}  // namespace isotouch
