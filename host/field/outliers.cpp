#include "host/field/outliers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "host/field/parallel.h"

namespace isotouch::field {

namespace {

// Trial of 2026-11: of 199 points strewn in the boxes of five objects this finds 145, the others lie beside the surface or in the body; none in eighteen
// sound clouds, where every sample has at least 5 that list it, and in a very uneven one of 1,435 samples three have 3 or 4.
constexpr std::uint32_t kFewest = 3;
constexpr std::uint32_t kFew = 10;  // with so few it may also be no
constexpr double kSparser = 4.0;    // times as far apart as those round it: points strewn over a large hollow list each other

// Two samples confirm each other when the step between them lies along both tangent planes and their normals agree but for the sign.
constexpr double kAlong = 0.42;          // sine of the largest angle to a tangent plane
constexpr double kAlike = 0.7;           // cosine between the normals
constexpr std::uint32_t kConfirmed = 3;  // neighbours that confirm a sample which is farther from the others than they are from each other
constexpr double kApart = 1.7;           // times as far apart as those round it

/// Of the samples that sample i lists, how many have neighbours less than 1 / `times` as far away as its own?
std::size_t denser(const Scan& scan, std::size_t i, double times) {
  const double limit = scan.spacing(i) / times;
  std::size_t count = 0;
  for (const Neighbour& neighbour : scan.around(i)) count += scan.spacing(neighbour.index) < limit ? 1U : 0U;
  return count;
}

bool sparser(const Scan& scan, std::size_t i) { return 2 * denser(scan, i, kSparser) > scan.around(i).size(); }

/// Is the sample apart from those round it, and does hardly any of them lie on one surface with it?
bool unconfirmed(const Scan& scan, std::size_t i, double usual) {
  const bool apart = scan.spacing(i) > kApart * usual || 4 * denser(scan, i, kApart) > scan.around(i).size();
  if (!apart) return false;
  std::uint32_t confirmed = 0;
  for (const Neighbour& neighbour : scan.around(i)) {
    if (neighbour.index == i) continue;
    const Eigen::Vector3d step = scan.positions()[neighbour.index] - scan.positions()[i];
    const double limit = kAlong * step.norm();
    const Eigen::Vector3d &own = scan.normals()[i], &other = scan.normals()[neighbour.index];
    if (std::abs(own.dot(other)) > kAlike && std::abs(own.dot(step)) < limit && std::abs(other.dot(step)) < limit) ++confirmed;
  }
  return confirmed < kConfirmed;
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

}  // namespace isotouch::field
