#include "shared/result.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace isotouch {
namespace {

TEST(Result, HoldsAValueOrAnError) {
  constexpr Result<int> kValue = 7;
  static_assert(kValue.has_value() && kValue && *kValue == 7 && kValue.value() == 7);
  constexpr Result<int> kError = Error::kBadMagic;
  static_assert(!kError.has_value() && !kError && kError.error() == Error::kBadMagic);
  struct Pair {
    int a, b;
  };
  constexpr Result<Pair> kPair = Pair{1, 2};
  static_assert(kPair->b == 2);
  static_assert(std::is_trivially_copyable_v<Result<Pair>>);
}

TEST(Result, OfNothingIsDoneOrAnError) {
  constexpr Result<void> kDone;
  static_assert(kDone.has_value() && kDone);
  constexpr Result<void> kError = Error::kBadPacket;
  static_assert(!kError.has_value() && !kError && kError.error() == Error::kBadPacket);
  static_assert(!std::is_convertible_v<Result<void>, bool>, "only a condition may ask");
}

TEST(Result, NoBooleanOrValueSlipsInOrOut) {
  static_assert(!std::is_convertible_v<Result<int>, bool>, "only a condition may ask");
  static_assert(!std::is_convertible_v<Result<int>, int>, "the value is taken by name");
}

TEST(Result, EveryErrorHasASentenceOfItsOwn) {
  std::set<std::string> sentences;
  constexpr int kErrors = static_cast<int>(Error::kBadPatch) + 1;
  for (int i = 0; i < kErrors; ++i) sentences.insert(describe(static_cast<Error>(i)));
  EXPECT_EQ(sentences.size(), static_cast<std::size_t>(kErrors));
  EXPECT_EQ(sentences.count("unknown error"), 0U);
  EXPECT_STREQ(describe(static_cast<Error>(kErrors)), "unknown error") << "a new error must be last in this test too";
}

}  // namespace
}  // namespace isotouch
