#include "host/view/slice_picture.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "host/view/axes.h"
#include "host/view/caption.h"
#include "host/view/colour_map.h"
#include "host/view/field_ray.h"
#include "host/view/palette.h"
#include "host/view/rows.h"
#include "host/view/text.h"

namespace isotouch::view {
namespace {

const Colour kFarOutside = srgb(0xEEF1F4);
const Colour kFarInside = srgb(0xF3E3CE);
const Colour kSurface = srgb(0x101418);

/// Which coordinates run along the slice.
struct Plane {
  int across, right, up;

  explicit Plane(char axis) : across(axis == 'x' ? 0 : axis == 'y' ? 1 : 2), right(axis == 'x' ? 2 : 0), up(axis == 'y' ? 2 : 1) {}
  static const char* name(int coordinate) { return coordinate == 0 ? "x" : coordinate == 1 ? "y" : "z"; }
};

/// The colour of a pixel.
///
/// slope_in_slice   length of the gradient's part in the slice, voxels a voxel
/// voxel            pixels a voxel
/// lined_outside    are there lines outside the object? A published field is one whole level there, which would be a line everywhere
Colour pixel_colour(double distance, double slope_in_slice, double band, double voxel, bool lined_outside) {
  if (slope_in_slice < 1e-3 && std::fabs(distance) > band - 0.01) return distance > 0 ? kFarOutside : kFarInside;
  const double slope = std::max(slope_in_slice, 0.05) / voxel;  // voxels a pixel
  const Colour base = distance_colour(distance / band);
  const auto line = [&](double level, double half_width) {
    return static_cast<float>(std::clamp(half_width + 0.5 - std::fabs(distance - level) / slope, 0.0, 1.0));
  };
  const double nearest = std::round(distance);
  const bool lined = nearest < 0 || (nearest > 0 && lined_outside);
  const float thin = voxel >= 2 && lined && std::fabs(nearest) < band - 0.5 ? 0.5F * line(nearest, 0.5) : 0.0F;
  return mix(mix(base, kSurface, thin), kSurface, line(0, 1.0));
}

/// Where a plane across the axis meets most of the object; of equal places the middle one.
double widest_place(const std::vector<Eigen::Vector3d>& outline, int axis, double brick_mm) {
  std::map<long, std::size_t> layers;
  for (const Eigen::Vector3d& p : outline) ++layers[std::lround(p[axis] / brick_mm)];
  std::vector<long> best;
  std::size_t most = 0;
  for (const auto& [layer, bricks] : layers) {
    if (bricks > most) best.clear();
    most = std::max(most, bricks);
    if (bricks == most) best.push_back(layer);
  }
  return static_cast<double>(best[best.size() / 2]) * brick_mm;
}

void draw_colour_bar(Canvas& canvas, const Rect& bar, double band, double edge_mm) {
  const float scale = drawing_scale(canvas.picture());
  const float cap = 20 * scale, gap = 14 * scale;  // what is far outside and far inside, apart from the ramp
  const TextStyle label{.capital = 8.5F * scale, .colour = kInk, .across = Anchor::kMiddle};
  const Rect outside{bar.left, bar.top, bar.right, bar.top + cap}, inside{bar.left, bar.bottom - cap, bar.right, bar.bottom};
  canvas.fill(outside, kFarOutside);
  canvas.fill(inside, kFarInside);
  draw_text(canvas, {bar.right + 10 * scale, bar.top + cap / 2}, "far outside", label);
  draw_text(canvas, {bar.right + 10 * scale, bar.bottom - cap / 2}, "far inside", label);
  const Rect ramp{bar.left, bar.top + cap + gap, bar.right, bar.bottom - cap - gap};
  for (float y = ramp.top; y < ramp.bottom; ++y) {
    const double value = 1 - 2 * static_cast<double>((y + 0.5F - ramp.top) / ramp.height());
    canvas.fill({ramp.left, y, ramp.right, ramp.bottom}, distance_colour(value));  // down to the end: no row shows what is under it
  }
  for (const double voxels : ticks(-band, band, 11)) {
    const float y = ramp.bottom - static_cast<float>((voxels / band + 1) / 2) * ramp.height();
    canvas.line({ramp.left, y}, {ramp.right, y}, (voxels == 0 ? 2 : 1) * scale, kSurface, voxels == 0 ? 1.0F : 0.35F);
    TextStyle end = label;
    end.along = Anchor::kEnd;
    draw_text(canvas, {bar.right + 26 * scale, y}, number(voxels, 1), end);
    end.colour = kPaleInk;
    draw_text(canvas, {bar.right + 90 * scale, y}, number(voxels * edge_mm, 2), end);
  }
  for (const Rect& part : {outside, ramp, inside}) canvas.frame(part, 1.2F * scale, kPaleInk);
  TextStyle head{.capital = 8.5F * scale, .colour = kInk, .along = Anchor::kEnd};
  draw_text(canvas, {bar.right + 26 * scale, bar.top - 12 * scale}, "voxels", head);
  head.colour = kPaleInk;
  draw_text(canvas, {bar.right + 90 * scale, bar.top - 12 * scale}, "mm", head);
}

/// z where that shows most of the touch, else the axis along which the least of it lies.
char axis_across(const Touch& touch) {
  if (std::fabs(touch.out().z()) < 0.5) return 'z';
  Eigen::Index axis = 0;
  touch.out().cwiseAbs().minCoeff(&axis);
  return static_cast<char>('x' + axis);
}

/// The touch as it is seen along the slice's axis, and what its signs mean.
void draw_touch(Canvas canvas, const Touch& touch, const Plane& plane, const Axes& axes) {
  const float scale = drawing_scale(canvas.picture());
  const auto pixel = [&](const Eigen::Vector3d& p) { return axes.at(p[plane.right], p[plane.up]); };
  const Point proxy = pixel(touch.proxy), hip = pixel(touch.hip);
  Canvas inside = canvas.within(axes.area());
  inside.line(proxy, hip, 4.5F * scale, srgb(0xFFFFFF), 0.8F);
  inside.line(proxy, hip, 2.5F * scale, kHipColour);
  const Point force{static_cast<float>(touch.force[plane.right]), -static_cast<float>(touch.force[plane.up])};
  if (touch.force.norm() > 0)
    draw_force(inside, proxy, proxy + force * (45 * scale / static_cast<float>(touch.force.norm())), 2.2F * scale);
  draw_hip(inside, hip, 5.5F * scale);
  draw_proxy(inside, proxy, 5.5F * scale);

  const TextStyle style{.capital = 8.5F * scale, .colour = kInk};
  float x = axes.area().left + 14 * scale;
  const float y = axes.area().top + 24 * scale;
  canvas.fill({x - 14 * scale, axes.area().top, x + 300 * scale, y + 12 * scale}, srgb(0xFFFFFF), 0.8F);
  const auto name = [&](const std::string& text) {
    draw_text(canvas, {x + 14 * scale, y}, text, style);
    x += 14 * scale + text_width(text, style) + 26 * scale;
  };
  draw_proxy(canvas, {x, y - 4 * scale}, 5.5F * scale);
  name("proxy");
  draw_hip(canvas, {x, y - 4 * scale}, 5.5F * scale);
  name("HIP, the hand");
  draw_force(canvas, {x - 8 * scale, y - 4 * scale}, {x + 8 * scale, y - 4 * scale}, 2 * scale);
  name("force, " + number(touch.force.norm(), 2) + " N");
}

}  // namespace

Picture slice_picture(const FieldView& field, const SliceOptions& options) {
  Picture picture(options.width, options.height);
  Canvas canvas(picture);
  const float scale = drawing_scale(picture);
  const FieldRays rays(field);
  const Plane plane(options.axis ? *options.axis : options.touch ? axis_across(*options.touch) : 'z');
  const double band = static_cast<double>(field.band.raw()) / (1 << Distance::kFractionBits);

  const double at = options.at_mm   ? *options.at_mm
                    : options.touch ? options.touch->proxy[plane.across]
                                    : widest_place(rays.outline(), plane.across, 4 * rays.edge());

  // The object with its band and a little air, in the shape of the room for it.
  Box box;
  for (const Eigen::Vector3d& p : rays.outline()) box.extend(p);
  const double air = (band + 5) * rays.edge();
  const Rect room{78 * scale, 24 * scale, static_cast<float>(options.width) - 178 * scale,
                  static_cast<float>(options.height) - 112 * scale};
  const double width = box.sizes()[plane.right] + 2 * air, height = box.sizes()[plane.up] + 2 * air;
  const double mm = std::max(width / static_cast<double>(room.width()), height / static_cast<double>(room.height()));  // a pixel
  const double half_x = mm * static_cast<double>(room.width()) / 2, half_y = mm * static_cast<double>(room.height()) / 2;
  const double mid_x = box.center()[plane.right], mid_y = box.center()[plane.up];
  const Axes axes(room, {std::string(Plane::name(plane.right)) + " (mm)", mid_x - half_x, mid_x + half_x},
                  {std::string(Plane::name(plane.up)) + " (mm)", mid_y - half_y, mid_y + half_y});

  const int left = static_cast<int>(std::ceil(room.left)), top = static_cast<int>(std::ceil(room.top));
  Image image(static_cast<int>(room.right) - left, static_cast<int>(room.bottom) - top);
  for_each_row(image.height(), [&](int row) {
    for (int column = 0; column < image.width(); ++column) {
      Eigen::Vector3d point;
      point[plane.across] = at;
      point[plane.right] = axes.x_of(left + column + 0.5);
      point[plane.up] = axes.y_of(top + row + 0.5);
      const FieldRays::Value value = rays.value(point);
      const double slope = std::hypot(value.gradient[plane.right], value.gradient[plane.up]);
      image.at(column, row) = value.outside_grid
                                  ? kFarOutside
                                  : pixel_colour(value.distance, slope, band, rays.edge() / mm, field.method != Method::kPublished);
    }
  });
  canvas.paint(image, left, top);
  if (options.touch) draw_touch(canvas, *options.touch, plane, axes);
  axes.draw_frame(canvas);
  draw_colour_bar(canvas, {room.right + 24 * scale, room.top + 22 * scale, room.right + 52 * scale, room.bottom}, band, rays.edge());
  std::string caption = "the field as the core samples it at ";
  caption += Plane::name(plane.across);
  caption += " = " + number(at, 3) + " mm; colours: distance; dark line: the surface; thin lines: one voxel apart, " +
             number(rays.edge(), 3) + " mm";
  draw_caption(canvas, options.title, {caption});
  return picture;
}

}  // namespace isotouch::view
