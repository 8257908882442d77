#include "host/view/invented.h"

#include <gtest/gtest.h>

#include <cmath>

#include "host/view/palette.h"
#include "host/view/points_picture.h"
#include "host/view/surface_picture.h"
#include "tests/host/view/sphere_field.h"

namespace isotouch::view {
namespace {

/// The half of the sphere with x below 0.
struct HalfInvented : SphereField {
  HalfInvented() {
    for (int k = 0; k < 48; k += 4) {
      for (int j = 0; j < 48; j += 4) {
        for (int i = 0; i < 24; i += 4) marks.mark(view, i, j, k);
      }
    }
  }
  field_file::Marks marks;
};

Eigen::Vector3d index_of(const Eigen::Vector3d& mm) { return mm / kTestEdge + Eigen::Vector3d::Constant(23.5); }

TEST(Invented, EndsBetweenTheBricks) {
  const HalfInvented field;
  const Invented invented(field.view, field.marks);
  ASSERT_TRUE(invented.any());
  EXPECT_NEAR(invented.share(), 0.5, 0.02);
  const double r = kTestRadius;
  for (double angle = 0; angle < 6.28; angle += 0.1) {
    const Eigen::Vector3d ring(0, r * std::cos(angle), r * std::sin(angle));
    EXPECT_TRUE(invented.at(index_of(ring - Eigen::Vector3d(0.3, 0, 0)))) << angle;
    EXPECT_FALSE(invented.at(index_of(ring + Eigen::Vector3d(0.3, 0, 0)))) << angle;
  }
  EXPECT_TRUE(invented.at(index_of({-r, 0, 0})));
  EXPECT_FALSE(invented.at(index_of({r, 0, 0})));
  EXPECT_FALSE(Invented(field.view, {}).at(index_of({-r, 0, 0}))) << "without marks";
}

TEST(Hatch, CoversAThird) {
  double sum = 0;
  constexpr int kSide = 400;
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) sum += static_cast<double>(hatch(x, y, 1));
  }
  EXPECT_NEAR(sum / kSide / kSide, 1.0 / 3, 0.02);
}

int purple(const Image& image, int left, int right) {
  int found = 0;
  for (int y = 0; y < image.height() - 86; ++y) {
    for (int x = left; x < right; ++x) {
      const Colour& c = image.at(x, y);
      found += c.r > 1.25F * c.g && c.b > 1.1F * c.g ? 1 : 0;
    }
  }
  return found;
}

TEST(SurfacePicture, HatchesWhatWasInvented) {
  const HalfInvented field;
  SurfaceOptions options{.width = 480, .height = 400, .direction = Direction{0, 0, 'y'}};
  EXPECT_EQ(purple(surface_picture(field.view, options).pixels(), 0, 480), 0);
  options.invented = field.marks;
  const Image image = surface_picture(field.view, options).pixels();
  EXPECT_GT(purple(image, 0, 236), 4000);
  EXPECT_LT(purple(image, 244, 480), 100) << "the other half was scanned";
}

TEST(PointsPicture, DrawsTheRimAndHidesItsFarSide) {
  cloud::OrientedPoints points;  // a square at z = 0, seen from the front
  for (int i = 0; i < 30 * 30; ++i) {
    points.positions.emplace_back(i % 30, i / 30, 0);
    points.normals.emplace_back(0, 0, 1);
  }
  const auto vermilion = [&](double z) {
    PointsOptions options{.direction = {0, 0, 'y'}, .spacing = 2, .mm_per_unit = 0, .rim_length = 20};
    options.rim = {{Eigen::Vector3d(5, 5, z), Eigen::Vector3d(25, 5, z)}};
    const Image image = points_picture(points, options).pixels();
    int found = 0;
    for (int y = 0; y < image.height() - 86; ++y) {
      for (int x = 0; x < image.width(); ++x) {
        const Colour &c = image.at(x, y), &rim = kRimColour;
        found += std::fabs(c.r - rim.r) + std::fabs(c.g - rim.g) + std::fabs(c.b - rim.b) < 0.05F ? 1 : 0;
      }
    }
    return found;
  };
  EXPECT_GT(vermilion(0.1), 250);
  EXPECT_LT(vermilion(-8), 20) << "behind the points it is pale";
}

}  // namespace
}  // namespace isotouch::view
