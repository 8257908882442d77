#include "shared/device_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "shared/bytes.h"

namespace isotouch {
namespace {

TEST(DeviceModel, WhatIsEncodedIsDecoded) {
  for (const DeviceModel& model : {libnifalcon_model(), martin_hillier_model()}) {
    const Result<DeviceModel> read = decode_model(encode(model));
    ASSERT_TRUE(read);
    EXPECT_EQ(*read, model);
  }
  EXPECT_NE(hash(libnifalcon_model()), hash(martin_hillier_model()));
}

TEST(DeviceModel, StandsAsTheSpecificationDrawsIt) {
  const DeviceModelBytes bytes = encode(libnifalcon_model());
  const std::uint8_t* at = bytes.data();
  EXPECT_EQ(load_le<std::int32_t>(at), 60 << 20);
  EXPECT_EQ(load_le<std::int32_t>(at + 12), Mm::of(-25.57).raw());
  EXPECT_EQ(load_le<std::int32_t>(at + 16), Mm::of(-1.91).raw());
  EXPECT_EQ(load_le<std::uint32_t>(at + 20), Angle::degrees(105).raw());
  EXPECT_EQ(load_le<std::uint32_t>(at + 40), Angle::degrees(35).raw());
  EXPECT_EQ(load_le<std::int32_t>(at + 56), NewtonMmPerWord::of(0.1).raw());
  EXPECT_EQ(load_le<std::int32_t>(at + 68), 125 << 20);
  EXPECT_EQ(load_le<std::int32_t>(at + 72), 4095);
  EXPECT_EQ(load_le<std::int32_t>(at + 80), 20 << 20);
  EXPECT_EQ(load_le<std::uint32_t>(at + 88), 3U);
  EXPECT_EQ(load_le<std::uint32_t>(at + 92), 100'000'000U);
  EXPECT_EQ(load_le<std::int32_t>(at + 104), Mm::of(0.046).raw());
  EXPECT_EQ(at[108], 1);
  EXPECT_EQ(at[111], 2);
  EXPECT_EQ(load_le<std::int32_t>(at + 112), 2000);
  EXPECT_EQ(load_le<std::uint32_t>(at + 116), 20'000U);
  EXPECT_EQ(at[120], 15);
  EXPECT_EQ(at[121], 0);
  EXPECT_TRUE(std::all_of(at + 122, at + kDeviceModelBytes, [](std::uint8_t b) { return b == 0; }));
}

TEST(DeviceModel, EveryByteIsInTheHashOrRefused) {
  const DeviceModelBytes good = encode(libnifalcon_model());
  std::set<std::uint64_t> seen = {hash(libnifalcon_model())};
  std::size_t accepted = 1;
  for (std::size_t bit = 0; bit < 8 * good.size(); ++bit) {
    DeviceModelBytes bytes = good;
    bytes[bit / 8] ^= static_cast<std::uint8_t>(1U << (bit % 8));
    const Result<DeviceModel> read = decode_model(bytes);
    if (!read) {
      EXPECT_EQ(read.error(), Error::kBadModel);
      continue;
    }
    EXPECT_LT(bit / 8, 122U) << "a reserved byte";
    ++accepted;
    seen.insert(hash(*read));
  }
  EXPECT_EQ(seen.size(), accepted);
  EXPECT_GT(accepted, 300U);
}

TEST(DeviceModel, NumbersThatWouldOverflowTheTickAreRefused) {
  const auto refused = [](auto change) {
    DeviceModel model = libnifalcon_model();
    change(model);
    return !decode_model(encode(model));
  };
  EXPECT_TRUE(refused([](DeviceModel& m) { m.arm = Mm::of(121); }));
  EXPECT_TRUE(refused([](DeviceModel& m) { m.rod = Mm::of(49); }));
  EXPECT_TRUE(refused([](DeviceModel& m) { m.joint = Mm::of(-1); }));
  EXPECT_TRUE(refused([](DeviceModel& m) { m.word_torque = NewtonMmPerWord{}; }));
  EXPECT_TRUE(refused([](DeviceModel& m) { m.word_limit = 4096; }));
  EXPECT_TRUE(refused([](DeviceModel& m) { m.word_slew = 0; }));
  EXPECT_TRUE(refused([](DeviceModel& m) { m.hold_ticks = 0; }));
  EXPECT_TRUE(refused([](DeviceModel& m) { m.ramp_ticks = 0; }));
  EXPECT_TRUE(refused([](DeviceModel& m) { m.legs[2].per_count = AnglePerCount{}; }));
  EXPECT_TRUE(refused([](DeviceModel& m) { m.led_idle = 0x10; }));
  EXPECT_TRUE(refused([](DeviceModel& m) { m.heat_word = 0; }));
  EXPECT_TRUE(refused([](DeviceModel& m) { m.heat_ms = 999; }));
  EXPECT_TRUE(refused([](DeviceModel& m) { m.buttons = 16; }));
  EXPECT_TRUE(refused([](DeviceModel& m) { m.hold_to_run = 2; }));
  EXPECT_FALSE(refused([](DeviceModel&) {}));
  EXPECT_FALSE(refused([](DeviceModel& m) { m.heat_word = 0, m.heat_ms = 0; }));  // as version 2.0 of the trace had it
}

}  // namespace
}  // namespace isotouch
