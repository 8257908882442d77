#include "host/live/verdict.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <vector>

namespace isotouch::live {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::vector<std::string> reasons(std::size_t lonely, std::size_t unexplained) {
  Verdict verdict;
  verdict.samples = 100;
  verdict.lonely = lonely;
  verdict.unexplained = unexplained;
  return verdict.reasons();
}

TEST(Verdict, ATenthOfTheSamplesMayHaveTooFewNeighbours) {
  EXPECT_THAT(reasons(10, 0), IsEmpty());
  EXPECT_THAT(reasons(11, 0), ElementsAre(HasSubstr("11 % of the samples have too few neighbours")));
}

TEST(Verdict, AQuarterOfTheSamplesMayContradictTheirNeighbours) {
  EXPECT_THAT(reasons(0, 25), IsEmpty());
  EXPECT_THAT(reasons(0, 26), ElementsAre(HasSubstr("26 % of the samples contradict their neighbours")));
}

}  // namespace
}  // namespace isotouch::live
