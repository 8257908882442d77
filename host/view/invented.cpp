#include "host/view/invented.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "host/view/caption.h"
#include "host/view/palette.h"
#include "host/view/text.h"

namespace isotouch::view {

Invented::Invented(const FieldView& field, const field_file::Marks& marks) : field_(field), share_(field_file::share_of(marks, field)) {
  if (!any()) return;
  bricks_.assign(field.brick_count, -1);
  for (std::uint32_t brick = 2; brick < field.brick_count; ++brick) {
    if (field_file::is_crossed(field, brick)) bricks_[brick] = marks.has(brick) ? 1 : 0;
  }
}

bool Invented::at(const Eigen::Vector3d& point) const {
  if (!any()) return false;
  constexpr int kSide = 1 << image_layout::kBrickShift;
  constexpr double kMiddle = 0.5 * (kSide - 1);
  const Eigen::Vector3d cell = (point.array() - kMiddle) / kSide;
  const Eigen::Vector3d low = cell.array().floor();
  const Eigen::Vector3d t = cell - low;
  double invented = 0, weights = 0;
  for (int n = 0; n < 8; ++n) {
    const std::array<int, 3> step = {n & 1, n >> 1 & 1, n >> 2};
    std::array<std::int32_t, 3> sample{};
    double weight = 1;
    for (std::size_t a = 0; a < 3; ++a) {
      const auto axis = static_cast<Eigen::Index>(a);
      weight *= step[a] != 0 ? t[axis] : 1 - t[axis];
      sample[a] = std::clamp(kSide * (static_cast<int>(low[axis]) + step[a]), 0, field_.size[a] - 1);
    }
    const std::int8_t kind = bricks_[field_.brick_number(sample[0], sample[1], sample[2])];
    if (kind < 0) continue;
    weights += weight;
    invented += weight * kind;
  }
  return invented > 0.5 * weights;
}

float hatch(double x, double y, float scale) {
  constexpr double kPeriod = 9, kWidth = 3;  // pixels across the lines, on a picture of 960 x 720
  const double across = (x + y) / (std::sqrt(2.0) * static_cast<double>(scale));
  const double off = std::fabs(across - kPeriod * std::round(across / kPeriod));
  return static_cast<float>(std::clamp(kWidth / 2 - off + 0.5, 0.0, 1.0));
}

void draw_invented_legend(Canvas& canvas, Point at, double share) {
  const float scale = drawing_scale(canvas.picture());
  const Rect box{std::round(at.x), std::round(at.y - 10 * scale), std::round(at.x + 26 * scale), std::round(at.y + 2 * scale)};
  Image lines(static_cast<int>(box.width()), static_cast<int>(box.height()));
  for (int y = 0; y < lines.height(); ++y) {
    for (int x = 0; x < lines.width(); ++x) lines.at(x, y) = mix(kPlainSurface, kInventedColour, hatch(x, y, scale));
  }
  canvas.paint(lines, static_cast<int>(box.left), static_cast<int>(box.top));
  canvas.frame(box, scale, kPaleInk);
  std::string text = "invented: nobody scanned this, ";
  text += number(100 * share, share < 0.1 ? 1 : 0) + " % of the surface";
  draw_text(canvas, {box.right + 10 * scale, at.y}, text, {.capital = 8.5F * scale, .colour = kInk});
}

}  // namespace isotouch::view
