#include "shared/tick_settings.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <set>
#include <string>

#include "shared/trace.h"

namespace isotouch {
namespace {

TEST(TickSettings, RawValuesGoInAndComeOutInTheOrderOfTheirNumbers) {
  const RawSettings raw = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11};
  const TickSettings settings = from_raw(raw);
  EXPECT_EQ(raw_settings(settings), raw);
  EXPECT_EQ(settings.stiffness.raw(), static_cast<int>(TickSetting::kStiffness));
  EXPECT_EQ(settings.damping.raw(), static_cast<int>(TickSetting::kDamping));
  EXPECT_EQ(settings.force_limit.raw(), static_cast<int>(TickSetting::kForceLimit));
  EXPECT_EQ(settings.friction.raw(), static_cast<int>(TickSetting::kFriction));
  EXPECT_EQ(settings.friction_damping.raw(), static_cast<int>(TickSetting::kFrictionDamping));
  EXPECT_EQ(settings.hand_damping.raw(), static_cast<int>(TickSetting::kHandDamping));
  EXPECT_EQ(settings.passivity.raw(), static_cast<int>(TickSetting::kPassivity));
  EXPECT_EQ(settings.weight.raw(), static_cast<int>(TickSetting::kWeight));
  EXPECT_EQ(settings.ramp_ticks, static_cast<unsigned>(TickSetting::kRampTicks));
  EXPECT_EQ(settings.device_damping.raw(), static_cast<int>(TickSetting::kDeviceDamping));
  EXPECT_EQ(settings.delay_ticks, static_cast<unsigned>(TickSetting::kDelayTicks));
}

TEST(TickSettings, LiveOnesReplaceOnlyThemselves) {
  const TickSettings before = from_raw({1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11});
  EXPECT_EQ(live_settings(before), (LiveRaw{1, 2, 3, 4, 5, 6, 7, 8}));
  EXPECT_EQ(raw_settings(with_live(before, {21, 22, 23, 24, 25, 26, 27, 28})), (RawSettings{21, 22, 23, 24, 25, 26, 27, 28, 9, 10, 11}));
}

TEST(TickSettings, TheDefaultsAreThoseOfTheTable) {
  const RawSettings raw = raw_settings(TickSettings{});
  for (std::size_t i = 0; i < kTickSettings; ++i) EXPECT_EQ(raw[i], kTickSettingRows[i]->raw(kTickSettingRows[i]->standard)) << i;
}

TEST(TickSettings, EveryRowIsUsable) {
  std::set<std::string> names;
  for (const SettingRow* row : kTickSettingRows) {
    const std::string name(row->name);
    EXPECT_TRUE(names.insert(name).second) << name;
    EXPECT_FALSE(row->meaning.empty()) << name;
    EXPECT_LT(row->low, row->high) << name;
    EXPECT_TRUE((row->standard >= row->low && row->standard <= row->high) || (row->zero_means_unset && row->standard == 0)) << name;
    EXPECT_LT(row->high * static_cast<double>(std::int64_t{1} << row->fraction_bits), 2147483647.0) << name;
    EXPECT_NEAR(row->value(row->raw(row->high)), row->high, 1.0 / static_cast<double>(std::int64_t{1} << row->fraction_bits)) << name;
  }
}

/// Every value that the table allows makes a recording that can be read again, and the next one beyond makes one that is refused: the recording's reader
/// has no range of its own.
TEST(TickSettings, TheExtremesOfEveryRangeAreTheExtremesOfARecordingsHeader) {
  for (std::size_t i = 0; i < kTickSettings; ++i) {
    const SettingRow& row = *kTickSettingRows[i];
    const RawRange range = raw_range(row);
    const auto is_read = [&](std::int64_t value) {
      RawSettings raw = raw_settings(TickSettings{});
      raw[i] = static_cast<std::int32_t>(value);
      TraceHeader header;
      header.settings = from_raw(raw);
      const Result<TraceHeader> read = decode_header(encode(header), trace_layout::kHeaderBytes);
      EXPECT_TRUE(!read || raw_settings(read->settings) == raw) << row.name;
      return read.has_value();
    };
    EXPECT_TRUE(is_read(range.low)) << row.name;
    EXPECT_TRUE(is_read(range.high)) << row.name;
    EXPECT_EQ(is_read(std::int64_t{range.low} - 1), row.zero_means_unset && range.low == 1) << row.name;
    EXPECT_FALSE(is_read(std::int64_t{range.high} + 1)) << row.name;
    if (row.zero_means_unset) {
      EXPECT_TRUE(is_read(0)) << row.name;
      EXPECT_FALSE(is_read(-1)) << row.name;
    }
  }
}

TEST(SettingChange, OnlyLiveSettingsWithinTheirRangeMayChange) {
  const auto valid = [](TickSetting setting, std::int64_t raw) { return is_valid(SettingChange{setting, static_cast<std::int32_t>(raw)}); };
  EXPECT_TRUE(valid(TickSetting::kNone, 0));
  EXPECT_FALSE(valid(TickSetting::kNone, 1));
  for (std::size_t i = 0; i < kTickSettings; ++i) {
    const auto setting = static_cast<TickSetting>(i + 1);
    const RawRange range = raw_range(*kTickSettingRows[i]);
    const bool live = i < kLiveSettings;
    EXPECT_EQ(valid(setting, range.low), live) << i;
    EXPECT_EQ(valid(setting, range.high), live) << i;
    EXPECT_FALSE(valid(setting, std::int64_t{range.low} - 1)) << i;
    EXPECT_FALSE(valid(setting, std::int64_t{range.high} + 1)) << i;
  }
  EXPECT_FALSE(valid(TickSetting::kStiffness, 0)) << "unset is no change";
  EXPECT_TRUE(valid(TickSetting::kForceLimit, 0)) << "no force at all is a value";
  EXPECT_FALSE(valid(static_cast<TickSetting>(12), 5));
  EXPECT_FALSE(valid(static_cast<TickSetting>(255), 5));
}

}  // namespace
}  // namespace isotouch
