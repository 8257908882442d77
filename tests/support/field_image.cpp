#include "tests/support/field_image.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>

#include "shared/bytes.h"
#include "shared/crc32.h"

namespace isotouch::test {

namespace {

using namespace image_layout;

std::int16_t coefficient(const DistanceFunction& distance, const Point& at, const FieldOptions& options) {
  double value = distance(at);
  if (options.prefilter && std::abs(value) < options.band + 2) {
    const double centre = value;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      Point before = at, after = at;
      before[axis] -= 1;
      after[axis] += 1;
      value -= (distance(before) - 2 * centre + distance(after)) / 8;
    }
  }
  return static_cast<std::int16_t>(std::lround(std::clamp(value, -options.band, options.band) * 4096));
}

}  // namespace

FieldImage::FieldImage(std::array<std::uint32_t, 3> size, const DistanceFunction& distance, const FieldOptions& options) {
  std::array<std::uint32_t, 3> roots{};
  for (std::size_t axis = 0; axis < 3; ++axis) roots[axis] = (size[axis] + 15) >> kNodeShift;
  const std::size_t cells = std::size_t{roots[0]} * roots[1] * roots[2];
  const auto far = static_cast<std::int16_t>(std::lround(options.band * 4096));

  std::vector<std::int16_t> bricks(2 * kSamplesPerBrick, far);
  std::fill(bricks.begin() + kSamplesPerBrick, bricks.end(), static_cast<std::int16_t>(-far));
  std::vector<std::uint32_t> nodes(2 * kBricksPerNode, kOutside);
  std::fill(nodes.begin() + kBricksPerNode, nodes.end(), kInside);
  std::vector<std::uint32_t> root;
  std::vector<std::uint8_t> parts(2);
  for (std::size_t cell = 0; cell < cells; ++cell) {
    std::vector<std::uint32_t> node;
    const std::array<std::size_t, 3> corner = {16 * (cell % roots[0]), 16 * (cell / roots[0] % roots[1]),
                                               16 * (cell / roots[0] / roots[1])};
    for (std::size_t slot = 0; slot < kBricksPerNode; ++slot) {
      std::array<std::int16_t, kSamplesPerBrick> brick{};
      for (std::size_t i = 0; i < kSamplesPerBrick; ++i) {
        Point at{};
        bool in_grid = true;
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const std::size_t index = corner[axis] + 4 * ((slot >> (2 * axis)) & 3) + ((i >> (2 * axis)) & 3);
          at[axis] = static_cast<double>(index);
          in_grid = in_grid && index >= 2 && index + 2 < size[axis];
        }
        brick[i] = in_grid ? coefficient(distance, at, options) : far;
      }
      const bool constant = std::all_of(brick.begin(), brick.end(), [&](std::int16_t c) { return c == brick[0]; });
      if (constant && (brick[0] == far || brick[0] == -far)) {
        node.push_back(brick[0] == far ? kOutside : kInside);
      } else {
        node.push_back(static_cast<std::uint32_t>(bricks.size() / kSamplesPerBrick));
        bricks.insert(bricks.end(), brick.begin(), brick.end());
        Point centre{};
        for (std::size_t axis = 0; axis < 3; ++axis)
          centre[axis] = 1.5 + static_cast<double>(corner[axis] + 4 * ((slot >> (2 * axis)) & 3));
        if (options.stiffness_part) parts.push_back(static_cast<std::uint8_t>(options.stiffness_part(centre)));
      }
    }
    if (node[0] <= kInside && std::all_of(node.begin(), node.end(), [&](std::uint32_t number) { return number == node[0]; })) {
      root.push_back(node[0]);
    } else {
      root.push_back(static_cast<std::uint32_t>(nodes.size() / kBricksPerNode));
      nodes.insert(nodes.end(), node.begin(), node.end());
    }
  }

  const std::size_t nodes_at = align64(kHeaderBytes + 4 * root.size());
  const std::size_t bricks_at = align64(nodes_at + 4 * nodes.size());
  const std::size_t table_at = bricks_at + 2 * bricks.size();
  const std::size_t total = table_at + (options.stiffness_part ? parts.size() : 0);
  words_.resize((total + 7) / 8);
  auto* at = reinterpret_cast<std::uint8_t*>(words_.data());
  const auto put = [at](std::size_t offset, auto value) { store_le(at + offset, value); };
  std::copy(kMagic.begin(), kMagic.end(), at);
  put(kMajorAt, kMajor);
  put(kMinorAt, options.interpolation == Interpolation::kTrilinear ? kMinorTrilinear : options.stiffness_part ? kMinorWithTable : kMinor);
  put(kHeaderBytesAt, static_cast<std::uint32_t>(kHeaderBytes));
  put(kTotalBytesAt, std::uint64_t{total});
  for (std::size_t axis = 0; axis < 3; ++axis) {
    put(kOriginAt + 4 * axis, static_cast<std::int32_t>(std::lround(options.origin_mm[axis] * 1048576)));
    put(kSizeAt + 4 * axis, size[axis]);
    put(kRootSizeAt + 4 * axis, roots[axis]);
  }
  const auto edge = static_cast<std::int32_t>(std::lround(options.edge_mm * 1048576));
  put(kEdgeAt, edge);
  put(kInverseEdgeAt, static_cast<std::int32_t>(((std::int64_t{1} << 44) + edge / 2) / edge));
  put(kBandAt, std::int32_t{far});
  put(kStiffnessAt, static_cast<std::int32_t>(std::lround(options.stiffness * 65536)));
  put(kMaxSlopeAt, static_cast<std::uint32_t>(std::lround(options.largest_slope * 65536)));
  put(kInterpolationAt, static_cast<std::uint32_t>(options.interpolation));
  put(kNodeCountAt, static_cast<std::uint32_t>(nodes.size() / kBricksPerNode));
  put(kBrickCountAt, static_cast<std::uint32_t>(bricks.size() / kSamplesPerBrick));
  put(kRootOffsetAt, static_cast<std::uint32_t>(kHeaderBytes));
  put(kNodeOffsetAt, static_cast<std::uint32_t>(nodes_at));
  put(kBrickOffsetAt, static_cast<std::uint32_t>(bricks_at));
  std::memcpy(at + kHeaderBytes, root.data(), 4 * root.size());
  std::memcpy(at + nodes_at, nodes.data(), 4 * nodes.size());
  std::memcpy(at + bricks_at, bricks.data(), 2 * bricks.size());
  if (options.stiffness_part) {
    put(kStiffnessTableAt, static_cast<std::uint32_t>(table_at));
    std::copy(parts.begin(), parts.end(), at + table_at);
  }
  put(kChecksumAt, crc32(at + kTotalBytesAt, total - kTotalBytesAt));

  const Result<FieldView> view = FieldView::parse({at, total});
  if (!view) {
    std::fprintf(stderr, "the test's own image is not a valid field: %s\n", describe(view.error()));
    std::abort();
  }
  view_ = *view;
}

std::vector<std::uint8_t> FieldImage::bytes() const { return {view_.image.begin(), view_.image.end()}; }

}  // namespace isotouch::test
