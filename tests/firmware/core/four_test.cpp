#include "firmware/core/four.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>

namespace isotouch::core {
namespace {

#ifdef ISOTOUCH_FOUR

/// Where a half of a number changes its sign, or the halves' products round down.
constexpr std::array<std::int32_t, 18> kNumbers = {0,        1,        -1,        255,        0x7FFF,     0x8000,
                                                   0x8001,   0xFFFF,   0x10000,   -0x7FFF,    -0x8000,    -0x8001,
                                                   -0x10000, -0x10001, 0x2AAAAAA, -0x2AAAAAB, 0x3FFFFFFF, -0x40000000};

TEST(Four, UpperWordsAreThoseOfOneNumberForEveryFactor) {
  for (std::int32_t upper = -0x8000; upper < 0x8000; ++upper) {
    const std::int32_t t = upper * 0x10000;
    for (std::size_t i = 0; i + 4 <= kNumbers.size(); ++i) {
      const Four words = upper_words(Four{kNumbers[i], kNumbers[i + 1], kNumbers[i + 2], kNumbers[i + 3]}, four(t));
      for (std::size_t lane = 0; lane < 4; ++lane)
        ASSERT_EQ(words[lane], upper_words(kNumbers[i + lane], t)) << kNumbers[i + lane] << " " << t;
    }
  }
}

#else

TEST(Four, IsNotThere) { GTEST_SKIP() << "this processor computes numbers one by one"; }

#endif

}  // namespace
}  // namespace isotouch::core
