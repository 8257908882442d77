#include "host/field/outliers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "host/field/parallel.h"

namespace isotouch::field {

namespace {

// Trial of 2026-11: of 199 points strewn in the boxes of five objects this finds 145, the others lie beside the surface or in the body; none in eighteen
// sound clouds, where every sample has at least 5 that list it, and in a very uneven one of 1,435 samples three have 3 or 4.
constexpr std::uint32_t kFewest = 3;
constexpr std::uint32_t kFew = 10;  // with so few it may also be no
constexpr double kSparser = 4.0;    // times as far apart as those round it: points strewn over a large hollow list each other

// Two samples confirm each other when the step between them lies along both tangent planes and their normals agree but for the sign.
constexpr double kAlong = 0.42;           // sine of the largest angle to a tangent plane
constexpr double kAlike = 0.7;            // cosine between the normals
constexpr std::ptrdiff_t kConfirmed = 3;  // neighbours that confirm a sample which is farther from the others than they are from each other
constexpr double kApart = 1.7;            // times as far apart as those round it

// Of the 16 others in a sample's list. Inner sides of hollow balls have a median of 15, strays up to six spacings off a surface 6, strays in a box 0.
constexpr std::ptrdiff_t kSurely = 12;
constexpr std::ptrdiff_t kTogether = 6;  // and of these some that are as sure: single strays may have 12, but no group of them

/// Of the samples that sample i lists, how many have neighbours less than 1 / `times` as far away as its own?
std::size_t denser(const Scan& scan, std::size_t i, double times) {
  const double limit = scan.spacing(i) / times;
  std::size_t count = 0;
  for (const Neighbour& neighbour : scan.around(i)) count += scan.spacing(neighbour.index) < limit ? 1U : 0U;
  return count;
}

bool sparser(const Scan& scan, std::size_t i) { return 2 * denser(scan, i, kSparser) > scan.around(i).size(); }

/// Does the sample, which is not connected, lie beside a surface that faces the same way? Then it is another layer of it.
bool is_layer(const Scan& scan, std::size_t i, const std::vector<bool>& is_connected) {
  std::size_t beside = 0, alike = 0;
  for (const Neighbour& n : scan.around(i)) {
    if (!is_connected[n.index]) continue;
    ++beside;
    alike += scan.normals()[n.index].dot(scan.normals()[i]) > kAlike ? 1U : 0U;
  }
  return 2 * alike > beside;
}

bool confirm_each_other(const Scan& scan, std::size_t i, std::size_t k) {
  if (i == k) return false;
  const Eigen::Vector3d step = scan.positions()[k] - scan.positions()[i];
  const double limit = kAlong * step.norm();
  const Eigen::Vector3d &own = scan.normals()[i], &other = scan.normals()[k];
  return std::abs(own.dot(other)) > kAlike && std::abs(own.dot(step)) < limit && std::abs(other.dot(step)) < limit;
}

/// Is the sample apart from those round it, and does hardly any of them lie on one surface with it?
bool unconfirmed(const Scan& scan, std::size_t i, double usual) {
  const bool apart = scan.spacing(i) > kApart * usual || 4 * denser(scan, i, kApart) > scan.around(i).size();
  if (!apart) return false;
  const auto around = scan.around(i);
  const auto confirming =
      std::count_if(around.begin(), around.end(), [&](const Neighbour& n) { return confirm_each_other(scan, i, n.index); });
  return confirming < kConfirmed;
}

}  // namespace

std::vector<std::uint32_t> connected(const Scan& scan) {
  std::vector<std::uint8_t> isolated(scan.size(), 0);
  const double usual = scan.median_spacing();
  in_parallel(scan.size(), 256, [&](std::size_t begin, std::size_t end) {
    for (const std::uint32_t i : scan.together(begin, end)) isolated[i] = unconfirmed(scan, i, usual) ? 1 : 0;
  });
  std::vector<std::uint32_t> listed(scan.size());
  for (bool found = true; found;) {
    found = false;
    std::fill(listed.begin(), listed.end(), 0);
    for (const std::uint32_t i : scan.together(0, scan.size())) {
      if (isolated[i] != 0) continue;  // strewn points do not vouch for each other
      for (const Neighbour& neighbour : scan.around(i)) listed[neighbour.index] += neighbour.index != i ? 1U : 0U;
    }
    for (std::size_t i = 0; i < scan.size(); ++i) {
      if (isolated[i] != 0 || listed[i] >= kFew || (listed[i] >= kFewest && !sparser(scan, i))) continue;
      isolated[i] = 1;
      found = true;
    }
  }
  std::vector<std::uint32_t> kept;
  for (std::uint32_t i = 0; i < scan.size(); ++i) {
    if (isolated[i] == 0) kept.push_back(i);
  }
  return kept;
}

std::vector<std::uint32_t> on_a_surface(const Scan& alone) {
  const auto confirming = [&](std::uint32_t i, const std::vector<bool>& heard) {
    const auto around = alone.around(i);
    return std::count_if(around.begin(), around.end(),
                         [&](const Neighbour& n) { return heard[n.index] && confirm_each_other(alone, i, n.index); });
  };
  const auto confirmed_by = [&](const std::vector<bool>& heard, std::ptrdiff_t fewest) {
    std::vector<bool> result(alone.size());
    for (std::uint32_t i = 0; i < alone.size(); ++i) result[i] = heard[i] && confirming(i, heard) >= fewest;
    return result;
  };
  const std::vector<bool> all(alone.size(), true);
  const std::vector<bool> sure = confirmed_by(confirmed_by(all, kSurely), kTogether);
  std::vector<std::uint32_t> found;
  for (std::uint32_t i = 0; i < alone.size(); ++i) {  // at an edge fewer lie on the sample's face
    if (sure[i] || confirming(i, sure) >= kConfirmed) found.push_back(i);
  }
  return found;
}

Sides connected_sides(const Scan& scan) {
  Sides result{connected(scan)};
  if (scan.size() - result.samples.size() < Scan::kListed) return result;
  std::vector<bool> is_connected(scan.size());
  for (const std::uint32_t i : result.samples) is_connected[i] = true;
  std::vector<std::uint32_t> others;
  cloud::OrientedPoints points;
  for (std::uint32_t i = 0; i < scan.size(); ++i) {
    if (is_connected[i] || is_layer(scan, i, is_connected)) continue;
    others.push_back(i);
    points.positions.push_back(scan.positions()[i]);
    points.normals.push_back(scan.normals()[i]);
  }
  if (others.size() < Scan::kListed) return result;
  const std::vector<std::uint32_t> found = on_a_surface(Scan(std::move(points)));
  for (const std::uint32_t i : found) result.samples.push_back(others[i]);
  std::sort(result.samples.begin(), result.samples.end());
  result.sparse = found.size();
  return result;
}

}  // namespace isotouch::field
