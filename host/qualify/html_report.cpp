#include <cstdint>
#include <cstdio>
#include <optional>
#include <string_view>
#include <utility>

#include "host/files/html_text.h"
#include "host/qualify/report.h"
#include "host/view/caption.h"
#include "host/view/histogram_plot.h"
#include "host/view/palette.h"
#include "host/view/plot.h"

namespace isotouch::qualify {

namespace {

constexpr const char* kStyle =
    "body{font:15px/1.5 system-ui,sans-serif;max-width:60rem;margin:2rem auto;padding:0 1rem;color:#222;background:#fff}"
    "h1{font-size:1.5rem}h2{font-size:1.15rem;margin-top:2rem}table{border-collapse:collapse}td,th{padding:.2rem .9rem .2rem "
    "0;text-align:left;"
    "border-bottom:1px solid #ddd;vertical-align:top}td.n{text-align:right;font-variant-numeric:tabular-nums}"
    ".fit{color:#17692b}.unfit{color:#b00020}.missed{color:#b00020;font-weight:600}.unknown{color:#777}.better{color:#9a5b00}"
    "img{width:100%;max-width:46rem}";

std::string short_number(double value) { return view::significant(value, 3); }

/// A figure within the page. Each is a document of its own, so that the letters of one are not taken for those of another.
///
/// about     what it shows, for who does not see it
std::string figure(const view::Picture& picture, const std::string& about) {
  std::string address;
  for (const std::uint8_t byte : view::encode(picture, ".svg")) {
    const char c = static_cast<char>(byte);
    const bool is_plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                          std::string_view(" ,./:;=-_()").find(c) != std::string_view::npos;
    char code[4];
    std::snprintf(code, sizeof code, "%%%02X", byte);
    address += is_plain ? std::string(1, c) : code;
  }
  return "<img alt=\"" + html_text(about) + "\" src=\"data:image/svg+xml," + address + "\">\n";
}

constexpr int kFigureWidth = 736, kFigureHeight = 250;

std::vector<view::ValueClass> classes_of(const link::Histogram& histogram, double unit_ns) {
  std::vector<view::ValueClass> classes;
  for (const protocol::Bin& bin : histogram.bins) classes.push_back({bin.upper / unit_ns, static_cast<double>(bin.count)});
  return classes;
}

std::string row(const std::string& name, const std::string& value) {
  return "<tr><th>" + html_text(name) + "</th><td>" + html_text(value) + "</td></tr>\n";
}

std::string verdict_table(const std::vector<Judgement>& judgements) {
  std::string html = "<table><tr><th>what</th><th>limit</th><th>seen</th><th></th></tr>\n";
  for (const Judgement& j : judgements) {
    const bool known = j.outcome != Judgement::Outcome::kNotMeasured;
    const char* look = j.outcome == Judgement::Outcome::kMissed ? "missed" : known ? "fit" : "unknown";
    html += "<tr><td>" + html_text(j.what) + "</td><td class=\"n\">" + short_number(j.limit) + " " + html_text(j.unit) +
            "</td><td class=\"n\">" + (known ? short_number(j.value) + " " + html_text(j.unit) : "") + "</td><td class=\"" + look + "\">" +
            in_words(j.outcome) + "</td></tr>\n";
  }
  return html + "</table>\n";
}

/// p50, p99, p99.9 and the largest, in words.
std::string quantiles(const link::Histogram& histogram, double unit_ns, const char* unit) {
  std::string text = std::to_string(histogram.count) + " values";
  const auto add = [&](const char* name, double share) {
    if (const auto ns = quantile_ns(histogram, share)) text += std::string(", ") + name + " " + short_number(*ns / unit_ns) + " " + unit;
  };
  add("median", 0.5), add("99 %", 0.99), add("99.9 %", 0.999), add("largest", 1);
  return text;
}

std::string worst_table(const Figures& figures) {
  if (figures.worst.empty()) return "<p>" + std::string("There were no ticks.") + "</p>\n";
  std::string html = "<table><tr><th>tick</th><th>began late by</th><th>took</th><th>what ran on its processor</th></tr>\n";
  for (const WorstTick& worst : figures.worst) {
    html += "<tr><td class=\"n\">" + std::to_string(worst.tick.number) + "</td><td class=\"n\">" +
            short_number(worst.tick.wake_ns / 1000.0) + " us</td><td class=\"n\">" + short_number(worst.tick.tick_ns / 1000.0) +
            " us</td>" + (worst.cause.empty() ? "<td class=\"unknown\">unknown" : "<td>" + html_text(worst.cause)) + "</td></tr>\n";
  }
  html += "</table>\n";
  if (!figures.cause_unknown.empty()) html += "<p>Causes: " + html_text(figures.cause_unknown) + "</p>\n";
  return html;
}

std::string subject_table(const Subject& subject) {
  const auto or_none = [](const std::string& text, const char* none) { return text.empty() ? std::string(none) : text; };
  return "<table>" + row("date", subject.date) + row("host", or_none(subject.host, "unknown")) + row("isotouch", subject.tool) +
         row("controller", subject.controller) + row("protocol", subject.protocol) + row("field", or_none(subject.field, "none")) +
         row("checksum of the settings", subject.settings) + row("device", or_none(subject.device, "none")) + "</table>\n";
}

std::string practice_table(const std::vector<Finding>& practice) {
  std::string html = "<table><tr><th>what</th><th>read</th><th></th><th>why, and what to do</th></tr>\n";
  for (const Finding& f : practice) {
    const bool known = f.verdict != Finding::Verdict::kNotRead;
    const char* look = f.verdict == Finding::Verdict::kBad    ? "missed"
                       : f.verdict == Finding::Verdict::kGood ? "fit"
                       : known                                ? "better"
                                                              : "unknown";
    html += "<tr><td>" + html_text(f.what) + "</td><td>" + html_text(f.read) + "</td><td class=\"" + look + "\">" + name_of(f.verdict) +
            "</td><td>" + html_text(f.why) + (f.remedy.empty() ? "" : "<br>" + html_text(f.remedy)) + "</td></tr>\n";
  }
  return html + "</table>\n<p>The verdict follows from what was measured, not from this table, which says where time may be lost.</p>\n";
}

/// A value over time.
std::string course_figure(view::Series series, const std::string& what, const std::string& unit) {
  view::Picture picture(kFigureWidth, kFigureHeight);
  view::Canvas canvas(picture);
  view::Plot plot;
  plot.x_label = "time (s)";
  plot.y_label = unit;
  plot.series.push_back(std::move(series));
  plot.draw(canvas, {0, 0, kFigureWidth, kFigureHeight});
  return figure(picture, what + " over time");
}

std::string course(const Figures& figures, const char* title, const char* unit, std::optional<double> Moment::*value) {
  view::Series series{"", {}, {}, view::kBlue};
  for (const Moment& m : figures.moments) {
    if (m.*value) series.x.push_back(m.second), series.y.push_back(*(m.*value));
  }
  const std::string heading = std::string("<h2>") + title + "</h2>\n";
  return heading + (series.x.empty() ? "<p>This board shows none.</p>\n" : course_figure(std::move(series), title, unit));
}

std::string late_course(const Figures& figures) {
  view::Series series{"", {}, {}, view::kBlue};
  for (const Moment& m : figures.moments) series.x.push_back(m.second), series.y.push_back(static_cast<double>(m.late));
  return "<h2>Late ticks until then</h2>\n" +
         (series.x.empty() ? "<p>Nothing was measured.</p>\n" : course_figure(std::move(series), "Late ticks", "ticks"));
}

}  // namespace

std::string html_report(const Figures& figures, const std::vector<Judgement>& judgements) {
  std::string html = "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>Qualification of " +
                     html_text(figures.address) + "</title><style>" + kStyle + "</style></head><body>\n";
  html += "<h1>" + html_text(figures.address) + " is <span class=\"" + (is_fit(judgements) ? "fit" : "unfit") + "\">" +
          html_text(sentence(judgements)) + "</span></h1>\n";
  html += "<p>" + std::to_string(figures.ticks) + " ticks of " + short_number(figures.period_ns / 1000.0) + " us in " +
          short_number(figures.seconds) + " s.</p>\n" + verdict_table(judgements);
  if (!figures.end_unknown.empty()) html += "<p>The end of the measurement: " + html_text(figures.end_unknown) + "</p>\n";
  html += "<h2>What was measured</h2>\n" + subject_table(figures.subject);
  html += "<h2>Settings that affect timing</h2>\n" +
          (figures.practice_unknown.empty() ? practice_table(figures.practice) : "<p>" + html_text(figures.practice_unknown) + "</p>\n");
  html += "<h2>The board</h2>\n<table>";
  for (const auto& [name, value] : figures.board) html += row(name, value);
  html += "</table>\n";
  for (std::size_t i = 0; i < protocol::kMeasures; ++i) {
    const auto measure = static_cast<protocol::Measure>(i);
    const MeasureText text = text_of(measure);
    const double unit_ns = measure == protocol::Measure::kDelay ? figures.period_ns : 1000.0;
    std::optional<double> limit;
    for (const Judgement& j : judgements) {
      if (measure == protocol::Measure::kWakeup && j.key == "wakeup_p999_us") limit = j.limit;
      if (measure == protocol::Measure::kTick && j.key == "cold_tick_p99_us") limit = j.limit;
      if (measure == protocol::Measure::kRoundTrip && j.key == "round_trip_p999_us") limit = j.limit;
      if (measure == protocol::Measure::kDelay && j.key == "word_max_ticks") limit = j.limit;
    }
    html += std::string("<h2>") + text.title + "</h2>\n<p>" + quantiles(figures.measures[i], unit_ns, text.unit) + "</p>\n";
    if (measure == protocol::Measure::kWakeup) {
      const std::string cut = figures.timer_unknown.empty() ? "" : ". It ended before its time: " + html_text(figures.timer_unknown);
      html += figures.timer.count > 0
                  ? "<p>The line beside it is cyclictest, the same rate afterwards, priority " + std::to_string(figures.timer_priority) +
                        ": " + quantiles(figures.timer, 1000, "us") + cut + "</p>\n"
                  : "<p>Not compared with cyclictest: " + html_text(figures.timer_unknown) + "</p>\n";
    }
    if (measure == protocol::Measure::kTick) {
      html += figures.cold.count > 0 ? "<p>The line beside it is the same afterwards, while other programs wrote to memory: " +
                                           quantiles(figures.cold, 1000, "us") + "</p>\n"
                                     : "<p>Cold ticks: " + html_text(figures.cold_unknown) + "</p>\n";
    }
    const link::Histogram beside = measure == protocol::Measure::kWakeup ? figures.timer
                                   : measure == protocol::Measure::kTick ? figures.cold
                                                                         : link::Histogram{};
    view::Picture picture(kFigureWidth, kFigureHeight);
    view::Canvas canvas(picture);
    view::HistogramPlot plot{"", text.unit, classes_of(figures.measures[i], unit_ns), classes_of(beside, unit_ns), "controller", "", limit};
    plot.beside_label = measure == protocol::Measure::kWakeup ? "cyclictest" : "while others wrote to memory";
    plot.draw(canvas, {0, 0, kFigureWidth, kFigureHeight});
    html += figure(picture, std::string("Histogram: ") + text.title);
  }
  html += "<h2>The worst ten ticks</h2>\n" + worst_table(figures);
  if (!figures.sensors_unknown.empty()) html += "<p>" + html_text(figures.sensors_unknown) + "</p>\n";
  html += course(figures, "Temperature", "°C", &Moment::celsius) +
          course(figures, "Clock rate of the slowest processor", "MHz", &Moment::megahertz);
  return html + late_course(figures) + "</body></html>\n";
}

}  // namespace isotouch::qualify
