#include "host/view/surface_picture.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "host/view/caption.h"
#include "host/view/field_ray.h"
#include "host/view/scene.h"
#include "host/view/text.h"

namespace isotouch::view {
namespace {

constexpr double kFar = 1e5;

/// The direction from which the proxy is seen, best with the surface under it turned 55 degrees from the eye, and near the default one.
Direction direction_showing(const Touch& touch, const FieldRays& rays, char up) {
  const Eigen::Vector3d out = (touch.proxy - touch.hip).normalized();
  const Direction standard{.up = up};
  Direction best = standard;
  double best_cost = 1e9;
  for (const double elevation : {20.0, 40.0, 0.0, -20.0}) {
    for (int turn = 0; turn < 24; ++turn) {
      const Direction candidate{-165.0 + 15.0 * turn, elevation, up};
      const Eigen::Vector3d eye = candidate.towards_eye();
      const double angle = std::acos(std::clamp(eye.dot(out), -1.0, 1.0)) * 57.3;
      const double walk = std::acos(std::clamp(eye.dot(standard.towards_eye()), -1.0, 1.0)) * 57.3;
      const bool hidden = rays.hit({touch.proxy + 2 * rays.edge() * out, eye}, 0, kFar).has_value();
      const double cost = std::fabs(angle - 55) + 0.5 * walk + (hidden ? 1000 : 0);
      if (cost < best_cost) {
        best_cost = cost;
        best = candidate;
      }
    }
  }
  return best;
}

/// The close-up of a touch, cut open through proxy and HIP, and what it says.
void draw_close_up(Image& image, const Rect& panel, const FieldRays& rays, const Touch& touch, const Camera& camera) {
  Canvas canvas(image);
  const float scale = drawing_scale(image);
  const double half = std::max(touch.depth_mm(), 6 * rays.edge());
  const Eigen::Vector3d out = (touch.proxy - touch.hip).normalized();
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
  const double ball = std::clamp(touch.depth_mm() / 5, 0.05 * half, 0.12 * half);
  draw_scene(image, panel, {rays, close, Markers(touch, ball), CutPlane{centre, eye}});
  canvas.frame(panel, 1.2F * scale, srgb(0xAEB8C2));
  draw_scale_bar(canvas, {panel.right - 12 * scale, panel.bottom - 14 * scale}, close.project(centre).pixel_per_mm,
                 static_cast<double>(panel.width()) / 4);

  struct Line {
    std::optional<std::uint32_t> dot;
    std::string text;
  };
  const std::vector<Line> lines = {
      {kProxyColour, "proxy, held by the surface"},
      {kHipColour, "HIP, the hand"},
      {std::nullopt, "penetration " + number(touch.depth_mm(), 3) + " mm, " + number(touch.depth_mm() / rays.edge(), 2) + " voxels"},
      {std::nullopt, "force " + number(touch.force_n, 3) + " N"},
      {std::nullopt, "tick " + std::to_string(touch.tick) + ", " + number(touch.time_s, 3) + " s"},
      {std::nullopt, "cut open here; lines one voxel apart"}};
  float y = panel.bottom + 26 * scale;
  for (const Line& line : lines) {
    float x = panel.left + 2 * scale;
    if (line.dot) {
      canvas.disc({x + 5 * scale, y - 4 * scale}, 5 * scale, srgb(*line.dot));
      x += 18 * scale;
    }
    draw_text(canvas, {x, y}, line.text, {.capital = 8.5F * scale, .colour = kInk});
    y += 20 * scale;
  }
}

}  // namespace

Image surface_picture(const FieldView& field, const SurfaceOptions& options) {
  Image image(options.width, options.height);
  Canvas canvas(image);
  const float scale = drawing_scale(image);
  const FieldRays rays(field);
  const Direction direction = options.direction ? *options.direction
                              : options.touch   ? direction_showing(*options.touch, rays, options.up)
                                                : Direction{.up = options.up};

  const auto width = static_cast<float>(options.width), height = static_cast<float>(options.height);
  const float column = options.touch ? 280 * scale : 0;
  std::vector<Eigen::Vector3d> shown = rays.outline();
  if (options.touch) shown.push_back(options.touch->hip);
  const Camera camera(direction.towards_eye(), direction.up_axis(), shown,
                      {20 * scale, 20 * scale, width - column - 20 * scale, height - 64 * scale});
  std::optional<Markers> markers;
  if (options.touch) {
    const double pixel_per_mm = camera.project(options.touch->proxy).pixel_per_mm;
    const double ball = std::clamp(0.3 * options.touch->depth_mm() * pixel_per_mm, 4.0 * static_cast<double>(scale),
                                   8.0 * static_cast<double>(scale));  // pixels
    markers.emplace(*options.touch, ball / pixel_per_mm);
  }
  draw_scene(image, {0, 0, width, height}, {rays, camera, markers, std::nullopt});

  const auto& size = field.size;
  draw_caption(canvas, options.title,
               {"zero surface as the core samples it, " + std::to_string(size[0]) + " × " + std::to_string(size[1]) + " × " +
                std::to_string(size[2]) + " samples, " + number(rays.edge(), 3) + " mm a voxel"});
  const Eigen::Vector3d middle = std::accumulate(shown.begin(), shown.end(), Eigen::Vector3d(0, 0, 0)) / static_cast<double>(shown.size());
  draw_scale_bar(canvas, {width - column - 24 * scale, height - 26 * scale}, camera.project(middle).pixel_per_mm,
                 static_cast<double>(width) / 8);
  if (options.touch) {
    const float side = column - 24 * scale;
    draw_close_up(image,
                  {std::floor(width - column), std::floor(24 * scale), std::floor(width - column + side), std::floor(24 * scale + side)},
                  rays, *options.touch, camera);
  }
  return image;
}

}  // namespace isotouch::view
