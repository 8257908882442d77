#include "host/qualify/svg.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>

namespace isotouch::qualify {

namespace {

constexpr double kWidth = 640, kHeight = 180, kLeft = 56, kBottom = 28, kTop = 10;
constexpr double kPlotWidth = kWidth - kLeft - 12, kPlotHeight = kHeight - kTop - kBottom;

std::string at(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f", x);
  return text;
}

std::string line(double x1, double y1, double x2, double y2, const char* look) {
  return "<line x1=\"" + at(x1) + "\" y1=\"" + at(y1) + "\" x2=\"" + at(x2) + "\" y2=\"" + at(y2) + "\" class=\"" + look + "\"/>";
}

std::string label(double x, double y, const char* anchor, const std::string& text) {
  return "<text x=\"" + at(x) + "\" y=\"" + at(y) + "\" text-anchor=\"" + anchor + "\">" + escaped(text) + "</text>";
}

std::string frame(const std::string& inside) {
  return "<svg viewBox=\"0 0 " + at(kWidth) + " " + at(kHeight) + "\" role=\"img\">" + inside + "</svg>\n";
}

/// Counts by quarters of an octave, whatever classes they came in, so that two histograms can be drawn on each other.
struct Column {
  double from_ns, to_ns;
  std::uint64_t count;
};
constexpr double kColumnsAnOctave = 4;

std::vector<Column> columns(const link::Histogram& histogram) {
  std::vector<Column> columns;
  for (const protocol::Bin& bin : histogram.bins) {
    const double place = std::floor(std::log2(std::max(bin.upper, 1U)) * kColumnsAnOctave);
    const double from = std::exp2(place / kColumnsAnOctave);
    if (columns.empty() || columns.back().from_ns < from) columns.push_back({from, std::exp2((place + 1) / kColumnsAnOctave), 0});
    columns.back().count += bin.count;
  }
  return columns;
}

}  // namespace

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '&')
      out += "&amp;";
    else if (c == '"')
      out += "&quot;";
    else
      out += c;
  }
  return out;
}

std::string short_number(double value) {
  char text[32];
  const double size = std::abs(value);
  const int decimals = size == 0 || size >= 100 ? 0 : std::clamp(2 - static_cast<int>(std::floor(std::log10(size))), 0, 6);
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  std::string number = text;
  if (number.find('.') != std::string::npos) {
    number.erase(number.find_last_not_of('0') + 1);
    if (number.back() == '.') number.pop_back();
  }
  return number;
}

std::string histogram_svg(const link::Histogram& histogram, double unit_ns, const std::string& unit, std::optional<double> limit_ns,
                          const link::Histogram& beside) {
  const std::vector<Column> bars = columns(histogram), line_of = columns(beside);
  if (bars.empty()) return "<p>Nothing was measured.</p>\n";
  double least = bars.front().from_ns, most = bars.back().to_ns;
  std::uint64_t highest = 1;
  for (const auto* all : {&bars, &line_of}) {
    for (const Column& c : *all) {
      least = std::min(least, c.from_ns), most = std::max(most, c.to_ns), highest = std::max(highest, c.count);
    }
  }
  if (limit_ns) most = std::max(most, *limit_ns * 1.1), least = std::min(least, *limit_ns / 1.1);
  const double octaves = std::max(std::log2(most / least), 1.0), decades = std::log10(static_cast<double>(highest)) + 0.5;
  const auto x = [&](double ns) { return kLeft + std::log2(ns / least) / octaves * kPlotWidth; };
  const auto y = [&](double count) { return kTop + kPlotHeight - (std::log10(count) + 0.3) / (decades + 0.3) * kPlotHeight; };
  std::string in;
  for (double count = 1; std::log10(count) < decades; count *= 10) {
    in += line(kLeft, y(count), kLeft + kPlotWidth, y(count), "grid") + label(kLeft - 6, y(count) + 4, "end", short_number(count));
  }
  for (double decade = std::floor(std::log10(least / unit_ns)); decade <= std::log10(most / unit_ns); ++decade) {
    for (const double step : {1.0, 2.0, 5.0}) {
      const double ns = step * std::pow(10, decade) * unit_ns;
      if (ns < least || ns > most || (step != 1.0 && octaves > 8)) continue;
      in += line(x(ns), kTop, x(ns), kTop + kPlotHeight, "grid") + label(x(ns), kHeight - 10, "middle", short_number(ns / unit_ns));
    }
  }
  in += label(kWidth - 4, kHeight - 10, "end", unit);
  const double floor = kTop + kPlotHeight;
  for (const Column& c : bars) {
    const double height = floor - y(static_cast<double>(c.count));
    in += "<rect class=\"bar\" x=\"" + at(x(c.from_ns)) + "\" y=\"" + at(floor - height) + "\" width=\"" +
          at(x(c.to_ns) - x(c.from_ns) - 0.5) + "\" height=\"" + at(height) + "\"><title>" + std::to_string(c.count) + " up to " +
          short_number(c.to_ns / unit_ns) + " " + unit + "</title></rect>";
  }
  std::string points;
  const auto point = [&](double ns, double height) { points += at(x(ns)) + "," + at(height) + " "; };
  double before = 0;  // where the last column ended: between columns that do not touch there is nothing
  for (const Column& c : line_of) {
    if (before > 0 && c.from_ns > before * 1.01) point(before, floor);
    if (c.from_ns > before * 1.01) point(c.from_ns, floor);
    for (const double ns : {c.from_ns, c.to_ns}) point(ns, y(static_cast<double>(c.count)));
    before = c.to_ns;
  }
  if (before > 0) point(before, floor);
  if (!points.empty()) in += "<polyline class=\"beside\" points=\"" + points + "\"/>";
  if (limit_ns) in += line(x(*limit_ns), kTop, x(*limit_ns), floor, "limit");
  return frame(in);
}

std::string course_svg(const std::vector<Sample>& samples, const std::string& unit) {
  if (samples.empty()) return "<p>Nothing was measured.</p>\n";
  double least = samples[0].value, most = least;
  for (const Sample& s : samples) least = std::min(least, s.value), most = std::max(most, s.value);
  const double margin = std::max((most - least) * 0.1, std::max(std::abs(most) * 0.01, 0.5));
  least -= margin, most += margin;
  const double length = std::max(samples.back().second, 1e-3);
  const auto x = [&](double second) { return kLeft + second / length * kPlotWidth; };
  const auto y = [&](double value) { return kTop + (most - value) / (most - least) * kPlotHeight; };
  std::string in;
  for (int i = 0; i <= 4; ++i) {
    const double value = least + (most - least) * i / 4;
    in += line(kLeft, y(value), kLeft + kPlotWidth, y(value), "grid") + label(kLeft - 6, y(value) + 4, "end", short_number(value));
    in += label(x(length * i / 4), kHeight - 10, "middle", short_number(length * i / 4) + " s");
  }
  std::string points;
  for (const Sample& s : samples) points += at(x(s.second)) + "," + at(y(s.value)) + " ";
  return frame(in + label(kLeft + 4, kTop + 12, "start", unit) + "<polyline class=\"course\" points=\"" + points + "\"/>");
}

}  // namespace isotouch::qualify
