#include "host/view/surface_picture.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "host/view/caption.h"
#include "host/view/field_ray.h"
#include "host/view/invented.h"
#include "host/view/scene.h"
#include "host/view/text.h"
#include "host/view/touch_view.h"

namespace isotouch::view {
namespace {

const Colour kFrame = srgb(0xAEB8C2);
const Colour kLens = srgb(0x4A5562);

/// Half the side of what the close-up shows, mm.
double close_up_half(const Touch& touch, const FieldRays& rays) { return std::max(1.2 * touch.depth_mm(), 6 * rays.edge()); }

/// The close-up of a touch, cut open through proxy and HIP, and what it says.
void draw_close_up(Canvas& canvas, const Rect& panel, const FieldRays& rays, const Invented& invented, const Touch& touch,
                   const Camera& camera) {
  const float scale = drawing_scale(canvas.picture());
  const double half = close_up_half(touch, rays);
  const Eigen::Vector3d out = touch.out();
  Eigen::Vector3d eye = camera.back() - camera.back().dot(out) * out;  // across the line of penetration, from the viewer's side
  if (eye.norm() < 1e-3) eye = camera.right();
  eye.normalize();
  const Eigen::Vector3d centre = (touch.proxy + touch.hip) / 2;
  std::vector<Eigen::Vector3d> shown;
  for (const double side : {-half, half}) {
    shown.emplace_back(centre + side * camera.right());
    shown.emplace_back(centre + side * camera.up());
  }
  const Camera close((eye + 0.25 * out).normalized(), camera.up(), shown, panel);
  const double ball = std::clamp(touch.depth_mm() / 5, 0.05 * half, 0.10 * half);
  const Scene scene{rays, close, Markers(touch, ball, 0.55 * half), CutPlane{centre, eye}, &invented};
  canvas.paint(scene_image(panel, scene, scale), static_cast<int>(panel.left), static_cast<int>(panel.top));
  canvas.frame(panel, 1.2F * scale, kFrame);
  draw_scale_bar(canvas, {panel.right - 12 * scale, panel.bottom - 14 * scale}, close.project(centre).pixel_per_mm,
                 static_cast<double>(panel.width()) / 4);

  enum class Sign { kNone, kProxy, kHip, kForce };
  struct Line {
    Sign sign;
    std::string text;
  };
  const std::vector<Line> lines = {
      {Sign::kProxy, "proxy, held by the surface"},
      {Sign::kHip, "HIP, the hand"},
      {Sign::kForce, "force on the hand, " + number(touch.force.norm(), 2) + " N"},
      {Sign::kNone, "penetration " + number(touch.depth_mm(), 2) + " mm, " + number(touch.depth_mm() / rays.edge(), 1) + " voxels"},
      {Sign::kNone, "tick " + std::to_string(touch.tick) + ", " + number(touch.time_s, 3) + " s"},
      {Sign::kNone, "cut open here; lines one voxel apart"}};
  float y = panel.bottom + 26 * scale;
  for (const Line& line : lines) {
    float x = panel.left + 2 * scale;
    const Point middle{x + 9 * scale, y - 4 * scale};
    if (line.sign == Sign::kProxy) draw_proxy(canvas, middle, 5.5F * scale);
    if (line.sign == Sign::kHip) draw_hip(canvas, middle, 5.5F * scale);
    if (line.sign == Sign::kForce) draw_force(canvas, middle - Point{9 * scale, 0}, middle + Point{9 * scale, 0}, 2 * scale);
    if (line.sign != Sign::kNone) x += 26 * scale;
    draw_text(canvas, {x, y}, line.text, {.capital = 8.5F * scale, .colour = kInk});
    y += 20 * scale;
  }
}

/// What the close-up shows, framed where it is, and lines from there to the panel.
void draw_lens(Canvas& canvas, const Rect& panel, const FieldRays& rays, const Touch& touch, const Camera& camera) {
  const float scale = drawing_scale(canvas.picture());
  const Camera::Projected seen = camera.project((touch.proxy + touch.hip) / 2);
  const float half = std::max(static_cast<float>(close_up_half(touch, rays) * seen.pixel_per_mm), 9 * scale);
  const Point at{static_cast<float>(seen.x), static_cast<float>(seen.y)};
  canvas.frame({at.x - half, at.y - half, at.x + half, at.y + half}, 1.5F * scale, kLens);
  const std::vector<Polyline> rays_to_panel = {{{at.x + half, at.y - half}, {panel.left, panel.top}},
                                               {{at.x + half, at.y + half}, {panel.left, panel.bottom}}};
  canvas.stroke(rays_to_panel, scale, kLens, 0.45F);
}

}  // namespace

Picture surface_picture(const FieldView& field, const SurfaceOptions& options) {
  Picture picture(options.width, options.height);
  Canvas canvas(picture);
  const float scale = drawing_scale(picture);
  const FieldRays rays(field);
  const Invented invented(field, options.invented);
  const Direction direction = options.direction ? *options.direction
                              : options.touch   ? direction_showing(*options.touch, rays, options.up)
                                                : Direction{.up = options.up};

  const auto width = static_cast<float>(options.width), height = static_cast<float>(options.height);
  const float column = options.touch ? 280 * scale : 0;
  std::vector<Eigen::Vector3d> shown = rays.outline();
  if (options.touch) shown.push_back(options.touch->hip);
  const Camera camera(direction.towards_eye(), direction.up_axis(), shown,
                      {20 * scale, 20 * scale, width - column - 20 * scale, height - (invented.any() ? 86 : 64) * scale});
  std::optional<Markers> markers;
  if (options.touch) {
    const double pixel_per_mm = camera.project(options.touch->proxy).pixel_per_mm;
    const double ball = std::clamp(0.3 * options.touch->depth_mm() * pixel_per_mm, 4.5 * std::max(static_cast<double>(scale), 1.0),
                                   8.0 * std::max(static_cast<double>(scale), 1.0));  // pixels
    markers.emplace(*options.touch, ball / pixel_per_mm, 6 * ball / pixel_per_mm);
  }
  canvas.paint(scene_image({0, 0, width, height}, {rays, camera, markers, std::nullopt, &invented}, scale));

  const auto& size = field.size;
  draw_caption(canvas, options.title,
               {"zero surface as the core samples it, " + std::to_string(size[0]) + " × " + std::to_string(size[1]) + " × " +
                std::to_string(size[2]) + " samples, " + number(rays.edge(), 3) + " mm a voxel"});
  if (invented.any()) draw_invented_legend(canvas, {24 * scale, height - 70 * scale}, invented.share());
  const Eigen::Vector3d middle = std::accumulate(shown.begin(), shown.end(), Eigen::Vector3d(0, 0, 0)) / static_cast<double>(shown.size());
  draw_scale_bar(canvas, {width - column - 24 * scale, height - 26 * scale}, camera.project(middle).pixel_per_mm,
                 static_cast<double>(width) / 8);
  if (options.touch) {
    const float side = column - 24 * scale;
    const Rect panel{std::floor(width - column), std::floor(24 * scale), std::floor(width - column + side), std::floor(24 * scale + side)};
    draw_lens(canvas, panel, rays, *options.touch, camera);
    draw_close_up(canvas, panel, rays, invented, *options.touch, camera);
  }
  return picture;
}

}  // namespace isotouch::view
