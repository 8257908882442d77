#include "host/view/caption.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "host/view/text.h"

namespace isotouch::view {

float drawing_scale(const Picture& picture) {
  return std::max(0.5F, std::min(static_cast<float>(picture.width()) / 960, static_cast<float>(picture.height()) / 720));
}

std::string number(double value, int decimals) {
  char digits[64];
  std::snprintf(digits, sizeof digits, "%.*f", decimals, value);
  std::string text = digits;
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  if (text == "-0") return "0";
  return text.front() == '-' ? std::string("−").append(text, 1) : text;
}

std::string significant(double value, int digits) {
  const double size = std::fabs(value);
  const int before_point = size > 0 ? static_cast<int>(std::floor(std::log10(size))) + 1 : 1;
  return number(value, std::clamp(digits - before_point, 0, 12));
}

double round_length(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  for (const double step : {5.0, 2.0}) {
    if (step * power <= value * (1 + 1e-9)) return step * power;
  }
  return power;
}

void draw_caption(Canvas& canvas, const std::string& title, const std::vector<std::string>& lines) {
  const float scale = drawing_scale(canvas.picture());
  float y = static_cast<float>(canvas.picture().height()) - 22 * scale;
  for (auto line = lines.rbegin(); line != lines.rend(); ++line) {
    draw_text(canvas, {24 * scale, y}, *line, {.capital = 8.5F * scale, .colour = kPaleInk});
    y -= 19 * scale;
  }
  draw_text(canvas, {24 * scale, y - 2 * scale}, title, {.capital = 12 * scale, .colour = kInk, .bold = true});
}

void draw_scale_bar(Canvas& canvas, Point end, double pixel_per_mm, double longest_pixels) {
  const float scale = drawing_scale(canvas.picture());
  const double length = round_length(longest_pixels / pixel_per_mm);
  const Point begin{end.x - static_cast<float>(length * pixel_per_mm), end.y};
  const float tick = 4 * scale;
  const std::vector<Polyline> bar = {
      {{begin.x, begin.y - tick}, {begin.x, begin.y + tick}}, {begin, end}, {{end.x, end.y - tick}, {end.x, end.y + tick}}};
  canvas.stroke(bar, 1.5F * scale, kInk);
  draw_text(canvas, {(begin.x + end.x) / 2, end.y - 8 * scale}, number(length, 4) + " mm",
            {.capital = 8.5F * scale, .colour = kInk, .along = Anchor::kMiddle});
}

}  // namespace isotouch::view
