/// What a depth camera sees of objects whose answer is known.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace isotouch::test {

struct RangePixel {
  double z = 0;  ///< along the optical axis, m; 0 = nothing returned
  std::array<double, 3> normal{};
};

/// Half a metre before the camera a pixel is 1 mm wide.
struct RangeImage {
  std::size_t width = 160, height = 120;
  double fx = 500, fy = 480, cx = 80.25, cy = 58.5;
  std::vector<RangePixel> pixels = std::vector<RangePixel>(width * height);

  /// Through the middle of a pixel, with z = 1.
  std::array<double, 3> ray(std::size_t pixel) const {
    return {(static_cast<double>(pixel % width) - cx) / fx, (static_cast<double>(pixel / width) - cy) / fy, 1};
  }
};

/// The side of a ball that the camera sees; `wall` is the depth of a plane behind it, 0 for none.
inline RangeImage ball_image(double radius, double distance, double wall = 0) {
  RangeImage image;
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const auto [x, y, one] = image.ray(i);
    const double square = x * x + y * y + 1;
    const double root = distance * distance - square * (distance * distance - radius * radius);
    if (root > 0) {
      const double z = (distance - std::sqrt(root)) / square;
      image.pixels[i] = {z, {x * z / radius, y * z / radius, (z - distance) / radius}};
    } else if (wall > 0) {
      image.pixels[i] = {wall, {0, 0, -1}};
    }
  }
  return image;
}

/// A plane with round hills: z = distance - height · cos(2πx / length) · cos(2πy / length). The image is full.
inline RangeImage relief_image(double height, double length, double distance) {
  RangeImage image;
  const double k = 2 * M_PI / length;
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const auto [x, y, one] = image.ray(i);
    double z = distance;
    for (int step = 0; step < 100; ++step) z = distance - height * std::cos(k * x * z) * std::cos(k * y * z);
    const double along_x = height * k * std::sin(k * x * z) * std::cos(k * y * z);
    const double along_y = height * k * std::cos(k * x * z) * std::sin(k * y * z);
    const double norm = std::sqrt(along_x * along_x + along_y * along_y + 1);
    image.pixels[i] = {z, {along_x / norm, along_y / norm, -1 / norm}};
  }
  return image;
}

}  // namespace isotouch::test
