#include "host/cloud/objects.h"

#include <Eigen/Geometry>
#include <cmath>
#include <utility>

namespace isotouch::cloud {
namespace {

using Eigen::Vector3d;

/// A limb that tapers evenly from one radius to the other along a chain of joints.
Body limb(const std::vector<Vector3d>& joints, double first_radius, double last_radius) {
  const double taper = (last_radius - first_radius) / static_cast<double>(joints.size() - 1);
  std::vector<Body> parts;
  for (std::size_t i = 0; i + 1 < joints.size(); ++i) {
    const double radius = first_radius + taper * static_cast<double>(i);
    parts.push_back(round_cone(joints[i], radius, joints[i + 1], radius + taper));
  }
  return unite(std::move(parts));
}

/// A nut with six sides: `across` from the axis to a side.
Body nut(const Vector3d& foot, const Vector3d& head, double across) {
  const Vector3d axis = (head - foot).normalized();
  const Vector3d u = axis.unitOrthogonal();
  const Vector3d v = axis.cross(u);
  const double s = 0.5 * std::sqrt(3.0);
  std::vector<Body> sides = {half_space(foot, -axis), half_space(head, axis)};
  for (const auto& [cosine, sine] : {std::pair(1.0, 0.0), {0.5, s}, {-0.5, s}, {-1.0, 0.0}, {-0.5, -s}, {0.5, -s}}) {
    const Vector3d out = cosine * u + sine * v;
    sides.push_back(half_space(foot + across * out, out));
  }
  return intersect(std::move(sides));
}

/// Barrel between two flanges with bolts, a domed bonnet with its nut, two hose caps and a pumper cap, and a chain ring that holds the latter.
Object hydrant() {
  std::vector<Body> parts = {
      cylinder({0, -93, 0}, {0, -82, 0}, 44),                                                // ground flange
      cone_stump({0, -84, 0}, 34, {0, -66, 0}, 29),                                          // foot of the barrel
      cylinder({0, -84, 0}, {0, 42, 0}, 29),                                                 // barrel
      cylinder({0, 34, 0}, {0, 45, 0}, 39),                                                  // bonnet flange
      intersect({ellipsoid({0, 40, 0}, {34, 40, 34}), half_space({0, 40, 0}, {0, -1, 0})}),  // bonnet
      cylinder({0, 74, 0}, {0, 82, 0}, 12),
      nut({0, 80, 0}, {0, 93, 0}, 8),  // operating nut
      cylinder({0, 8, 0}, {0, 8, 47}, 19),
      cylinder({0, 8, 42}, {0, 8, 53}, 24),
      nut({0, 8, 52}, {0, 8, 63}, 7),           // pumper nozzle and cap
      torus({0, -16, 35}, {1, 0, 0}, 13, 2.2),  // chain ring, through barrel and cap
      mirror_x(unite({cylinder({0, 12, 0}, {46, 12, 0}, 14), cylinder({41, 12, 0}, {51, 12, 0}, 18), nut({50, 12, 0}, {60, 12, 0}, 6)})),
  };
  const double d = std::sqrt(0.5);
  for (const auto& [x, z] : {std::pair(1.0, 0.0), {d, d}, {0.0, 1.0}, {-d, d}, {-1.0, 0.0}, {-d, -d}, {0.0, -1.0}, {d, -d}}) {
    parts.push_back(cylinder({37 * x, -84, 37 * z}, {37 * x, -77, 37 * z}, 3.5));  // bolts of the ground flange
    parts.push_back(cylinder({34 * x, 30, 34 * z}, {34 * x, 49, 34 * z}, 2.5));    // bolts through the bonnet flange
  }
  return {"hydrant",
          "a barrel between bolted flanges, a domed bonnet, three capped nozzles with six-sided nuts, a thin chain ring",
          3756,
          unite(std::move(parts)),
          {-61, -94, -45},
          {61, 94, 64}};
}

/// A plump body and a broad head with ear tufts, ringed eyes and a hooked beak; wings of five thin feathers each, a fan of a tail, talons.
Object owl() {
  std::vector<Body> half = {
      cone_stump({26, 56, -2}, 15, {35, 86.5, -4}, 1),  // ear tuft
      torus({19, 44, 31}, {0.25, 0, 1}, 14, 3.5),       // ring round the eye
      sphere({18, 44, 29}, 8.5),                        // eye
      limb({{10, -66, 6}, {12, -76, 10}}, 8, 7),        // leg
      limb({{12, -78, 8}, {12, -82, 38}}, 5, 3),        // talons
      limb({{14, -78, 8}, {26, -82, 33}}, 5, 3),
      limb({{10, -78, 8}, {3, -82, 34}}, 5, 3),
      limb({{12, -78, 6}, {14, -82, -16}}, 5, 3),
      round_cone({34, 16, -4}, 17, {56, 8, -10}, 10),  // shoulder
  };
  const std::vector<Vector3d> feather_tips = {{89.5, 20, -16}, {88, 2, -17}, {83, -16, -18}, {75, -33, -18}, {64, -48, -17}};
  for (const Vector3d& tip : feather_tips) half.push_back(round_cone({50, 9, -10}, 8.5, tip, 3.5));
  return {
      "owl",
      "a body and a head of ellipsoids, ear tufts, ringed eyes, a hooked beak, wings of five tapering feathers, a fan of a tail, talons",
      3725,
      unite({
          ellipsoid({0, -18, -4}, {52, 62, 39}),           // body
          ellipsoid({0, 42, 0}, {51, 35, 36}),             // head
          round_cone({0, 36, 34}, 6.5, {0, 25, 42}, 2.5),  // beak
          intersect({ellipsoid({0, -66, -32}, {34, 34, 8}, {1, 0, 0}, {0, 0.94, 0.35}),
                     half_space({0, -80, 0}, {0, -1, 0})}),  // tail, cut straight
          mirror_x(unite(std::move(half))),
      }),
      {-94, -87, -45},
      {94, 88, 45}};
}

/// Standing, arms out and a little forward, in a cap, with ears, a small nose, shorts, shoes and a satchel on his back.
Object boy() {
  std::vector<Body> half = {
      torus({25, 62, -1}, {0.35, 0, 1}, 5, 2.2),                                                 // ear
      limb({{20, 22, -3}, {40, 8, 4}, {55, 10, 20}}, 8, 5.5),                                    // arm
      ellipsoid({57.5, 11, 25}, {5, 7, 8}),                                                      // hand
      limb({{55, 13, 24}, {50, 19, 27}}, 2.6, 2),                                                // thumb
      limb({{12, -28, 0}, {14, -58, 2}, {14, -84, 0}}, 13, 9),                                   // leg
      cone_stump({12, -24, 0}, 14, {14, -54, 1}, 16.5),                                          // leg of the shorts
      intersect({ellipsoid({14, -85, 8}, {9.5, 11, 20}), half_space({0, -93, 0}, {0, -1, 0})}),  // shoe
  };
  return {"boy",
          "a cap, a head with ring ears, a rounded trunk in shorts, tapering arms and legs, thumbs, shoes, a satchel",
          5153,
          unite({
              ellipsoid({0, 61, 0}, {25, 29, 26}),                                                        // head
              sphere({0, 58, 26}, 4),                                                                     // nose
              intersect({ellipsoid({0, 63, -1}, {28, 31, 29}), half_space({0, 72, 0}, {0, -1, -0.15})}),  // cap
              intersect({cylinder({0, 69, 4}, {0, 73, 5}, 34), half_space({0, 0, 8}, {0, 0, -1})}),       // its peak
              cylinder({0, 24, -1}, {0, 40, 0}, 9),                                                       // neck
              box({0, 6, -1}, {25, 28, 17}, 12),                                                          // trunk
              box({0, -24, 0}, {26, 10, 18}, 6),                                                          // hips
              box({0, 9, -22}, {17, 17, 10}, 3),                                                          // satchel
              mirror_x(unite(std::move(half))),
          }),
          {-64, -94, -33},
          {64, 95, 40}};
}

/// A big round helmet with a window for the face and a ball on a thin stalk, a belted body, mitten hands; one of them holds up a bomb with its fuse.
Object bomberman() {
  std::vector<Body> half = {
      limb({{15, -50, 0}, {19, -72, 0}}, 13, 11),                                               // leg
      intersect({ellipsoid({20, -80, 6}, {21, 18, 28}), half_space({0, -93, 0}, {0, -1, 0})}),  // boot
      box({13, 24, 42}, {4.5, 13, 5}, 4),                                                       // eye
  };
  const Body helmet = ellipsoid({0, 26, 0}, {65, 51, 56});
  const Body window = box({0, 22, 60}, {40, 24, 18}, 12);
  return {"bomberman",
          "a helmet with a sunk face window and a ball on a stalk, a belted body, boots, mittens, a raised bomb with a thin fuse",
          3751,
          unite({
              subtract(helmet, window),
              cylinder({0, 70, 0}, {0, 84, 0}, 3),
              sphere({0, 83, -2}, 12),                       // stalk and ball
              round_cone({0, -24, 0}, 33, {0, -46, 0}, 35),  // body
              torus({0, -50, 0}, {0, 1, 0}, 34, 5),
              box({0, -50, 38}, {9, 8, 4}),  // belt and buckle
              limb({{-28, -14, 0}, {-54, -26, 6}, {-70, -22, 14}}, 12, 10),
              sphere({-74, -20, 18}, 17),  // his right arm, mitten
              limb({{28, -14, 0}, {56, -30, 8}, {72, -28, 18}}, 12, 10),
              sphere({74, -26, 22}, 16),  // his left arm, mitten
              sphere({75, 3, 26}, 18),
              cylinder({75, 18, 26}, {75, 25, 26}, 7),
              limb({{75, 24, 26}, {77, 34, 26}, {85, 40, 27}}, 2.2, 1.6),  // bomb, fuse
              mirror_x(unite(std::move(half))),
          }),
          {-93, -94, -62},
          {94, 96, 66}};
}

/// A lean cat on the prowl, head low and tail up: legs in four different steps, round ears, a long thin tail.
Object jaguar() {
  return {
      "jaguar",
      "a lean trunk, four tapering legs in stride with paws, a head with muzzle, jaw and round ears, a long thin tail",
      4433,
      unite({
          round_cone({-34, 8, 0}, 15.5, {24, 8, 0}, 18.5),                                // trunk
          ellipsoid({-38, 8, 0}, {18, 20, 16}), ellipsoid({24, 10, 0}, {19, 21, 17}),     // haunches, shoulders
          limb({{34, 14, 0}, {58, 20, 0}}, 12, 10),                                       // neck
          ellipsoid({64, 21, 0}, {14, 12.5, 12}),                                         // head
          round_cone({72, 18, 0}, 7.5, {81, 16, 0}, 6),                                   // muzzle
          limb({{66, 12, 0}, {80, 8.5, 0}}, 5, 3.5),                                      // jaw
          intersect({sphere({60, 32, 9}, 6.5), half_space({61.5, 32, 9}, {1, 0, 0.2})}),  // ears, flat in front
          intersect({sphere({60, 32, -9}, 6.5), half_space({61.5, 32, -9}, {1, 0, -0.2})}),
          limb({{26, 2, 9}, {34, -16, 10}, {30, -33, 10}}, 9, 4.5), limb({{29, -35, 10}, {38, -37, 10}}, 5, 4),       // fore left leg, paw
          limb({{24, 2, -9}, {20, -18, -10}, {10, -34, -10}}, 9, 4.5), limb({{10, -35, -10}, {18, -37, -10}}, 5, 4),  // fore right
          limb({{-40, 2, 9}, {-30, -14, 10}, {-40, -24, 10}, {-38, -34, 10}}, 11, 4.2), limb({{-38, -35, 10}, {-29, -37, 10}}, 5, 4),
          limb({{-42, 2, -9}, {-44, -16, -10}, {-58, -24, -10}, {-60, -34, -10}}, 11, 4.2), limb({{-60, -35, -10}, {-51, -37, -10}}, 5, 4),
          limb({{-50, 16, 0}, {-68, 12, 2}, {-82, 14, 3}, {-92, 24, 3}, {-96, 36, 1}, {-92, 46, -2}}, 4.5, 2),  // tail
      }),
      {-99, -42, -26},
      {88, 50, 26}};
}

}  // namespace

std::vector<Object> characters() { return {hydrant(), owl(), boy(), bomberman(), jaguar()}; }

}  // namespace isotouch::cloud
