/// How accurate a result must be, from both sides.
#pragma once

#include <gmock/gmock.h>

namespace isotouch::test {

/// An error between half of `bound` and `bound`. An error above the bound is a loss. An error below half of it means that the result has become twice as
/// good, or that nothing was compared; then the bound must be tightened, or the test mended.
MATCHER_P(IsAccuracyOf, bound,
          std::string(negation ? "is not " : "is ") + "between " + testing::PrintToString(bound / 2) + " and " +
              testing::PrintToString(bound)) {
  *result_listener << (arg > bound ? "a loss" : arg < bound / 2 ? "twice as good as the bound, or nothing was compared" : "within");
  return arg >= bound / 2 && arg <= bound;
}

}  // namespace isotouch::test
