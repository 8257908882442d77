#include "host/field/open_rim.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <vector>

#include "host/field/angle.h"
#include "host/field/parallel.h"

namespace isotouch::field {

namespace {

using Eigen::Vector3d;

constexpr double kGap = 140 * std::numbers::pi / 180;
constexpr double kTurned = 0.5;      // cosine: a neighbour whose normal is farther off shows that the surface turns away
constexpr double kBehind = 0.5;      // spacings: one that far behind, with its back to the sample, is the other face of a thin wall
constexpr std::size_t kFewest = 12;  // samples a rim

/// The eighth of the plane in which a place lies, counted round the origin.
unsigned octant(double x, double y) {
  if (y < 0) return 4 + octant(-x, -y);
  if (x < 0) return 2 + octant(y, -x);
  return x < y ? 1 : 0;
}

/// The widest sector, as an angle, that the neighbours leave empty in the sample's tangent plane; 0 where one of them lies round an edge, or where
/// it is narrower than kGap.
double widest_gap(const Scan& scan, std::size_t sample) {
  const Vector3d& normal = scan.normals()[sample];
  int least = 0;
  normal.cwiseAbs().minCoeff(&least);
  const Vector3d u = normal.cross(Vector3d::Unit(least)).normalized();
  const Vector3d v = normal.cross(u);
  std::array<std::array<double, 2>, Scan::kListed> places;  // along u and v
  std::size_t count = 0;
  unsigned octants = 0;  // in which there are any
  for (const Neighbour& neighbour : scan.around(sample)) {
    if (neighbour.index == sample) continue;
    const Vector3d step = scan.positions()[neighbour.index] - scan.positions()[sample];
    const double alike = scan.normals()[neighbour.index].dot(normal);
    if (alike < -kTurned && std::abs(step.dot(normal)) > kBehind * scan.spacing(sample)) continue;
    if (alike < kTurned) return 0;
    places[count] = {step.dot(u), step.dot(v)};
    octants |= 1U << octant(places[count][0], places[count][1]);
    ++count;
  }
  const unsigned empty = ~octants & 0xFFU;
  if ((empty & (empty << 1 | empty >> 7)) == 0) return 0;  // nowhere two in a row: no gap is wider than three octants
  std::array<double, Scan::kListed> angles{};
  for (std::size_t i = 0; i < count; ++i) angles[i] = angle_of(places[i][1], places[i][0]);
  if (count == 0) return 0;
  const auto end = angles.begin() + static_cast<std::ptrdiff_t>(count);
  std::sort(angles.begin(), end);
  double widest = angles[0] + 2 * std::numbers::pi - angles[count - 1];
  for (std::size_t i = 1; i < count; ++i) widest = std::max(widest, angles[i] - angles[i - 1]);
  return widest;
}

/// Two neighbours on a rim.
struct Link {
  double squared_length;
  std::uint32_t a, b;
  auto operator<=>(const Link&) const = default;
};

/// Samples that hang together.
struct Chain {
  std::size_t samples = 0;
  double length = 0;
  double last = 0;  ///< the longest link, which stands for the one that closes the ring
  Vector3d sum = Vector3d::Zero(), normals = Vector3d::Zero();
};

}  // namespace

OpenRim open_rim(const Scan& scan) {
  std::vector<std::uint8_t> on_rim(scan.size());
  in_parallel(scan.size(), 256, [&](std::size_t begin, std::size_t end) {
    for (const std::uint32_t i : scan.together(begin, end)) on_rim[i] = widest_gap(scan, i) > kGap ? 1 : 0;
  });
  std::vector<Link> links;
  for (std::uint32_t i = 0; i < on_rim.size(); ++i) {
    if (on_rim[i] == 0) continue;
    for (const Neighbour& neighbour : scan.around(i)) {
      if (neighbour.index != i && on_rim[neighbour.index] != 0)
        links.push_back({neighbour.squared_distance, std::min(i, neighbour.index), std::max(i, neighbour.index)});
    }
  }
  std::sort(links.begin(), links.end());
  std::vector<std::uint32_t> above(scan.size());
  std::iota(above.begin(), above.end(), 0U);
  const auto root = [&](std::uint32_t i) {
    while (above[i] != i) i = above[i] = above[above[i]];
    return i;
  };
  std::vector<Chain> chains(scan.size());
  std::vector<Link> joined, closing;
  for (const Link& link : links) {
    const std::uint32_t a = root(link.a), b = root(link.b);
    if (a == b) {
      closing.push_back(link);
      continue;
    }
    above[b] = a;
    joined.push_back(link);
    chains[a].last = std::sqrt(link.squared_length);
    chains[a].length += chains[b].length + chains[a].last;
  }
  for (std::uint32_t i = 0; i < on_rim.size(); ++i) {
    if (on_rim[i] == 0) continue;
    Chain& chain = chains[root(i)];
    ++chain.samples;
    chain.sum += scan.positions()[i];
    chain.normals += scan.normals()[i];
  }
  OpenRim rim;
  std::uint32_t longest = 0;
  for (std::uint32_t c = 0; c < chains.size(); ++c) {
    const Chain& chain = chains[c];
    if (chain.samples < kFewest) continue;
    rim.samples += chain.samples;
    rim.length += chain.length + chain.last;
    rim.least_surrounded = std::min(rim.least_surrounded, chain.normals.norm() / static_cast<double>(chain.samples));
    if (chain.length + chain.last <= rim.longest) continue;
    longest = c;
    rim.longest = chain.length + chain.last;
    rim.place = chain.sum / static_cast<double>(chain.samples);
  }
  if (rim.samples == 0) return rim;
  // Two ends of a tree that are neighbours close its ring.
  std::vector<std::uint32_t> degree(scan.size());
  const auto count = [&](const Link& link) {
    ++degree[link.a];
    ++degree[link.b];
  };
  for (const Link& link : joined) count(link);
  for (const Link& link : closing) {
    if (degree[link.a] != 1 || degree[link.b] != 1) continue;
    count(link);
    joined.push_back(link);
  }
  for (const Link& link : joined) {
    if (chains[root(link.a)].samples >= kFewest) rim.links.push_back({scan.positions()[link.a], scan.positions()[link.b]});
  }
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (std::uint32_t i = 0; i < on_rim.size(); ++i) {
    if (on_rim[i] == 0 || root(i) != longest) continue;
    const Vector3d off = scan.positions()[i] - rim.place;
    spread += off * off.transpose() / static_cast<double>(chains[longest].samples);
  }
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.compute(spread);
  const Vector3d axis = solver.eigenvectors().col(0);
  rim.bent = std::sqrt(std::max(0.0, solver.eigenvalues()[0]));
  std::size_t above_plane = 0;
  for (const Vector3d& p : scan.positions()) above_plane += axis.dot(p - rim.place) > 2.0 * rim.bent ? 1U : 0U;
  std::size_t below_plane = 0;
  for (const Vector3d& p : scan.positions()) below_plane += axis.dot(p - rim.place) < -2.0 * rim.bent ? 1U : 0U;
  rim.behind = static_cast<double>(std::min(above_plane, below_plane)) / static_cast<double>(scan.size());
  return rim;
}

}  // namespace isotouch::field
