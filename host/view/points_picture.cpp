#include "host/view/points_picture.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "host/view/caption.h"
#include "host/view/light.h"
#include "host/view/palette.h"
#include "host/view/text.h"

namespace isotouch::view {
namespace {

constexpr int kFine = 2;  // fine pixels along a pixel's side

/// Discs with a depth buffer, in fine pixels.
class Discs {
 public:
  Discs(int width, int height, const Camera& camera)
      : camera_(camera), light_(camera), colours_(width * kFine, height * kFine), depths_(count(colours_), kEmpty) {}

  void draw(const Eigen::Vector3d& centre, const Eigen::Vector3d& normal, double radius) {
    const Camera::Projected middle = camera_.project(centre);
    const Eigen::Vector3d to_eye = (camera_.eye() - centre).normalized();
    const bool behind = normal.dot(to_eye) < 0;
    const Eigen::Vector3d seen = behind ? Eigen::Vector3d(-normal) : normal;
    const Colour lit = light_.shade(behind ? kBehind : kFront, seen, to_eye);
    const Colour colour = behind ? mix(lit, backdrop(0.5F), 0.72F) : lit;
    const double reach = radius * middle.pixel_per_mm;
    const auto fine = [](double pixels) { return static_cast<int>(std::floor(pixels * kFine)); };
    const int x1 = std::min(fine(middle.x + reach) + 1, colours_.width()), y1 = std::min(fine(middle.y + reach) + 1, colours_.height());
    for (int y = std::max(0, fine(middle.y - reach)); y < y1; ++y) {
      for (int x = std::max(0, fine(middle.x - reach)); x < x1; ++x) {
        const Ray ray = camera_.ray((x + 0.5) / kFine, (y + 0.5) / kFine);
        const double slope = ray.direction.dot(normal);
        if (std::fabs(slope) < 1e-6) continue;
        const double t = (centre - ray.from).dot(normal) / slope;
        const double off = (ray.at(t) - centre).norm() / radius;
        double& depth = depths_[static_cast<std::size_t>(y) * static_cast<std::size_t>(colours_.width()) + static_cast<std::size_t>(x)];
        if (off > 1 || t >= depth) continue;
        depth = t;
        colours_.at(x, y) = colour * (off > 0.82 ? 0.72F : 1.0F);  // a darker rim tells neighbours apart
      }
    }
  }

  /// Averages the fine pixels, over the backdrop where no disc is.
  Image image() const {
    Image image(colours_.width() / kFine, colours_.height() / kFine);
    for (int y = 0; y < image.height(); ++y) {
      const Colour behind = backdrop(static_cast<float>(y) / static_cast<float>(image.height()));
      for (int x = 0; x < image.width(); ++x) {
        Colour sum{0, 0, 0};
        for (int part = 0; part < kFine * kFine; ++part) {
          const int fx = x * kFine + part % kFine, fy = y * kFine + part / kFine;
          const double depth =
              depths_[static_cast<std::size_t>(fy) * static_cast<std::size_t>(colours_.width()) + static_cast<std::size_t>(fx)];
          sum = sum + (depth < kEmpty ? colours_.at(fx, fy) : behind);
        }
        image.at(x, y) = sum * (1.0F / (kFine * kFine));
      }
    }
    return image;
  }

  /// Is nothing before this place? `slack` nearer counts as there.
  bool is_seen(const Eigen::Vector3d& place, double slack) const {
    const Camera::Projected at = camera_.project(place);
    const int x = static_cast<int>(at.x * kFine), y = static_cast<int>(at.y * kFine);
    if (x < 0 || y < 0 || x >= colours_.width() || y >= colours_.height()) return false;
    const double depth = depths_[static_cast<std::size_t>(y) * static_cast<std::size_t>(colours_.width()) + static_cast<std::size_t>(x)];
    return (place - camera_.eye()).norm() < depth + slack;
  }

 private:
  static constexpr double kEmpty = std::numeric_limits<double>::max();
  static std::size_t count(const Image& image) {
    return static_cast<std::size_t>(image.width()) * static_cast<std::size_t>(image.height());
  }
  inline static const Colour kFront = srgb(0x84B4E6);
  inline static const Colour kBehind = srgb(0xB9A58F);

  const Camera& camera_;
  Light light_;
  Image colours_;
  std::vector<double> depths_;  // mm along the ray
};

/// The open rim over the discs, and what the line means.
void draw_rim(Canvas& canvas, const Camera& camera, const Discs& discs, const PointsOptions& options, Point legend) {
  const float scale = drawing_scale(canvas.picture());
  std::vector<Polyline> seen, hidden;
  constexpr int kPieces = 4;
  for (const auto& link : options.rim) {
    for (int piece = 0; piece < kPieces; ++piece) {
      const auto at = [&](double t) { return Eigen::Vector3d(link[0] + t / kPieces * (link[1] - link[0])); };
      const Camera::Projected from = camera.project(at(piece)), to = camera.project(at(piece + 1));
      const Polyline line = {{static_cast<float>(from.x), static_cast<float>(from.y)},
                             {static_cast<float>(to.x), static_cast<float>(to.y)}};
      (discs.is_seen(at(piece + 0.5), 2 * options.spacing) ? seen : hidden).push_back(line);
    }
  }
  canvas.stroke(hidden, 2 * scale, kRimColour, 0.35F);
  canvas.stroke(seen, 3 * scale, kRimColour);
  canvas.line({legend.x, legend.y - 4 * scale}, {legend.x + 26 * scale, legend.y - 4 * scale}, 3 * scale, kRimColour);
  const bool known = options.mm_per_unit > 0;
  std::string text = "open rim: the scan ends here; about ";
  text += known ? number(options.rim_length * options.mm_per_unit, 0) + " mm long" : significant(options.rim_length, 2) + " long";
  draw_text(canvas, {legend.x + 36 * scale, legend.y}, text, {.capital = 8.5F * scale, .colour = kInk});
}

}  // namespace

Picture points_picture(const cloud::OrientedPoints& points, const PointsOptions& options) {
  Picture picture(options.width, options.height);
  Canvas canvas(picture);
  const float scale = drawing_scale(picture);
  const auto width = static_cast<float>(options.width), height = static_cast<float>(options.height);
  const Camera camera(options.direction.towards_eye(), options.direction.up_axis(), points.positions,
                      {20 * scale, 20 * scale, width - 20 * scale, height - (options.rim.empty() ? 64 : 86) * scale});
  const double pixel = 1 / camera.project(points.positions.front()).pixel_per_mm;
  const double radius = std::max(0.5 * options.spacing, 0.8 * pixel);  // below a pixel and a half a disc would flicker
  Discs discs(options.width, options.height, camera);
  for (std::size_t i = 0; i < points.size(); ++i) discs.draw(points.positions[i], points.normals[i], radius);
  canvas.paint(discs.image());
  if (!options.rim.empty()) draw_rim(canvas, camera, discs, options, {24 * scale, height - 70 * scale});

  const bool known = options.mm_per_unit > 0;
  const std::string distance = known ? number(options.spacing * options.mm_per_unit, 3) + " mm" : significant(options.spacing, 3);
  if (known) {
    draw_scale_bar(canvas, {width - 24 * scale, height - 26 * scale},
                   camera.project(points.positions.front()).pixel_per_mm / options.mm_per_unit, static_cast<double>(width) / 8);
  }
  draw_caption(canvas, options.title,
               {std::to_string(points.size()) + " oriented points, " + distance + " apart" + (known ? "" : " in the units of their file")});
  return picture;
}

}  // namespace isotouch::view
