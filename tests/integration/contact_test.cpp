/// What the hand meets in contact, on fields that the host wrote: the proxy on the surface everywhere, and creases without pits.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "firmware/core/index_frame.h"
#include "firmware/core/proxy.h"
#include "firmware/core/render.h"
#include "host/cloud/placement.h"
#include "host/cloud/shapes.h"
#include "host/encoding/write_image.h"
#include "host/field/build_field.h"
#include "host/field/make_grid.h"
#include "host/field/sample_distance.h"
#include "host/motion/motion.h"
#include "tests/support/reference.h"

namespace isotouch {
namespace {

/// The field of one of the project's objects as `build` makes it, at 186 voxels along its longest side.
field_file::Image object(const std::string& name) {
  const cloud::OrientedPoints raw = cloud::sample_shape(cloud::shape(name), cloud::shape(name).default_points);
  const cloud::Placement placement = cloud::place(raw.positions);
  const cloud::OrientedPoints points = cloud::placed(raw, placement);
  Eigen::Vector3d low = points.positions[0], high = low;
  for (const auto& p : points.positions) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const field::Grid grid = field::make_grid(low, high, (high - low).maxCoeff() / 186, field::field_margin(4.0));
  field::Progress progress;
  encoding::FieldInfo info;
  info.placement = placement;
  return encoding::write_image(field::build_field(points, grid, 4.0, progress), info);
}

TEST(ContactHeavy, TheProxyIsNeverBelowTheSurfaceOnATour) {
  for (const char* name : {"hydrant", "jaguar"}) {
    const field_file::Image image = object(name);
    const FieldView field = *FieldView::parse(image.bytes());
    motion::MotionOptions options;
    options.ticks = 60000;
    core::ProxyState state;
    std::uint64_t contacts = 0;
    double deepest = 1.0;
    motion::make_motion(&field, options, [&](const Input& in) {
      const core::Contact contact = core::step_proxy(core::to_index(in.hip, field), field, state);
      if (!contact.touching) return;
      ++contacts;
      deepest = std::min(deepest, test::to_double(core::sample_field(field, contact.proxy).distance));
    });
    EXPECT_GT(contacts, 5000U) << name;
    EXPECT_GE(deepest, -0.05) << name;
  }
}

/// Two planes that meet in a crease of `degrees` in a general direction, inside a ball; written by the host from exact distances.
struct Crease {
  Eigen::Vector3d along, out, side;
  Eigen::Vector3d centre{0.11, -0.07, 0.05};  // mm
  field_file::Image image;

  Crease(double degrees, test::Random& random) : image(0) {
    const auto vector = [](const test::Point& p) { return Eigen::Vector3d(p.x, p.y, p.z); };
    along = vector(random.direction());
    out = along.cross(vector(random.direction())).normalized();
    side = along.cross(out);
    const double half = degrees / 57.295779513 / 2;
    const Eigen::Vector3d n1 = out * std::sin(half) + side * std::cos(half), n2 = out * std::sin(half) - side * std::cos(half);
    const double edge = 0.34, radius = 12.0;
    const Eigen::Vector3d corner = Eigen::Vector3d::Constant(radius);
    const field::Grid grid = field::make_grid(-corner, corner, edge, 10.0);
    const auto distance = [&](const Eigen::Vector3d& p) {
      return std::max(std::min(n1.dot(p - centre), n2.dot(p - centre)), (p - centre).norm() - radius);
    };
    image = encoding::write_image(field::sample_distance(distance, grid, 4.0), {});
  }
};

TEST(ContactHeavy, SlidingAlongACreaseTheForceIsThatOfTheConvergedProxy) {
  test::Random random(61);
  for (const double degrees : {60.0, 90.0, 120.0}) {
    for (int body = 0; body < 4; ++body) {
      const Crease crease(degrees, random);
      const FieldView field = *FieldView::parse(crease.image.bytes());
      const auto index = [&](double s, double deep) {
        const Eigen::Vector3d p = crease.centre + 0.34 * (s * crease.along - deep * crease.out + 0.5 * std::sin(s / 6) * crease.side);
        const auto voxels = [&](double mm, Mm origin) { return (mm - origin.raw() / 1048576.0) * (1048576.0 / field.edge.raw()); };
        return test::to_voxel({voxels(p.x(), field.origin.x), voxels(p.y(), field.origin.y), voxels(p.z(), field.origin.z)});
      };
      core::ProxyState state;
      for (double deep = -6; deep < 4; deep += 0.25) core::step_proxy(index(-16, deep), field, state);
      double worst = 0;
      int compared = 0;
      for (double s = -16; s < 16; s += 0.3 / 0.34) {  // 300 mm/s
        const Vec3<Voxel> hip = index(s, 4);
        const core::Contact now = core::step_proxy(hip, field, state);
        core::ProxyState later = state;
        core::Contact converged;
        for (int t = 0; t < 20; ++t) converged = core::step_proxy(hip, field, later);
        ASSERT_TRUE(now.touching && converged.touching);
        worst = std::max(worst, test::angle_degrees(test::to_point(now.deflection), test::to_point(converged.deflection)));
        ++compared;
      }
      EXPECT_GT(compared, 30);
      EXPECT_LT(worst, 1.0) << degrees << " degrees, body " << body;
    }
  }
}

}  // namespace
}  // namespace isotouch
