#include "host/qualify/report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "tests/host/qualify/good_board.h"

namespace isotouch::qualify {
namespace {

using testing::HasSubstr;
using testing::Not;

void replace_all(std::string& text, std::string_view from, std::string_view to) {
  for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) text.replace(at, from.size(), to);
}

/// Where the paths of this colour begin that lie in the page's histogram with this number: their x, in order.
std::vector<double> path_begins(const std::string& page, int histogram, std::string_view colour) {
  std::size_t at = 0;
  for (int i = 0; i <= histogram; ++i) at = page.find("<img alt=\"Histogram:", at + 1);
  std::string figure = page.substr(at, page.find("\">\n", at) - at);
  replace_all(figure, "=%22rgb(", ":rgb(");  // Cairo 1.16 writes colours as a style, 1.18 as attributes,
  replace_all(figure, "%25, ", "%25,");      // and with spaces
  std::vector<double> begins;
  for (at = figure.find(colour); at != std::string::npos; at = figure.find(colour, at + 1)) {
    begins.push_back(std::strtod(figure.c_str() + figure.find("M ", at) + 2, nullptr));
  }
  return begins;
}

/// The x of the line that marks the limit, and where the bar of the largest values begins.
struct Marked {
  double limit, last_bar;
};
Marked marked(const Figures& figures, int histogram) {
  const std::string page = html_report(figures, judge(figures, {}));
  const auto limits = path_begins(page, histogram, "stroke:rgb(83."), bars = path_begins(page, histogram, "fill:rgb(0%25,44.");
  if (limits.empty() || bars.size() < 2) return {0, 0};
  return {limits.front(), bars[bars.size() - 2]};  // the legend comes last
}

TEST(Report, TheObjectHoldsEveryFigure) {
  const Figures figures = good_board();
  const auto json = json_report(figures, judge(figures, {}));
  EXPECT_EQ(json["verdict"], "fit");
  EXPECT_EQ(json["limits"].size(), 12U);
  EXPECT_EQ(json["limits"][0]["unit"], "%");
  EXPECT_EQ(json["ticks"], 10'000);
  for (const char* key : {"wakeup_us", "tick_us", "round_trip_us", "cyclictest_us"}) {
    EXPECT_EQ(json[key]["count"], 10'000) << key;
    EXPECT_GT(json[key]["max"].get<double>(), json[key]["p50"].get<double>()) << key;
  }
  EXPECT_DOUBLE_EQ(json["wakeup_us"]["p50"].get<double>(), 12);
  EXPECT_DOUBLE_EQ(json["wakeup_us"]["p999"].get<double>(), 40);
  EXPECT_DOUBLE_EQ(json["wakeup_us"]["max"].get<double>(), 90);
  EXPECT_DOUBLE_EQ(json["delay_ticks"]["max"].get<double>(), 0.09);
  ASSERT_EQ(json["worst_ticks"].size(), 2U);
  EXPECT_EQ(json["worst_ticks"][0]["cause"], "processor 0: kworker/0:1");
  EXPECT_TRUE(json["worst_ticks"][1]["cause"].is_null());
  EXPECT_EQ(json["moments"][0]["celsius"], 55.5);
  EXPECT_EQ(json["moments"][0]["state"], "active");
  EXPECT_EQ(json["moments"][0]["force"], true);
  ASSERT_EQ(json["moments"].size(), 3U) << "with the look after the cold ticks";
  EXPECT_EQ(json["moments"][2]["second"], 12);
  EXPECT_EQ(json["cold_seconds"], 2);
  EXPECT_EQ(json["cold_late"], 0);
  EXPECT_EQ(json["cyclictest_priority"], 80);
  EXPECT_EQ(json["cold_tick_us"]["count"], 2'000);
  EXPECT_DOUBLE_EQ(json["cold_tick_us"]["p99"].get<double>(), 30);
}

TEST(Report, ItSaysWhatWasMeasuredAndWhatTheBoardDoesForIt) {
  Figures figures = good_board();
  auto json = json_report(figures, judge(figures, {}));
  EXPECT_EQ(json["date"], "2026-11-26T08:30:00Z");
  EXPECT_EQ(json["host"], "board");
  EXPECT_EQ(json["versions"].dump(), R"({"isotouch":"isotouch 1","controller":"isotouchd 1","protocol":"1.2"})");
  EXPECT_EQ(json["program"], "isotouchd 1");
  EXPECT_EQ(json["field"], "0123456789abcdef");
  EXPECT_EQ(json["device"], "FALCON1");
  EXPECT_EQ(json["settings_checksum"], "fedcba9876543210");
  EXPECT_EQ(json["practice"][0].dump(),
            R"({"key":"kernel","read":"Linux 6.1 <rt>","verdict":"bad","why":"It is slow.","remedy":"sudo reboot"})");
  EXPECT_EQ(json["practice"][1].dump(),
            R"({"key":"governor","read":null,"verdict":"could not be read","why":"There is none.","remedy":null})");
  EXPECT_EQ(json["verdict"], "fit") << "a finding explains, the measurement judges";
  const std::string page = html_report(figures, judge(figures, {}));
  for (const char* text :
       {"2026-11-26T08:30:00Z", "0123456789abcdef", "fedcba9876543210", "FALCON1", "<td>Linux 6.1 &lt;rt&gt;</td><td class=\"missed\">bad",
        "It is slow.<br>sudo reboot", "<td class=\"unknown\">could not be read"}) {
    EXPECT_THAT(page, HasSubstr(text));
  }
  figures.subject.field = figures.subject.device = "";
  json = json_report(figures, judge(figures, {}));
  EXPECT_TRUE(json["field"].is_null() && json["device"].is_null());
}

TEST(Report, WhatIsUnknownIsNullAndSaid) {
  Figures figures = good_board();
  figures.timer = {};
  figures.timer_unknown = "cyclictest is not installed there";
  figures.cause_unknown = "the tracer may not be used";
  figures.cold = {};
  figures.cold_unknown = "cold ticks were not asked for";
  figures.end_unknown = "the connection was closed";
  figures.sensors_unknown = "no sensor was read";
  figures.practice_unknown = "no setting was read";
  figures.moments[0].celsius = figures.moments[1].celsius = std::nullopt;
  const auto judgements = judge(figures, {});
  const auto json = json_report(figures, judgements);
  EXPECT_EQ(json["cyclictest_us"]["unknown"], figures.timer_unknown);
  EXPECT_EQ(json["cold_tick_us"]["unknown"], figures.cold_unknown);
  EXPECT_EQ(json["sensors_unknown"], figures.sensors_unknown);
  EXPECT_EQ(json["practice_unknown"], figures.practice_unknown);
  EXPECT_EQ(json["limits"][6]["key"], "celsius_max");
  EXPECT_TRUE(json["limits"][6]["value"].is_null());
  const std::string page = html_report(figures, judgements);
  EXPECT_THAT(page, HasSubstr("cyclictest is not installed there"));
  EXPECT_THAT(page, HasSubstr("the tracer may not be used"));
  EXPECT_THAT(page, HasSubstr("cold ticks were not asked for"));
  EXPECT_THAT(page, HasSubstr("This board shows none."));
  EXPECT_THAT(page, HasSubstr("the connection was closed"));
  EXPECT_THAT(page, HasSubstr("no sensor was read"));
  EXPECT_THAT(page, HasSubstr("no setting was read"));
}

TEST(Report, ACyclictestThatEndedBeforeItsTimeIsNotShownAsAWholeOne) {
  Figures figures = good_board();
  EXPECT_FALSE(json_report(figures, judge(figures, {})).contains("cyclictest_unknown"));
  EXPECT_THAT(html_report(figures, judge(figures, {})), Not(HasSubstr("before its time")));
  figures.timer_unknown = "FATAL: killed by <an admin>";
  const auto json = json_report(figures, judge(figures, {}));
  EXPECT_EQ(json["cyclictest_us"]["count"], 10'000);
  EXPECT_EQ(json["cyclictest_unknown"], figures.timer_unknown);
  EXPECT_THAT(html_report(figures, judge(figures, {})), HasSubstr("us. It ended before its time: FATAL: killed by &lt;an admin&gt;</p>"));
  figures.timer = {};
  EXPECT_FALSE(json_report(figures, judge(figures, {})).contains("cyclictest_unknown")) << "cyclictest_us says it";
}

TEST(Report, ThePageStandsAloneAndShowsTheVerdict) {
  Figures figures = good_board();
  std::string page = html_report(figures, judge(figures, {}));
  EXPECT_THAT(page, HasSubstr("<span class=\"fit\">fit</span>"));
  EXPECT_THAT(page, Not(HasSubstr("<script")));
  EXPECT_THAT(page, Not(HasSubstr("src=\"http"))) << "nothing is fetched";
  EXPECT_THAT(page, HasSubstr("Linux 6.1 &lt;rt&gt;"));
  std::size_t pictures = 0;
  for (auto at = page.find("<img alt="); at != std::string::npos; at = page.find("<img alt=", at + 1)) ++pictures;
  EXPECT_EQ(pictures, 7U) << "four histograms, temperature, clock rate, late ticks";
  EXPECT_THAT(page, HasSubstr("cyclictest, the same rate afterwards, priority 80"));
  figures.late = 3;
  page = html_report(figures, judge(figures, {}));
  EXPECT_THAT(page, HasSubstr("<span class=\"unfit\">not fit; beyond the limit: late ticks</span>"));
}

TEST(Report, ALimitIsDrawnAtItsValue) {
  for (int histogram = 0; histogram < static_cast<int>(protocol::kMeasures); ++histogram) {
    Figures figures = good_board();
    const Marked good = marked(figures, histogram);
    EXPECT_GT(good.limit, good.last_bar) << histogram;
    figures.measures[static_cast<std::size_t>(histogram)].bins.push_back({5'000'000, 20});  // 5000 us, or 5 ticks
    const Marked late = marked(figures, histogram);
    EXPECT_LT(late.limit, late.last_bar) << histogram;
    EXPECT_GT(late.limit, 0) << histogram;
  }
}

}  // namespace
}  // namespace isotouch::qualify
