#include "host/evaluate/dirty_scan.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "tests/support/sanitized.h"

namespace isotouch::evaluate {
namespace {

const Dirt& dirt(const std::vector<Dirt>& all, const std::string& name) {
  for (const Dirt& kind : all) {
    if (kind.name == name) return kind;
  }
  throw std::out_of_range(name);
}

std::vector<DirtyRow> rows(const std::string& shape, bool one_sided, const std::vector<std::string>& names, std::uint64_t seed = 1) {
  const std::vector<Dirt> all = all_dirt();
  std::vector<Dirt> chosen;
  for (const std::string& name : names) chosen.push_back(dirt(all, name));
  std::vector<DirtyRow> found;
  dirty_rows(
      {cloud::shape(shape), one_sided}, chosen, [&](const DirtyRow& row) { found.push_back(row); }, seed);
  return found;
}

TEST(DirtyScans, AreTwentyOfThirtyKindsWithNamesOfTheirOwn) {
  std::set<std::string> names;
  for (const Dirt& kind : all_dirt()) names.insert(kind.name);
  EXPECT_EQ(names.size(), all_dirt().size());
  EXPECT_EQ(names.size(), 30U);
  EXPECT_EQ(dirty_scans().size(), 20U);
}

TEST(DirtyScans, OfATorusComeOutRight) {
  for (const DirtyRow& row :
       rows("torus", false, test::examples<std::string>({"noise 25 %", "strays 5 %", "tilt 30°", "flipped 40 %", "no normals"}))) {
    EXPECT_EQ(row.refused, "") << row.dirt;
    EXPECT_FALSE(row.wrong()) << row.dirt;
    EXPECT_TRUE(row.verdict.plausible()) << row.dirt << ' ' << row.verdict.reasons[0];
    EXPECT_LT(row.surface_rms, 0.2) << row.dirt;
    EXPECT_NEAR(row.volume, 1.0, 0.01) << row.dirt;
  }
}

TEST(DirtyScans, OfOneSideAreFeltFromTheirFront) {
  for (const DirtyRow& row : rows("owl", true, test::examples<std::string>({"clean", "noise 10 %", "strays 2 %"}))) {
    EXPECT_EQ(row.refused, "") << row.dirt;
    EXPECT_LT(row.wrong_side, 0.005) << row.dirt;
    EXPECT_LT(row.surface_rms, 0.3) << row.dirt;
  }
}

TEST(DirtyScans, OfOtherBodiesAreEachWholeAndFromOneSide) {
  const std::vector<DirtyScan> scans = dirty_scans({cloud::shape("box"), cloud::shape("owl")});
  ASSERT_EQ(scans.size(), 4U);
  EXPECT_EQ(scans[1].name(), "owl");
  EXPECT_EQ(scans[3].name(), "owl, one side");
}

TEST(DirtyScans, StraysLeaveNothingInTheAir) {
  for (const DirtyRow& row : rows("sphere", false, {"strays 2 %", "strays 5 %"}, 2)) {
    EXPECT_EQ(row.pieces, 1U) << row.dirt;
    EXPECT_LT(row.truth_rms, 0.06) << row.dirt;
  }
}

TEST(DirtyScans, AHugeHoleIsNotBelieved) {
  for (const DirtyRow& row : rows("torus", false, {"hole 20"})) {
    EXPECT_TRUE(row.wrong());
    EXPECT_FALSE(row.verdict.plausible());
    EXPECT_FALSE(row.believed_wrong());
  }
}

}  // namespace
}  // namespace isotouch::evaluate
