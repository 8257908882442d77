#include "firmware/loop/field_slots.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <thread>

#include "tests/support/field_image.h"

namespace isotouch::loop {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// Small images that differ.
Bytes image(int which) {
  static const auto all = [] {
    std::array<Bytes, 4> images;
    for (std::size_t i = 0; i < images.size(); ++i) {
      images[i] = test::FieldImage({16, 16, 16},
                                   [&](const test::Point& p) {
                                     return test::length(p - test::Point{8, 8, 8}) - 2.0 - 0.2 * double(i);
                                   },
                                   {.band = 2.0})
                      .bytes();
    }
    return images;
  }();
  return all[static_cast<std::size_t>(which) % all.size()];
}

Result<std::uint32_t> upload(FieldSlots& slots, const Bytes& bytes) {
  const auto place = slots.begin(bytes.size());
  if (place.empty()) return Error::kBadSize;
  std::copy(bytes.begin(), bytes.end(), place.begin());
  const Result<const FieldView*> view = slots.verify();
  if (!view) return view.error();
  return slots.commit();
}

TEST(FieldSlots, TheTickFeelsNothingUntilAFieldIsCommitted) {
  FieldSlots slots(1 << 20);
  EXPECT_EQ(slots.field().view, nullptr);
  EXPECT_EQ(slots.field().generation, 0U);
  const Bytes bytes = image(0);
  const auto place = slots.begin(bytes.size());
  ASSERT_EQ(place.size(), bytes.size());
  EXPECT_EQ(reinterpret_cast<std::uintptr_t>(place.data()) % 64, 0U);
  std::copy(bytes.begin(), bytes.end(), place.begin());
  EXPECT_EQ(slots.commit().error(), Error::kTruncated) << "nobody has checked it";
  ASSERT_TRUE(slots.verify());
  EXPECT_EQ(slots.field().view, nullptr);
  ASSERT_TRUE(slots.commit());
  const ActiveField field = slots.field();
  ASSERT_NE(field.view, nullptr);
  EXPECT_EQ(field.generation, 1U);
  EXPECT_TRUE(std::equal(bytes.begin(), bytes.end(), field.view->image.begin(), field.view->image.end()));
}

TEST(FieldSlots, APlaceIsNotReceivedIntoBeforeTheTickHasLeftIt) {
  FieldSlots slots(1 << 20);
  ASSERT_TRUE(upload(slots, image(0)));
  EXPECT_FALSE(slots.free());
  EXPECT_TRUE(slots.begin(100).empty()) << "the tick has not taken the first one over";
  EXPECT_EQ(slots.acknowledged(), 0U);
  const ActiveField first = slots.field();
  EXPECT_EQ(slots.acknowledged(), 1U);
  const auto next = slots.begin(image(1).size());
  ASSERT_FALSE(next.empty());
  EXPECT_NE(next.data(), first.view->image.data());
  std::fill(next.begin(), next.end(), std::uint8_t{0xFF});
  EXPECT_EQ(first.view->hash(), slots.field().view->hash());
  slots.abandon();
  EXPECT_EQ(slots.commit().error(), Error::kTruncated);
}

TEST(FieldSlots, ARefusedImageLeavesTheTickItsField) {
  FieldSlots slots(1 << 20);
  const std::uint32_t good = *upload(slots, image(0));
  slots.field();
  Bytes bad = image(1);
  bad[200] ^= 1;
  EXPECT_EQ(upload(slots, bad).error(), Error::kBadChecksum);
  EXPECT_EQ(slots.field().generation, good);
  EXPECT_TRUE(slots.free());
  EXPECT_EQ(*upload(slots, image(1)), good + 1);
}

TEST(FieldSlots, RefusesWhatDoesNotFit) {
  FieldSlots slots(1000);
  EXPECT_EQ(slots.begin(1000).size(), 1000U);
  EXPECT_TRUE(slots.begin(1001).empty());
  EXPECT_TRUE(slots.begin(0).empty());
}

TEST(FieldSlots, AFieldCanBeTakenAway) {
  FieldSlots slots(1 << 20);
  ASSERT_TRUE(upload(slots, image(0)));
  EXPECT_FALSE(slots.clear());
  slots.field();
  EXPECT_TRUE(slots.clear());
  EXPECT_EQ(slots.field().view, nullptr);
  EXPECT_EQ(slots.field().generation, 0U);
  EXPECT_EQ(slots.published().view, nullptr);
  EXPECT_EQ(*upload(slots, image(2)), 3U) << "a generation is never given twice";
  EXPECT_NE(slots.field().view, nullptr);
}

Result<std::uint32_t> patch(FieldSlots& slots, const Bytes& bytes) {
  const auto place = slots.begin(bytes.size());
  if (place.empty()) return Error::kBadSize;
  std::copy(bytes.begin(), bytes.end(), place.begin());
  const Result<const FieldView*> view = slots.verify();
  if (!view) return view.error();
  return slots.commit_patched((*view)->hash(), author_of(3));
}

TEST(FieldSlots, APatchedFieldIsTheSameSurface) {
  FieldSlots slots(1 << 20);
  const std::uint32_t first = *upload(slots, image(0));
  EXPECT_EQ(slots.field().surface, first);
  EXPECT_EQ(slots.field().patched_from, 0U);
  std::uint32_t before = first;
  for (int which = 1; which < 5; ++which) {
    const std::uint32_t generation = *patch(slots, image(which));
    const ActiveField field = slots.field();
    EXPECT_EQ(field.generation, generation);
    EXPECT_EQ(field.patched_from, before);
    EXPECT_EQ(field.surface, first);
    EXPECT_EQ(field.hash, field.view->hash());
    EXPECT_EQ(field.author, author_of(3));
    before = generation;
  }
  const std::uint32_t other = *upload(slots, image(5));
  EXPECT_EQ(slots.field().surface, other);
  EXPECT_EQ(slots.field().patched_from, 0U);
}

TEST(FieldSlots, APatchThatIsTakenBackLeavesAFieldOfItsOwn) {
  FieldSlots slots(1 << 20);
  ASSERT_TRUE(upload(slots, image(0)));
  slots.field();
  ASSERT_TRUE(patch(slots, image(1)));
  const std::uint64_t felt = slots.field().view->hash();
  ASSERT_TRUE(patch(slots, image(2)));
  EXPECT_TRUE(slots.take_back());
  const ActiveField field = slots.field();
  EXPECT_EQ(field.view->hash(), felt);
  EXPECT_EQ(field.patched_from, 0U) << "nobody knows what the tick has felt meanwhile";
  EXPECT_EQ(field.surface, field.generation);
}

TEST(FieldSlots, WhatTheTickDidNotTakeIsTakenBack) {
  FieldSlots slots(1 << 20);
  ASSERT_TRUE(upload(slots, image(1)));
  EXPECT_TRUE(slots.take_back());
  EXPECT_EQ(slots.field().view, nullptr) << "there was none before";
  ASSERT_TRUE(upload(slots, image(2)));
  const std::uint64_t hash = slots.field().view->hash();
  EXPECT_FALSE(slots.take_back()) << "the tick has it";
  const std::uint32_t generation = *upload(slots, image(3));
  EXPECT_TRUE(slots.take_back());
  EXPECT_TRUE(slots.begin(100).empty()) << "the tick may be reading it at this moment";
  const ActiveField field = slots.field();
  ASSERT_NE(field.view, nullptr);
  EXPECT_EQ(field.view->hash(), hash);
  EXPECT_GT(field.generation, generation) << "whoever has seen the one taken back sees another one";
  EXPECT_TRUE(upload(slots, image(3))) << "and the place is free again";
}

TEST(FieldSlots, NoTickEverSeesHalfAFieldWhileFieldsAreSwapped) {
  FieldSlots slots(1 << 20);
  std::array<std::uint64_t, 4> hashes{};
  for (int i = 0; i < 4; ++i) {
    const test::FieldImage fresh({16, 16, 16},
                                 [&](const test::Point& p) {
                                   return test::length(p - test::Point{8, 8, 8}) - 2.0 - 0.2 * double(i);
                                 },
                                 {.band = 2.0});
    hashes[static_cast<std::size_t>(i)] = fresh.view().hash();
  }
  constexpr std::uint32_t kSwaps = 300;
  std::atomic<std::uint32_t> wrong{0}, seen{0};
  std::thread tick([&] {
    for (std::uint32_t before = 0; before < kSwaps;) {
      const ActiveField field = slots.field();
      if (field.view == nullptr) continue;
      if (field.view->hash() != hashes[field.generation % 4] || field.generation < before) ++wrong;
      if (field.generation != before) ++seen;
      before = field.generation;
    }
  });
  for (std::uint32_t generation = 1; generation <= kSwaps;) {
    const auto committed = upload(slots, image(static_cast<int>(generation)));
    if (!committed) {
      std::this_thread::yield();
      continue;
    }
    EXPECT_EQ(*committed, generation);
    ++generation;
  }
  tick.join();
  EXPECT_EQ(wrong, 0U);
  EXPECT_EQ(seen, kSwaps) << "every published field is taken over, because none is published before";
}

TEST(FieldSlots, AGuardHoldsAFieldOnlyUntilACommandOfAnother) {
  FieldSlots slots(1 << 20);
  slots.expect_guard();
  const auto one = upload(slots, image(1));
  ASSERT_TRUE(one);
  slots.field();
  EXPECT_FALSE(slots.free()) << "the guard has not seen it";
  EXPECT_NE(slots.acknowledged(), *one);
  EXPECT_EQ(slots.field_of(*one).view, slots.published().view);
  EXPECT_TRUE(slots.free());
  EXPECT_EQ(slots.acknowledged(), *one);

  const auto two = upload(slots, image(2));
  ASSERT_TRUE(two);
  EXPECT_NE(slots.field_of(*one).view, nullptr) << "a command of the field before";
  slots.field();
  EXPECT_NE(slots.field_of(*two).view, nullptr);
  EXPECT_EQ(slots.field_of(*one).view, nullptr);

  ASSERT_TRUE(slots.clear());
  slots.field();
  EXPECT_EQ(slots.field_of(0).view, nullptr) << "a command without a field";
  EXPECT_TRUE(slots.free()) << "else no field could ever be loaded again";
  EXPECT_TRUE(upload(slots, image(3)));
}

}  // namespace
}  // namespace isotouch::loop
