#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "hil/falcon_model/angle.h"
#include "hil/falcon_model/paths.h"
#include "hil/falcon_model/smooth.h"

namespace isotouch::falcon_model {

namespace {

/// Sine of a full turn in `period` ms, the whole turns taken off first.
double wave(double ms, double period) {
  const double turns = ms / period;
  return sine(2 * kPi * (turns - std::floor(turns)));
}

/// There within `there` ms, a rest, and back; from 0 to 1 to 0, again and again.
double in_and_out(double ms, double there, double rest) {
  const double round = 2 * (there + rest);
  const double t = ms - round * std::floor(ms / round);
  return smooth(t / there) - smooth((t - there - rest) / there);
}

Vector press(double ms) { return {0, 0, 45 - 35 * in_and_out(ms, 1400, 300)}; }

Vector stab(double ms) { return {45 - 90 * in_and_out(ms, 170, 400), 3, 5}; }

Vector tour(double ms) {
  const double radius = 33 - 12 * wave(ms, 7500);
  const double height = 0.9 * wave(ms + 1000, 20000);
  const double around = std::sqrt(1 - height * height);
  return radius * Vector{around * wave(ms, 3000), height, around * wave(ms + 750, 3000)};
}

Vector stroke(double ms) {
  const double x = 25 * wave(ms, 2000);
  return {x, 0, std::sqrt(33.0 * 33 - x * x)};
}

Vector tremor(double ms) { return {0.5 * wave(ms, 97), 0.5 * wave(ms, 103), 45 - 13 * smooth(ms / 600) + 0.5 * wave(ms, 100)}; }

constexpr std::array<std::pair<const char*, Vector (*)(double)>, 6> kMotions = {
    {{"rest", [](double) { return Vector{}; }}, {"press", press}, {"stab", stab}, {"tour", tour}, {"stroke", stroke}, {"tremor", tremor}}};

}  // namespace

std::vector<std::string> motion_names() {
  std::vector<std::string> names;
  for (const auto& [name, motion] : kMotions) names.emplace_back(name);
  return names;
}

Path scripted_path(const std::string& name) {
  for (const auto& [known, motion] : kMotions) {
    if (name == known) return motion;
  }
  throw std::invalid_argument("no motion is called '" + name + "'");
}

}  // namespace isotouch::falcon_model
