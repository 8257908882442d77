#include "host/field/nearest.h"

#include <algorithm>
#include <limits>
#include <nanoflann.hpp>

namespace isotouch::field {

namespace {

// nanoflann prunes by sums of rounded numbers and drops ties at the border, so it searches a little further than needed; `addPoint`
// decides.
constexpr double kSlack = 1.0 + 1e-9;

struct Positions {
  const std::vector<Eigen::Vector3d>& at;

  std::size_t kdtree_get_point_count() const { return at.size(); }
  double kdtree_get_pt(std::size_t i, std::size_t axis) const { return at[i][static_cast<Eigen::Index>(axis)]; }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
};

/// Keeps the `capacity` smallest.
class NearestFew {
 public:
  using DistanceType = double;
  NearestFew(std::size_t capacity, std::vector<Neighbour>& found) : capacity_(capacity), found_(found) { found_.clear(); }
  std::size_t size() const { return found_.size(); }
  bool full() const { return found_.size() == capacity_; }
  double worstDist() const { return full() ? found_.back().squared_distance * kSlack : std::numeric_limits<double>::max(); }
  bool addPoint(double squared_distance, std::uint32_t index) {
    const Neighbour candidate{squared_distance, index};
    if (full()) {
      if (!(candidate < found_.back())) return true;
      found_.pop_back();
    }
    found_.insert(std::upper_bound(found_.begin(), found_.end(), candidate), candidate);
    return true;
  }
  void sort() {}  // asked for by nanoflann 1.5 and later; they are in order at any time

 private:
  std::size_t capacity_;
  std::vector<Neighbour>& found_;
};

class Within {
 public:
  using DistanceType = double;
  Within(double radius, std::vector<Neighbour>& found) : squared_radius_(radius * radius), found_(found) { found_.clear(); }
  std::size_t size() const { return found_.size(); }
  bool full() const { return true; }
  double worstDist() const { return squared_radius_ * kSlack; }
  bool addPoint(double squared_distance, std::uint32_t index) {
    if (squared_distance <= squared_radius_) found_.push_back({squared_distance, index});
    return true;
  }
  void sort() { std::sort(found_.begin(), found_.end()); }

 private:
  double squared_radius_;
  std::vector<Neighbour>& found_;
};

}  // namespace

struct Nearest::Tree {
  using Index = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Positions>, Positions, 3, std::uint32_t>;

  explicit Tree(const std::vector<Eigen::Vector3d>& at) : positions{at}, index(3, positions, nanoflann::KDTreeSingleIndexAdaptorParams(8)) {
    index.buildIndex();
  }
  Positions positions;
  Index index;
};

Nearest::Nearest(const std::vector<Eigen::Vector3d>& positions) : tree_(std::make_unique<Tree>(positions)) {}
Nearest::~Nearest() = default;

void Nearest::nearest(const Eigen::Vector3d& point, std::size_t count, std::vector<Neighbour>& found) const {
  NearestFew result(count, found);
  if (count > 0) tree_->index.findNeighbors(result, point.data(), {});
}

void Nearest::within(const Eigen::Vector3d& point, double radius, std::vector<Neighbour>& found) const {
  Within result(radius, found);
  tree_->index.findNeighbors(result, point.data(), {});
  result.sort();  // nanoflann 1.4 does not
}

}  // namespace isotouch::field
