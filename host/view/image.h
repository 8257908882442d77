/// A picture in memory: linear light, so that averages and blends are those of light and not of stored bytes.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace isotouch::view {

/// Linear red, green and blue; 0 black, 1 white, more is cut off when the picture is written.
struct Colour {
  float r = 0, g = 0, b = 0;

  Colour operator+(Colour o) const { return {r + o.r, g + o.g, b + o.b}; }
  Colour operator*(Colour o) const { return {r * o.r, g * o.g, b * o.b}; }
  Colour operator*(float f) const { return {r * f, g * f, b * f}; }
};

/// `a` at t = 0, `b` at t = 1.
inline Colour mix(Colour a, Colour b, float t) { return a * (1.0F - t) + b * t; }

/// The light behind a colour as it is written in style sheets, 0xRRGGBB (sRGB, IEC 61966-2-1).
inline Colour srgb(std::uint32_t code) {
  const auto light = [](std::uint32_t byte) {
    const float v = static_cast<float>(byte & 0xFFU) / 255.0F;
    return v <= 0.04045F ? v / 12.92F : std::pow((v + 0.055F) / 1.055F, 2.4F);
  };
  return {light(code >> 16), light(code >> 8), light(code)};
}

/// The byte that a screen needs to show an amount of light.
inline std::uint8_t to_byte(float light) {
  const float v = std::clamp(light, 0.0F, 1.0F);
  const float coded = v <= 0.0031308F ? 12.92F * v : 1.055F * std::pow(v, 1.0F / 2.4F) - 0.055F;
  return static_cast<std::uint8_t>(coded * 255.0F + 0.5F);
}

/// Row by row from the top; pixel (x, y) covers [x, x+1) x [y, y+1).
class Image {
 public:
  Image(int width, int height, Colour fill = {1, 1, 1})
      : width_(width), height_(height), pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), fill) {}

  int width() const { return width_; }
  int height() const { return height_; }
  Colour& at(int x, int y) { return pixels_[index(x, y)]; }
  const Colour& at(int x, int y) const { return pixels_[index(x, y)]; }
  /// Lays a colour over a pixel; the part of it that the colour covers is 0 to 1. Outside the picture nothing happens.
  void blend(int x, int y, Colour colour, float cover) {
    if (x >= 0 && y >= 0 && x < width_ && y < height_) at(x, y) = mix(at(x, y), colour, cover);
  }

 private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  }
  int width_, height_;
  std::vector<Colour> pixels_;
};

}  // namespace isotouch::view
