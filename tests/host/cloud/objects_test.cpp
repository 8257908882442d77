#include "host/cloud/objects.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

namespace isotouch::cloud {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3i;

/// A body on a grid of one unit, with one voxel of outside all round.
class Voxels {
 public:
  explicit Voxels(const Object& object)
      : object_(object), size_((object.high - object.low).array().ceil().cast<int>().matrix() + Vector3i::Constant(3)) {
    inside_.assign(static_cast<std::size_t>(size_.prod()), 0);
    fill(Vector3i::Zero(), size_);
  }

  std::size_t count(int what) const { return static_cast<std::size_t>(std::count(inside_.begin(), inside_.end(), what)); }

  /// The longest extent of the inside along each axis.
  Vector3i extent() const {
    Vector3i low = size_;
    Vector3i high = Vector3i::Zero();
    for (int z = 0; z < size_.z(); ++z) {
      for (int y = 0; y < size_.y(); ++y) {
        for (int x = 0; x < size_.x(); ++x) {
          if (inside_[index({x, y, z})] == 0) continue;
          low = low.cwiseMin(Vector3i(x, y, z));
          high = high.cwiseMax(Vector3i(x, y, z));
        }
      }
    }
    return high - low + Vector3i::Ones();
  }

  /// The number of pieces, joined through faces, of the inside (1) or the outside (0).
  int pieces(signed char of) {
    int found = 0;
    const signed char visited = static_cast<signed char>(of - 10);
    std::vector<Vector3i> open;
    for (int z = 0; z < size_.z(); ++z) {
      for (int y = 0; y < size_.y(); ++y) {
        for (int x = 0; x < size_.x(); ++x) {
          if (inside_[index({x, y, z})] != of) continue;
          ++found;
          open = {{x, y, z}};
          inside_[index({x, y, z})] = visited;
          while (!open.empty()) {
            const Vector3i here = open.back();
            open.pop_back();
            for (int axis = 0; axis < 3; ++axis) {
              for (const int step : {-1, 1}) {
                Vector3i there = here;
                there[axis] += step;
                if (there[axis] < 0 || there[axis] >= size_[axis] || inside_[index(there)] != of) continue;
                inside_[index(there)] = visited;
                open.push_back(there);
              }
            }
          }
        }
      }
    }
    return found;
  }

 private:
  std::size_t index(const Vector3i& v) const { return static_cast<std::size_t>((v.z() * size_.y() + v.y()) * size_.x() + v.x()); }

  /// Fills a block at once where the distance says that it lies on one side, else its halves.
  void fill(const Vector3i& from, const Vector3i& to) {
    const Vector3d a = object_.low + from.cast<double>() - Vector3d::Ones();
    const Vector3d b = object_.low + to.cast<double>() - Vector3d::Constant(2.0);  // the block's first and last voxel
    const double distance = object_.body(0.5 * (a + b)).distance;
    const Vector3i extent = to - from;
    if (extent.prod() == 1 || std::abs(distance) > 0.5 * (b - a).norm()) {
      if (distance >= 0.0) return;
      for (int z = from.z(); z < to.z(); ++z) {
        for (int y = from.y(); y < to.y(); ++y) {
          for (int x = from.x(); x < to.x(); ++x) inside_[index({x, y, z})] = 1;
        }
      }
      return;
    }
    int longest = 0;
    extent.maxCoeff(&longest);
    Vector3i middle_to = to;
    Vector3i middle_from = from;
    middle_to[longest] = middle_from[longest] = from[longest] + extent[longest] / 2;
    fill(from, middle_to);
    fill(middle_from, to);
  }

  const Object& object_;
  Vector3i size_;
  std::vector<signed char> inside_;
};

struct Published {
  double inside_nodes;
  std::array<double, 3> grid;  ///< 0 where the paper names none
};

TEST(ObjectsHeavy, AreClosedBodiesOfOnePieceInThePublishedSizes) {
  const std::map<std::string, Published> published = {{"hydrant", {586222, {0, 187, 0}}},
                                                      {"owl", {824436, {186, 173, 87}}},
                                                      {"boy", {304072, {126, 187, 72}}},
                                                      {"bomberman", {1129209, {0, 187, 0}}},
                                                      {"jaguar", {134987, {186, 0, 0}}}};
  ASSERT_EQ(characters().size(), published.size());
  for (const Object& object : characters()) {
    Voxels voxels(object);
    const Published& paper = published.at(object.name);
    EXPECT_NEAR(static_cast<double>(voxels.count(1)) / paper.inside_nodes, 1.0, 0.05) << object.name;
    const Vector3i extent = voxels.extent();
    for (int axis = 0; axis < 3; ++axis) {
      const double expected = paper.grid[static_cast<std::size_t>(axis)];
      if (expected == 0.0) continue;
      EXPECT_NEAR(extent[axis], expected, 4.0) << object.name << ", axis " << axis;
    }
    EXPECT_EQ(voxels.pieces(1), 1) << object.name << " falls apart";
    EXPECT_EQ(voxels.pieces(0), 1) << object.name << " has a hollow";
  }
}

}  // namespace
}  // namespace isotouch::cloud
