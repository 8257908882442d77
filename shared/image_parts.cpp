#include "shared/image_parts.h"

#include <algorithm>

#include "shared/bytes.h"
#include "shared/field_view.h"

namespace isotouch {

using namespace image_layout;

Result<ImageParts> ImageParts::of(std::span<const std::uint8_t> header, std::uint64_t image_bytes) {
  const std::uint8_t* at = header.data();
  if (header.size() < kHeaderBytes || !std::equal(kMagic.begin(), kMagic.end(), at)) return Error::kBadMagic;
  if (load_le<std::uint16_t>(at + kMajorAt) != kMajor) return Error::kBadVersion;
  ImageParts parts;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    parts.root_size[axis] = load_le<std::uint32_t>(at + kRootSizeAt + 4 * axis);
    if (parts.root_size[axis] < 1 || parts.root_size[axis] > kMaxSize >> kNodeShift) return Error::kBadHeader;
  }
  parts.node_count = load_le<std::uint32_t>(at + kNodeCountAt);
  parts.brick_count = load_le<std::uint32_t>(at + kBrickCountAt);
  parts.root_at = load_le<std::uint32_t>(at + kRootOffsetAt);
  parts.nodes_at = load_le<std::uint32_t>(at + kNodeOffsetAt);
  parts.bricks_at = load_le<std::uint32_t>(at + kBrickOffsetAt);
  parts.band = load_le<std::int32_t>(at + kBandAt);
  if (parts.node_count < 2 || parts.brick_count < 2 || parts.band < 1 || parts.band > INT16_MAX) return Error::kBadHeader;
  const bool aligned = parts.root_at % 4 == 0 && parts.nodes_at % 4 == 0 && parts.bricks_at % 4 == 0;
  const bool in_order = parts.root_at >= kHeaderBytes && parts.root_at + 4 * parts.root_entries() <= parts.nodes_at &&
                        parts.nodes_at + 4 * parts.node_entries() <= parts.bricks_at &&
                        parts.bricks_at + 2 * parts.samples() <= image_bytes;
  if (!aligned || !in_order || image_bytes > UINT32_MAX) return Error::kBadSize;
  return parts;
}

}  // namespace isotouch
