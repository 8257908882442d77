#include "host/encoding/lay_out_image.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>

#include "host/encoding/spline.h"
#include "host/field/does_not_fit.h"
#include "shared/bytes.h"
#include "shared/crc32.h"

namespace isotouch::encoding {

namespace {

using namespace image_layout;

constexpr std::size_t kBrickBytes = sizeof(Coefficients);

/// `value` in the format Q, or the sentence why it does not fit.
template <class Q>
Q in_format(double value, double low, double high, const char* what) {
  if (!(value >= low && value <= high)) {
    throw field::DoesNotFit(
        std::string(what) + " is " + std::to_string(value) + ", a field holds " + std::to_string(low) + " to " + std::to_string(high),
        "choose another size, --voxel, --band or --stiffness");
  }
  return Q::from_raw(static_cast<std::int32_t>(std::floor(value * static_cast<double>(1 << Q::kFractionBits) + 0.5)));
}

}  // namespace

ImageHeader image_header(const field::Grid& grid, double band, const FieldInfo& info) {
  ImageHeader header{};
  std::uint8_t* at = header.data();
  std::copy(kMagic.begin(), kMagic.end(), at);
  store_le(at + kMajorAt, kMajor);
  store_le(at + kMinorAt, info.interpolation == Interpolation::kTrilinear ? kMinorTrilinear : kMinor);
  store_le(at + kHeaderBytesAt, static_cast<std::uint32_t>(kHeaderBytes));
  store_le(at + kSourceHashAt, info.source_hash);
  const auto edge = in_format<MmPerVoxel>(grid.edge, 1.0 / 64, 16, "the voxel edge in mm");
  store_le(at + kEdgeAt, edge.raw());
  store_le(at + kInverseEdgeAt, static_cast<std::int32_t>(((std::int64_t{1} << 45) / edge.raw() + 1) / 2));
  store_le(at + kBandAt, in_format<Distance>(band, 1, 7.99, "the band in voxels").raw());
  store_le(at + kStiffnessAt, in_format<Stiffness>(info.stiffness_n_per_mm, 1.0 / (1 << 16), 100, "the stiffness in N/mm").raw());
  for (int axis = 0; axis < 3; ++axis) {
    const int size = grid.size[axis];
    if (size < 8 || size > static_cast<int>(kMaxSize)) {
      throw field::DoesNotFit("the grid has " + std::to_string(size) + " samples along one axis, a field holds 8 to 4096",
                              "choose another --voxel or --grid");
    }
    store_le(at + kSizeAt + 4 * axis, size);
    store_le(at + kRootSizeAt + 4 * axis, (size + 15) >> kNodeShift);
    store_le(at + kOriginAt + 4 * axis, in_format<Mm>(grid.origin[axis], -512, 512, "the grid's corner in mm").raw());
    store_le(at + kOffsetAt + 8 * axis, std::bit_cast<std::uint64_t>(info.placement.offset[axis]));
  }
  store_le(at + kMethodAt, static_cast<std::uint32_t>(info.method));
  store_le(at + kInterpolationAt, static_cast<std::uint32_t>(info.interpolation));
  store_le(at + kPointCountAt, info.point_count);
  store_le(at + kScaleAt, std::bit_cast<std::uint64_t>(info.placement.scale));
  return header;
}

void store_certificate(const Certificate& certificate, ImageHeader& header) {
  std::uint8_t* at = header.data();
  const auto store = [at](std::size_t offset, double value, int bits) {
    store_le(at + offset, static_cast<std::uint32_t>(std::clamp(std::ceil(std::ldexp(value, bits)), 0.0, 4294967295.0)));
  };
  store(kMaxSlopeAt, certificate.largest_slope, 16);
  store(kQuantisationAt, certificate.quantisation_voxel, 24);
  store(kThinnestWallAt, certificate.thinnest_wall_voxel, 16);
  store_le(at + kAdvisedStiffnessAt, static_cast<std::uint32_t>(std::ldexp(certificate.stiffness_n_per_mm, Stiffness::kFractionBits)));
  store_le(at + kAdvisedPeriodAt, certificate.period_ns);
  store(kAdvisedDampingAt, certificate.damping_n_s_mm, Damping::kFractionBits);
  store_le(at + kAdvisedDelayAt, certificate.delay_ticks);
}

field_file::Image lay_out_image(const ImageHeader& header, const ImageTables& tables, const std::function<void(std::uint8_t*)>& copy) {
  const std::size_t nodes_at = align64(kHeaderBytes + 4 * tables.root.size());
  const std::size_t bricks_at = align64(nodes_at + 4 * tables.nodes.size());
  const std::size_t bricks_end = bricks_at + kBrickBytes * (tables.stored + 2);
  const std::size_t bytes = bricks_end + tables.stiffness.size();
  if (bytes > std::numeric_limits<std::uint32_t>::max()) {
    throw field::DoesNotFit("the field needs " + std::to_string(bytes) + " bytes, at most 4 GB fit",
                            "choose a larger --voxel or a smaller --band");
  }
  field_file::Image image(bytes);
  std::uint8_t* at = image.data();
  std::copy(header.begin(), header.end(), at);
  store_le(at + kTotalBytesAt, static_cast<std::uint64_t>(bytes));
  store_le(at + kNodeCountAt, static_cast<std::uint32_t>(tables.nodes.size() / kBricksPerNode));
  store_le(at + kBrickCountAt, static_cast<std::uint32_t>(tables.stored + 2));
  store_le(at + kRootOffsetAt, static_cast<std::uint32_t>(kHeaderBytes));
  store_le(at + kNodeOffsetAt, static_cast<std::uint32_t>(nodes_at));
  store_le(at + kBrickOffsetAt, static_cast<std::uint32_t>(bricks_at));
  if (!tables.stiffness.empty()) {
    if (load_le<std::uint32_t>(at + kInterpolationAt) == static_cast<std::uint32_t>(Interpolation::kSpline))
      store_le(at + kMinorAt, kMinorWithTable);
    store_le(at + kStiffnessTableAt, static_cast<std::uint32_t>(bricks_end));
  }

  static_assert(std::endian::native == std::endian::little, "tables are copied as they are");
  std::memcpy(at + kHeaderBytes, tables.root.data(), 4 * tables.root.size());
  std::memcpy(at + nodes_at, tables.nodes.data(), 4 * tables.nodes.size());
  const auto band = static_cast<std::int16_t>(load_le<std::int32_t>(&header[kBandAt]));
  Coefficients constant;
  constant.fill(band);
  std::memcpy(at + bricks_at, &constant, sizeof constant);
  constant.fill(static_cast<std::int16_t>(-band));
  std::memcpy(at + bricks_at + kBrickBytes, &constant, sizeof constant);
  copy(at + bricks_at + 2 * kBrickBytes);
  std::copy(tables.stiffness.begin(), tables.stiffness.end(), at + bricks_end);
  store_le(at + kChecksumAt, crc32(at + kTotalBytesAt, bytes - kTotalBytesAt));
  return image;
}

}  // namespace isotouch::encoding
