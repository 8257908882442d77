#include "host/view/histogram_plot.h"

#include <algorithm>
#include <cmath>

#include "host/view/axes.h"
#include "host/view/caption.h"
#include "host/view/legend.h"
#include "host/view/palette.h"
#include "host/view/text.h"

namespace isotouch::view {
namespace {

constexpr double kColumnsAnOctave = 4;

double begin_of(const ValueClass& column) { return column.up_to / std::exp2(1 / kColumnsAnOctave); }

/// From values and counts to pixels.
class LogAxes {
 public:
  LogAxes(const Rect& area, double least, double most, double highest)
      : area_(area), least_(least), octaves_(std::max(std::log2(most / least), 1.0)), decades_(std::log10(highest) + 0.5) {}

  const Rect& area() const { return area_; }
  double octaves() const { return octaves_; }
  double last() const { return least_ * std::exp2(octaves_); }
  bool holds(double value) const { return value >= least_ && value <= last(); }
  bool holds_count(double count) const { return std::log10(count) < decades_; }
  float x(double value) const { return area_.left + static_cast<float>(std::log2(value / least_) / octaves_) * area_.width(); }
  float y(double count) const {
    constexpr double kBelowOne = 0.3;  // decades, so that a single value has a bar
    return area_.bottom - static_cast<float>((std::log10(count) + kBelowOne) / (decades_ + kBelowOne)) * area_.height();
  }

 private:
  Rect area_;
  double least_, octaves_, decades_;
};

LogAxes axes_for(const Rect& area, const std::vector<ValueClass>& bars, const std::vector<ValueClass>& line, std::optional<double> limit) {
  const ValueClass& first = bars.empty() ? line.front() : bars.front();
  double least = begin_of(first), most = first.up_to, highest = 1;
  for (const auto* all : {&bars, &line}) {
    for (const ValueClass& c : *all) {
      least = std::min(least, begin_of(c));
      most = std::max(most, c.up_to);
      highest = std::max(highest, c.count);
    }
  }
  if (limit) most = std::max(most, *limit * 1.1), least = std::min(least, *limit / 1.1);
  return LogAxes(area, least, most, highest);
}

void draw_grid(Canvas& canvas, const LogAxes& axes, const std::string& unit, float scale) {
  const Rect& area = axes.area();
  const TextStyle style{.capital = 8.5F * scale, .colour = kInk, .along = Anchor::kEnd, .across = Anchor::kMiddle};
  for (double count = 1; axes.holds_count(count); count *= 10) {
    canvas.line({area.left, axes.y(count)}, {area.right, axes.y(count)}, scale, kGrid);
    draw_text(canvas, {area.left - 8 * scale, axes.y(count)}, significant(count, 3), style);
  }
  TextStyle below = style;
  below.along = Anchor::kMiddle;
  below.across = Anchor::kEnd;
  for (double decade = -9; decade < 16; ++decade) {
    for (const double step : {1.0, 2.0, 5.0}) {
      const double value = step * std::pow(10.0, decade);
      if (!axes.holds(value) || (step != 1.0 && axes.octaves() > 8)) continue;
      canvas.line({axes.x(value), area.top}, {axes.x(value), area.bottom}, scale, kGrid);
      draw_text(canvas, {axes.x(value), area.bottom + 9 * scale}, significant(value, 3), below);
    }
  }
  draw_text(canvas, {(area.left + area.right) / 2, area.bottom + 27 * scale}, unit, below);
}

/// Where columns do not touch, there is nothing between them.
std::vector<Polyline> outline(const std::vector<ValueClass>& line, const LogAxes& axes) {
  const float floor = axes.area().bottom;
  Polyline points;
  double before = 0;
  for (const ValueClass& c : line) {
    const double from = begin_of(c);
    if (from > before * 1.01) {
      if (before > 0) points.push_back({axes.x(before), floor});
      points.push_back({axes.x(from), floor});
    }
    for (const double value : {from, c.up_to}) points.push_back({axes.x(value), axes.y(c.count)});
    before = c.up_to;
  }
  if (before > 0) points.push_back({axes.x(before), floor});
  return {points};
}

}  // namespace

std::vector<ValueClass> by_quarter_octaves(const std::vector<ValueClass>& classes) {
  std::vector<ValueClass> columns;
  for (const ValueClass& c : classes) {
    if (c.count <= 0) continue;
    // A bound itself belongs to the column that it ends.
    const double up_to = std::exp2(std::ceil(std::log2(std::max(c.up_to, 1e-3)) * kColumnsAnOctave - 1e-9) / kColumnsAnOctave);
    if (columns.empty() || columns.back().up_to < up_to * (1 - 1e-9)) columns.push_back({up_to, 0});
    columns.back().count += c.count;
  }
  return columns;
}

void HistogramPlot::draw(Canvas& canvas, const Rect& place) const {
  const float scale = drawing_scale(canvas.picture());
  const Rect area = frame_in(place, scale);
  draw_text(canvas, {area.left, area.top - 12 * scale}, title, {.capital = 10 * scale, .colour = kInk, .bold = true});
  canvas.fill(area, srgb(0xFFFFFF));
  const std::vector<ValueClass> bars = by_quarter_octaves(classes), line = by_quarter_octaves(beside);
  if (bars.empty() && line.empty()) {
    draw_text(canvas, {area.left + 12 * scale, area.top + 26 * scale}, "nothing was measured",
              {.capital = 8.5F * scale, .colour = kPaleInk});
    canvas.frame(area, 1.2F * scale, kPaleInk);
    return;
  }
  const LogAxes axes = axes_for(area, bars, line, limit);
  draw_grid(canvas, axes, unit, scale);
  for (const ValueClass& c : bars) {
    const float right = std::max(axes.x(c.up_to) - 0.5F * scale, axes.x(begin_of(c)) + 0.5F * scale);
    canvas.fill({axes.x(begin_of(c)), axes.y(c.count), right, area.bottom}, kBlue);
  }
  canvas.within(area).stroke(outline(line, axes), 1.8F * scale, kOrange);
  if (limit) {
    const Polyline at = {{axes.x(*limit), area.top}, {axes.x(*limit), area.bottom}};
    canvas.stroke(dashed(at, 7 * scale, 5 * scale), 1.8F * scale, kVermilion);
  }
  canvas.frame(area, 1.2F * scale, kPaleInk);

  Legend legend(canvas, area);
  if (limit) legend.add_line("limit", kVermilion, 1.8F, true);
  if (!line.empty()) legend.add_line(beside_label, kOrange, 1.8F, false);
  legend.add_area(label, kBlue);
}

}  // namespace isotouch::view
