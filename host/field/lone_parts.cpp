#include "host/field/lone_parts.h"

#include <Eigen/Geometry>
#include <cstdint>
#include <memory>
#include <vector>

#include "host/field/orientation.h"
#include "host/field/sets.h"
#include "host/field/winding_sign.h"

namespace isotouch::field {

namespace {

using Eigen::Vector3d;

constexpr std::size_t kAsked = 11;       // a sample's list as far as it joins, itself among them
constexpr double kContradictory = 0.15;  // share of pairs of neighbours: such a part may be a group of strays

struct Part {
  std::vector<std::uint32_t> members;
  std::unique_ptr<Scan> scan = {};
  Eigen::AlignedBox3d box = {};
  double side = 0;  ///< 1: closed, its normals point out of it; -1: into it; 0: nobody can tell

  bool encloses(const Vector3d& place) const { return side != 0 && box.contains(place) && side * WindingSign(*scan)(place) > 0.5; }
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

}  // namespace

std::size_t turn_lone_parts(Scan& scan, bool heard) {
  std::vector<Part> parts = parts_of(scan);
  if (parts.size() == 1) return 0;
  for (Part& part : parts) {
    cloud::OrientedPoints points;
    for (const std::uint32_t i : part.members) {
      points.positions.push_back(scan.positions()[i]);
      points.normals.push_back(scan.normals()[i]);
      part.box.extend(scan.positions()[i]);
    }
    part.scan = std::make_unique<Scan>(std::move(points));
    if (contradictions(*part.scan) > kContradictory) continue;
    const Facing facing = field::facing(*part.scan);
    if (facing.is_closed()) part.side = facing.is_outward() ? 1 : facing.is_inward() ? -1 : 0;
  }
  std::size_t turned = 0;
  for (const Part& part : parts) {
    if (part.side == 0) continue;
    std::size_t round = 0;
    for (const Part& other : parts) round += &other != &part && other.encloses(part.scan->positions()[0]) ? 1U : 0U;
    const double right = round % 2 == 0 ? 1 : -1;
    if (part.side == right || (heard && round > 0)) continue;
    for (const std::uint32_t i : part.members) scan.turn_normal(i);
    turned += part.members.size();
  }
  return turned;
}

}  // namespace isotouch::field
