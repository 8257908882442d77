#include "firmware/store/calibration_store.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/firmware/store/crashing_folder.h"

namespace isotouch::store {
namespace {

AnglesAtZero angles(std::uint32_t first) { return {Angle::from_raw(first), Angle::from_raw(0x89ABCDEF), Angle::from_raw(first * 7)}; }

void write(CrashingFolder& folder, const std::string& name, const std::string& text) {
  ASSERT_TRUE(folder.write(name, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}));
}

TEST(CalibrationStore, KeepsOneForEachSerial) {
  CrashingFolder folder;
  CalibrationStore store(folder);
  EXPECT_EQ(store.read("A1").error(), StoreError::kNotFound);
  ASSERT_TRUE(store.put("A1", angles(0x18E38E39)));
  ASSERT_TRUE(store.put("B2", angles(2)));
  ASSERT_TRUE(store.put("B2", angles(3)));
  EXPECT_EQ(*store.read("A1"), angles(0x18E38E39));
  EXPECT_EQ(*store.read("B2"), angles(3));
  EXPECT_EQ(folder.names().size(), 2U);
}

TEST(CalibrationStore, AFileWithOneBitChangedIsNoCalibration) {
  CrashingFolder folder;
  CalibrationStore store(folder);
  ASSERT_TRUE(store.put("A1", angles(0x18E38E39)));
  FileBytes good(100);
  good.resize(*folder.read("calibration-A1", good));
  ASSERT_EQ(std::string(good.begin(), good.begin() + 18), "18e38e39 89abcdef ");
  for (std::size_t bit = 0; bit < 8 * good.size(); ++bit) {
    FileBytes bad = good;
    bad[bit / 8] = static_cast<std::uint8_t>(bad[bit / 8] ^ 1U << bit % 8);
    ASSERT_TRUE(folder.write("calibration-A1", bad));
    const auto read = store.read("A1");
    // A letter as a capital is the same number.
    const bool same_number = bit % 8 == 5 && good[bit / 8] >= 'a';
    EXPECT_EQ(bool(read), same_number) << bit;
  }
  for (const std::string& text : {std::string(), std::string(good.begin(), good.end() - 1), std::string(good.begin(), good.end()) + "x"}) {
    write(folder, "calibration-A1", text);
    EXPECT_EQ(store.read("A1").error(), StoreError::kDamaged);
  }
}

TEST(CalibrationStore, ASerialNamesAFileAndNothingElse) {
  for (const char* bad : {"", "../x", "a b", "1234567890123456789012345", "\xC3\xA4"})
    EXPECT_FALSE(CalibrationStore::is_serial(bad)) << bad;
  for (const char* good : {"12PZ657E", "x", "123456789012345678901234"}) EXPECT_TRUE(CalibrationStore::is_serial(good)) << good;
  CrashingFolder folder;
  CalibrationStore store(folder);
  EXPECT_EQ(store.put("../x", angles(1)).error(), StoreError::kNotAllowed);
  EXPECT_TRUE(folder.names().empty());
}

TEST(CalibrationStore, EveryPowerCutLeavesTheOldAnglesOrTheNewOnes) {
  CrashingFolder before;
  ASSERT_TRUE(CalibrationStore(before).put("A1", angles(1)));
  int starts = 0, old_ones = 0;
  bool done = false;
  for (int steps = 0; !done; ++steps) {
    CrashingFolder folder = before;
    folder.steps_left = steps;
    done = bool(CalibrationStore(folder).put("A1", angles(2)));
    for (unsigned kept = 0; kept < 1U << folder.pending(); ++kept) {
      for (const auto content : {CrashingFolder::Content::kKept, CrashingFolder::Content::kEmpty, CrashingFolder::Content::kTorn}) {
        CrashingFolder next = folder.after_power_cut(kept, content);
        const auto found = CalibrationStore(next).read("A1");
        ASSERT_TRUE(found) << steps;
        ASSERT_TRUE(*found == angles(2) || (!done && *found == angles(1))) << steps;
        old_ones += *found == angles(1) ? 1 : 0;
        ++starts;
      }
    }
  }
  EXPECT_GT(old_ones, 3);
  EXPECT_GT(starts, 12);
}

}  // namespace
}  // namespace isotouch::store
