#include "host/field/open_rim.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <optional>
#include <span>
#include <vector>

#include "host/field/angle.h"
#include "host/field/parallel.h"
#include "host/field/sets.h"

namespace isotouch::field {

namespace {

using Eigen::Vector3d;

constexpr double kGap = 140 * std::numbers::pi / 180;
constexpr double kTurned = 0.5;  // cosine: a neighbour whose normal is farther off shows that the surface turns away
constexpr double kBehind = 0.5;  // spacings: one that far behind, with its back to the sample, is the other face of a thin wall
constexpr double kGapOfWall = 110 * std::numbers::pi / 180;  // among twice as many neighbours and more
constexpr std::size_t kFewest = 12;                          // samples a rim
constexpr std::size_t kFew = 3 * kFewest;                    // so many may still be chance, where the end beside them was seen
constexpr double kBothSides = 0.5;                           // of `Chain::surrounded`: less on an edge that two faces share
constexpr double kBeside = 4.0;                              // spacings
constexpr double kNotAll = 0.95;  // of the samples: a patch lies beside something, such as the object over a table
constexpr double kOutward = 1.0;  // spacings: a patch ends that far beyond the middle of its rim

/// The eighth of the plane in which a place lies, counted round the origin.
unsigned octant(double x, double y) {
  if (y < 0) return 4 + octant(-x, -y);
  if (x < 0) return 2 + octant(y, -x);
  return x < y ? 1 : 0;
}

/// The widest sector between directions; angles are in any order, and there is at least one.
double widest_sector(std::span<double> angles) {
  std::sort(angles.begin(), angles.end());
  double widest = angles.front() + 2 * std::numbers::pi - angles.back();
  for (std::size_t i = 1; i < angles.size(); ++i) widest = std::max(widest, angles[i] - angles[i - 1]);
  return widest;
}

/// Is the neighbour at `step` on the other face of a thin wall?
bool is_behind(const Scan& scan, std::size_t sample, const Vector3d& step, double alike) {
  return alike < -kTurned && std::abs(step.dot(scan.normals()[sample])) > kBehind * scan.spacing(sample);
}

/// The widest sector, as an angle, that the neighbours leave empty in the sample's tangent plane; 0 where one of them lies round an edge, or where
/// it is narrower than kGap.
double widest_gap(const Scan& scan, std::size_t sample) {
  const Vector3d& normal = scan.normals()[sample];
  const Vector3d u = normal.unitOrthogonal(), v = normal.cross(u);
  std::array<std::array<double, 2>, Scan::kListed> places;  // along u and v
  std::size_t count = 0;
  unsigned octants = 0;  // in which there are any
  for (const Neighbour& neighbour : scan.around(sample)) {
    if (neighbour.index == sample) continue;
    const Vector3d step = scan.positions()[neighbour.index] - scan.positions()[sample];
    const double alike = scan.normals()[neighbour.index].dot(normal);
    if (is_behind(scan, sample, step, alike)) continue;
    if (alike < kTurned) return 0;
    places[count] = {step.dot(u), step.dot(v)};
    octants |= 1U << octant(places[count][0], places[count][1]);
    ++count;
  }
  const unsigned empty = ~octants & 0xFFU;
  if ((empty & (empty << 1 | empty >> 7)) == 0) return 0;  // nowhere two in a row: no gap is wider than three octants
  std::array<double, Scan::kListed> angles{};
  for (std::size_t i = 0; i < count; ++i) angles[i] = angle_of(places[i][1], places[i][0]);
  return count == 0 ? 0 : widest_sector({angles.data(), count});
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
  std::size_t beside_end = 0;  ///< of these, where all may be chance: with `is_end_seen`
  double length = 0;
  double last = 0;  ///< the longest link, which stands for the one that closes the ring
  Vector3d sum = Vector3d::Zero(), normals = Vector3d::Zero();

  Vector3d middle() const { return sum / static_cast<double>(samples); }
  double surrounded() const { return normals.norm() / static_cast<double>(samples); }
  bool may_be_chance() const { return samples < kFew && surrounded() < kBothSides; }
  bool is_rim() const { return samples >= kFewest && !(may_be_chance() && 2 * beside_end > samples); }
};

/// Unit, in the sample's tangent plane: away from its neighbours on the same surface.
Vector3d outward(const Scan& scan, std::uint32_t sample) {
  const Vector3d& normal = scan.normals()[sample];
  Vector3d away = Vector3d::Zero();
  for (const Neighbour& neighbour : scan.around(sample)) {
    if (scan.normals()[neighbour.index].dot(normal) > kTurned) away += scan.positions()[sample] - scan.positions()[neighbour.index];
  }
  return (away - normal * normal.dot(away)).normalized();
}

/// Does a thin wall go on where the nearest neighbours leave a gap? Many of them lie on its other face, so a gap may be chance where points lie at
/// random. The neighbours of the neighbours decide.
bool wall_goes_on(const Scan& scan, std::uint32_t sample) {
  const Vector3d &own = scan.positions()[sample], &normal = scan.normals()[sample];
  const auto around = scan.around(sample);
  const auto behind = [&](const Neighbour& n) {
    return is_behind(scan, sample, scan.positions()[n.index] - own, scan.normals()[n.index].dot(normal));
  };
  if (std::none_of(around.begin(), around.end(), behind)) return false;
  const Vector3d u = normal.unitOrthogonal(), v = normal.cross(u);
  std::vector<double> angles;
  for (const Neighbour& first : around) {
    for (const Neighbour& second : scan.around(first.index)) {
      if (second.index == sample || scan.normals()[second.index].dot(normal) < kTurned) continue;
      const Vector3d step = scan.positions()[second.index] - own;
      angles.push_back(angle_of(step.dot(v), step.dot(u)));
    }
  }
  return !angles.empty() && widest_sector(angles) < kGapOfWall;
}

/// Does the scan have samples on the narrow face in which a wall ends, beside a sample on its edge? Points at random leave a long piece of such a face empty
/// here and there, and the edges beside it look like those of a wall that was cut off.
bool is_end_seen(const Scan& scan, std::uint32_t sample, std::vector<Neighbour>& found) {
  const Vector3d &own = scan.positions()[sample], &normal = scan.normals()[sample];
  const Vector3d away = outward(scan, sample);
  const double near = kBehind * scan.spacing(sample);
  scan.tree().within(own, kBeside * scan.spacing(sample), found);
  const auto depth_of = [&](const Neighbour& other) { return -(scan.positions()[other.index] - own).dot(normal); };
  const auto behind = std::ranges::find_if(
      found, [&](const Neighbour& other) { return scan.normals()[other.index].dot(normal) < -kTurned && depth_of(other) > 0.0; });
  if (behind == found.end()) return false;
  const double thickness = depth_of(*behind);  // of the wall, by the nearest sample on its other face
  return std::any_of(found.begin(), found.end(), [&](const Neighbour& other) {
    const Vector3d step = scan.positions()[other.index] - own;
    const double depth = depth_of(other);
    return scan.normals()[other.index].dot(away) > kTurned && step.dot(away) > -near && depth > -near && depth < thickness + near;
  });
}

/// The samples of all patches: sets of neighbours, but for those behind a wall, that end outward of their rims. Round a hole a surface ends towards the
/// rim's middle, at the end of a tube along it.
///
/// middle_of   called with a sample; of its rim, or null where it is on none
template <typename MiddleOf>
std::size_t patch_samples(const Scan& scan, const MiddleOf& middle_of) {
  Sets sets(scan.size());
  for (std::uint32_t i = 0; i < scan.size(); ++i) {
    for (const Neighbour& neighbour : scan.around(i)) {
      if (scan.normals()[neighbour.index].dot(scan.normals()[i]) < -kTurned) continue;
      const std::uint32_t a = sets.of(i), b = sets.of(neighbour.index);
      if (a != b) sets.join(a, b);
    }
  }
  struct Surface {
    std::size_t samples = 0;
    double outward = 0;  // sum over rim samples: how far they end beyond their rim's middle, in spacings
    double on_rim = 0;
  };
  std::vector<Surface> surfaces(scan.size());
  for (std::uint32_t i = 0; i < scan.size(); ++i) {
    Surface& surface = surfaces[sets.of(i)];
    ++surface.samples;
    const std::optional<Vector3d> middle = middle_of(i);
    if (!middle) continue;
    surface.outward += (scan.positions()[i] - *middle).dot(outward(scan, i)) / scan.spacing(i);
    surface.on_rim += 1;
  }
  std::size_t samples = 0;
  for (const Surface& surface : surfaces) {
    const bool patch = surface.on_rim > 0 && surface.outward > kOutward * surface.on_rim &&
                       static_cast<double>(surface.samples) < kNotAll * static_cast<double>(scan.size());
    samples += patch ? surface.samples : 0;
  }
  return samples;
}

}  // namespace

OpenRim open_rim(const Scan& scan) {
  std::vector<std::uint8_t> on_rim(scan.size());
  in_parallel(scan.size(), 256, [&](std::size_t begin, std::size_t end) {
    for (const std::uint32_t i : scan.together(begin, end)) on_rim[i] = widest_gap(scan, i) > kGap && !wall_goes_on(scan, i) ? 1 : 0;
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
  Sets rims(scan.size());
  std::vector<Chain> chains(scan.size());
  std::vector<Link> joined, closing;
  for (const Link& link : links) {
    const std::uint32_t a = rims.of(link.a), b = rims.of(link.b);
    if (a == b) {
      closing.push_back(link);
      continue;
    }
    rims.join(a, b);
    joined.push_back(link);
    chains[a].last = std::sqrt(link.squared_length);
    chains[a].length += chains[b].length + chains[a].last;
  }
  for (std::uint32_t i = 0; i < on_rim.size(); ++i) {
    if (on_rim[i] == 0) continue;
    Chain& chain = chains[rims.of(i)];
    ++chain.samples;
    chain.sum += scan.positions()[i];
    chain.normals += scan.normals()[i];
  }
  std::vector<Neighbour> found;
  for (std::uint32_t i = 0; i < on_rim.size(); ++i) {
    if (on_rim[i] == 0) continue;
    Chain& chain = chains[rims.of(i)];
    if (chain.samples >= kFewest && chain.may_be_chance() && is_end_seen(scan, i, found)) ++chain.beside_end;
  }
  OpenRim rim;
  std::uint32_t longest = 0;
  for (std::uint32_t c = 0; c < chains.size(); ++c) {
    const Chain& chain = chains[c];
    if (!chain.is_rim()) continue;
    rim.samples += chain.samples;
    rim.length += chain.length + chain.last;
    if (chain.surrounded() < rim.least_surrounded) {
      rim.least_surrounded = chain.surrounded();
      rim.least_place = chain.middle();
    }
    if (chain.length + chain.last <= rim.longest) continue;
    longest = c;
    rim.longest = chain.length + chain.last;
    rim.place = chain.middle();
  }
  if (rim.samples == 0) return rim;
  rim.patches = patch_samples(scan, [&](std::uint32_t i) -> std::optional<Vector3d> {
    if (on_rim[i] == 0) return std::nullopt;
    const Chain& chain = chains[rims.of(i)];
    return chain.is_rim() ? std::optional(chain.middle()) : std::nullopt;
  });
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
  std::vector<double> lengths(scan.size());
  for (const Link& link : joined) {
    if (!chains[rims.of(link.a)].is_rim()) continue;
    rim.links.push_back({scan.positions()[link.a], scan.positions()[link.b]});
    for (const std::uint32_t end : {link.a, link.b}) lengths[end] += 0.5 * std::sqrt(link.squared_length);
  }
  for (std::uint32_t i = 0; i < on_rim.size(); ++i) {
    if (on_rim[i] == 0) continue;
    const std::uint32_t own = rims.of(i);
    if (chains[own].is_rim()) rim.along.push_back({i, lengths[i], own == longest, own, chains[own].surrounded()});
  }
  return rim;
}

}  // namespace isotouch::field
