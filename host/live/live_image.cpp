/// The part of a live field that makes an image of its bricks.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

#include "host/encoding/lay_out_image.h"
#include "host/field/parallel.h"
#include "host/live/brick_surroundings.h"
#include "host/live/live_field.h"
#include "shared/hash64.h"

namespace isotouch::live {

/// Slope and wall of the bricks that changed and of those around them.
void LiveField::certify() {
  std::vector<Node*> stale;
  for (Node* node : nodes_.all()) {
    if (node->stale != 0) stale.push_back(node);
  }
  const float none = 2.0F * static_cast<float>(reach_.band);
  const auto band = static_cast<std::int16_t>(std::floor(reach_.band * (1 << Distance::kFractionBits) + 0.5));
  field::in_parallel(stale.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      Node& node = *stale[n];
      const BrickSurroundings surroundings(node, nodes_, band);
      for (NodeMask left = node.stale; left != 0; left &= left - 1) {
        const auto brick = static_cast<std::size_t>(std::countr_zero(left));
        node.slope[brick] = 0.0F;
        node.wall[brick] = none;
        if (((node.stored | node.inside) & (left & -left)) == 0) continue;
        const encoding::Surroundings values = surroundings.of(brick);
        node.slope[brick] = encoding::squared_slope(apron_of(values));
        node.wall[brick] = encoding::thinnest_wall(values, samples_of(values), none);
      }
      node.stale = 0;
    }
  });
}

std::uint64_t LiveField::certificate_hash() const {
  std::uint64_t hash = 0;
  for (const auto& node : nodes_.by_place()) {
    if (!node) continue;
    for (NodeMask left = node->stored | node->inside; left != 0; left &= left - 1) {
      const auto brick = static_cast<std::size_t>(std::countr_zero(left));
      const auto bytes = std::bit_cast<std::array<std::uint8_t, 8>>(std::array{node->slope[brick], node->wall[brick]});
      hash = hash64(bytes.data(), bytes.size(), hash);
    }
  }
  return hash;
}

field_file::Image LiveField::image() const {
  using namespace image_layout;
  std::vector<std::uint32_t> root, nodes(2 * kBricksPerNode, kOutside);
  std::fill(nodes.begin() + kBricksPerNode, nodes.end(), kInside);
  std::vector<const Node*> written;
  std::uint32_t bricks = 2;
  float slope = 0.0F, wall = 2.0F * static_cast<float>(reach_.band);
  root.reserve(nodes_.by_place().size());
  for (const auto& node : nodes_.by_place()) {
    if (!node || (node->stored | node->inside) == 0) {
      root.push_back(kOutside);
      continue;
    }
    slope = std::max(slope, *std::max_element(node->slope.begin(), node->slope.end()));
    for (NodeMask left = node->stored | node->inside; left != 0; left &= left - 1)
      wall = std::min(wall, node->wall[static_cast<std::size_t>(std::countr_zero(left))]);
    if (node->inside == ~NodeMask{0}) {
      root.push_back(kInside);
      continue;
    }
    root.push_back(static_cast<std::uint32_t>(nodes.size() / kBricksPerNode));
    for (std::size_t brick = 0; brick < kBricksPerNode; ++brick)
      nodes.push_back((node->stored >> brick & 1U) != 0 ? bricks++ : (node->inside >> brick & 1U) != 0 ? kInside : kOutside);
    written.push_back(node.get());
  }
  encoding::FieldInfo info = info_;
  info.source_hash = source_hash_;
  info.point_count = static_cast<std::uint32_t>(verdict_.points);
  encoding::ImageHeader header = encoding::image_header(grid_, reach_.band, info);
  encoding::store_certificate(encoding::certificate_from(slope, wall, reach_.band), header);
  return encoding::lay_out_image(header, {root, nodes, bricks - 2, {}}, [&](std::uint8_t* at) {
    for (const Node* node : written) {
      const std::size_t bytes = node->bricks.size() * sizeof(encoding::Coefficients);
      std::memcpy(at, node->bricks.data(), bytes);
      at += bytes;
    }
  });
}

}  // namespace isotouch::live
