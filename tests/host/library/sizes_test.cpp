/// A program that was compiled with the header of 0.9.0 passes these sizes for ever, and owns no byte behind them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <vector>

#include "host/library/isotouch.h"
#include "tests/host/library/golden.h"

namespace isotouch {
namespace {

using test::Field;

constexpr std::size_t kFieldFacts = 152, kSettings = 112, kFelt = 120, kTraceFacts = 40;

/// Structures of an old program, one behind the other, and what lies behind them.
template <class Struct>
class Old {
 public:
  explicit Old(std::size_t bytes) : size(bytes), room_(bytes + 1024, kForeign) {}
  Struct* at() { return reinterpret_cast<Struct*>(room_.data()); }
  template <class Number>
  Number number(std::size_t offset) const {
    Number number{};
    std::memcpy(&number, room_.data() + offset, sizeof number);
    return number;
  }
  bool is_kept_to() const {
    return std::all_of(room_.begin() + static_cast<std::ptrdiff_t>(size), room_.end(), [](std::uint8_t byte) { return byte == kForeign; });
  }
  const std::size_t size;

 private:
  static constexpr std::uint8_t kForeign = 0xA5;
  std::vector<std::uint8_t> room_;
};

TEST(LibrarySizes, FactsOfTheFirstVersionAreGiven) {
  const Field field;
  Old<isotouch_field_facts> facts(kFieldFacts);
  ASSERT_DONE(isotouch_field_describe(field.handle, facts.at(), facts.size));
  EXPECT_EQ(facts.number<std::uint64_t>(0), field.facts().hash);
  EXPECT_TRUE(facts.is_kept_to());

  isotouch_trace trace = 0;
  ASSERT_DONE(isotouch_trace_load(test::golden("positions.trace").c_str(), &trace));
  Old<isotouch_trace_facts> found(kTraceFacts);
  ASSERT_DONE(isotouch_trace_describe(trace, found.at(), found.size));
  EXPECT_GT(found.number<std::uint64_t>(0), 0U);
  EXPECT_TRUE(found.is_kept_to());
  EXPECT_DONE(isotouch_free(trace));
}

TEST(LibrarySizes, ATouchWithTheSettingsOfTheFirstVersionFeelsTheSame) {
  const Field field;
  Old<isotouch_settings> settings(kSettings);
  ASSERT_DONE(isotouch_settings_default(settings.at(), settings.size));
  EXPECT_EQ(settings.number<std::uint32_t>(8), 1'000'000U);
  EXPECT_TRUE(settings.is_kept_to());
  isotouch_touch old = 0, now = 0;
  ASSERT_DONE(isotouch_touch_new(field.handle, settings.at(), settings.size, &old));
  ASSERT_DONE(isotouch_touch_new(field.handle, nullptr, 0, &now));

  const isotouch_field_facts object = field.facts();
  std::vector<double> path;
  for (int tick = 0; tick < 100; ++tick) {
    for (int axis = 0; axis < 3; ++axis) {
      const double middle = (object.low_mm[axis] + object.high_mm[axis]) / 2;
      path.push_back(axis == 1 ? object.high_mm[1] + (middle - object.high_mm[1]) * tick / 100 : middle);
    }
  }
  std::vector<isotouch_felt> wanted(100);
  ASSERT_DONE(isotouch_touch_path(now, 100, path.data(), wanted.data(), 100 * sizeof wanted[0]));
  EXPECT_EQ(wanted.back().contact, 1U);
  Old<isotouch_felt> felt(99 * kFelt);
  ASSERT_DONE(isotouch_touch_path(old, 99, path.data(), felt.at(), felt.size));
  for (std::size_t tick = 0; tick < 99; ++tick) EXPECT_EQ(felt.number<std::uint64_t>(tick * kFelt), tick) << "one lies behind the other";
  EXPECT_TRUE(felt.is_kept_to());
  Old<isotouch_felt> last(kFelt);
  ASSERT_DONE(isotouch_touch_position(old, path.data() + 3 * 99, 0, last.at(), last.size));
  EXPECT_EQ(last.number<double>(64), wanted.back().force_n[1]);
  ASSERT_DONE(isotouch_touch_missed(old, last.at(), last.size));
  EXPECT_TRUE(last.is_kept_to());

  isotouch_touch device = 0;
  ASSERT_DONE(isotouch_touch_new(field.handle, settings.at(), settings.size, &device));
  const std::int32_t counts[3] = {0, 0, 0};
  ASSERT_DONE(isotouch_touch_counts(device, counts, 7, 0, last.at(), last.size));
  EXPECT_TRUE(last.is_kept_to());
  for (const isotouch_touch each : {old, now, device}) EXPECT_DONE(isotouch_free(each));
}

TEST(LibrarySizes, StructuresOfANewerHeaderAreRefused) {
  const Field field;
  Old<isotouch_field_facts> facts(sizeof(isotouch_field_facts) + 8);
  EXPECT_REFUSED(isotouch_field_describe(field.handle, facts.at(), facts.size), ISOTOUCH_BAD_ARGUMENT, "the header of this library");
  Old<isotouch_settings> settings(sizeof(isotouch_settings) + 8);
  EXPECT_REFUSED(isotouch_settings_default(settings.at(), settings.size), ISOTOUCH_BAD_ARGUMENT, "isotouch_settings");
  isotouch_touch touch = 0;
  EXPECT_REFUSED(isotouch_touch_new(field.handle, settings.at(), settings.size, &touch), ISOTOUCH_BAD_ARGUMENT, "isotouch_settings");
  EXPECT_REFUSED(isotouch_touch_new(field.handle, nullptr, kSettings, &touch), ISOTOUCH_BAD_ARGUMENT,
                 "isotouch_settings is a null pointer");
}

}  // namespace
}  // namespace isotouch
