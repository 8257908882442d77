#include "firmware/store/field_intake.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <string>
#include <thread>
#include <vector>

#include "firmware/loop/linux_clock.h"
#include "shared/bytes.h"
#include "shared/crc32.h"
#include "tests/firmware/store/crashing_folder.h"
#include "tests/firmware/store/packed_field.h"
#include "tests/support/field_patch.h"
#include "tests/support/random.h"

namespace isotouch::store {
namespace {

using testing::HasSubstr;

/// Time passes only by sleeping; the tick comes by in every nap, unless it does not run.
class TickingClock final : public loop::Clock {
 public:
  explicit TickingClock(loop::FieldSlots& slots) : slots_(slots) {}
  std::int64_t now_ns() override { return now_; }
  void sleep_until_ns(std::int64_t when_ns) override {
    now_ = when_ns;
    if (runs) (void)slots_.field();
  }
  bool runs = true;

 private:
  loop::FieldSlots& slots_;
  std::int64_t now_ = 0;
};

struct Rig {
  explicit Rig(FieldCheck check = {}, std::size_t limit = 1 << 18)
      : slots(limit), clock(slots), store(folder, 3), intake(slots, &store, clock, std::move(check)) {}

  IntakeOutcome upload(const std::vector<std::uint8_t>& bytes, protocol::Begin promise) {
    promise.packed_bytes = bytes.size();
    std::copy(bytes.begin(), bytes.end(), intake.upload().begin());
    return intake.accept(promise);
  }
  IntakeOutcome upload(const PackedField& field) { return upload(field.bytes, field.promise); }
  std::uint64_t felt() {
    const loop::ActiveField field = slots.field();
    return field.view == nullptr ? 0 : field.view->hash();
  }

  CrashingFolder folder;
  loop::FieldSlots slots;
  TickingClock clock;
  FieldStore store;
  FieldIntake intake;
};

TEST(FieldIntake, AGoodFieldIsFeltStoredAndThereAtTheNextStart) {
  Rig rig;
  const PackedField ball = packed_ball(1);
  const IntakeOutcome outcome = rig.upload(ball);
  EXPECT_EQ(outcome.refusal.sentence(), "");
  EXPECT_EQ(outcome.field.image_hash, ball.promise.image_hash);
  EXPECT_EQ(outcome.field.generation, rig.slots.acknowledged());
  EXPECT_EQ(rig.felt(), ball.promise.image_hash);
  EXPECT_EQ(rig.intake.published().image_hash, ball.promise.image_hash);
  EXPECT_EQ(rig.intake.published().name, ball.promise.name);
  EXPECT_EQ(rig.intake.published().stiffness, rig.slots.field().view->stiffness);

  loop::FieldSlots slots(1 << 18);
  FieldIntake next(slots, &rig.store, rig.clock, {});
  EXPECT_EQ(next.begin_with_active().sentence(), "");
  EXPECT_EQ(slots.field().view->hash(), ball.promise.image_hash);
  EXPECT_EQ(next.published().name, ball.promise.name) << "the store keeps it";
}

IntakeOutcome patch(Rig& rig, const std::vector<std::uint8_t>& bytes) {
  std::copy(bytes.begin(), bytes.end(), rig.intake.upload().begin());
  return rig.intake.patch(bytes.size(), author_of(5));
}

TEST(FieldIntake, APatchIsFeltAndNotStored) {
  Rig rig;
  ASSERT_EQ(rig.upload(packed_ball(1)).refusal.sentence(), "");
  const std::uint32_t surface = rig.slots.field().surface;
  for (int which = 2; which < 6; ++which) {
    const test::FieldImage before = ball_image(which - 1), after = ball_image(which);
    const std::uint32_t generation = rig.slots.field().generation;
    const IntakeOutcome outcome = patch(rig, test::make_patch(before.view(), after.view()));
    ASSERT_EQ(outcome.refusal.sentence(), "");
    EXPECT_EQ(outcome.field.image_hash, after.view().hash());
    EXPECT_EQ(rig.felt(), after.view().hash());
    EXPECT_EQ(rig.slots.field().patched_from, generation);
    EXPECT_EQ(rig.slots.field().surface, surface);
    EXPECT_EQ(rig.intake.hash_of(outcome.field.generation), after.view().hash());
    EXPECT_EQ(outcome.field.name, packed_ball(1).promise.name);
  }
  EXPECT_EQ(rig.store.active(), packed_ball(1).promise.image_hash) << "the next start begins with what was stored";
  EXPECT_EQ(rig.intake.stored().size(), 1U);
}

TEST(FieldIntake, APatchThatDoesNotFitLeavesTheFieldBefore) {
  Rig rig;
  const test::FieldImage one = ball_image(1), two = ball_image(2), three = ball_image(3);
  const auto refused = [&](const std::vector<std::uint8_t>& bytes, const std::string& why) {
    const std::uint64_t before = rig.felt();
    const std::uint32_t generation = rig.slots.field().generation;
    const IntakeOutcome outcome = patch(rig, bytes);
    EXPECT_THAT(outcome.refusal.sentence(), HasSubstr(why));
    EXPECT_THAT(outcome.refusal.sentence(), HasSubstr("; "));
    EXPECT_EQ(rig.felt(), before);
    EXPECT_EQ(rig.slots.field().generation, generation);
    EXPECT_EQ(outcome.field.image_hash, before);
    EXPECT_TRUE(rig.slots.free());
  };
  const auto good = test::make_patch(one.view(), two.view());
  refused(good, "no field is loaded");
  ASSERT_EQ(rig.upload(packed_ball(1)).refusal.sentence(), "");
  refused(test::make_patch(two.view(), three.view()), "this patch is for the field ");
  refused({good.data(), good.data() + good.size() - 7}, "the patch is not usable: ");
  for (std::size_t at = 0; at < good.size(); at += 97) {
    auto bad = good;
    bad[at] ^= 0x10;
    refused(bad, "the patch ");
  }
  auto lies = good;  // names another image than it gives
  lies[33] ^= 1;
  store_le(lies.data() + 12, crc32(lies.data() + 16, lies.size() - 16));
  refused(lies, "the patch does not fit: ");
  EXPECT_EQ(patch(rig, good).refusal.sentence(), "");
  EXPECT_EQ(rig.felt(), two.view().hash());
  refused(good, "this patch is for the field ");
}

TEST(FieldIntake, APatchIsJudgedLikeAField) {
  bool strict = false;
  Rig rig([&](const FieldView&) { return strict ? Refusal("too stiff; be softer") : Refusal(); });
  ASSERT_EQ(rig.upload(packed_ball(1)).refusal.sentence(), "");
  strict = true;
  EXPECT_EQ(patch(rig, test::make_patch(ball_image(1).view(), ball_image(2).view())).refusal.sentence(), "too stiff; be softer");
  EXPECT_EQ(rig.felt(), packed_ball(1).promise.image_hash);
}

/// A flipped bit in the image must not be copied into the next one and pass there as good.
TEST(FieldIntake, ADamagedImageIsNotPatched) {
  Rig rig;
  ASSERT_EQ(rig.upload(packed_ball(1)).refusal.sentence(), "");
  const auto image = rig.slots.field().view->image;
  const_cast<std::uint8_t*>(image.data())[image.size() - 5] ^= 1;
  EXPECT_THAT(patch(rig, test::make_patch(ball_image(1).view(), ball_image(2).view())).refusal.sentence(), HasSubstr("does not fit"));
}

TEST(FieldIntake, APatchThatTheLoopDoesNotTakeIsTakenBack) {
  Rig rig;
  ASSERT_EQ(rig.upload(packed_ball(1)).refusal.sentence(), "");
  const auto bytes = test::make_patch(ball_image(1).view(), ball_image(2).view());
  rig.clock.runs = false;
  const IntakeOutcome outcome = patch(rig, bytes);
  EXPECT_THAT(outcome.refusal.sentence(), HasSubstr("the controller's loop does not run"));
  EXPECT_EQ(outcome.field.image_hash, packed_ball(1).promise.image_hash);
  EXPECT_EQ(rig.store.active(), packed_ball(1).promise.image_hash);
  rig.clock.runs = true;
  EXPECT_EQ(rig.felt(), packed_ball(1).promise.image_hash);
  EXPECT_EQ(rig.slots.field().patched_from, 0U);
  EXPECT_EQ(patch(rig, bytes).refusal.sentence(), "");
}

TEST(FieldIntake, AStoredFieldIsSelected) {
  Rig rig;
  const PackedField one = packed_ball(1), two = packed_ball(2);
  ASSERT_EQ(rig.upload(one).refusal.sentence(), "");
  ASSERT_EQ(rig.upload(two).refusal.sentence(), "");
  ASSERT_EQ(rig.intake.stored().size(), 2U);
  EXPECT_EQ(rig.intake.select(one.promise.image_hash).refusal.sentence(), "");
  EXPECT_EQ(rig.felt(), one.promise.image_hash);
  EXPECT_EQ(rig.store.active(), one.promise.image_hash);
  EXPECT_THAT(rig.intake.select(5).refusal.sentence(), HasSubstr("no field of this hash"));
  EXPECT_EQ(rig.felt(), one.promise.image_hash);
}

TEST(FieldIntake, AFieldThatTheTickHasLeftStillHasItsHash) {
  Rig rig;
  const PackedField one = packed_ball(1), two = packed_ball(2);
  const std::uint32_t first = rig.upload(one).field.generation;
  const std::uint32_t second = rig.upload(two).field.generation;
  EXPECT_EQ(rig.intake.hash_of(first), one.promise.image_hash) << "of a tick that is recorded late";
  EXPECT_EQ(rig.intake.hash_of(second), two.promise.image_hash);
  EXPECT_EQ(rig.intake.hash_of(second + 1), 0U);
  EXPECT_EQ(rig.intake.hash_of(0), 0U);
}

TEST(FieldIntake, NobodySeesTheHashOfOneFieldWithTheGenerationOfAnother) {
  Rig rig;
  const PackedField one = packed_ball(1), two = packed_ball(2);
  ASSERT_EQ(rig.upload(one).refusal.sentence(), "");
  ASSERT_EQ(rig.upload(two).refusal.sentence(), "");
  std::atomic<bool> stop{false};
  int wrong = 0, seen = 0;
  std::thread reader([&] {
    while (!stop) {
      const PublishedField field = rig.intake.published();
      const std::uint64_t of_it = field.generation % 2 == 1 ? one.promise.image_hash : two.promise.image_hash;  // they take turns
      wrong += field.image_hash != of_it ? 1 : 0;
      ++seen;
    }
  });
  for (int i = 0; i < 1000; ++i) ASSERT_EQ(rig.intake.select((i % 2 == 0 ? one : two).promise.image_hash).refusal.sentence(), "");
  stop = true;
  reader.join();
  EXPECT_EQ(wrong, 0) << "of " << seen;
  EXPECT_GT(seen, 1000);
}

TEST(FieldIntake, AFieldThatDoesNotFitNamesTheSettingThatLimitsIt) {
  const PackedField ball = packed_ball(1);
  Rig rig({}, 1 << 11);
  const std::string said =
      "the field takes " + std::to_string(ball.promise.image_bytes) + " bytes, and [limits] field_mib allows 2048 bytes; ";
  EXPECT_THAT(rig.intake.begin_with(ball.bytes, "ball").sentence(), HasSubstr(said));
  EXPECT_THAT(rig.intake.begin_with(std::vector<std::uint8_t>(5000), "zeros").sentence(),
              HasSubstr("takes 5000 bytes, and [limits] field_mib"))
      << "an image";
}

TEST(FieldIntake, WhatIsWrongIsRefusedAndTheOldFieldStays) {
  bool check_fails = false;
  Rig rig([&](const FieldView&) { return std::string(check_fails ? "too steep for this device" : ""); });
  const PackedField old = packed_ball(1), good = packed_ball(2);
  ASSERT_EQ(rig.upload(old).refusal.sentence(), "");
  const auto expect_refused = [&](const IntakeOutcome& outcome, const std::string& why) {
    EXPECT_THAT(outcome.refusal.sentence(), HasSubstr(why));
    EXPECT_EQ(rig.felt(), old.promise.image_hash) << why;
    EXPECT_EQ(rig.store.active(), old.promise.image_hash) << why;
    EXPECT_EQ(rig.intake.published().image_hash, old.promise.image_hash) << why;
  };
  protocol::Begin other = good.promise;
  other.image_hash ^= 1;
  expect_refused(rig.upload(good.bytes, other), "checksum");
  expect_refused(rig.upload({}, good.promise), "it is no field");
  expect_refused(rig.upload(packed_ball(3, 128)), "[limits] field_mib allows 262144");
  check_fails = true;
  expect_refused(rig.upload(good), "too steep");
  check_fails = false;
  rig.folder.full = true;
  expect_refused(rig.upload(good), "no space");
  rig.folder.full = false;
  EXPECT_EQ(rig.upload(good).refusal.sentence(), "") << "and what is good is accepted afterwards";
}

TEST(FieldIntake, AFieldThatIsRefusedLaterIsTakenAwayOnce) {
  std::string verdict;
  Rig rig([&](const FieldView&) { return verdict; });
  Refusal said;
  EXPECT_TRUE(rig.intake.check_again(said)) << "there is none";
  const PackedField ball = packed_ball(1);
  ASSERT_EQ(rig.upload(ball).refusal.sentence(), "");
  EXPECT_TRUE(rig.intake.check_again(said));
  EXPECT_EQ(said.sentence(), "");
  EXPECT_EQ(rig.felt(), ball.promise.image_hash);

  verdict = "too stiff; set less";
  EXPECT_TRUE(rig.intake.check_again(said));
  EXPECT_EQ(said.sentence(), "the field was unloaded: too stiff; set less and load it again");
  EXPECT_EQ(rig.felt(), 0U);
  EXPECT_EQ(rig.intake.published().image_hash, 0U);
  EXPECT_EQ(rig.intake.published().generation, 0U);
  said = {};
  EXPECT_TRUE(rig.intake.check_again(said));
  EXPECT_EQ(said.sentence(), "");

  verdict.clear();
  EXPECT_EQ(rig.intake.select(ball.promise.image_hash).refusal.sentence(), "");
  EXPECT_EQ(rig.felt(), ball.promise.image_hash);
  verdict = "too stiff; set less";
  EXPECT_TRUE(rig.intake.check_again(said));
  EXPECT_FALSE(rig.slots.free()) << "the tick has not come by";
  said = {};
  EXPECT_TRUE(rig.intake.check_again(said)) << "nothing is published any more";
  EXPECT_EQ(said.sentence(), "");
}

TEST(FieldIntake, ALoopThatDoesNotRunIsTold) {
  Rig rig;
  ASSERT_EQ(rig.upload(packed_ball(1)).refusal.sentence(), "");
  rig.clock.runs = false;
  EXPECT_THAT(rig.upload(packed_ball(2)).refusal.sentence(), HasSubstr("loop does not run"));
  EXPECT_THAT(rig.upload(packed_ball(3)).refusal.sentence(), HasSubstr("still loading the previous field"));
  rig.clock.runs = true;
  (void)rig.slots.field();
  EXPECT_EQ(rig.upload(packed_ball(3)).refusal.sentence(), "");
}

TEST(FieldIntake, WhatTheTickDoesNotTakeIsNeitherStoredNorFeltLater) {
  for (const bool has_old : {false, true}) {
    Rig rig;
    const PackedField old = packed_ball(1), late = packed_ball(2);
    if (has_old) {
      ASSERT_EQ(rig.upload(old).refusal.sentence(), "");
    }
    const std::uint64_t before = has_old ? old.promise.image_hash : 0;
    rig.clock.runs = false;
    EXPECT_THAT(rig.upload(late).refusal.sentence(), HasSubstr("loop does not run"));
    EXPECT_EQ(rig.intake.published().image_hash, before);
    EXPECT_EQ(rig.store.active().value_or(0), before);
    EXPECT_FALSE(rig.store.holds(late.promise.image_hash));
    loop::FieldSlots slots(1 << 18);
    FieldIntake next(slots, &rig.store, rig.clock, {});
    EXPECT_EQ(next.begin_with_active().sentence(), "");
    EXPECT_EQ(next.published().image_hash, before) << "nor at the next start";
    rig.clock.runs = true;
    EXPECT_EQ(rig.felt(), before) << "nor when the loop runs again";
    EXPECT_EQ(rig.intake.published().generation, rig.slots.field().generation);
    EXPECT_EQ(rig.upload(late).refusal.sentence(), "");
    EXPECT_EQ(rig.felt(), late.promise.image_hash);
  }
}

TEST(FieldIntake, AChoiceThatTheTickDoesNotTakeIsNoChoice) {
  Rig rig;
  const PackedField one = packed_ball(1), two = packed_ball(2);
  ASSERT_EQ(rig.upload(one).refusal.sentence(), "");
  ASSERT_EQ(rig.upload(two).refusal.sentence(), "");
  rig.clock.runs = false;
  EXPECT_THAT(rig.intake.select(one.promise.image_hash).refusal.sentence(), HasSubstr("loop does not run"));
  EXPECT_EQ(rig.store.active(), two.promise.image_hash);
  EXPECT_TRUE(rig.store.holds(one.promise.image_hash)) << "it was there before";
  EXPECT_EQ(rig.felt(), two.promise.image_hash);
}

TEST(FieldIntake, TenThousandFieldsWithFlippedBitsLeaveTheOldOne) {
  Rig rig;
  const PackedField old = packed_ball(1), good = packed_ball(2);
  ASSERT_EQ(rig.upload(old).refusal.sentence(), "");
  test::Random random(5);
  int refused = 0;
  for (int round = 0; round < 10'000; ++round) {
    std::vector<std::uint8_t> bytes = good.bytes;
    for (std::uint64_t flips = 1 + random.bits() % 3; flips > 0; --flips)
      bytes[random.bits() % bytes.size()] ^= static_cast<std::uint8_t>(1U << random.bits() % 8);
    // Half of them with a checksum that is right again: then what lies deeper has to see it.
    if (round % 2 == 1) store_le(bytes.data() + 12, crc32(bytes.data() + 16, bytes.size() - 16));
    const IntakeOutcome outcome = rig.upload(bytes, good.promise);
    if (!outcome.refusal) {
      ASSERT_EQ(rig.felt(), good.promise.image_hash) << "flips that leave the image as it was";
      ASSERT_EQ(rig.upload(old).refusal.sentence(), "");
      continue;
    }
    ++refused;
    ASSERT_EQ(rig.felt(), old.promise.image_hash) << outcome.refusal.sentence();
    ASSERT_EQ(rig.store.active(), old.promise.image_hash);
  }
  EXPECT_GT(refused, 9000);
  RecordProperty("refused", refused);
}

TEST(FieldIntake, AFieldThatWentBadInTheStoreIsNotBegunWith) {
  Rig rig;
  const PackedField ball = packed_ball(1);
  ASSERT_EQ(rig.upload(ball).refusal.sentence(), "");
  std::vector<std::uint8_t> bad = ball.bytes;
  bad[400] ^= 1;
  ASSERT_TRUE(rig.folder.write(rig.store.list().front().file, bad));
  loop::FieldSlots slots(1 << 18);
  FieldIntake next(slots, &rig.store, rig.clock, {});
  EXPECT_THAT(next.begin_with_active().sentence(), HasSubstr("was not loaded"));
  EXPECT_EQ(slots.field().view, nullptr);
  EXPECT_THAT(next.select(ball.promise.image_hash).refusal.sentence(), HasSubstr("not usable"));
}

TEST(FieldIntake, WithoutAStoreFieldsAreFeltButNotKept) {
  loop::FieldSlots slots(1 << 18);
  TickingClock clock(slots);
  FieldIntake intake(slots, nullptr, clock, {});
  EXPECT_EQ(intake.begin_with_active().sentence(), "");
  const PackedField ball = packed_ball(1);
  std::copy(ball.bytes.begin(), ball.bytes.end(), intake.upload().begin());
  EXPECT_EQ(intake.accept(ball.promise).refusal.sentence(), "");
  EXPECT_TRUE(intake.stored().empty());
  EXPECT_THAT(intake.select(1).refusal.sentence(), HasSubstr("stores no fields"));
}

}  // namespace
}  // namespace isotouch::store
