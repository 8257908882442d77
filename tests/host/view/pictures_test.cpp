/// The finished pictures, each as a whole: what must be in them, at sizes other than the usual one too.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "host/published/build.h"
#include "host/view/caption.h"
#include "host/view/colour_map.h"
#include "host/view/force_picture.h"
#include "host/view/points_picture.h"
#include "host/view/slice_picture.h"
#include "host/view/surface_picture.h"
#include "host/view/touch_view.h"
#include "tests/host/view/sphere_field.h"
#include "tests/support/sanitized.h"

namespace isotouch::view {
namespace {

template <class Test>
int count(const Image& image, const Test& test) {
  int found = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) found += test(image.at(x, y)) ? 1 : 0;
  }
  return found;
}

const auto is_blue = [](const Colour& c) { return c.b > 3 * c.r && c.b > 1.5F * c.g && c.b > 0.05F; };
const auto is_orange = [](const Colour& c) { return c.r > 4 * c.b && c.r > 1.5F * c.g && c.r < 6 * c.g && c.r > 0.05F; };
const auto is_black = [](const Colour& c) { return c.r + c.g + c.b < 0.06F; };

Touch touch_from(const Eigen::Vector3d& out) { return {.proxy = kTestRadius * out, .hip = (kTestRadius - 2) * out, .force = 1.6 * out}; }

TEST(SurfacePicture, ShowsTheTouchWhereverItIs) {
  const SphereField field;
  for (const Eigen::Vector3d& out : test::examples<Eigen::Vector3d>({{-0.6, 0, -0.8}, {0, -1, 0}, {0, 1, 0}})) {
    SurfaceOptions options{.width = 480, .height = 360, .direction = {}, .touch = touch_from(out)};
    const Image image = surface_picture(field.view, options).pixels();
    ASSERT_EQ(image.width(), 480);
    ASSERT_EQ(image.height(), 360);
    EXPECT_GT(count(image, is_blue), 60) << out.transpose();
    EXPECT_GT(count(image, is_orange), 60) << out.transpose();
    const int with_force = count(image, is_black);
    options.touch->force.setZero();
    EXPECT_LT(count(surface_picture(field.view, options).pixels(), is_black) + 60, with_force) << out.transpose();
  }
}

TEST(SurfacePicture, WithoutATouchHasNoMarkers) {
  const SphereField field;
  const Image image =
      surface_picture(field.view, {.width = 400, .height = 320, .direction = Direction{10, 80}, .title = "sphere"}).pixels();
  EXPECT_EQ(count(image, is_blue), 0);
  EXPECT_EQ(count(image, is_orange), 0);
}

TEST(SlicePicture, GoesThroughTheTouchAndShowsItFromTheSide) {
  const SphereField field;
  for (const Eigen::Vector3d& out : test::examples<Eigen::Vector3d>({{0.6, 0.8, 0}, {0.6, 0, 0.8}, {0, -0.6, -0.8}})) {
    const Touch touch = touch_from(out);
    const Image with = slice_picture(field.view, {.touch = touch}).pixels();
    const char axis = out.z() == 0 ? 'z' : out.y() == 0 ? 'y' : 'x';
    const Image without = slice_picture(field.view, {.axis = axis, .at_mm = 0}).pixels();
    int changed = 0, blue = 0;
    for (int y = 90; y < 600; ++y) {  // below the legend
      for (int x = 80; x < 780; ++x) {
        const Colour &a = with.at(x, y), &b = without.at(x, y);
        if (a.r == b.r && a.g == b.g && a.b == b.b) continue;
        ++changed;
        blue += is_blue(a) ? 1 : 0;
      }
    }
    EXPECT_GT(blue, 60) << axis;
    EXPECT_GT(changed, 400) << axis;
    EXPECT_LT(changed, 6000) << "another slice was drawn";
  }
}

TEST(ATouch, IsSeenFromWhereNothingHidesIt) {
  const SphereField field;
  const FieldRays rays(field.view);
  const Direction front{0, 0, 'y'};
  const auto at = [](double degrees) {
    const double angle = degrees * std::numbers::pi / 180;
    return touch_from({std::sin(angle), 0, std::cos(angle)});
  };
  EXPECT_NEAR(view_cost(at(55), front, rays), 0, 1e-6);
  EXPECT_NEAR(view_cost(at(20), front, rays), 35, 1e-6);
  EXPECT_GT(view_cost(at(150), front, rays), 1000);
  for (const double degrees : {20.0, 55.0, 90.0, 150.0})
    EXPECT_LE(slant_cost(at(degrees), front), view_cost(at(degrees), front, rays)) << degrees;
  for (const double degrees : {0.0, 90.0, 180.0, 270.0}) {
    EXPECT_LT(view_cost(at(degrees), direction_showing(at(degrees), rays, 'y'), rays), 30) << degrees;
  }
}

TEST(SlicePicture, DrawsTheSurfaceWhereTheSliceMeetsIt) {
  const SphereField field;
  // Half the width of the dark line's circle, pixels, in the row through the middle.
  const auto radius = [&](char axis, double at) {
    const Image image = slice_picture(field.view, {.axis = axis, .at_mm = at}).pixels();
    int first = -1, last = -1;
    for (int x = 80; x < 780; ++x) {
      const Colour c = image.at(x, (24 + 720 - 112) / 2);
      if (c.r + c.g + c.b > 0.08F) continue;
      if (first < 0) first = x;
      last = x;
    }
    EXPECT_NEAR(first - 78, 781 - last, 3) << "the sphere is in the middle";
    return (last - first) / 2.0;
  };
  for (const char axis : {'x', 'y', 'z'}) {
    const double whole = radius(axis, 0);
    EXPECT_GT(whole, 100);
    EXPECT_NEAR(radius(axis, 0.6 * kTestRadius) / whole, 0.8, 0.01) << axis;
    EXPECT_NEAR(radius(axis, -0.8 * kTestRadius) / whole, 0.6, 0.01) << axis;
  }
}

// A published field is a whole level outside, up to the border of its grid; beyond the border it is far outside.
TEST(SlicePicture, AConstantLevelHasNoLinesAndTheGridABorder) {
  published::LevelField levels(SphereField::field().grid, published::kOutsideLevel);
  for (std::size_t n = 0; n < levels.values.size(); ++n) {
    const int i = static_cast<int>(n);
    const Eigen::Vector3i node(i % 48, i / 48 % 48, i / (48 * 48));
    const double layers = std::ceil((levels.grid.position(node).norm() - kTestRadius) / kTestEdge);
    levels.values[n] = static_cast<std::int8_t>(std::clamp<double>(layers, published::kDeepestLevel, published::kOutsideLevel));
  }
  encoding::FieldInfo info;
  info.method = Method::kPublished;
  const field_file::Image written = encoding::write_image(published::to_band_field(levels), info);
  const FieldView view = *FieldView::parse(written.bytes());
  const Image image = slice_picture(view, {.axis = 'z', .at_mm = 0}).pixels();
  const Colour level = distance_colour(1.0 / 7), border = image.at(90, 360);
  const auto same = [](const Colour& a, const Colour& b) {
    return std::fabs(a.r - b.r) < 0.02F && std::fabs(a.g - b.g) < 0.02F && std::fabs(a.b - b.b) < 0.02F;
  };
  EXPECT_GT(count(image, [&](const Colour& c) { return same(c, level); }), 20'000);
  EXPECT_GT(border.r, 0.8F) << "beyond the grid it is far outside, not blue";
}

TEST(SlicePicture, BesideTheObjectIsEmptyButDrawn) {
  const SphereField field;
  const Image image = slice_picture(field.view, {.width = 400, .height = 320, .axis = 'z', .at_mm = 500}).pixels();
  EXPECT_EQ(image.width(), 400);
}

TEST(DistanceColours, AreWarmInsideAndGrowDarkerBothWays) {
  const auto sum = [](Colour c) { return c.r + c.g + c.b; };
  for (double v = 0.05; v < 1; v += 0.05) {
    EXPECT_GT(distance_colour(-v).r, distance_colour(-v).b);
    EXPECT_LT(distance_colour(v).r, distance_colour(v).b);
    EXPECT_LT(sum(distance_colour(v)), sum(distance_colour(v - 0.05)));
    EXPECT_LT(sum(distance_colour(-v)), sum(distance_colour(-v + 0.05)));
  }
  EXPECT_EQ(sum(distance_colour(7)), sum(distance_colour(1)));
}

TEST(PointsPicture, FrontDiscsAreBlueAndThoseFromBehindPale) {
  cloud::OrientedPoints points;
  for (int i = 0; i < 25; ++i) {
    points.positions.emplace_back(i % 5, i / 5, 0);
    points.normals.emplace_back(0, 0, 1);
  }
  const auto blue = [&] {
    const Image image =
        points_picture(points, {.width = 480, .height = 360, .direction = {0, 0, 'y'}, .spacing = 1, .mm_per_unit = 0}).pixels();
    return count(image, [](const Colour& c) { return c.b > 1.6F * c.r && c.b > 0.1F; });
  };
  EXPECT_GT(blue(), 20'000);
  for (Eigen::Vector3d& normal : points.normals) normal = -normal;
  EXPECT_LT(blue(), 200);
}

/// Half a second in contact of two.
ForceCurve half_sine() {
  ForceCurve curve{"felt", {}, {}};
  for (int i = 0; i < 1000; ++i) {
    curve.time_s.push_back(i * 0.001);
    curve.force.emplace_back(std::max(0.0, std::sin(i * 0.01)), 0, 0);
  }
  return curve;
}

TEST(ForcePicture, WithAndWithoutAnotherCurve) {
  const ForceCurve curve = half_sine();
  EXPECT_EQ(force_picture(curve, nullptr, {.width = 640, .height = 400}).width(), 640);
  EXPECT_EQ(force_picture(curve, &curve, {}).height(), 720);
  ForceCurve shorter = curve;
  shorter.time_s.resize(10), shorter.force.resize(10);
  EXPECT_EQ(force_picture(curve, &shorter, {}).height(), 720);
  EXPECT_EQ(force_picture({}, nullptr, {}).height(), 720) << "an empty trace";
}

TEST(ForcePicture, ForcesOfOneSizeInTwoDirectionsDiffer) {
  const ForceCurve one{"one", {0, 0.001, 0.002}, {{1, 0, 0}, {0, 2, 0}, {0, 0, 1}}};
  const ForceCurve other{"other", {0, 0.001}, {{-1, 0, 0}, {0, 2, 0}}};
  EXPECT_EQ(force_differences(one, other), (std::vector<double>{2000, 0}));
  EXPECT_EQ(force_differences(other, one), (std::vector<double>{2000, 0}));
  EXPECT_TRUE(force_differences({}, one).empty());
}

TEST(ForcePicture, ShadesTheContactsAndDrawsALimitThatIsNear) {
  const auto is_green = [](const Colour& c) { return c.g > 1.05F * c.r && c.g > 1.05F * c.b && c.r > 0.5F; };
  const auto is_vermilion = [](const Colour& c) { return c.r > 4 * c.b && c.r > 3 * c.g && c.r > 0.3F; };
  const ForceCurve curve = half_sine();
  const auto always = [&](double limit) { return std::vector<double>(curve.time_s.size(), limit); };
  const Image without = force_picture(curve, nullptr, {}).pixels();
  EXPECT_EQ(count(without, is_green), 0);
  EXPECT_EQ(count(without, is_vermilion), 0);
  const Image with = force_picture(curve, nullptr, {.contacts = {{0, 0.314}, {0.628, 0.942}}, .limits_n = always(1.2)}).pixels();
  EXPECT_GT(count(with, is_green), 100'000);
  EXPECT_GT(count(with, is_vermilion), 500);
  EXPECT_EQ(count(force_picture(curve, nullptr, {.limits_n = always(8)}).pixels(), is_vermilion), 0) << "far above: in words";
  std::vector<double> lowered = always(8);
  std::fill_n(lowered.begin(), 10, 4);
  EXPECT_GT(count(force_picture(curve, nullptr, {.limits_n = lowered}).pixels(), is_vermilion), 500) << "it changes: a line, however far";
  ForceCurve begun{"begun", {}, {}};  // a tenth of the other one
  begun.time_s.assign(curve.time_s.begin(), curve.time_s.begin() + static_cast<std::ptrdiff_t>(curve.time_s.size() / 10));
  begun.force.assign(curve.force.begin(), curve.force.begin() + static_cast<std::ptrdiff_t>(begun.time_s.size()));
  const auto limited = [&](std::vector<double> limits) { return force_picture(begun, &curve, {.limits_n = std::move(limits)}).pixels(); };
  EXPECT_GT(count(limited(std::vector<double>(begun.time_s.size(), 1.2)), is_vermilion), count(limited({}), is_vermilion) + 400)
      << "to the end of the longer one";
}

TEST(Numbers, AreShortAndHaveNoNegativeZero) {
  EXPECT_EQ(number(12.5, 3), "12.5");
  EXPECT_EQ(number(12, 0), "12");
  EXPECT_EQ(number(120, 2), "120");
  EXPECT_EQ(number(-0.0001, 2), "0");
  EXPECT_EQ(number(-1.25, 2), "−1.25");
  EXPECT_EQ(significant(0.0023149, 3), "0.00231");
  EXPECT_EQ(significant(7.176, 3), "7.18");
  EXPECT_EQ(significant(0, 3), "0");
  EXPECT_EQ(round_length(7.3), 5);
  EXPECT_EQ(round_length(0.29), 0.2);
  EXPECT_EQ(round_length(1), 1);
}

}  // namespace
}  // namespace isotouch::view
