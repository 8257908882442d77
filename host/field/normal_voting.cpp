#include "host/field/normal_voting.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "host/field/parallel.h"

namespace isotouch::field {

namespace {

// Trial of 2026-11, 6 % of the normals turned in five objects: of 1,236 all but 4 are found and one sound one is turned; in a scan 234 of 237. In twelve
// sound clouds together two are turned. At -0.1 a part far thinner than its sampling loses four sound normals.
static_assert(Scan::kListed == 17);  // 16 neighbours vote
constexpr double kOpposed = -0.3;    ///< of all that is said
constexpr double kSoftening = 0.25;  ///< squared spacings: nearer neighbours are not louder
constexpr std::size_t kFewest = 4;
constexpr std::size_t kPasses = 3;  ///< what was turned helps to judge the others

bool contradicted(const Scan& scan, std::size_t i) {
  const auto around = scan.around(i);
  const double soft = kSoftening * scan.spacing(i) * scan.spacing(i);
  const Eigen::Vector3d& own = scan.normals()[i];
  double sum = 0.0, loudness = 0.0;
  std::size_t voices = 0;
  for (const auto& neighbour : around) {
    const Eigen::Vector3d& other = scan.normals()[neighbour.index];
    const Eigen::Vector3d step = scan.positions()[neighbour.index] - scan.positions()[i];
    const double square = step.squaredNorm();
    if (!(square > 0.0)) continue;
    const double alike = own.dot(other);
    const double bound = alike - 3.0 * own.dot(step) * other.dot(step) / square;
    const double softened = square + soft;
    const double weight = 1.0 / (softened * std::sqrt(softened));
    sum += weight * (alike > 0.0 ? std::max(bound, 0.0) : bound);  // one side seen twice, one over the other, is no contradiction
    loudness += weight * std::abs(alike);
    ++voices;
  }
  return voices >= kFewest && sum < kOpposed * loudness;
}

}  // namespace

std::size_t turn_outvoted(Scan& scan) {
  std::vector<std::uint8_t> wrong(scan.size(), 0), before, turned(scan.size(), 0);
  for (std::size_t pass = 0; pass < kPasses; ++pass) {
    before = wrong;
    const auto has_news = [&](std::size_t i) {
      const auto around = scan.around(i);
      return pass == 0 || std::any_of(around.begin(), around.end(), [&](const Neighbour& n) { return before[n.index] != 0; });
    };
    in_parallel(scan.size(), 256, [&](std::size_t begin, std::size_t end) {
      for (const std::uint32_t i : scan.together(begin, end)) wrong[i] = has_news(i) && contradicted(scan, i);
    });
    std::size_t count = 0;
    for (std::size_t i = 0; i < wrong.size(); ++i) {
      if (wrong[i] == 0) continue;
      scan.turn_normal(i);
      turned[i] ^= 1;
      ++count;
    }
    if (count == 0) break;
  }
  return static_cast<std::size_t>(std::count(turned.begin(), turned.end(), 1));
}

}  // namespace isotouch::field
