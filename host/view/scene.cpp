#include "host/view/scene.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "host/view/light.h"
#include "host/view/palette.h"
#include "host/view/rows.h"

namespace isotouch::view {
namespace {

const Colour kCutFace = srgb(0xEFDDBB);
const Colour kCutLine = srgb(0x8C6A34);
constexpr double kFar = 1e5;           // mm: beyond everything
constexpr float kShineThrough = 0.6F;  // how much of a hidden marker is seen through the surface

/// Draws one ray after another; knows nothing of pixels.
class Painter {
 public:
  /// scale     `drawing_scale` of the picture
  Painter(const Scene& scene, float scale) : scene_(scene), light_(scene.camera), scale_(scale) {}

  /// part      which of the pixel's four rays: also the place on the lamp that casts its shadow
  /// pixel     width of a pixel at the object, mm
  Colour colour(const Ray& ray, int part, double pixel, float height_share) const {
    const double begin = begin_of(ray);
    const std::optional<double> t = begin < kFar ? scene_.rays.hit(ray, begin, kFar) : std::nullopt;
    Colour seen = t ? surface(ray, *t, *t <= begin + 1e-6, part, pixel) : backdrop(height_share);
    if (scene_.markers) {
      if (const auto marker = scene_.markers->hit(ray)) {
        const Colour ball = light_.shade(marker->colour, marker->normal, -ray.direction);
        seen = mix(seen, ball, t && *t < marker->t ? kShineThrough : 1.0F);
      }
    }
    return seen;
  }

 private:
  /// Where a ray enters what the cut left over.
  double begin_of(const Ray& ray) const {
    if (!scene_.cut) return 0;
    const double approach = ray.direction.dot(scene_.cut->normal);
    const double height = (ray.from - scene_.cut->point).dot(scene_.cut->normal);
    if (height <= 0) return 0;
    return approach < 0 ? -height / approach : kFar;
  }

  Colour surface(const Ray& ray, double t, bool cut, int part, double pixel) const {
    const Eigen::Vector3d point = ray.at(t);
    const FieldRays::Value value = scene_.rays.value(point);
    if (cut && scene_.cut) return cut_face(value, pixel);
    const Eigen::Vector3d normal = value.gradient.norm() > 1e-6 ? value.gradient.normalized() : Eigen::Vector3d(-ray.direction);
    const Eigen::Vector3d lamp = light_.lamp(part);
    bool lit = normal.dot(lamp) > 0;
    if (lit && !scene_.cut) lit = !scene_.rays.hit({point + 0.75 * scene_.rays.edge() * normal, lamp}, 0, kFar);
    return light_.shade(material(point), normal, -ray.direction, lit ? 1.0F : 0.0F, openness(point, normal));
  }

  /// Hatched on the picture where the surface was invented.
  Colour material(const Eigen::Vector3d& point) const {
    if (scene_.invented == nullptr || !scene_.invented->at(scene_.rays.to_index(point))) return kPlainSurface;
    const Camera::Projected seen = scene_.camera.project(point);
    return mix(kPlainSurface, kInventedColour, hatch(seen.x, seen.y, scale_));
  }

  Colour cut_face(const FieldRays::Value& value, double pixel) const {
    const Eigen::Vector3d& n = scene_.cut->normal;
    const double slope = std::max(0.1, (value.gradient - value.gradient.dot(n) * n).norm());
    const double to_line = std::fabs(value.distance - std::round(value.distance)) / slope * scene_.rays.edge() / pixel;  // pixels
    const bool stored = value.gradient.norm() > 0.25 && value.distance < -0.5;
    const auto line = stored ? static_cast<float>(std::clamp(1.1 - to_line, 0.0, 1.0)) : 0.0F;
    return mix(kCutFace, kCutLine, 0.55F * line);
  }

  /// Ambient occlusion: on an open plane the distance grows as one walks along the normal; in a crease it does not.
  float openness(const Eigen::Vector3d& point, const Eigen::Vector3d& normal) const {
    double closed = 0, weights = 0;
    for (const double height : {0.7, 1.4, 2.2, 3.2}) {  // voxels, within the band
      const double reached = scene_.rays.value(point + height * scene_.rays.edge() * normal).distance;
      closed += std::max(0.0, 1 - reached / height);
      weights += 1;
    }
    return static_cast<float>(std::clamp(1 - 1.3 * closed / weights, 0.15, 1.0));
  }

  const Scene& scene_;
  Light light_;
  float scale_;
};

}  // namespace

Image scene_image(const Rect& area, const Scene& scene, float scale) {
  const Painter painter(scene, scale);
  const int left = static_cast<int>(area.left), top = static_cast<int>(area.top);
  Image image(static_cast<int>(area.right) - left, static_cast<int>(area.bottom) - top);
  const double pixel = scene.cut ? 1 / scene.camera.project(scene.cut->point).pixel_per_mm : 0;  // only the cut's lines need it
  for_each_row(image.height(), [&](int row) {
    const float share = static_cast<float>(row) / static_cast<float>(image.height());
    for (int column = 0; column < image.width(); ++column) {
      Colour sum{0, 0, 0};
      for (int part = 0; part < 4; ++part) {
        const Ray ray = scene.camera.ray(left + column + 0.25 + 0.5 * (part & 1), top + row + 0.25 + 0.5 * (part >> 1));
        sum = sum + painter.colour(ray, part, pixel, share);
      }
      image.at(column, row) = sum * 0.25F;
    }
  });
  return image;
}

}  // namespace isotouch::view
