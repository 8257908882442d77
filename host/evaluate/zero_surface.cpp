#include "host/evaluate/zero_surface.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <numeric>
#include <utility>

#include "firmware/core/field_sampler.h"
#include "host/evaluate/stored_surface.h"
#include "host/field/parallel.h"
#include "host/to_double.h"

namespace isotouch::evaluate {

namespace {

using Eigen::Vector3d;
using Eigen::Vector3i;
using namespace image_layout;

constexpr int kSide = 8;                        // half voxels along a brick
constexpr int kNodes = kSide + 1;               // lattice points along it
constexpr int kReach = 7;                       // coefficients that they touch, from one before the brick
constexpr std::int32_t kScale = 512 << 12;      // of a lattice value: 8³ from the weights, 12 fraction bits
constexpr std::int32_t kUnsure = kScale >> 13;  // twice the core's own error, sample_field
constexpr std::int32_t kEdgeSteps = 1 << 15;    // the core's resolution along half a voxel
constexpr std::int32_t kApartSteps = kEdgeSteps / 256;

/// A lattice edge that the surface crosses: from a lattice point, along every axis that has a bit in `along`.
struct Crossing {
  std::uint64_t key;  // of the edge: number of its lower lattice point * 8 + along
  std::int32_t lower, upper;

  bool operator<(const Crossing& o) const { return key < o.key; }
  bool operator==(const Crossing& o) const { return key == o.key; }
};

struct Part {
  std::vector<Crossing> crossings;                  // by key, each once
  std::vector<std::array<std::uint32_t, 3>> faces;  // indices into crossings
};

/// Numbers for the points of the whole lattice.
class Lattice {
 public:
  explicit Lattice(const FieldView& field) {
    for (std::size_t a = 0; a < 3; ++a) size_[a] = 2 * (static_cast<std::uint64_t>(field.size[a]) + 8);
  }
  std::uint64_t number(const Vector3i& p) const {
    return (static_cast<std::uint64_t>(p.z()) * size_[1] + static_cast<std::uint64_t>(p.y())) * size_[0] +
           static_cast<std::uint64_t>(p.x());
  }
  Vector3i point(std::uint64_t number) const {
    return {static_cast<int>(number % size_[0]), static_cast<int>(number / size_[0] % size_[1]),
            static_cast<int>(number / size_[0] / size_[1])};
  }

 private:
  std::array<std::uint64_t, 3> size_{};
};

Vector3i axes(std::uint64_t along) {
  return {static_cast<int>(along & 1), static_cast<int>((along >> 1) & 1), static_cast<int>((along >> 2) & 1)};
}

/// The core's distance `steps` of 2^-16 voxel from a lattice point along an edge; 2^-16 voxel.
std::int32_t core_distance(const FieldView& field, const Vector3i& point, const Vector3i& along, std::int32_t steps) {
  const auto at = [&](int a) { return Voxel::from_raw(point[a] * kEdgeSteps + along[a] * steps); };
  return core::sample_field(field, {at(0), at(1), at(2)}).distance.raw();
}

/// The field at the 9³ lattice points of one brick, times kScale: exact.
class BrickValues {
 public:
  /// False when the numbers that reach into the brick have one sign, so that the field has it too.
  bool load(const FieldView& field, const Vector3i& cell) {
    std::array<std::int32_t, kReach * kReach * kReach> block;
    std::int32_t low = 0, high = 0;
    for (int n = 0; n < kReach * kReach * kReach; ++n) {
      const Vector3i sample = 4 * cell + Vector3i(n % kReach, n / kReach % kReach, n / kReach / kReach) - Vector3i::Ones();
      const auto inside_grid = [&](int a) { return std::clamp(sample[a], 0, field.size[static_cast<std::size_t>(a)] - 1); };
      const std::int32_t c = field.coefficient(inside_grid(0), inside_grid(1), inside_grid(2));
      block[static_cast<std::size_t>(n)] = c;
      low = std::min(low, c - 1);  // zero counts as inside
      high = std::max(high, c);
    }
    if (low >= 0 || high <= 0) return false;
    const std::int32_t beside = field.interpolation == Interpolation::kSpline ? 1 : 0;
    const auto along_x = expand<kReach * kReach>(block, beside);    // axes rotate: y z x
    const auto along_y = expand<kReach * kNodes>(along_x, beside);  // z x y
    values_ = expand<kNodes * kNodes>(along_y, beside);             // x y z
    for (int z = 0; z < kNodes; ++z) {
      for (int y = 0; y < kNodes; ++y) {
        for (int x = 0; x < kNodes; ++x) {
          std::int32_t& value = values_[index(x, y, z)];
          if (std::abs(value) > kUnsure) continue;
          const std::int32_t core = core_distance(field, kSide * cell + Vector3i(x, y, z), Vector3i::Zero(), 0);
          value = core * (kScale >> 16);
        }
      }
    }
    return true;
  }
  static std::size_t index(int x, int y, int z) {
    return (static_cast<std::size_t>(z) * kNodes + static_cast<std::size_t>(y)) * kNodes + static_cast<std::size_t>(x);
  }
  std::int32_t at(const Vector3i& p) const { return values_[index(p.x(), p.y(), p.z())]; }

 private:
  /// Rows of seven numbers → lattice values, eight times too large. Between two samples the weights are 1/2 1/2. At a sample they are the
  /// spline's, 1/8 3/4 1/8, or, where what is beside it counts nothing, 1. The row's axis moves to the back, so that three calls do all axes.
  template <std::size_t kRows>
  static std::array<std::int32_t, kRows * kNodes> expand(const std::array<std::int32_t, kRows * kReach>& from, std::int32_t beside) {
    std::array<std::int32_t, kRows * kNodes> to;
    for (std::size_t row = 0; row < kRows; ++row) {
      const std::int32_t* c = &from[row * kReach];
      for (std::size_t n = 0; n < kNodes; ++n) {
        const std::size_t i = n / 2;
        to[n * kRows + row] = n % 2 == 0 ? beside * (c[i] + c[i + 2]) + (8 - 2 * beside) * c[i + 1] : 4 * (c[i + 1] + c[i + 2]);
      }
    }
    return to;
  }

  std::array<std::int32_t, kNodes * kNodes * kNodes> values_;
};

/// Triangles of one brick, cube by cube.
class BrickSurface {
 public:
  BrickSurface(const Lattice& lattice, const Vector3i& cell, const BrickValues& values, Part& part)
      : lattice_(lattice), first_(kSide * cell), values_(values), part_(part) {}

  void add_all() {
    for (int z = 0; z < kSide; ++z) {
      for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) add_cube({x, y, z});
      }
    }
    // Crossings were noted once for each corner of each triangle: now once each.
    std::vector<Crossing> all = std::move(part_.crossings);
    part_.crossings = all;
    std::sort(part_.crossings.begin(), part_.crossings.end());
    part_.crossings.erase(std::unique(part_.crossings.begin(), part_.crossings.end()), part_.crossings.end());
    part_.faces.resize(all.size() / 3);
    for (std::size_t i = 0; i < all.size(); ++i) {
      const auto found = std::lower_bound(part_.crossings.begin(), part_.crossings.end(), all[i]);
      part_.faces[i / 3][i % 3] = static_cast<std::uint32_t>(found - part_.crossings.begin());
    }
  }

 private:
  struct Corner {
    std::uint64_t along;  // from the cube's lowest corner
    std::int32_t value;
    bool outside() const { return value > 0; }
  };

  void add_cube(const Vector3i& cube) {
    std::array<Corner, 8> corners;
    int outside = 0;
    for (std::uint64_t n = 0; n < 8; ++n) {
      corners[n] = {n, values_.at(cube + axes(n))};
      outside += corners[n].outside() ? 1 : 0;
    }
    if (outside == 0 || outside == 8) return;
    // Six ways from corner 0 to corner 7 along the axes; each is the chain of a tetrahedron's corners. The first three turn right-handed.
    constexpr std::array<std::array<std::uint64_t, 2>, 6> kWays = {{{1, 3}, {2, 6}, {4, 5}, {1, 5}, {2, 3}, {4, 6}}};
    for (std::size_t way = 0; way < 6; ++way) {
      std::array<Corner, 4> chain = {corners[0], corners[kWays[way][0]], corners[kWays[way][1]], corners[7]};
      if (way >= 3) std::swap(chain[2], chain[3]);
      add_tetrahedron(cube, chain);
    }
  }

  /// corners   right-handed: seen from the first, the others turn clockwise
  void add_tetrahedron(const Vector3i& cube, std::array<Corner, 4> corners) {
    const auto outside = std::count_if(corners.begin(), corners.end(), [](const Corner& c) { return c.outside(); });
    if (outside == 0 || outside == 4) return;
    // Even permutations only: inside first, where only one is outside that one first.
    const bool first_is = outside == 1;
    const auto belongs_first = [&](const Corner& c) { return c.outside() == first_is; };
    if (!belongs_first(corners[0])) {
      const auto found = std::find_if(corners.begin(), corners.end(), belongs_first) - corners.begin();
      const auto other = static_cast<std::size_t>(found == 3 ? 1 : found + 1);
      const auto third = static_cast<std::size_t>(6) - other - static_cast<std::size_t>(found);
      corners = {corners[static_cast<std::size_t>(found)], corners[0], corners[third], corners[other]};
    }
    const auto& [a, b0, c0, d0] = corners;
    if (outside == 2) {  // bring the second inside corner to the second place by turning the other three
      Corner b = b0, c = c0, d = d0;
      while (b.outside()) {
        const Corner last = d;
        d = b, b = c, c = last;
      }
      add_triangle(cube, {a, c}, {a, d}, {b, d});
      add_triangle(cube, {a, c}, {b, d}, {b, c});
    } else if (first_is) {
      add_triangle(cube, {a, b0}, {a, d0}, {a, c0});
    } else {
      add_triangle(cube, {a, b0}, {a, c0}, {a, d0});
    }
  }

  using Edge = std::pair<Corner, Corner>;
  void add_triangle(const Vector3i& cube, const Edge& a, const Edge& b, const Edge& c) {
    for (const auto& [p, q] : {a, b, c}) {
      const Corner& lower = p.along < q.along ? p : q;  // along a chain the lower has a part of the other's bits
      const Corner& upper = p.along < q.along ? q : p;
      const std::uint64_t number = lattice_.number(first_ + cube + axes(lower.along));
      part_.crossings.push_back({number * 8 + (upper.along - lower.along), lower.value, upper.value});
    }
  }

  const Lattice& lattice_;
  Vector3i first_;
  const BrickValues& values_;
  Part& part_;
};

/// Bricks, in the order z, y, x, around which coefficients of both signs can be.
std::vector<Vector3i> candidate_bricks(const FieldView& field) {
  enum Sign : std::uint8_t { kNone = 0, kNegative = 1, kPositive = 2 };
  std::vector<std::uint8_t> signs(field.brick_count, kNone);
  for (std::size_t brick = 0; brick < signs.size(); ++brick) {
    for (std::size_t n = 0; n < kSamplesPerBrick; ++n) {
      signs[brick] = static_cast<std::uint8_t>(signs[brick] | (field.bricks[brick * kSamplesPerBrick + n] > 0 ? kPositive : kNegative));
    }
  }
  const Vector3i nodes(field.root_size[0], field.root_size[1], field.root_size[2]);
  const auto node_at = [&](const Vector3i& p) { return field.root[(p.z() * nodes.y() + p.y()) * nodes.x() + p.x()]; };
  const Vector3i bricks = 4 * nodes;
  const auto sign_at = [&](const Vector3i& p) {
    const std::uint32_t node = node_at(p / 4);
    const int slot = (p.z() & 3) << 4 | (p.y() & 3) << 2 | (p.x() & 3);
    return signs[field.nodes[node * kBricksPerNode + static_cast<std::size_t>(slot)]];
  };
  /// Something about all places within one step of `at`, as one number of bits.
  const auto around = [](const Vector3i& at, const Vector3i& size, const auto& bits) {
    std::uint8_t seen = 0;
    for (int n = 0; n < 27; ++n) {
      const Vector3i p = at + Vector3i(n % 3, n / 3 % 3, n / 9) - Vector3i::Ones();
      if ((p.array() >= 0).all() && (p.array() < size.array()).all()) seen = static_cast<std::uint8_t>(seen | bits(p));
    }
    return seen;
  };
  std::vector<Vector3i> found;
  Vector3i node;
  for (node.z() = 0; node.z() < nodes.z(); ++node.z()) {
    for (node.y() = 0; node.y() < nodes.y(); ++node.y()) {
      for (node.x() = 0; node.x() < nodes.x(); ++node.x()) {
        const std::uint8_t kinds = around(node, nodes, [&](const Vector3i& p) { return 1U << std::min(node_at(p), 2U); });
        if (kinds == 1U << kOutside || kinds == 1U << kInside) continue;
        for (int n = 0; n < 64; ++n) {
          const Vector3i cell = 4 * node + Vector3i(n & 3, (n >> 2) & 3, n >> 4);
          const bool in_grid = 4 * cell.x() < field.size[0] && 4 * cell.y() < field.size[1] && 4 * cell.z() < field.size[2];
          if (in_grid && around(cell, bricks, sign_at) == (kNegative | kPositive)) found.push_back(cell);
        }
      }
    }
  }
  return found;
}

/// Where the core finds zero along the edge, in 2^-16 voxel from its lower end: false position that counts an end which stays twice half.
std::int32_t zero_along(const FieldView& field, const Vector3i& point, const Vector3i& along, const Crossing& crossing) {
  constexpr std::int32_t kNear = 2;  // 2^-15 voxel
  struct End {
    std::int32_t at;
    double distance;
  };
  End low{0, static_cast<double>(crossing.lower)}, high{kEdgeSteps, static_cast<double>(crossing.upper)};
  const bool low_outside = low.distance > 0;
  int stayed = 0;
  while (high.at - low.at > 1) {
    const double share = low.distance / (low.distance - high.distance);
    const std::int32_t at = std::clamp(low.at + static_cast<std::int32_t>(share * (high.at - low.at)), low.at + 1, high.at - 1);
    const std::int32_t distance = core_distance(field, point, along, at);
    if (std::abs(distance) <= kNear) return at;
    const End here{at, static_cast<double>(distance) * (kScale >> 16)};
    if ((distance > 0) == low_outside) {
      low = here;
      if (stayed == 1) high.distance /= 2;
      stayed = 1;
    } else {
      high = here;
      if (stayed == -1) low.distance /= 2;
      stayed = -1;
    }
  }
  return low_outside ? high.at : low.at;
}

}  // namespace

cloud::TriangleMesh zero_surface(const FieldView& field, Corners corners) {
  require_stored_surface(field);
  const std::vector<Vector3i> bricks = candidate_bricks(field);
  const Lattice lattice(field);
  std::vector<Part> parts(bricks.size());
  field::in_parallel(bricks.size(), 16, [&](std::size_t begin, std::size_t end) {
    BrickValues values;
    for (std::size_t i = begin; i < end; ++i) {
      if (values.load(field, bricks[i])) BrickSurface(lattice, bricks[i], values, parts[i]).add_all();
    }
  });

  std::vector<Crossing> crossings;
  for (const Part& part : parts) crossings.insert(crossings.end(), part.crossings.begin(), part.crossings.end());
  std::sort(crossings.begin(), crossings.end());
  crossings.erase(std::unique(crossings.begin(), crossings.end()), crossings.end());

  cloud::TriangleMesh surface;
  surface.vertices.resize(crossings.size());
  const Vector3d origin = to_double(field.origin);
  const double edge = to_double(field.edge);
  const std::int32_t margin = corners == Corners::kApart ? kApartSteps : 0;
  field::in_parallel(crossings.size(), 4096, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Vector3i point = lattice.point(crossings[i].key / 8);
      const Vector3i along = axes(crossings[i].key & 7);
      const std::int32_t zero = std::clamp(zero_along(field, point, along, crossings[i]), margin, kEdgeSteps - margin);
      const Vector3i steps = point * kEdgeSteps + along * zero;
      surface.vertices[i] = origin + edge / 65536 * steps.cast<double>();
    }
  });
  std::vector<std::uint32_t> numbers;
  for (const Part& part : parts) {
    numbers.clear();
    for (const Crossing& crossing : part.crossings) {
      numbers.push_back(static_cast<std::uint32_t>(std::lower_bound(crossings.begin(), crossings.end(), crossing) - crossings.begin()));
    }
    for (const auto& [a, b, c] : part.faces) surface.faces.push_back({numbers[a], numbers[b], numbers[c]});
  }
  return surface;
}

std::vector<Piece> pieces(const cloud::TriangleMesh& surface) {
  const std::vector<std::uint32_t> root = cloud::pieces_of_vertices(surface);
  std::vector<Piece> all(surface.vertices.size());
  std::vector<bool> present(surface.vertices.size(), false);
  for (const auto& [a, b, c] : surface.faces) {
    const std::uint32_t first = root[a];
    present[first] = true;
    const Vector3d& origin = surface.vertices[first];  // near the piece, so that little cancels
    const Vector3d p = surface.vertices[a] - origin, q = surface.vertices[b] - origin, r = surface.vertices[c] - origin;
    all[first].volume += p.dot(q.cross(r)) / 6;
    all[first].area += (q - p).cross(r - p).norm() / 2;
    all[first].place = origin;
  }
  std::vector<Piece> found;
  for (std::size_t v = 0; v < all.size(); ++v) {
    if (present[v]) found.push_back(all[v]);
  }
  std::stable_sort(found.begin(), found.end(), [](const Piece& a, const Piece& b) { return std::abs(a.volume) > std::abs(b.volume); });
  return found;
}

double volume(const std::vector<Piece>& pieces) {
  return std::accumulate(pieces.begin(), pieces.end(), 0.0, [](double sum, const Piece& piece) { return sum + piece.volume; });
}

double area(const std::vector<Piece>& pieces) {
  return std::accumulate(pieces.begin(), pieces.end(), 0.0, [](double sum, const Piece& piece) { return sum + piece.area; });
}

}  // namespace isotouch::evaluate
