#include "host/motion/gestures.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "host/error.h"

namespace isotouch::motion {

using Eigen::Vector3d;

namespace {

constexpr double kTravelSpeed = 1000;   // mm/s, between touches
constexpr double kApproachSpeed = 250;  // mm/s, to a place
constexpr double kPressSpeed = 25;      // mm/s
constexpr double kFastestHand = 1000;   // mm/s, while it follows a surface
constexpr int kLooks = 400;             // places from which the bent and the thin ones are chosen
constexpr std::size_t kChosen = 12;

Vector3d any_tangent(const Vector3d& normal) {
  int axis = 0;
  normal.cwiseAbs().minCoeff(&axis);
  return normal.cross(Vector3d::Unit(axis)).normalized();
}

}  // namespace

Gestures::Gestures(const FeltSurface& surface, Hand& hand, cloud::Random random)
    : surface_(surface), hand_(hand), random_(random), voxel_(surface.voxel_mm()), radius_(surface.radius() + 2.0) {
  std::vector<Place> places;
  for (int i = 0; i < kLooks; ++i) {
    if (const auto place = look()) places.push_back(*place);
  }
  if (places.empty())
    throw InputError("the field holds no surface that a hand could reach from outside; build it again from a closed cloud");

  std::vector<double> curvature(places.size());
  for (std::size_t i = 0; i < places.size(); ++i) curvature[i] = surface_.sample(places[i].at.position).curvature;
  std::vector<std::size_t> order(places.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return curvature[a] > curvature[b]; });
  for (const std::size_t i : order) {
    const bool apart = std::all_of(bent_.begin(), bent_.end(),
                                   [&](const Place& p) { return (p.at.position - places[i].at.position).norm() > 6 * voxel_; });
    if (apart && bent_.size() < kChosen) bent_.push_back(places[i]);
  }

  std::vector<double> thickness(places.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Vector3d inward = -places[i].at.normal;
    const Vector3d from = places[i].at.position - 2 * radius_ * inward;
    const auto first = surface_.first_hit(from, inward, 4 * radius_);
    const bool seen = first && (first->position - places[i].at.position).norm() < 2 * voxel_;
    thickness[i] = seen ? surface_.way_out(places[i].at.position + 0.5 * voxel_ * inward, inward, 2 * radius_) : 2 * radius_;
  }
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return thickness[a] != thickness[b] ? thickness[a] < thickness[b] : a < b; });
  for (std::size_t i = 0; i < std::min(kChosen, order.size()); ++i) {
    thin_.push_back(places[order[i]]);
    thickness_.push_back(thickness[order[i]]);
  }
  hand_.step(places.front().from);
}

/// A point of the cube [-1, 1]³. Each draw is a statement of its own: arguments and operands are evaluated in no certain order.
Vector3d Gestures::draw() {
  Vector3d v;
  for (double& coordinate : v) coordinate = random_.uniform(-1, 1);
  return v;
}

Vector3d Gestures::direction() {
  for (;;) {  // the share of the cube that the ball fills, 52 %, ends this soon
    const Vector3d v = draw();
    const double square = v.squaredNorm();
    if (square > 0.01 && square <= 1) return v / std::sqrt(square);
  }
}

std::optional<Gestures::Place> Gestures::look() {
  const Vector3d from = surface_.centre() + radius_ * direction();
  const Vector3d towards = surface_.centre() + 0.6 * radius_ * draw();
  const auto hit = surface_.first_hit(from, (towards - from).normalized(), 2 * radius_);
  if (!hit) return std::nullopt;
  return Place{from, *hit};
}

Gestures::Place Gestures::any_place() {
  for (int i = 0; i < kLooks; ++i) {
    if (const auto place = look()) return *place;
  }
  return bent_.front();
}

/// Over the ball around the object, never through it.
void Gestures::travel(const Vector3d& to) {
  const Vector3d centre = surface_.centre();
  const Vector3d a = (hand_.position() - centre).normalized();
  const Vector3d b = (to - centre).normalized();
  Vector3d middle = a + b;
  if (middle.norm() < 0.2) middle = any_tangent(a);  // opposite: any way round
  middle.normalize();
  std::vector<Vector3d> way{centre + radius_ * a};
  for (const Vector3d& half : {middle, b}) {
    const Vector3d begin = (way.back() - centre) / radius_;
    for (int i = 1; i <= 8; ++i) way.push_back(centre + radius_ * (begin + i / 8.0 * (half - begin)).normalized());
  }
  way.back() = to;
  hand_.move_along(way, kTravelSpeed);
}

/// To `clearance` mm before the place, along the way it was seen.
void Gestures::approach(const Place& place, double clearance) {
  travel(place.from);
  const Vector3d way = place.at.position - place.from;
  hand_.move(place.from + std::max(0.0, 1 - clearance / way.norm()) * way, kApproachSpeed);
}

/// From near a place of the surface to the ball, by a free way if there is one.
void Gestures::retreat(const SurfacePoint& from) {
  const Vector3d start = from.position + 2 * voxel_ * from.normal;
  hand_.move(start, kApproachSpeed);
  Vector3d way = from.normal;
  for (int i = 0; i < 24; ++i) {
    const Vector3d tried = i == 0 ? way : direction();
    if (tried.dot(from.normal) > 0 && !surface_.first_hit(start, tried, 2 * radius_)) {
      way = tried;
      break;
    }
  }
  const Vector3d out = start - surface_.centre();  // |start + s way - centre| = radius
  const double half = out.dot(way);
  const double s = -half + std::sqrt(std::max(0.0, half * half + radius_ * radius_ - out.squaredNorm()));
  hand_.move(start + s * way, kApproachSpeed);
}

void Gestures::press() {
  const Place place = any_place();
  approach(place, 3);
  const double depth = random_.uniform(1, 6) * voxel_;
  hand_.move(place.at.position - depth * place.at.normal, kPressSpeed);
  hand_.hold(0.3);
  retreat(place.at);
}

void Gestures::slide() {
  constexpr double kSpeeds[] = {100, 300, 1000};
  const Place place = any_place();
  glide(place, kSpeeds[random_.bits() % 3], 1.5, 4, 0);
}

void Gestures::graze() { glide(any_place(), 30, 1.5, 0, 0.1); }

/// Follows the surface with the hand `depth` voxels below it, plus a ripple of 10 a second.
void Gestures::glide(const Place& place, double speed, double seconds, double depth, double ripple) {
  approach(place, 2);
  hand_.move(place.at.position, kPressSpeed);
  SurfacePoint foot = place.at;
  Vector3d heading = any_tangent(foot.normal);
  const Vector3d drawn = draw();
  heading = (drawn.x() * heading + drawn.y() * foot.normal.cross(heading)).normalized();
  const double turn = drawn.z();  // radians a second, nearly
  const double tick_s = hand_.period_s();
  for (double time = 0; time < seconds && !hand_.done(); time += tick_s) {
    const double ends = minimum_jerk(time / 0.15) * minimum_jerk((seconds - time) / 0.15);
    heading = (heading - heading.dot(foot.normal) * foot.normal + turn * tick_s * foot.normal.cross(heading)).normalized();
    const auto next = surface_.project(foot.position + ends * speed * tick_s * heading);
    if (!next) break;
    foot = *next;
    const double below = voxel_ * ends * (depth + ripple * wave(10 * time));
    const Vector3d wanted = foot.position - below * foot.normal;
    const Vector3d way = wanted - hand_.position();
    const double reach = kFastestHand * tick_s;  // at an edge the normal turns faster than a hand can follow
    hand_.step(way.norm() > reach ? hand_.position() + reach * way.normalized() : wanted);
  }
  retreat(foot);
}

void Gestures::tap() {
  const Place place = any_place();
  approach(place, 2);
  const Vector3d above = place.at.position + 1.0 * place.at.normal;
  for (int i = 0; i < 8; ++i) {
    const double peak = random_.uniform(200, 500);
    hand_.move(above, peak);
    hand_.move(place.at.position - random_.uniform(1, 3) * voxel_ * place.at.normal, peak);
    hand_.move(above, peak);
    hand_.hold(0.03);
  }
  retreat(place.at);
}

void Gestures::corner() {
  const Place place = bent_[random_.bits() % bent_.size()];
  approach(place, 3);
  const Vector3d inner = place.at.position - random_.uniform(1, 5) * voxel_ * place.at.normal;
  hand_.move(inner, kPressSpeed);
  hand_.hold(0.3);
  for (int i = 0; i < 4; ++i) hand_.move(inner + 2 * voxel_ * direction(), kPressSpeed);
  hand_.hold(0.2);
  retreat(place.at);
}

void Gestures::stab() {
  const std::size_t chosen = random_.bits() % thin_.size();
  const SurfacePoint& at = thin_[chosen].at;
  const double beyond = std::max(20 * voxel_, 8.0) + random_.uniform(1, 3) * voxel_;
  const Vector3d before = at.position + beyond * at.normal;
  const Vector3d behind = at.position - (thickness_[chosen] + beyond) * at.normal;
  const double peak = std::min(1000.0, random_.uniform(300, 1300));
  const Vector3d out = before - surface_.centre();
  travel(surface_.centre() + radius_ * (out + radius_ * at.normal).normalized());
  hand_.move(before, kApproachSpeed);
  hand_.move(behind, peak);
  hand_.hold(0.05);
  hand_.move(before, peak);
  hand_.hold(0.05);
  travel(surface_.centre() + radius_ * out.normalized());
}

void Gestures::leave() {
  const Place place = any_place();
  approach(place, 2);
  hand_.move(place.at.position - 2 * voxel_ * place.at.normal, kPressSpeed);
  const Vector3d centre = surface_.centre();
  const Vector3d inward = (centre - place.at.position).normalized();
  hand_.move(centre + (radius_ + 15) * inward, 400);  // through the object and out of the grid on the far side
  hand_.hold(0.05);
  hand_.move(place.at.position + 3 * place.at.normal, 400);
  retreat(place.at);
  const Vector3d home = hand_.position();
  hand_.move(home + 500 * (home - centre).normalized(), 2500);  // some of these pass ±512 mm, where the core clamps
  hand_.move(Vector3d(600, 0, 0), 2500);
  hand_.hold(0.02);
  hand_.move(home + 500 * (home - centre).normalized(), 2500);
  hand_.move(home, 2500);
}

}  // namespace isotouch::motion
