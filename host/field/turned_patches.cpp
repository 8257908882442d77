#include "host/field/turned_patches.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "host/field/orientation.h"
#include "host/field/sets.h"

namespace isotouch::field {

namespace {

using Eigen::Vector3d;

constexpr std::size_t kAsked = 11;    // a sample's list as far as it is asked, itself among them
constexpr double kSure = 0.9;         // of an agreement: these hang together
constexpr double kClear = 0.5;        // these count at a border
constexpr double kAgain = 0.25;       // of the contradictions: so many agreements at the same border are chance
constexpr std::int64_t kFewest = 12;  // contradictions, each asked from both ends
constexpr double kOneWay = 0.5;       // of them: how many more lie behind each other than before each other, or less
// Samples: fewer may be a fine part of a sound scan, and are judged one by one (normal_voting.h).
constexpr std::size_t kSmallest = 7;
constexpr std::size_t kPasses = 8;  // a patch within a patch

/// What the neighbours in two parts say to each other.
struct Border {
  std::int64_t opposed = 0, agreed = 0;
  std::int64_t behind = 0;  ///< of the opposed: how many more lie behind each other than before each other
};

std::size_t turn_once(Scan& scan) {
  Sets sets(scan.size());
  struct Pair {
    std::uint32_t a, b;
    bool opposed;
    int behind;
  };
  std::vector<Pair> clear;
  for (std::uint32_t i = 0; i < scan.size(); ++i) {
    for (const Neighbour& n : scan.around(i, kAsked)) {
      if (n.index == i) continue;
      const Vector3d &own = scan.normals()[i], &other = scan.normals()[n.index];
      const Vector3d step = scan.positions()[n.index] - scan.positions()[i];
      const double agreed = agreement(own, other, step);
      if (std::abs(agreed) < kClear) continue;
      if (agreed > kSure) {
        const std::uint32_t a = sets.of(i), b = sets.of(n.index);
        if (a != b) sets.join(a, b);
      } else {
        const double ahead = own.dot(step), back = -other.dot(step);
        clear.push_back({i, n.index, agreed < 0.0, ahead < 0.0 && back < 0.0 ? 1 : ahead > 0.0 && back > 0.0 ? -1 : 0});
      }
    }
  }
  std::vector<std::size_t> size(scan.size());
  for (std::uint32_t i = 0; i < scan.size(); ++i) ++size[sets.of(i)];
  std::map<std::pair<std::uint32_t, std::uint32_t>, Border> borders;  // from the smaller part to the larger
  for (const Pair& pair : clear) {
    std::uint32_t a = sets.of(pair.a), b = sets.of(pair.b);
    if (size[a] == size[b]) continue;  // one part, or two of which neither is the larger
    if (size[a] > size[b]) std::swap(a, b);
    Border& border = borders[{a, b}];
    ++(pair.opposed ? border.opposed : border.agreed);
    border.behind += pair.opposed ? pair.behind : 0;
  }
  std::vector<std::uint8_t> wrong(scan.size());
  for (const auto& [parts, border] : borders) {
    const bool beside = static_cast<double>(std::abs(border.behind)) < kOneWay * static_cast<double>(border.opposed);
    const bool alone = static_cast<double>(border.agreed) < kAgain * static_cast<double>(border.opposed);
    if (size[parts.first] >= kSmallest && border.opposed >= kFewest && beside && alone) wrong[parts.first] = 1;
  }
  std::size_t turned = 0;
  for (std::uint32_t i = 0; i < scan.size(); ++i) {
    if (wrong[sets.of(i)] == 0) continue;
    scan.turn_normal(i);
    ++turned;
  }
  return turned;
}

}  // namespace

std::size_t turn_patches(Scan& scan) {
  std::size_t turned = 0;
  for (std::size_t pass = 0; pass < kPasses; ++pass) {
    const std::size_t now = turn_once(scan);
    if (now == 0) break;
    turned += now;
  }
  return turned;
}

}  // namespace isotouch::field
