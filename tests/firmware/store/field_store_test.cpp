#include "firmware/store/field_store.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/firmware/store/crashing_folder.h"

namespace isotouch::store {
namespace {

FileBytes field(std::uint64_t hash) { return FileBytes(24 + hash % 7, static_cast<std::uint8_t>(hash)); }

/// What the store begins with: the active field's hash, 0 when there is none; the test fails when that field is not whole.
std::uint64_t boots_with(FieldStore& store) {
  const auto hash = store.active();
  if (!hash) return 0;
  FileBytes bytes(100);
  const StoreResult<std::size_t> got = store.read(*hash, bytes);
  EXPECT_TRUE(got) << "the active field is not there";
  bytes.resize(got ? *got : 0);
  EXPECT_EQ(bytes, field(*hash)) << "the active field is not whole";
  return *hash;
}

bool upload(FieldStore& store, std::uint64_t hash) { return store.put(hash, "name", field(hash)) && store.set_active(hash); }

std::vector<std::uint64_t> hashes(FieldStore& store) {
  std::vector<std::uint64_t> all;
  for (const StoredField& stored : store.list()) all.push_back(stored.hash);
  return all;
}

TEST(FieldStore, WhatIsStoredIsListedReadAndActive) {
  CrashingFolder folder;
  FieldStore store(folder, 4);
  EXPECT_EQ(boots_with(store), 0U);
  ASSERT_TRUE(upload(store, 0xABC));
  ASSERT_TRUE(store.put(0xDEF, "a b/../c.itf", field(0xDEF)));
  EXPECT_EQ(boots_with(store), 0xABCU);
  const std::vector<StoredField> fields = store.list();
  ASSERT_EQ(fields.size(), 2U);
  EXPECT_EQ(fields[0].file, "00000001-0000000000000abc-name.itf");
  EXPECT_EQ(fields[1].file, "00000002-0000000000000def-a_b____c_itf.itf") << "nothing of a name leaves the folder";
  EXPECT_EQ(fields[1].bytes, field(0xDEF).size());
  FileBytes out(100);
  EXPECT_EQ(store.read(1, out).error(), StoreError::kNotFound);
}

TEST(FieldStore, TheOldestGoFirstAndTheActiveOneStays) {
  CrashingFolder folder;
  FieldStore store(folder, 3);
  ASSERT_TRUE(upload(store, 1));
  for (std::uint64_t hash = 2; hash <= 5; ++hash) ASSERT_TRUE(store.put(hash, "", field(hash)));
  EXPECT_EQ(hashes(store), (std::vector<std::uint64_t>{1, 4, 5}));
  ASSERT_TRUE(store.put(4, "again", field(4)));
  EXPECT_EQ(hashes(store), (std::vector<std::uint64_t>{1, 5, 4})) << "the same field takes no second place, and is the newest";
  ASSERT_TRUE(store.put(6, "", field(6)));
  EXPECT_EQ(hashes(store), (std::vector<std::uint64_t>{1, 4, 6})) << "what was sent again does not go first";
}

TEST(FieldStore, WhatAKilledRunLeftHalfWrittenIsRemoved) {
  CrashingFolder folder;
  ASSERT_TRUE(folder.write("new.part", field(1)));
  FieldStore store(folder, 2);
  EXPECT_TRUE(folder.names().empty());
}

TEST(FieldStore, FilesOfOthersAreLeftAlone) {
  CrashingFolder folder;
  for (const char* name : {"readme", "x.itf", "0000000a-0000000000000001-n.itf", "00000001-000000000000000g-n.itf"}) {
    ASSERT_TRUE(folder.write(name, field(1)));
  }
  FieldStore store(folder, 2);
  for (std::uint64_t hash = 1; hash <= 4; ++hash) ASSERT_TRUE(upload(store, hash));
  EXPECT_EQ(folder.names().size(), 4U + 2U + 1U);
}

TEST(FieldStore, APointerThatIsNoHashPointsNowhere) {
  CrashingFolder folder;
  FieldStore store(folder, 2);
  ASSERT_TRUE(upload(store, 1));
  for (const std::string& text :
       {std::string(), std::string("0000000000000001"), std::string("000000000000000x\n"), std::string(40, '1')}) {
    ASSERT_TRUE(folder.write("active", {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}));
    EXPECT_FALSE(store.active()) << text;
  }
}

TEST(FieldStore, AFieldThatWasTakenBackDoesNotReturnAfterAPowerCut) {
  CrashingFolder folder;
  FieldStore store(folder, 4);
  const FileBytes bytes(10, 7);
  ASSERT_TRUE(store.put(1, "old", bytes) && store.set_active(1));
  ASSERT_TRUE(store.put(2, "new", bytes) && store.set_active(2));
  ASSERT_TRUE(store.take_back(2, 1, true));
  CrashingFolder left = folder.after_power_cut(0, CrashingFolder::Content::kEmpty);
  FieldStore next(left, 4);
  EXPECT_EQ(next.active(), 1U);
  EXPECT_FALSE(next.holds(2));
  EXPECT_TRUE(next.holds(1));
}

TEST(FieldStore, AFullStorageRefusesAndLosesNothing) {
  CrashingFolder folder;
  FieldStore store(folder, 2);
  ASSERT_TRUE(upload(store, 1));
  ASSERT_TRUE(upload(store, 2));
  folder.full = true;
  EXPECT_EQ(store.put(3, "", field(3)).error(), StoreError::kNoSpace);
  EXPECT_EQ(store.set_active(1).error(), StoreError::kNoSpace);
  EXPECT_EQ(hashes(store), (std::vector<std::uint64_t>{1, 2}));
  EXPECT_EQ(boots_with(store), 2U);
  EXPECT_THAT(folder.names(), testing::Not(testing::Contains("new.part"))) << "what was begun is taken back";
}

/// Every step of an upload without power, everything that was not synced kept, lost or torn in every combination.
///
/// then      called with what each start finds
int at_every_power_cut(const CrashingFolder& before, std::uint64_t hash, const std::function<void(CrashingFolder&, int)>& then) {
  int starts = 0;
  for (int steps = 0;; ++steps) {
    CrashingFolder folder = before;
    folder.steps_left = steps;
    FieldStore store(folder, 2);
    const bool done = upload(store, hash);
    EXPECT_LT(folder.pending(), 8U);
    for (unsigned kept = 0; kept < 1U << folder.pending(); ++kept) {
      for (const auto content : {CrashingFolder::Content::kKept, CrashingFolder::Content::kEmpty, CrashingFolder::Content::kTorn}) {
        CrashingFolder next = folder.after_power_cut(kept, content);
        then(next, done ? -1 : steps);
        ++starts;
      }
    }
    if (done && folder.steps_left > 0) return starts;
  }
}

TEST(FieldStore, EveryPowerCutLeavesTheOldFieldOrTheNewOneWhole) {
  CrashingFolder before;
  FieldStore first(before, 2);
  ASSERT_TRUE(upload(first, 1));
  ASSERT_TRUE(upload(first, 2));
  int old_ones = 0, new_ones = 0, starts = 0;
  starts += at_every_power_cut(before, 3, [&](CrashingFolder& found, int cut) {
    FieldStore store(found, 2);
    const std::uint64_t now = boots_with(store);
    ASSERT_TRUE(now == 2 || now == 3) << "cut at " << cut;
    if (cut < 0) {
      ASSERT_EQ(now, 3U) << "what was promised is there";
    }
    (now == 2 ? old_ones : new_ones) += 1;
    // Whatever was left does not disturb the next upload, nor does a second power cut within it.
    starts += at_every_power_cut(found, 4, [&](CrashingFolder& again, int) {
      FieldStore last(again, 2);
      const std::uint64_t then = boots_with(last);
      ASSERT_TRUE(then == now || then == 4) << "cut at " << cut;
    });
    ASSERT_TRUE(upload(store, 5));
    EXPECT_EQ(boots_with(store), 5U);
    EXPECT_LE(store.list().size(), 2U);
    EXPECT_THAT(found.names(), testing::Not(testing::Contains("new.part")));
  });
  EXPECT_GT(old_ones, 10);
  EXPECT_GT(new_ones, 10);
  EXPECT_GT(starts, 1000);
  RecordProperty("starts", starts);
}

}  // namespace
}  // namespace isotouch::store
