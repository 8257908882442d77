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

using namespace trace_layout;

TraceHeader some_header() {
  TraceHeader header;
  header.record_count = 3;
  header.field_hash = 0x1122334455667788;
  header.has_outputs = true;
  header.settings_checksum = 0x4142434445464748;
  header.period_ns = 500'000;
  header.settings.stiffness = Stiffness::of(2);
  header.settings.damping = Damping::of(0.001);
  header.settings.force_limit = Newton::of(7.5);
  header.settings.friction = Ratio::of(0.5);
  header.settings.friction_damping = Damping::of(0.002);
  header.settings.hand_damping = Damping::of(0.003);
  header.settings.passivity = Damping::of(0.004);
  header.settings.weight = Newton::of(-0.75);
  header.settings.ramp_ticks = 40;
  header.settings.device_damping = Damping::of(0.005);
  header.settings.delay_ticks = 3;
  header.device = martin_hillier_model();
  return header;
}

/// Every field has a value of its own.
TraceRecord some_record(InputKind kind) {
  TraceRecord record;
  Input& in = record.input;
  in.kind = kind;
  in.lines = kLineEnableWrong;
  in.late = 19;
  in.requests = kRequestResume;
  in.change = {TickSetting::kFriction, 0x0A0B0C0D};
  in.age = 0x0203;
  in.author = 0x0E0D0C0B;
  in.field_generation = 0x04050607;
  if (kind == InputKind::kPosition) {
    in.hip = {Mm::from_raw(0x01020304), Mm::from_raw(-5), Mm::from_raw(6)};
    in.buttons = 0x0B;
  } else {
    in.packet = encode(FalconReply{{1447, -1447, 12}, 4, 7});
  }
  Output& out = record.output;
  out.hip = {Mm::from_raw(1), Mm::from_raw(-2), Mm::from_raw(3)};
  out.proxy = {Mm::from_raw(7), Mm::from_raw(-8), Mm::from_raw(9)};
  out.force = {Newton::from_raw(-10), Newton::from_raw(11), Newton::from_raw(12)};
  out.commands = {-13, 14, -15};
  out.state = 0x1617;
  out.status = 0x18191A1B;
  out.faults = 0x1C1D;
  out.packet_flags = 0x0E;
  out.buttons = 0x0F;
  record.chain = 0x2122232425262728;
  record.arrival_ns = 0x3132333435363738;
  return record;
}

constexpr std::array kKinds = {InputKind::kPosition, InputKind::kPacket};

std::uint64_t file_bytes(const TraceHeader& header) { return 256 + 104 * header.record_count; }

void repair(TraceHeaderBytes& bytes) { store_le(bytes.data() + 252, crc32(bytes.data(), 252)); }

TEST(Trace, TheHeaderStandsAsTheSpecificationDrawsIt) {
  const TraceHeaderBytes bytes = encode(some_header());
  const std::uint8_t* at = bytes.data();
  EXPECT_EQ(std::string(at, at + 4), "ITRC");
  EXPECT_EQ(load_le<std::uint16_t>(at + 4), 3);
  EXPECT_EQ(load_le<std::uint16_t>(at + 6), 0);
  EXPECT_EQ(load_le<std::uint32_t>(at + 8), 256U);
  EXPECT_EQ(load_le<std::uint32_t>(at + 12), 104U);
  EXPECT_EQ(load_le<std::uint64_t>(at + 16), 3U);
  EXPECT_EQ(load_le<std::uint64_t>(at + 24), 0x1122334455667788U);
  EXPECT_EQ(load_le<std::uint32_t>(at + 32), 1U);
  EXPECT_EQ(load_le<std::uint32_t>(at + 36), 500'000U);
  const RawSettings settings = raw_settings(some_header().settings);
  for (std::size_t i = 0; i < kTickSettings; ++i) EXPECT_EQ(load_le<std::int32_t>(at + 40 + 4 * i), settings[i]) << i;
  EXPECT_EQ(load_le<std::uint32_t>(at + 84), 0U);
  const DeviceModelBytes model = encode(martin_hillier_model());
  EXPECT_TRUE(std::equal(model.begin(), model.end(), at + 88));
  EXPECT_EQ(load_le<std::uint64_t>(at + 216), 0x4142434445464748U);
  EXPECT_TRUE(std::all_of(at + 224, at + 252, [](std::uint8_t b) { return b == 0; }));
  EXPECT_EQ(load_le<std::uint32_t>(at + 252), crc32(at, 252));
}

TEST(Trace, ARestartWithoutAChangeHoldsTheHeat) {
  for (const InputKind kind : kKinds) {
    TraceRecord record = some_record(kind);
    record.input.requests = kRequestRestart;
    record.input.change = {};
    record.input.heat = 0xF1020304;
    EXPECT_EQ(load_le<std::uint32_t>(encode(record).data() + 8), 0xF1020304);
    record.input.buttons = kind == InputKind::kPosition ? std::uint8_t{3} : std::uint8_t{0};
    const auto read = decode_record(encode(record));
    ASSERT_TRUE(read);
    EXPECT_EQ(*read, record);
    TraceRecordBytes no_restart = encode(record);
    no_restart[4] = 0;
    EXPECT_FALSE(decode_record(no_restart)) << "a value of no setting";
  }
}

TEST(Trace, APatchIsNamedByTheImageAfter) {
  for (const InputKind kind : kKinds) {
    TraceRecord record = some_record(kind);
    record.input.requests = kRequestMoved | kRequestStop;
    record.input.change = {};
    record.input.moved_to = 0xF1020304;
    record.input.field_generation = 5;
    record.input.buttons = kind == InputKind::kPosition ? std::uint8_t{3} : std::uint8_t{0};
    TraceRecordBytes bytes = encode(record);
    EXPECT_EQ(bytes[4], 0b1001);
    EXPECT_EQ(load_le<std::uint32_t>(bytes.data() + 8), 0xF1020304);
    const auto read = decode_record(bytes);
    ASSERT_TRUE(read);
    EXPECT_EQ(*read, record);
    const auto refused = [&](std::size_t at, std::uint8_t value) {
      TraceRecordBytes bad = bytes;
      bad[at] = value;
      return !decode_record(bad);
    };
    EXPECT_TRUE(refused(4, 0b1100)) << "with a restart";
    EXPECT_TRUE(refused(4, 0b101000)) << "an unknown request";
    EXPECT_TRUE(refused(5, 1)) << "with a change of a setting";
    EXPECT_TRUE(refused(12, 0)) << "without a field";
  }
}

TEST(Trace, TheRecordStandsAsTheSpecificationDrawsIt) {
  for (const InputKind kind : kKinds) {
    const TraceRecordBytes bytes = encode(some_record(kind));
    const std::uint8_t* at = bytes.data();
    EXPECT_EQ(at[0], static_cast<std::uint8_t>(kind));
    EXPECT_EQ(at[1], 0);
    EXPECT_EQ(at[2], kLineEnableWrong);
    EXPECT_EQ(at[3], 19);
    EXPECT_EQ(at[4], kRequestResume);
    EXPECT_EQ(at[5], static_cast<std::uint8_t>(TickSetting::kFriction));
    EXPECT_EQ(load_le<std::uint16_t>(at + 6), 0x0203);
    EXPECT_EQ(load_le<std::int32_t>(at + 8), 0x0A0B0C0D);
    EXPECT_EQ(load_le<std::uint32_t>(at + 12), 0x04050607U);
    if (kind == InputKind::kPosition) {
      for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(load_le<std::int32_t>(at + 16 + 4 * i), (std::array{0x01020304, -5, 6})[i]);
      EXPECT_EQ(load_le<std::uint32_t>(at + 28), 0x0BU);
    } else {
      const FalconPacket packet = some_record(kind).input.packet;
      EXPECT_TRUE(std::equal(packet.begin(), packet.end(), at + 16));
    }
    for (std::size_t i = 0; i < 9; ++i) EXPECT_EQ(load_le<std::int32_t>(at + 32 + 4 * i), (std::array{1, -2, 3, 7, -8, 9, -10, 11, 12})[i]);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(load_le<std::int16_t>(at + 68 + 2 * i), (std::array{-13, 14, -15})[i]);
    EXPECT_EQ(load_le<std::uint16_t>(at + 74), 0x1617);
    EXPECT_EQ(load_le<std::uint32_t>(at + 76), 0x18191A1BU);
    EXPECT_EQ(load_le<std::uint16_t>(at + 80), 0x1C1D);
    EXPECT_EQ(at[82], 0x0E);
    EXPECT_EQ(at[83], 0x0F);
    EXPECT_EQ(load_le<std::uint32_t>(at + 84), 0x0E0D0C0BU);
    EXPECT_EQ(load_le<std::uint64_t>(at + 88), 0x2122232425262728U);
    EXPECT_EQ(load_le<std::uint64_t>(at + 96), 0x3132333435363738U);
  }
}

TEST(Trace, WhatIsEncodedIsDecoded) {
  const TraceHeader header = some_header();
  const Result<TraceHeader> read = decode_header(encode(header), file_bytes(header));
  ASSERT_TRUE(read) << describe(read.error());
  EXPECT_EQ(*read, header);
  for (const InputKind kind : kKinds) {
    TraceRecord record = some_record(kind);
    for (const bool fresh : {false, true}) {
      record.input.fresh = fresh;
      record.input.age = fresh ? 0 : 65535;
      const Result<TraceRecord> again = decode_record(encode(record));
      ASSERT_TRUE(again);
      EXPECT_EQ(*again, record);
    }
  }
}

TEST(Trace, AnEmptyTraceAndANewerMinorVersionAreRead) {
  TraceHeaderBytes bytes = encode(TraceHeader{});
  EXPECT_TRUE(decode_header(bytes, 256));
  store_le<std::uint16_t>(bytes.data() + 6, 5);
  repair(bytes);
  EXPECT_TRUE(decode_header(bytes, 256));
}

TEST(Trace, EveryMalformedHeaderIsRefusedForItsReason) {
  struct Malformed {
    std::string what;
    Error expected;
    std::function<void(std::uint8_t*)> spoil;  ///< the checksum is made right afterwards
  };
  std::vector<Malformed> cases = {
      {"another magic", Error::kBadMagic, [](std::uint8_t* h) { h[3] = 'X'; }},
      {"a field", Error::kBadMagic, [](std::uint8_t* h) { h[2] = 'F', h[3] = 'B'; }},
      {"the version before", Error::kBadVersion, [](std::uint8_t* h) { store_le<std::uint16_t>(h + 4, 2); }},
      {"the next major version", Error::kBadVersion, [](std::uint8_t* h) { store_le<std::uint16_t>(h + 4, 4); }},
      {"another header length", Error::kBadHeader, [](std::uint8_t* h) { store_le(h + 8, 100U); }},
      {"another record length", Error::kBadHeader, [](std::uint8_t* h) { store_le(h + 12, 0U); }},
      {"one record too many", Error::kTruncated, [](std::uint8_t* h) { store_le<std::uint64_t>(h + 16, 4); }},
      {"2^64 - 1 records", Error::kTruncated, [](std::uint8_t* h) { store_le(h + 16, ~std::uint64_t{0}); }},
      {"a record count that overflows to the right size", Error::kTruncated,
       [](std::uint8_t* h) { store_le(h + 16, (std::uint64_t{1} << 61) + 3); }},
      {"one record too few", Error::kBadSize, [](std::uint8_t* h) { store_le<std::uint64_t>(h + 16, 2); }},
      {"outputs that are neither there nor not", Error::kBadHeader, [](std::uint8_t* h) { h[32] = 2; }},
      {"a period of 0", Error::kBadHeader, [](std::uint8_t* h) { store_le(h + 36, 0U); }},
      {"a period below 0.1 ms", Error::kBadHeader, [](std::uint8_t* h) { store_le(h + 36, 99'999U); }},
      {"a period above 4 ms", Error::kBadHeader, [](std::uint8_t* h) { store_le(h + 36, 4'000'001U); }},
      {"a setting outside its range", Error::kBadHeader, [](std::uint8_t* h) { store_le(h + 40, -1); }},
      {"a model without arms", Error::kBadModel, [](std::uint8_t* h) { store_le(h + 88, 0); }},
      {"a model with a reserved byte", Error::kBadModel, [](std::uint8_t* h) { h[88 + 127] = 1; }},
  };
  for (const std::size_t reserved : {33U, 35U, 84U, 87U, 224U, 251U}) {
    cases.push_back({"reserved byte " + std::to_string(reserved), Error::kBadHeader, [=](std::uint8_t* h) { h[reserved] = 1; }});
  }
  for (const Malformed& malformed : cases) {
    TraceHeaderBytes bytes = encode(some_header());
    malformed.spoil(bytes.data());
    repair(bytes);
    const Result<TraceHeader> read = decode_header(bytes, file_bytes(some_header()));
    ASSERT_FALSE(read) << malformed.what;
    EXPECT_EQ(read.error(), malformed.expected) << malformed.what << ": " << describe(read.error());
  }
}

TEST(Trace, EveryLengthButTheRightOneAndEveryFlippedBitIsRefused) {
  TraceHeaderBytes bytes = encode(some_header());
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    const std::vector<std::uint8_t> head(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
    const Result<TraceHeader> read = decode_header(head, size);
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error(), size < 6 ? Error::kBadMagic : Error::kTruncated) << size;
  }
  const std::uint64_t right = file_bytes(some_header());
  for (std::uint64_t size = 256; size < right + 110; ++size) EXPECT_EQ(decode_header(bytes, size).has_value(), size == right) << size;
  for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
    bytes[bit / 8] ^= static_cast<std::uint8_t>(1U << (bit % 8));
    EXPECT_FALSE(decode_header(bytes, right)) << bit;
    bytes[bit / 8] ^= static_cast<std::uint8_t>(1U << (bit % 8));
  }
}

TEST(Trace, ARecordWithAnUndefinedValueIsRefused) {
  const auto refused_at = [](InputKind kind, std::size_t offset, std::uint8_t value) {
    TraceRecordBytes bytes = encode(some_record(kind));
    bytes[offset] = value;
    const Result<TraceRecord> read = decode_record(bytes);
    return !read && read.error() == Error::kBadRecord;
  };
  for (const InputKind kind : kKinds) {
    EXPECT_TRUE(refused_at(kind, 0, 2)) << "a third kind";
    EXPECT_TRUE(refused_at(kind, 1, 1)) << "a fresh sample with an age";
    EXPECT_TRUE(refused_at(kind, 1, 2)) << "neither fresh nor not";
    EXPECT_TRUE(refused_at(kind, 2, 0x28)) << "an undefined verdict";
    EXPECT_TRUE(refused_at(kind, 3, 32)) << "more late periods than are counted";
    EXPECT_TRUE(refused_at(kind, 4, 8)) << "an undefined request";
    EXPECT_TRUE(refused_at(kind, 5, 9)) << "a setting that may not change";
    EXPECT_TRUE(refused_at(kind, 5, 0)) << "a value of no setting";
    EXPECT_TRUE(refused_at(kind, 11, 0x60)) << "a friction above 1.5";
    EXPECT_TRUE(refused_at(kind, 11, 0x80)) << "a friction below 0";
    EXPECT_FALSE(refused_at(kind, 84, 1)) << "any user may be an author";
  }
  EXPECT_TRUE(refused_at(InputKind::kPosition, 28, 0x10)) << "a fifth button";
  for (std::size_t offset = 29; offset < 32; ++offset) EXPECT_TRUE(refused_at(InputKind::kPosition, offset, 1)) << "a reserved byte";
  EXPECT_FALSE(refused_at(InputKind::kPacket, 16, 0)) << "a malformed packet is an input like any other";
}

TEST(Trace, EveryVerdictOfTheGuardFitsBesideTheLines) {
  for (std::size_t number = 0; number < kGuardVerdicts; ++number) {
    const auto verdict = static_cast<GuardVerdict>(number);
    const std::uint8_t bits = line_bits(verdict);
    EXPECT_EQ(bits & ~kLineGuard, 0) << number;
    EXPECT_EQ(guard_verdict(static_cast<std::uint8_t>(bits | kLineStop | kLineEnableWrong | kLineMemory)), verdict) << number;
  }
}

TEST(Trace, TheChainIsTheHashThatTheSpecificationStates) {
  const TraceHeader header = some_header();
  Chain chain(header);
  std::uint64_t expected = hash64(encode(header).data() + 36, 180);
  EXPECT_EQ(chain.value(), expected);
  for (const InputKind kind : kKinds) {
    const TraceRecord record = some_record(kind);
    expected = hash64(encode(record).data(), 88, expected);
    EXPECT_EQ(chain.extend(record.input, record.output), expected);
    EXPECT_EQ(chain.value(), expected);
  }
}

TEST(Trace, TheChainSeesInputsSettingsDeviceAndOutputsAndNothingElse) {
  const auto chain_of = [](const TraceHeader& header, const TraceRecord& record) {
    return Chain(header).extend(record.input, record.output);
  };
  for (const InputKind kind : kKinds) {
    const TraceHeader header = some_header();
    const TraceRecord record = some_record(kind);
    std::set<std::uint64_t> seen = {chain_of(header, record)};
    std::size_t changes = 1;
    const auto changed_header = [&](auto change) {
      TraceHeader other = header;
      change(other);
      seen.insert(chain_of(other, record));
      ++changes;
    };
    changed_header([](TraceHeader& h) { h.device.led_idle ^= 1; });
    changed_header([](TraceHeader& h) { h.device.play = Mm{}; });
    changed_header([](TraceHeader& h) { h.period_ns += 1; });
    for (std::size_t i = 0; i < kTickSettings; ++i) {
      changed_header([&](TraceHeader& h) {
        RawSettings raw = raw_settings(h.settings);
        raw[i] += 1;
        h.settings = from_raw(raw);
      });
    }
    for (std::size_t bit = 0; bit < 8 * 88; ++bit) {
      TraceRecordBytes bytes = encode(record);
      bytes[bit / 8] ^= static_cast<std::uint8_t>(1U << (bit % 8));
      const Result<TraceRecord> other = decode_record(bytes);
      if (!other || other->input.kind != kind) continue;
      seen.insert(chain_of(header, *other));
      ++changes;
    }
    EXPECT_EQ(seen.size(), changes);
    EXPECT_GT(changes, 580U);

    TraceRecord later = record;
    later.arrival_ns += 1;
    later.chain += 1;
    TraceHeader longer = header;
    longer.record_count += 1;
    longer.field_hash += 1;
    longer.has_outputs = false;
    EXPECT_EQ(chain_of(longer, later), chain_of(header, record));
  }
}

TEST(Trace, ADifferenceIsNamedByItsFieldAndPart) {
  for (const InputKind kind : kKinds) {
    const TraceRecord record = some_record(kind);
    EXPECT_FALSE(differing_input(record.input, record.input));
    EXPECT_FALSE(differing_output(record.output, record.output));
    const auto input_named = [&](auto change) {
      Input other = record.input;
      change(other);
      return std::string(differing_input(record.input, other).view());
    };
    const auto output_named = [&](auto change) {
      Output other = record.output;
      change(other);
      return std::string(differing_output(record.output, other).view());
    };
    EXPECT_EQ(input_named([](Input& in) { in.fresh = true; }), "input.fresh");
    EXPECT_EQ(input_named([](Input& in) { in.age = 7; }), "input.age");
    EXPECT_EQ(input_named([](Input& in) { in.change.raw = 7; }), "input.value");
    EXPECT_EQ(input_named([](Input& in) { in.author = author_of(1000); }), "input.author");
    EXPECT_EQ(input_named([](Input& in) { in.kind = in.kind == InputKind::kPacket ? InputKind::kPosition : InputKind::kPacket; }),
              "input.kind");
    if (kind == InputKind::kPosition) {
      EXPECT_EQ(input_named([](Input& in) { in.hip.y = Mm{}; }), "input.hip.y");
      EXPECT_EQ(input_named([](Input& in) { in.buttons = 0; }), "input.buttons");
    } else {
      EXPECT_EQ(input_named([](Input& in) { in.packet[9] ^= 1; }), "input.packet");
    }
    EXPECT_EQ(output_named([](Output& out) { out.hip.z = Mm{}; }), "hip.z");
    EXPECT_EQ(output_named([](Output& out) { out.force.x = Newton{}; }), "force.x");
    EXPECT_EQ(output_named([](Output& out) { out.commands[1] = 0; }), "commands[1]");
    EXPECT_EQ(output_named([](Output& out) { out.commands[2] = 0, out.status = 0; }), "commands[2]");
    EXPECT_EQ(output_named([](Output& out) { out.state = 0; }), "state");
    EXPECT_EQ(output_named([](Output& out) { out.faults = 0; }), "faults");
    EXPECT_EQ(output_named([](Output& out) { out.buttons = 0; }), "buttons");
  }
}

}  // namespace
}  // namespace isotouch
