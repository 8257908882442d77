#include "host/field/slope_limit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <tuple>

namespace isotouch::field {
namespace {

using Eigen::Vector3i;
using Place = std::tuple<int, int, int>;  // z, y, x

/// Bricks from 0 to 4 along each axis that `listed` names, with the distance at each sample.
BandField field_of(const std::function<double(const Vector3i&)>& distance, const std::function<bool(const Vector3i&)>& listed) {
  BandField field{{Eigen::Vector3d::Zero(), 1.0, Vector3i::Constant(20)}, 3.0, {}};
  for (int n = 0; n < 125; ++n) {
    Brick brick{{n % 5, n / 5 % 5, n / 25}, {}};
    if (!listed(brick.cell)) continue;
    for (int s = 0; s < 64; ++s)
      brick.distance[static_cast<std::size_t>(s)] = static_cast<float>(distance(4 * brick.cell + Vector3i(s & 3, s >> 2 & 3, s >> 4)));
    field.bricks.push_back(brick);
  }
  return field;
}

std::map<Place, float> samples(const BandField& field) {
  std::map<Place, float> all;
  for (const Brick& brick : field.bricks) {
    for (int s = 0; s < 64; ++s) {
      const Vector3i at = 4 * brick.cell + Vector3i(s & 3, s >> 2 & 3, s >> 4);
      all[{at.z(), at.y(), at.x()}] = std::clamp(brick.distance[static_cast<std::size_t>(s)], -3.0F, 3.0F);
    }
  }
  return all;
}

/// The largest step between two samples face to face; what is not listed is outside, at the band's distance.
float steepest(const BandField& field) {
  const auto all = samples(field);
  float most = 0.0F;
  for (const auto& [place, distance] : all) {
    const auto [z, y, x] = place;
    for (const Place& beside :
         {Place(z, y, x + 1), Place(z, y + 1, x), Place(z + 1, y, x), Place(z, y, x - 1), Place(z, y - 1, x), Place(z - 1, y, x)}) {
      const auto found = all.find(beside);
      most = std::max(most, std::abs(distance - (found == all.end() ? 3.0F : found->second)));
    }
  }
  return most;
}

bool everywhere(const Vector3i&) { return true; }

TEST(LimitSlopes, LeavesATrueDistanceAsItIs) {
  const auto ball = [](const Vector3i& p) { return (p.cast<double>() - Eigen::Vector3d(9.3, 9.7, 10.1)).norm() - 5.4; };
  BandField field = field_of(ball, everywhere);
  const auto before = samples(field);
  ASSERT_LT(steepest(field), 1.0F);
  limit_slopes(field, 1.2);
  EXPECT_EQ(samples(field), before);
}

TEST(LimitSlopes, MakesAJumpARampWithItsZeroInThePlaceOfTheJump) {
  // A cube that is as deep inside as the band reaches, right beside what is as far outside.
  static constexpr int kLow = 6, kHigh = 13;
  const auto inside = [](const Vector3i& p) { return (p.array() >= kLow).all() && (p.array() <= kHigh).all(); };
  BandField field = field_of([&](const Vector3i& p) { return inside(p) ? -3.0 : 3.0; }, everywhere);
  limit_slopes(field, 1.2);
  EXPECT_NEAR(steepest(field), 1.2F, 1e-4F);
  for (const auto& [place, distance] : samples(field)) {
    const auto [z, y, x] = place;
    const Vector3i p(x, y, z);
    EXPECT_EQ(distance < 0.0F, inside(p));
  }
  std::size_t compared = 0;
  for (const auto& [place, distance] : samples(field)) {  // across a side of the cube, away from its edges
    const auto [z, y, x] = place;
    if (y < 9 || y > 10 || z < 9 || z > 10) continue;
    const double way = std::min(std::abs(x - kLow + 0.5), std::abs(x - kHigh - 0.5));
    ASSERT_NEAR(std::abs(distance), std::min(3.0, 1.2 * way), 1e-4) << x;
    ++compared;
  }
  EXPECT_EQ(compared, 80U);
}

TEST(LimitSlopes, ListsTheBricksThatARampReachesInto) {
  // One brick inside, no other listed: its six neighbours must hold the ramp's other half.
  const Vector3i middle(2, 2, 2);
  BandField field = field_of([](const Vector3i&) { return -3.0; }, [&](const Vector3i& cell) { return cell == middle; });
  for (int n = 0; n < 125; ++n) {  // what faces it is outside
    const Vector3i cell(n % 5, n / 5 % 5, n / 25);
    if ((cell - middle).cwiseAbs().sum() != 1) continue;
    Brick brick{cell, {}};
    brick.distance.fill(3.0F);
    field.bricks.push_back(brick);
  }
  const auto by_place = [](const Brick& a, const Brick& b) {
    return std::tuple(a.cell.z(), a.cell.y(), a.cell.x()) < std::tuple(b.cell.z(), b.cell.y(), b.cell.x());
  };
  std::sort(field.bricks.begin(), field.bricks.end(), by_place);
  const std::size_t before = field.bricks.size();
  limit_slopes(field, 1.2);
  EXPECT_NEAR(steepest(field), 1.2F, 1e-4F);
  EXPECT_GT(field.bricks.size(), before);
  EXPECT_LE(field.bricks.size(), 27U);
  EXPECT_TRUE(std::is_sorted(field.bricks.begin(), field.bricks.end(), by_place));
  const auto all = samples(field);
  EXPECT_EQ(std::count_if(all.begin(), all.end(), [](const auto& sample) { return sample.second < 0.0F; }), 64);
}

}  // namespace
}  // namespace isotouch::field
