#include "host/view/plot.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "host/view/caption.h"
#include "host/view/legend.h"
#include "host/view/text.h"

namespace isotouch::view {
namespace {

const Colour kBand = srgb(0xE9F0E4);

std::pair<double, double> extent(const std::vector<Series>& all, std::vector<double> Series::*values) {
  double low = 1e300, high = -1e300;
  for (const Series& series : all) {
    for (const double v : series.*values) {
      if (!std::isfinite(v)) continue;
      low = std::min(low, v);
      high = std::max(high, v);
    }
  }
  if (low > high) return {0, 1};
  if (low == high) return {low - 0.5, high + 0.5};
  return {low, high};
}

/// The line in pixels. Where many values share a column of pixels, their extremes stand for them, so that no peak is lost.
std::vector<Polyline> pixel_lines(const Series& series, const Axes& axes) {
  std::vector<Polyline> lines;
  const auto add = [&](Point p) {
    if (lines.empty()) lines.emplace_back();
    lines.back().push_back(p);
  };
  const std::size_t count = std::min(series.x.size(), series.y.size());
  for (std::size_t i = 0; i < count;) {
    if (!std::isfinite(series.y[i])) {
      if (!lines.empty() && !lines.back().empty()) lines.emplace_back();
      ++i;
      continue;
    }
    const Point first = axes.at(series.x[i], series.y[i]);
    Point low = first, high = first, last = first;
    for (++i; i < count && std::isfinite(series.y[i]); ++i) {
      const Point p = axes.at(series.x[i], series.y[i]);
      if (std::floor(p.x) != std::floor(first.x)) break;
      if (p.y < low.y) low = p;
      if (p.y > high.y) high = p;
      last = p;
    }
    add(first);
    if (low.x > high.x) std::swap(low, high);
    if (low.x > first.x) add(low);
    if (high.x > low.x) add(high);
    if (last.x > high.x) add(last);
  }
  return lines;
}

void draw_legend(Canvas& canvas, const Plot& plot, const Rect& area) {
  Legend legend(canvas, area);
  legend.add_area(plot.band_label, kBand);
  for (auto series = plot.series.rbegin(); series != plot.series.rend(); ++series)
    legend.add_line(series->label, series->colour, std::max(series->width, 1.8F), series->broken);
}

}  // namespace

Axes Plot::axes(const Rect& place, float scale) const {
  const auto [first, last] = extent(series, &Series::x);
  auto [low, high] = extent(series, &Series::y);
  if (y_range) {
    std::tie(low, high) = *y_range;
  } else {
    if (low > 0 && low < 0.5 * high) low = 0;
    const double air = 0.06 * (high - low);
    if (low != 0) low -= air;
    high += air;
  }
  return Axes(frame_in(place, scale), {x_label, first, last}, {y_label, low, high});
}

void Plot::draw(Canvas& canvas, const Rect& place) const {
  const float scale = drawing_scale(canvas.picture());
  const Axes frame = axes(place, scale);
  const Rect& area = frame.area();
  canvas.fill(area, srgb(0xFFFFFF));
  Canvas inside = canvas.within(area);
  for (const auto& [from, to] : bands) inside.fill({frame.at(from, 0).x, area.top, frame.at(to, 0).x, area.bottom}, kBand);
  frame.draw_grid(canvas);
  for (const Series& line : series) {
    std::vector<Polyline> lines = pixel_lines(line, frame);
    if (line.broken) {
      std::vector<Polyline> pieces;
      for (const Polyline& whole : lines) {
        const std::vector<Polyline> cut = dashed(whole, 7 * scale, 5 * scale);
        pieces.insert(pieces.end(), cut.begin(), cut.end());
      }
      lines = std::move(pieces);
    }
    inside.stroke(lines, line.width * scale, line.colour);
  }
  frame.draw_frame(canvas);
  draw_text(canvas, {area.left, area.top - 12 * scale}, title, {.capital = 10 * scale, .colour = kInk, .bold = true});
  draw_legend(canvas, *this, area);
}

}  // namespace isotouch::view
