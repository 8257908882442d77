#include "host/qualify/fleet.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

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
  fs::path report(const std::string& host, double wakeup_us, const std::string& date = "2026-11-26") const {
    Figures figures;
    figures.subject.host = host;
    figures.subject.date = date;
    const std::vector<Judgement> judgements = {judged("wakeup_p999_us", "", "", 1000, wakeup_us),
                                               judged("celsius", "", "", 75, std::nullopt), judged("word_max_ticks", "", "", 1, 0.5),
                                               judged("faults", "", "", 0, 0)};
    return folder_.write(host + date + ".json", json_report(figures, judgements).dump());
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

TEST_F(ReadFleet, BoardsOfOneHostNameAreToldApartByAddressAndDevice) {
  const auto of = [&](const char* file, const std::string& address, const std::string& device, const char* date = "2026-11-26") {
    Figures figures;
    figures.address = address;
    figures.subject.host = "board";
    figures.subject.device = device;
    figures.subject.date = date;
    const std::vector<Judgement> judgements = {judged("word_max_ticks", "", "", 1, 0.5), judged("faults", "", "", 0, 0)};
    return folder_.write(file, json_report(figures, judgements).dump());
  };
  const auto names = [](const Fleet& fleet) {
    std::vector<std::string> all;
    for (const FleetBoard& board : fleet.boards) all.push_back(board.name);
    return all;
  };
  const fs::path a = of("a", "ssh://a", ""), b = of("b", "ssh://b", ""), c = of("c", "ssh://b", "F7");
  EXPECT_THAT(names(read_fleet({a, b, c})), ElementsAre("board (ssh://a)", "board (ssh://b)", "board (ssh://b, F7)"));
  EXPECT_THAT(names(read_fleet({a, of("later", "ssh://a", "", "2026-11-27")})), ElementsAre("board", "board"));
  EXPECT_THAT(complaint({a, b, a}), HasSubstr("board is there with the same date"));
}

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
  EXPECT_THAT(fleet.unjudged, ElementsAre("wakeup_p999_us", "word_max_ticks", "faults"));
}

TEST_F(ReadFleet, ABoardThatWasMeasuredOftenCountsOnceWithItsNewestValue) {
  const std::vector<fs::path> often = {report("red", 70, "2026-11-28"), report("red", 20, "2026-11-25"), report("red", 70, "2026-11-26"),
                                       report("red", 70, "2026-11-27")};
  std::vector<fs::path> all = often;
  all.push_back(report("blue", 20));
  EXPECT_THAT(read_fleet(all).unjudged, ElementsAre("wakeup_p999_us", "word_max_ticks", "faults")) << "these are two boards";
  for (const char* host : {"green", "grey", "black", "white"}) all.push_back(report(host, 20));
  for (const FleetBoard& board : read_fleet(all).boards) {
    EXPECT_EQ(!board.outliers.empty(), board.values[0] == 70) << board.name << " of " << board.date;
  }
}

TEST_F(ReadFleet, AReportOfAnotherReleaseHasEmptyCells) {
  const auto newer = folder_.write(
      "newer.json",
      R"({"host": "x", "date": "", "verdict": "not fit", "limits": [{"key": "new", "limit": 0, "value": 1, "outcome": "missed"}]})");
  EXPECT_EQ(to_csv(read_fleet({report("red", 20), newer})),
            "board,date,verdict,wakeup_p999_us,celsius,word_max_ticks,faults,new,outliers,"
            "wakeup_p999_us_limit,celsius_limit,word_max_ticks_limit,faults_limit,new_limit\n"
            "red,2026-11-26,fit,20,,0.5,0,,,1000,75,1,0,\n"
            "x,,not fit,,,,,1,,,,,,0\n");
}

TEST_F(ReadFleet, TheTableHasARowForEachBoard) {
  EXPECT_EQ(to_csv(read_fleet({report("red", 20), report("blue, left", 21.5)})),
            "board,date,verdict,wakeup_p999_us,celsius,word_max_ticks,faults,outliers,"
            "wakeup_p999_us_limit,celsius_limit,word_max_ticks_limit,faults_limit\n"
            "red,2026-11-26,fit,20,,0.5,0,,1000,75,1,0\n"
            "\"blue, left\",2026-11-26,fit,21.5,,0.5,0,,1000,75,1,0\n");
}

TEST_F(ReadFleet, LimitsThatDifferFromBoardToBoardAreNamedWithTheBoards) {
  EXPECT_THAT(unlike_limits(read_fleet({report("red", 20), report("blue", 21)})), IsEmpty());
  const auto lax = [&](const std::string& host, const std::string& faults) {
    return folder_.write(host + ".json", R"({"host": ")" + host + R"(", "date": "", "verdict": "fit", "limits": [
        {"key": "wakeup_p999_us", "limit": 1e9, "value": 5000, "outcome": "met"},
        {"key": "celsius", "limit": 75, "value": null, "outcome": "not measured"},
        {"key": "word_max_ticks", "limit": 1, "value": 1, "outcome": "met"}, )" +
                                             faults + "]}");
  };
  const std::string faults = R"({"key": "faults", "limit": 0, "value": 0, "outcome": "met"})";
  const auto more = lax("more", faults + R"(, {"key": "inactive", "limit": 50, "value": 3, "outcome": "met"})");
  EXPECT_THAT(unlike_limits(read_fleet({report("red", 20), lax("lax", faults), report("blue", 20), more})),
              ElementsAre("wakeup_p999_us: at most 1000 on red and blue, at most 1e+09 on lax and more",
                          "inactive: missing on red and lax and blue, at most 50 on more"));
}

TEST_F(ReadFleet, TheOutcomeAndTheVerdictMustFollowFromTheFigures) {
  const auto limit = [](const std::string& key, const std::string& value, const std::string& outcome) {
    return R"({"key": ")" + key + R"(", "limit": 1, "value": )" + value + R"(, "outcome": ")" + outcome + "\"}";
  };
  const auto said = [&](const std::string& verdict, const std::vector<std::string>& limits, const std::string& more = "") {
    std::string list;
    for (const std::string& one : limits) list += (list.empty() ? "" : ", ") + one;
    return complaint(
        {folder_.write("x.json", R"({"host": "x", "date": "", "verdict": ")" + verdict + R"(", "limits": [)" + list + "]" + more + "}")});
  };
  const std::string word = limit("word_max_ticks", "1", "met"), faults = limit("faults", "0", "met"), met = limit("a", "1", "met"),
                    missed = limit("b", "1.5", "missed"), unknown = limit("c", "null", "not measured");
  EXPECT_THAT(said("fit", {word, faults, met}), IsEmpty());
  EXPECT_THAT(said("fit", {word, faults, unknown}), IsEmpty());
  EXPECT_THAT(said("not fit", {word, faults, missed}), IsEmpty());
  EXPECT_THAT(said("not fit", {limit("word_max_ticks", "null", "not measured"), faults}), IsEmpty());
  const std::string celsius = limit("celsius_max", "null", "not measured"), lost = R"(, "sensors_unknown": "the shell has ended")";
  EXPECT_THAT(said("fit", {word, faults, celsius}), IsEmpty());
  EXPECT_THAT(said("not fit", {word, faults, celsius}, lost), IsEmpty());
  EXPECT_THAT(said("fit", {word, faults, celsius}, lost), HasSubstr("does not follow from its limits"));
  EXPECT_THAT(said("fit", {}), HasSubstr("x.json: a report without limits"));
  for (const auto& [verdict, limits] :
       std::vector<std::pair<std::string, std::vector<std::string>>>{{"fit", {word, faults, missed}},
                                                                     {"not fit", {word, faults, met}},
                                                                     {"splendid", {word, faults}},
                                                                     {"fit", {limit("word_max_ticks", "null", "not measured"), faults}},
                                                                     {"fit", {word, limit("faults", "null", "not measured")}},
                                                                     {"fit", {met}},
                                                                     {"fit", {word}},
                                                                     {"fit", {faults}}}) {
    EXPECT_THAT(said(verdict, limits), HasSubstr("x.json: the verdict '" + verdict + "' does not follow from its limits")) << limits.back();
  }
  for (const std::string& wrong : {limit("late_ticks", "500", "met"), limit("a", "0", "missed"), limit("a", "0", "not measured"),
                                   limit("a", "null", "met"), limit("a", "2", "exceeded")}) {
    EXPECT_THAT(said("fit", {word, faults, wrong}), HasSubstr("does not follow from its value and limit")) << wrong;
    EXPECT_THAT(said("not fit", {word, faults, wrong}), HasSubstr("does not follow from its value and limit")) << wrong;
  }
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
