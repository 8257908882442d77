#include "host/view/worst_picture.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <optional>
#include <vector>

#include "host/field/first_hit.h"
#include "host/field/line_crossings.h"
#include "host/field/triangle_tree.h"
#include "host/view/axes.h"
#include "host/view/canvas.h"
#include "host/view/caption.h"
#include "host/view/colour_map.h"
#include "host/view/field_ray.h"
#include "host/view/light.h"
#include "host/view/rows.h"
#include "host/view/text.h"

namespace isotouch::view {
namespace {

using Eigen::Vector3d;
using field::TriangleTree;

const Colour kMaterial = srgb(0xD4DEE8);
const Colour kSection = srgb(0xD9C7A4);
const Colour kPlace = srgb(0x101418);
constexpr double kWidestScale = 2;       // voxels: beyond, colours are full
constexpr double kNarrowestScale = 0.5;  // voxels: surfaces may agree, also where a touch is worst

/// A surface, and where the other one is as seen from it.
struct Body {
  const TriangleTree& own;
  const TriangleTree& other;
  const TriangleTree& other_closed;  // what it turns round is inside the other
  const FieldRays* field;            // nullptr: the truth

  bool is_truth() const { return field == nullptr; }
  /// Signed, mm: positive where the field stands out of the truth, on whichever of the two.
  double error(const Vector3d& point) const {
    const double distance = other.nearest(point).distance;
    return field::is_inside(other_closed, point) == is_truth() ? distance : -distance;
  }
  Vector3d normal(const Vector3d& point, const field::FaceHit& hit) const {
    if (is_truth()) return hit.normal;
    const Vector3d gradient = field->value(point).gradient;
    return gradient.norm() > 1e-6 ? Vector3d(gradient.normalized()) : hit.normal;
  }
};

struct Shot {
  const Camera& camera;
  std::optional<double> begin;  ///< mm from the eye along its axis: what is nearer is cut away
  double full_mm;               ///< error of full colour; 0: no colours
};

void draw_body(Canvas& canvas, const Rect& panel, const Body& body, const Shot& shot) {
  const Light light(shot.camera);
  const int left = static_cast<int>(panel.left), top = static_cast<int>(panel.top);
  Image image(static_cast<int>(panel.right) - left, static_cast<int>(panel.bottom) - top);
  for_each_row(image.height(), [&](int row) {
    const Colour behind = backdrop(static_cast<float>(row) / static_cast<float>(image.height()));
    for (int column = 0; column < image.width(); ++column) {
      Colour sum{0, 0, 0};
      std::optional<Colour> albedo;  // one question a pixel
      for (int part = 0; part < 4; ++part) {
        const Ray ray = shot.camera.ray(left + column + 0.25 + 0.5 * (part & 1), top + row + 0.25 + 0.5 * (part >> 1));
        const double begin = shot.begin ? *shot.begin / -ray.direction.dot(shot.camera.back()) : 0;
        const auto hit = field::first_hit(body.own, ray.from, ray.direction, begin);
        if (!hit) {
          sum = sum + behind;
        } else if (hit->from_inside) {
          sum = sum + kSection;
        } else {
          if (!albedo) albedo = shot.full_mm > 0 ? distance_colour(body.error(ray.at(hit->t)) / shot.full_mm) : kMaterial;
          sum = sum + light.shade(*albedo, body.normal(ray.at(hit->t), *hit), -ray.direction);
        }
      }
      image.at(column, row) = sum * 0.25F;
    }
  });
  canvas.paint(image, left, top);
}

/// From where the place is seen: 35 degrees beside its normal, upright, and free if that can be.
struct Eye {
  Vector3d direction;
  bool free;
};

Eye eye_for(const Body& body, const Vector3d& place, const Vector3d& other_foot, double voxel) {
  const TriangleTree::Foot foot = body.own.nearest(place);
  const field::Corners at = body.own.corners(foot.face);
  const Vector3d normal = (at[1] - at[0]).cross(at[2] - at[0]).normalized();
  const auto is_free = [&](const Vector3d& to_eye) {
    if (field::first_hit(body.own, place + 0.05 * voxel * normal, to_eye)) return false;
    const Vector3d foot_normal = (place - other_foot).dot(normal) > 0 ? Vector3d::Zero() : Vector3d(voxel * normal);
    return !field::first_hit(body.other, place + foot_normal, to_eye) || (place - other_foot).dot(normal) <= 0;
  };
  Eye best{normal, false};
  double best_cost = 1e9;
  for (int elevation = -60; elevation <= 60; elevation += 15) {
    for (int azimuth = 0; azimuth < 360; azimuth += 15) {
      const Vector3d candidate = Direction{static_cast<double>(azimuth), static_cast<double>(elevation), 'y'}.towards_eye();
      const double angle = std::acos(std::clamp(candidate.dot(normal), -1.0, 1.0)) * 180 / std::numbers::pi;
      const bool free = is_free(candidate);
      const double cost = std::fabs(angle - 35) + 0.2 * std::abs(elevation - 15) + (free ? 0 : 1000);
      if (cost < best_cost) {
        best_cost = cost;
        best = {candidate, free};
      }
    }
  }
  return best;
}

Point pixel(const Camera& camera, const Vector3d& place) {
  const Camera::Projected at = camera.project(place);
  return {static_cast<float>(at.x), static_cast<float>(at.y)};
}

/// A ring at `from`, and a line from it to a dot.
void draw_sign(Canvas canvas, Point from, Point to, float radius) {
  const float scale = drawing_scale(canvas.picture());
  Polyline ring;
  for (int i = 0; i <= 48; ++i) {
    const auto angle = static_cast<float>(i * 2 * std::numbers::pi / 48);
    ring.push_back(from + Point{std::cos(angle), std::sin(angle)} * radius);
  }
  const std::array<Polyline, 2> lines = {ring, Polyline{from, to}};
  canvas.stroke(lines, 4 * scale, {1, 1, 1}, 0.8F);
  canvas.stroke(lines, 1.8F * scale, kPlace);
  canvas.disc(to, 3 * scale, kPlace);
}

/// A ring on the worst place, and a line from it to where the other surface is nearest.
void draw_place(const Canvas& canvas, const Camera& camera, const Vector3d& place, const Vector3d& foot) {
  draw_sign(canvas, pixel(camera, place), pixel(camera, foot), 9 * drawing_scale(canvas.picture()));
}

void draw_legend(Canvas& canvas, const Rect& bar, double full_voxels, double voxel_mm, bool wider) {
  const float scale = drawing_scale(canvas.picture());
  const TextStyle label{.capital = 8.5F * scale, .colour = kInk, .along = Anchor::kEnd, .across = Anchor::kMiddle};
  TextStyle pale = label;
  pale.colour = kPaleInk;
  for (float y = bar.top; y < bar.bottom; ++y) {
    const double value = 1 - 2 * static_cast<double>((y + 0.5F - bar.top) / bar.height());
    canvas.fill({bar.left, y, bar.right, bar.bottom}, distance_colour(value));  // down to the end: no row shows what is under it
  }
  canvas.frame(bar, 1.2F * scale, kPaleInk);
  TextStyle head = label;
  head.along = Anchor::kStart;
  draw_text(canvas, {bar.left, bar.top - 54 * scale}, "distance between the surfaces", head);
  draw_text(canvas, {bar.left, bar.top - 34 * scale}, "the field stands out", head);
  draw_text(canvas, {bar.left, bar.bottom + 18 * scale}, "the field is missing", head);
  draw_text(canvas, {bar.right + 54 * scale, bar.top - 16 * scale}, "voxel", label);
  draw_text(canvas, {bar.right + 120 * scale, bar.top - 16 * scale}, "mm", pale);
  if (wider) draw_text(canvas, {bar.left, bar.bottom + 38 * scale}, "full colour: as much or more", head);
  for (const double value : ticks(-full_voxels, full_voxels, 9)) {
    const float y = bar.bottom - static_cast<float>((value / full_voxels + 1) / 2) * bar.height();
    canvas.line({bar.left, y}, {bar.right, y}, scale, kPlace, value == 0 ? 0.9F : 0.3F);
    draw_text(canvas, {bar.right + 54 * scale, y}, number(value, 2), label);
    draw_text(canvas, {bar.right + 120 * scale, y}, number(value * voxel_mm, 3), pale);
  }
}

}  // namespace

Picture worst_picture(const FieldView& field, const cloud::TriangleMesh& surface, const cloud::TriangleMesh& truth,
                      const cloud::TriangleMesh& closed, const WorstPlace& worst, const WorstOptions& options) {
  Picture picture(options.width, options.height);
  Canvas canvas(picture);
  const float scale = drawing_scale(picture);
  const auto width = static_cast<float>(options.width), height = static_cast<float>(options.height);
  for (int y = 0; y < options.height; ++y) {
    canvas.fill({0, static_cast<float>(y), width, static_cast<float>(y + 1)}, backdrop(static_cast<float>(y) / height));
  }
  const TriangleTree ours(surface), theirs(truth), all_theirs(closed);
  const FieldRays rays(field);
  const Body felt{ours, theirs, all_theirs, &rays}, mesh{theirs, ours, ours, nullptr};
  const Body& owner = worst.on_truth ? mesh : felt;
  const Vector3d foot = owner.other.nearest(worst.place).point;
  const Eye eye = eye_for(owner, worst.place, foot, worst.voxel_mm);

  const float gap = std::floor(16 * scale), column = std::floor(236 * scale), foot_of_panels = std::floor(height - 92 * scale);
  const float side = std::floor((width - column - 3 * gap) / 2), top = std::floor(44 * scale);
  const std::array<Rect, 2> panels = {{{gap, top, gap + side, foot_of_panels}, {2 * gap + side, top, 2 * gap + 2 * side, foot_of_panels}}};
  const Rect overview{width - column, top, width - gap, top + column - gap};

  const double length = worst.touch ? std::max((worst.touch->proxy - worst.touch->hip).norm(), (worst.touch->god - worst.touch->hip).norm())
                                    : worst.distance_mm;
  const double reach = std::max(9 * worst.voxel_mm, 1.4 * length + 4 * worst.voxel_mm);
  const Vector3d centre = (worst.place + foot) / 2;
  const auto looking = [&](double half, const Vector3d& at, const Rect& area) {
    const Camera level(eye.direction, Vector3d::UnitY(), std::array{at}, area);
    const std::vector<Vector3d> shown = {at - half * level.right(), at + half * level.right(), at - half * level.up(),
                                         at + half * level.up()};
    return Camera(eye.direction, Vector3d::UnitY(), shown, area);
  };
  const double full = std::clamp(worst.distance_mm / worst.voxel_mm, kNarrowestScale, kWidestScale) * worst.voxel_mm;
  const std::array<const Body*, 2> bodies = {&felt, &mesh};
  const std::array<const char*, 2> names = {"the field's surface, as the core samples it", "the true surface"};
  for (std::size_t i = 0; i < 2; ++i) {
    const Camera camera = looking(reach, centre, panels[i]);
    const std::optional<double> begin =
        eye.free ? std::nullopt : std::optional(camera.project(worst.place).distance - 0.1 * worst.voxel_mm);
    draw_body(canvas, panels[i], *bodies[i], {camera, begin, full});
    if (worst.touch) {
      draw_place(canvas.within(panels[i]), camera, i == 0 ? worst.touch->proxy : worst.touch->god, worst.touch->hip);
    } else {
      draw_place(canvas.within(panels[i]), camera, worst.place, foot);
    }
    canvas.frame(panels[i], 1.2F * scale, srgb(0xAEB8C2));
    draw_text(canvas, {panels[i].left + 2 * scale, top - 12 * scale}, names[i], {.capital = 9.5F * scale, .colour = kInk});
    draw_scale_bar(canvas, {panels[i].right - 12 * scale, panels[i].bottom - 14 * scale}, camera.project(centre).pixel_per_mm,
                   static_cast<double>(side) / 5);
  }

  Eigen::AlignedBox3d box;
  for (const Vector3d& vertex : truth.vertices) box.extend(vertex);
  const Camera whole(eye.direction, Vector3d::UnitY(), truth.vertices, overview);
  draw_body(canvas, overview, mesh, {whole, std::nullopt, 0});
  draw_place(canvas.within(overview), whole, worst.place, worst.place);
  canvas.frame(overview, 1.2F * scale, srgb(0xAEB8C2));
  draw_text(canvas, {overview.left + 2 * scale, top - 12 * scale}, "where it is", {.capital = 9.5F * scale, .colour = kInk});
  const Rect bar{overview.left, overview.bottom + 92 * scale, overview.left + 26 * scale, foot_of_panels - 44 * scale};
  draw_legend(canvas, bar, full / worst.voxel_mm, worst.voxel_mm, worst.touch || worst.distance_mm > full);

  const Point sign{panels[1].left + 10 * scale, foot_of_panels + 20 * scale};
  draw_sign(canvas, sign, sign + Point{18 * scale, 0}, 6 * scale);
  draw_text(canvas, {sign.x + 30 * scale, sign.y + 4 * scale},
            worst.touch ? "what holds the hand (left the proxy, right the god-object), and the hand"
                        : "the worst place, and the nearest one of the other surface",
            {.capital = 8.5F * scale, .colour = kInk});

  char where[96];
  std::snprintf(where, sizeof where, "(%.2f, %.2f, %.2f) mm", worst.place.x(), worst.place.y(), worst.place.z());
  const std::string figure = number(worst.distance_mm / worst.voxel_mm, 2) + " voxels = " + number(worst.distance_mm, 3) + " mm";
  if (worst.touch) {
    draw_caption(canvas, options.title + ": felt worst", {worst.touch->words + ", at " + where + (eye.free ? "" : "; cut open there")});
    return picture;
  }
  draw_caption(canvas, options.title + ": worst place",
               {figure + (worst.on_truth ? " from the true surface to the field's" : " from the field's surface to the true one") +
                ", at " + where + (eye.free ? "" : "; cut open there")});
  return picture;
}

}  // namespace isotouch::view
