#include "firmware/guard/arm_geometry.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "firmware/guard/to_double.h"

namespace isotouch::guard {

namespace {

constexpr int kSteps = 40;
constexpr double kFound = 1e-3;      // mm
constexpr double kAcross = 0.99;     // of the rod
constexpr double kLongestStep = 20;  // mm: from far away it does not leap over the workspace

Point cross(const Point& a, const Point& b) { return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}; }

double radians(double raw) { return raw * (2 * std::numbers::pi / 4294967296.0); }

}  // namespace

double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
double length(const Point& v) { return std::sqrt(dot(v, v)); }
Point operator-(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

ArmGeometry::ArmGeometry(const DeviceModel& device)
    : arm_(to_double(device.arm)),
      rod_(to_double(device.rod)),
      joint_(to_double(device.joint)),
      radial_(to_double(device.radial)),
      tangential_(to_double(device.tangential)),
      torque_(to_double(device.word_torque)),
      origin_(to_point(device.workspace_origin)) {
  for (std::size_t i = 0; i < legs_.size(); ++i) {
    const DeviceLeg& leg = device.legs[i];
    const double azimuth = radians(leg.azimuth.raw());
    legs_[i].outwards = {std::cos(azimuth), std::sin(azimuth), 0};
    legs_[i].across = {-std::sin(azimuth), std::cos(azimuth), 0};
    legs_[i].at_zero = radians(leg.at_zero.raw());
    legs_[i].per_count = radians(std::ldexp(leg.per_count.raw(), -AnglePerCount::kFractionBits));
  }
  double turned = 0;  // by the sines from leg to leg
  for (std::size_t i = 0; i < 3; ++i) turned += dot(legs_[i].across, legs_[(i + 1) % 3].outwards);
  clockwise_ = turned < 0;
}

bool ArmGeometry::find(const std::array<std::int16_t, 3>& counts, const Point& near, Grip& grip) const {
  return find_from(near, counts, grip) || find_from({}, counts, grip);
}

/// Newton's iteration.
bool ArmGeometry::find_from(const Point& near, const std::array<std::int16_t, 3>& counts, Grip& grip) const {
  Point at = {near[0] + origin_[0], near[1] + origin_[1], near[2] + origin_[2]};
  std::array<Point, 3> elbows{};  // as seen from each leg: along it, and up; with how far the elbow moves when the arm turns
  for (std::size_t i = 0; i < 3; ++i) {
    const double angle = legs_[i].at_zero + legs_[i].per_count * counts[i];
    elbows[i] = {arm_ * std::cos(angle), arm_ * std::sin(angle), 0};
  }
  for (int step = 0; step < kSteps; ++step) {
    std::array<Point, 3> gradients{};
    Point missing{}, levers{};
    bool reaches = true;
    for (std::size_t i = 0; i < 3; ++i) {
      const double along = radial_ + dot(at, legs_[i].outwards) - elbows[i][0];
      const double up = at[2] - elbows[i][1];
      const double wanted = tangential_ + dot(at, legs_[i].across);
      const double aside = std::clamp(wanted, -kAcross * rod_, kAcross * rod_);
      reaches = reaches && aside == wanted;
      const double rod = std::sqrt(rod_ * rod_ - aside * aside), reach = joint_ + rod, slope = reach * aside / rod;
      for (std::size_t axis = 0; axis < 2; ++axis) gradients[i][axis] = along * legs_[i].outwards[axis] + slope * legs_[i].across[axis];
      gradients[i][2] = up;
      missing[i] = (reach * reach - along * along - up * up) / 2;
      levers[i] = up * elbows[i][0] - along * elbows[i][1];
    }
    const std::array<Point, 3> columns = {cross(gradients[1], gradients[2]), cross(gradients[2], gradients[0]),
                                          cross(gradients[0], gradients[1])};
    const double determinant = dot(gradients[0], columns[0]);
    if (!(std::abs(determinant) > 1)) return false;
    Point move{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      move[axis] = (missing[0] * columns[0][axis] + missing[1] * columns[1][axis] + missing[2] * columns[2][axis]) / determinant;
    }
    const double far = length(move), part = far > kLongestStep ? kLongestStep / far : 1;
    if (!std::isfinite(far)) return false;
    if (far < kFound) {
      const bool mirrored = (determinant < 0) != clockwise_;  // the closures hold, but a singularity lies between here and the middle
      if (!(reaches && levers[0] > 0 && levers[1] > 0 && levers[2] > 0) || mirrored) return false;
      grip.at = at - origin_;
      for (std::size_t i = 0; i < 3; ++i) {
        grip.turns[i] = {gradients[i][0] / levers[i], gradients[i][1] / levers[i], gradients[i][2] / levers[i]};
      }
      return true;
    }
    for (std::size_t axis = 0; axis < 3; ++axis) at[axis] += part * move[axis];
  }
  return false;
}

Point ArmGeometry::force(const std::array<std::int16_t, 3>& commands, const Grip& grip) const {
  Point force{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      force[axis] -= torque_ * commands[i] * grip.turns[i][axis];  // a positive one turns inwards
  }
  return force;
}

double ArmGeometry::rounding(const Grip& grip) const {
  return torque_ * (length(grip.turns[0]) + length(grip.turns[1]) + length(grip.turns[2]));
}

}  // namespace isotouch::guard
