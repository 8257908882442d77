#include "host/field/lone_parts.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "host/field/orientation.h"
#include "host/field/sets.h"
#include "host/field/winding_sign.h"

namespace isotouch::field {

namespace {

constexpr std::size_t kAsked = 11;       // a sample's list as far as it joins, itself among them
constexpr double kContradictory = 0.15;  // share of pairs of neighbours: such a part may be a group of strays
constexpr std::size_t kWitnesses = 16;   // samples of a part, spread over the file's order
constexpr double kClear = 0.25;          // off a whole number: beside an open part, nobody can say what is within it

struct Part {
  std::vector<std::uint32_t> members;
  double side = 0;  ///< 1: closed, its normals point out of it; -1: into it; 0: nobody can tell
};

/// In the order of their first samples.
std::vector<Part> parts_of(const Scan& scan) {
  Sets sets(scan.size());
  for (std::uint32_t i = 0; i < scan.size(); ++i) {
    for (const Neighbour& n : scan.around(i, kAsked)) {
      const std::uint32_t a = sets.of(i), b = sets.of(n.index);
      if (a != b) sets.join(a, b);
    }
  }
  std::vector<Part> parts;
  std::vector<std::uint32_t> number(scan.size());  // of a set, plus one
  for (std::uint32_t i = 0; i < scan.size(); ++i) {
    std::uint32_t& own = number[sets.of(i)];
    if (own == 0) {
      parts.emplace_back();
      own = static_cast<std::uint32_t>(parts.size());
    }
    parts[own - 1].members.push_back(i);
  }
  return parts;
}

double side_of(const Scan& scan, const Part& part) {
  cloud::OrientedPoints points;
  for (const std::uint32_t i : part.members) {
    points.positions.push_back(scan.positions()[i]);
    points.normals.push_back(scan.normals()[i]);
  }
  const Scan alone(std::move(points));
  if (contradictions(alone) > kContradictory) return 0;
  const Facing facing = field::facing(alone);
  if (!facing.is_closed()) return 0;
  return facing.is_outward() ? 1 : facing.is_inward() ? -1 : 0;
}

/// What samples of a part say of the others: how many clearly have it outside all of them, in a hollow or outside, and in a body.
struct Witnesses {
  std::size_t asked = 0, outside = 0, even = 0, odd = 0;
};

/// They look from just outside the part, where it does not count itself. Whether the others face rightly does not matter.
Witnesses witnesses_of(const Part& part, const Scan& scan, const WindingSign& winding) {
  Witnesses found;
  found.asked = std::min(kWitnesses, part.members.size());
  for (std::size_t n = 0; n < found.asked; ++n) {
    const std::uint32_t i = part.members[n * part.members.size() / found.asked];
    const double number = winding(scan.positions()[i] + part.side * scan.spacing(i) * scan.normals()[i]);
    if (std::abs(number - std::round(number)) > kClear) continue;
    ++(std::lround(number) % 2 == 0 ? found.even : found.odd);
    if (std::lround(number) == 0) ++found.outside;
  }
  return found;
}

}  // namespace

std::vector<std::uint32_t> turn_lone_parts(Scan& scan, bool heard) {
  std::vector<Part> parts = parts_of(scan);
  if (parts.size() == 1) return {};
  const WindingSign winding(scan);
  std::vector<std::uint32_t> turned;
  for (Part& part : parts) {
    part.side = side_of(scan, part);
    if (part.side == 0) continue;
    const Witnesses found = witnesses_of(part, scan, winding);
    const bool is_outside = heard ? found.outside == found.asked : 2 * found.even > found.asked;
    const bool is_within = !heard && 2 * found.odd > found.asked;
    const double right = is_outside ? 1 : is_within ? -1 : part.side;
    if (part.side != right) turned.insert(turned.end(), part.members.begin(), part.members.end());
  }
  for (const std::uint32_t i : turned) scan.turn_normal(i);
  return turned;
}

}  // namespace isotouch::field
