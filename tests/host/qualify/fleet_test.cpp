#include "host/qualify/fleet.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "host/error.h"
#include "host/qualify/report.h"
#include "tests/support/scratch_folder.h"

namespace isotouch::qualify {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
namespace fs = std::filesystem;

bool has_outliers(const Fleet& fleet) {
  return std::ranges::any_of(fleet.boards, [](const FleetBoard& board) { return !board.outliers.empty(); });
}

class ReadFleet : public ::testing::Test {
 protected:
  /// A report as `json_report` writes it, with one value changed.
  fs::path report(const std::string& host, double wakeup_us) const {
    Figures figures;
    figures.subject.host = host;
    figures.subject.date = "2026-11-26";
    std::vector<Judgement> judgements(2);
    judgements[0].key = "wakeup_p999_us";
    judgements[0].value = wakeup_us;
    judgements[0].outcome = Judgement::Outcome::kMet;
    judgements[1].key = "celsius";
    return folder_.write(host + ".json", json_report(figures, judgements).dump());
  }
  std::string complaint(const std::vector<fs::path>& reports) const {
    try {
      (void)read_fleet(reports);
    } catch (const InputError& error) {
      return error.what();
    }
    return {};
  }
  ScratchFolder folder_;
};

TEST_F(ReadFleet, AValueFarFromAllOthersIsAnOutlier) {
  const Fleet fleet =
      read_fleet({report("a", 20), report("b", 21), report("c", 19.5), report("d", 60), report("e", 20.5), report("f", 20)});
  for (const FleetBoard& board : fleet.boards) {
    if (board.name == "d") {
      EXPECT_THAT(board.outliers, ElementsAre("wakeup_p999_us"));
    } else {
      EXPECT_THAT(board.outliers, IsEmpty()) << board.name;
    }
  }
}

TEST_F(ReadFleet, BoardsThatScatterHaveNone) {
  EXPECT_FALSE(has_outliers(read_fleet({report("a", 10), report("b", 14), report("c", 20), report("d", 26), report("e", 31)})));
  EXPECT_FALSE(has_outliers(read_fleet({report("a", 20), report("b", 20), report("c", 20), report("d", 20), report("e", 23)})));
}

TEST_F(ReadFleet, TheLimitsOfAnOutlierLieWhereTheHeaderSays) {
  // Distances from 100 are 10, 10, 10, 10, 0 and the board's: five times 1.4826 times 10 is 74.
  const auto with = [&](double value) {
    return has_outliers(
        read_fleet({report("a", 90), report("b", 110), report("c", 90), report("d", 110), report("e", 100), report("f", value)}));
  };
  EXPECT_FALSE(with(165));
  EXPECT_TRUE(with(185));
  // All alike: a fifth of the median is 20.
  const auto among_equals = [&](double value) {
    return has_outliers(read_fleet({report("a", 100), report("b", 100), report("c", 100), report("d", 100), report("e", value)}));
  };
  EXPECT_FALSE(among_equals(119));
  EXPECT_TRUE(among_equals(121));
}

TEST_F(ReadFleet, AFewBoardsCannotSayWhichIsUnlikeTheOthers) {
  const Fleet fleet = read_fleet({report("a", 20), report("b", 20), report("c", 20), report("d", 600)});
  EXPECT_FALSE(has_outliers(fleet));
  EXPECT_THAT(fleet.unjudged, ElementsAre("wakeup_p999_us"));
}

TEST_F(ReadFleet, AReportOfAnotherReleaseHasEmptyCells) {
  const auto newer = folder_.write(
      "newer.json", R"({"host": "x", "date": "", "verdict": "fit", "limits": [{"key": "new", "value": 1, "outcome": "met"}]})");
  EXPECT_EQ(to_csv(read_fleet({report("red", 20), newer})),
            "board,date,verdict,wakeup_p999_us,celsius,new,outliers\n"
            "red,2026-11-26,fit,20,,,\n"
            "x,,fit,,,1,\n");
}

TEST_F(ReadFleet, TheTableHasARowForEachBoard) {
  EXPECT_EQ(to_csv(read_fleet({report("red", 20), report("blue, left", 21.5)})),
            "board,date,verdict,wakeup_p999_us,celsius,outliers\n"
            "red,2026-11-26,fit,20,,\n"
            "\"blue, left\",2026-11-26,fit,21.5,,\n");
}

TEST_F(ReadFleet, AVerdictMustFollowFromTheLimits) {
  const auto said = [&](const std::string& verdict, const std::string& limits) {
    return complaint(
        {folder_.write("x.json", R"({"host": "x", "date": "", "verdict": ")" + verdict + R"(", "limits": [)" + limits + "]}")});
  };
  const std::string met = R"({"key": "a", "value": 1, "outcome": "met"})", missed = R"({"key": "b", "value": 1, "outcome": "missed"})",
                    unknown = R"({"key": "c", "value": null, "outcome": "not measured"})";
  EXPECT_THAT(said("fit", ""), HasSubstr("x.json: a report without limits"));
  EXPECT_THAT(said("fit", met + "," + missed), HasSubstr("x.json: the verdict 'fit' does not follow from its limits"));
  EXPECT_THAT(said("not fit", met), HasSubstr("does not follow"));
  EXPECT_THAT(said("splendid", met), HasSubstr("does not follow"));
  EXPECT_THAT(said("fit", met + "," + unknown), IsEmpty());
  EXPECT_THAT(said("not fit", met + "," + unknown), IsEmpty()) << "where no device answered, nothing was felt";
  EXPECT_THAT(said("not fit", missed), IsEmpty());
}

TEST_F(ReadFleet, WhatIsNoReportIsRefusedByName) {
  EXPECT_THAT(complaint({folder_.path() / "none.json"}), HasSubstr("none.json: cannot be read"));
  EXPECT_THAT(complaint({folder_.write("text.json", "hello")}), HasSubstr("text.json: no JSON"));
  EXPECT_THAT(complaint({folder_.write("other.json", "{\"host\": 7}")}), HasSubstr("other.json: no report of a board"));
  EXPECT_THAT(complaint({folder_.path()}), HasSubstr("it is a folder"));
  EXPECT_THAT(complaint({report("a", 20), report("a", 21)}), HasSubstr("a is there with the same date"));
}

}  // namespace
}  // namespace isotouch::qualify
