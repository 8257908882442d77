#include "host/qualify/verdict.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "shared/tick_io.h"
#include "tests/host/qualify/good_board.h"

namespace isotouch::qualify {
namespace {

using Outcome = Judgement::Outcome;

/// The keys of the limits with that outcome, once the good board is spoiled.
std::set<std::string> keys(Outcome outcome, const std::function<void(Figures&)>& spoil, const Limits& limits = {}) {
  Figures figures = good_board();
  spoil(figures);
  std::set<std::string> keys;
  for (const Judgement& j : judge(figures, limits)) {
    if (j.outcome == outcome) keys.insert(j.key);
  }
  return keys;
}

constexpr auto kAsItIs = [](Figures&) {};

TEST(Verdict, AGoodBoardIsFitAndEveryLimitWasJudged) {
  const auto judgements = judge(good_board(), {});
  EXPECT_EQ(judgements.size(), 12U);
  EXPECT_TRUE(is_fit(judgements)) << sentence(judgements);
  EXPECT_EQ(sentence(judgements), "fit");
  EXPECT_TRUE(keys(Outcome::kNotMeasured, kAsItIs).empty());
}

TEST(Verdict, ALimitIsKeptOrExceededForPeopleAndMetOrMissedForPrograms) {
  using enum Judgement::Outcome;
  EXPECT_STREQ(in_words(kMet), "kept");
  EXPECT_STREQ(in_words(kMissed), "exceeded");
  EXPECT_STREQ(in_words(kNotMeasured), "not measured");
  EXPECT_STREQ(name_of(kMet), "met");
  EXPECT_STREQ(name_of(kMissed), "missed");
}

TEST(Verdict, EachLimitFailsAloneAndByName) {
  const std::vector<std::pair<std::string, std::function<void(Figures&)>>> spoilt = {
      {"left_out", [](Figures& f) { f.ticks = 9'890; }},
      {"late_ticks", [](Figures& f) { f.late = 1; }},
      {"wakeup_p999_us",
       [](Figures& f) {
         f.measures[0].bins.back() = {101'000, 20};
       }},
      {"round_trip_p999_us",
       [](Figures& f) {
         f.measures[2].bins.back() = {2'501'000, 20};
       }},
      {"lost_samples", [](Figures& f) { f.measures[2].count = 9'899; }},
      {"word_max_ticks",
       [](Figures& f) {
         f.measures[3].bins.push_back({1'000'001, 1});
       }},
      {"celsius_max", [](Figures& f) { f.moments[0].celsius = 75.1; }},
      {"page_faults", [](Figures& f) { f.page_faults = 1; }},
      {"allocations", [](Figures& f) { f.allocations = 1; }},
      {"faults", [](Figures& f) { f.moments[1].state = 6; }},
      {"cold_tick_p99_us", [](Figures& f) { f.cold.bins[1].upper = 100'001; }},
      {"inactive", [](Figures& f) { f.moments[0].force = f.moments[1].force = false; }},
  };
  EXPECT_EQ(spoilt.size(), judge(good_board(), {}).size()) << "every limit has its case here";
  for (const auto& [key, spoil] : spoilt) {
    EXPECT_EQ(keys(Outcome::kMissed, spoil), std::set<std::string>{key});
    Figures figures = good_board();
    spoil(figures);
    const auto judgements = judge(figures, {});
    EXPECT_FALSE(is_fit(judgements)) << key;
    EXPECT_THAT(sentence(judgements), testing::StartsWith("not fit; beyond the limit: "));
  }
}

TEST(Verdict, AValueAtItsLimitIsGood) {
  const auto at_the_limit = [](Figures& f) {
    f.moments[0].celsius = 75;
    f.measures[3].bins.back().upper = 1'000'000;
    f.measures[2] = {9'801, {{2'500'000, 9'801}}};
    f.moments[1].state = 5, f.moments[1].force = false;
    f.measures[0].bins = {{100'000, 10'000}};
    f.ticks = 9'900;
  };
  EXPECT_TRUE(keys(Outcome::kMissed, at_the_limit).empty());
}

TEST(Verdict, TheWakeUpsLimitFollowsThePeriodUnlessItIsSet) {
  const auto faster = [](Figures& f) { f.period_ns = 100'000, f.ticks = 100'000, f.cold = {}, f.cold_seconds = 0; };
  EXPECT_EQ(keys(Outcome::kMissed, faster), std::set<std::string>{"wakeup_p999_us"}) << "40 us of a tenth of 100 us";
  Limits own;
  own.wakeup_us = 39;
  EXPECT_EQ(keys(Outcome::kMissed, kAsItIs, own), std::set<std::string>{"wakeup_p999_us"});
}

TEST(Verdict, AColdTickMayTakeATenthOfThePeriodUnlessTheLimitIsSet) {
  EXPECT_TRUE(keys(Outcome::kMissed, [](Figures& f) { f.cold.bins[1].upper = 100'000; }).empty());
  EXPECT_TRUE(keys(Outcome::kMissed, [](Figures& f) { f.cold.bins = {{9'000, 1'980}, {200'000, 20}}; }).empty()) << "one in a hundred";
  const auto faster = [](Figures& f) {
    f.period_ns = 200'000, f.ticks = 50'000, f.measures[0].bins = {{9'000, 50'000}}, f.cold.count = 10'000;
  };
  EXPECT_EQ(keys(Outcome::kMissed, faster), std::set<std::string>{"cold_tick_p99_us"});
  Limits own;
  own.cold_tick_us = 29;
  EXPECT_EQ(keys(Outcome::kMissed, kAsItIs, own), std::set<std::string>{"cold_tick_p99_us"});
  EXPECT_EQ(keys(Outcome::kNotMeasured, [](Figures& f) { f.cold = {}, f.cold_seconds = 0; }), std::set<std::string>{"cold_tick_p99_us"});
}

TEST(Verdict, TicksFasterThanAFalconNeedNoSampleEach) {
  const auto ten_kilohertz = [](Figures& f) {
    f.period_ns = 100'000, f.ticks = 100'000, f.measures[0].bins = {{9'000, 100'000}}, f.cold = {}, f.cold_seconds = 0;
  };
  EXPECT_TRUE(keys(Outcome::kMissed, ten_kilohertz).empty()) << "one a millisecond is all there is";
  const auto and_slow = [&](Figures& f) { ten_kilohertz(f), f.measures[2].count = 9'000; };
  EXPECT_EQ(keys(Outcome::kMissed, and_slow), std::set<std::string>{"lost_samples"});
}

TEST(Verdict, AControllerThatNeverGaveAForceIsNotFit) {
  for (std::uint16_t state = 0; state <= 6; ++state) {
    Figures figures = good_board();
    for (Moment& moment : figures.moments) moment.state = state, moment.force = false;
    EXPECT_FALSE(is_fit(judge(figures, {}))) << state << ": also in the state active, where the hand touches nothing";
  }
}

TEST(Verdict, WhatHappensAfterTheUndisturbedTicksCounts) {
  EXPECT_EQ(keys(Outcome::kMissed, [](Figures& f) { f.later[0].state = 6; }), std::set<std::string>{"faults"});
  EXPECT_EQ(keys(Outcome::kMissed, [](Figures& f) { f.later[0].page_faults = 1; }), std::set<std::string>{"page_faults"});
  EXPECT_EQ(keys(Outcome::kMissed, [](Figures& f) { f.later[0].allocations = 1; }), std::set<std::string>{"allocations"});
  EXPECT_EQ(keys(Outcome::kMissed, [](Figures& f) { f.cold_late = 1; }), std::set<std::string>{"late_ticks"});
  EXPECT_EQ(keys(Outcome::kMissed, [](Figures& f) { f.cold.count = 1'979; }), std::set<std::string>{"left_out"});
  EXPECT_EQ(keys(Outcome::kMissed, [](Figures& f) { f.cold = {}; }), std::set<std::string>{"left_out"}) << "no tick came at all";
  EXPECT_TRUE(keys(Outcome::kMissed, [](Figures& f) { f.cold.count = 1'980, f.later[0].state = 5; }).empty());
}

TEST(Verdict, AControllerThatIsGoneAtTheEndIsNotFit) {
  const auto gone = [](Figures& f) { f.later.clear(), f.end_unknown = "the connection was closed"; };
  EXPECT_EQ(keys(Outcome::kNotMeasured, gone), std::set<std::string>{"faults"});
  Figures figures = good_board();
  gone(figures);
  EXPECT_EQ(sentence(judge(figures, {})), "not fit; not measured: checks that find a fault");
}

TEST(Verdict, WhatWasNotMeasuredIsSaidAndOnlyMissingWordsMakeABoardUnfit) {
  const auto no_sensor = [](Figures& f) { f.moments[0].celsius = f.moments[1].celsius = std::nullopt; };
  EXPECT_EQ(keys(Outcome::kNotMeasured, no_sensor), std::set<std::string>{"celsius_max"});
  Figures figures = good_board();
  no_sensor(figures);
  EXPECT_EQ(sentence(judge(figures, {})), "fit; not measured: highest temperature");
  figures.measures[3] = {};
  EXPECT_FALSE(is_fit(judge(figures, {}))) << "no device: no word was ever made of a sample";
  EXPECT_FALSE(is_fit(judge(Figures{}, {})));
  EXPECT_FALSE(is_fit({}));
}

TEST(Verdict, ABoardWhoseSensorsWereLostIsNotFit) {
  Figures figures = good_board();
  figures.sensors_unknown = "the shell there has ended";
  EXPECT_EQ(sentence(judge(figures, {})), "not fit; not measured: highest temperature");
  figures.moments[0].celsius = 75.1;
  EXPECT_EQ(sentence(judge(figures, {})), "not fit; beyond the limit: highest temperature") << "what was read until then counts";
}

}  // namespace
}  // namespace isotouch::qualify
