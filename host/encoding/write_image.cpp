#include "host/encoding/write_image.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <utility>

#include "host/encoding/apron.h"
#include "host/encoding/brick_rows.h"
#include "host/encoding/brick_tree.h"
#include "host/encoding/certificate.h"
#include "host/encoding/round_creases.h"
#include "host/encoding/small_components.h"
#include "host/encoding/spline.h"
#include "host/error.h"
#include "shared/bytes.h"
#include "shared/crc32.h"

namespace isotouch::encoding {

namespace {

using namespace image_layout;

/// `value` in the format Q, or the sentence why it does not fit.
template <class Q>
Q in_format(double value, double low, double high, const char* what) {
  if (!(value >= low && value <= high)) {
    throw InputError(std::string(what) + " is " + std::to_string(value) + ", a field holds " + std::to_string(low) + " to " +
                     std::to_string(high) + "; choose another size, --voxel, --band or --stiffness");
  }
  return Q::from_raw(static_cast<std::int32_t>(std::floor(value * static_cast<double>(1 << Q::kFractionBits) + 0.5)));
}

/// Samples beyond the grid in its last bricks are far outside; then tells whether the whole brick is one constant.
BrickKind finish(Coefficients& brick, const field::Brick& source, const Eigen::Vector3i& size, std::int16_t band) {
  const bool beyond = ((4 * source.cell).array() + 4 > size.array()).any();
  for (int n = 0; beyond && n < 64; ++n) {
    const Eigen::Vector3i sample = 4 * source.cell + Eigen::Vector3i(n & 3, (n >> 2) & 3, n >> 4);
    if ((sample.array() >= size.array()).any()) brick[static_cast<std::size_t>(n)] = band;
  }
  const auto all = [&](int value) { return std::all_of(brick.begin(), brick.end(), [=](std::int16_t c) { return c == value; }); };
  return all(band) ? BrickKind::kOutside : all(-band) ? BrickKind::kInside : BrickKind::kStored;
}

void store_header(std::uint8_t* at, const field::BandField& field, const FieldInfo& info) {
  std::copy(kMagic.begin(), kMagic.end(), at);
  store_le(at + kMajorAt, kMajor);
  store_le(at + kMinorAt, info.interpolation == Interpolation::kTrilinear ? kMinorTrilinear : kMinor);
  store_le(at + kHeaderBytesAt, static_cast<std::uint32_t>(kHeaderBytes));
  store_le(at + kSourceHashAt, info.source_hash);
  const auto edge = in_format<MmPerVoxel>(field.grid.edge, 1.0 / 64, 16, "the voxel edge in mm");
  store_le(at + kEdgeAt, edge.raw());
  store_le(at + kInverseEdgeAt, static_cast<std::int32_t>(((std::int64_t{1} << 45) / edge.raw() + 1) / 2));
  store_le(at + kBandAt, in_format<Distance>(field.band, 1, 7.99, "the band in voxels").raw());
  store_le(at + kStiffnessAt, in_format<Stiffness>(info.stiffness_n_per_mm, 1.0 / (1 << 16), 100, "the stiffness in N/mm").raw());
  for (int axis = 0; axis < 3; ++axis) {
    const int size = field.grid.size[axis];
    if (size < 8 || size > static_cast<int>(kMaxSize)) {
      throw InputError("the grid has " + std::to_string(size) +
                       " samples along one axis, a field holds 8 to 4096; choose another --voxel or --grid");
    }
    store_le(at + kSizeAt + 4 * axis, size);
    store_le(at + kRootSizeAt + 4 * axis, (size + 15) >> kNodeShift);
    store_le(at + kOriginAt + 4 * axis, in_format<Mm>(field.grid.origin[axis], -512, 512, "the grid's corner in mm").raw());
    store_le(at + kOffsetAt + 8 * axis, std::bit_cast<std::uint64_t>(info.placement.offset[axis]));
  }
  store_le(at + kMethodAt, static_cast<std::uint32_t>(info.method));
  store_le(at + kInterpolationAt, static_cast<std::uint32_t>(info.interpolation));
  store_le(at + kPointCountAt, info.point_count);
  store_le(at + kScaleAt, std::bit_cast<std::uint64_t>(info.placement.scale));
}

/// Rounded up: what is promised from above must hold.
void store_certificate(std::uint8_t* at, const Certificate& certificate) {
  const auto store = [at](std::size_t offset, double value, int bits) {
    store_le(at + offset, static_cast<std::uint32_t>(std::clamp(std::ceil(std::ldexp(value, bits)), 0.0, 4294967295.0)));
  };
  store(kMaxSlopeAt, certificate.largest_slope, 16);
  store(kQuantisationAt, certificate.quantisation_voxel, 24);
  store(kThinnestWallAt, certificate.thinnest_wall_voxel, 16);
  store_le(at + kAdvisedStiffnessAt, static_cast<std::uint32_t>(std::ldexp(certificate.stiffness_n_per_mm, Stiffness::kFractionBits)));
  store_le(at + kAdvisedPeriodAt, certificate.period_ns);
  store(kAdvisedDampingAt, certificate.damping_ns_per_mm, Damping::kFractionBits);
  store_le(at + kAdvisedDelayAt, certificate.delay_ticks);
}

/// Each stored brick's stiffness in 255ths of the largest, and none for bricks 0 and 1.
std::vector<std::uint8_t> stiffness_table(const std::vector<double>& stiffness, const std::vector<std::size_t>& stored) {
  if (stiffness.empty()) return {};
  const double unit = *std::max_element(stiffness.begin(), stiffness.end()) / kFullStiffness;
  std::vector<std::uint8_t> table(2);
  for (const std::size_t b : stored) {
    table.push_back(static_cast<std::uint8_t>(std::clamp(std::floor(stiffness[b] / unit + 0.5), 1.0, double{kFullStiffness})));
  }
  return table;
}

}  // namespace

field_file::OpenField write_field(field::BandField field, FieldInfo info) {
  if (info.method == Method::kPublished) info.interpolation = Interpolation::kTrilinear;
  std::array<std::uint8_t, kHeaderBytes> header{};
  store_header(header.data(), field, info);  // before the work: it refuses what does not fit

  const std::vector<Neighbours> around = neighbours(field);
  const field::BandField held =
      info.method == Method::kPublished ? std::move(field) : round_creases(std::move(field), around);  // what the grid can hold
  const int steps = info.interpolation == Interpolation::kSpline ? kSplineSteps : 0;
  std::vector<Coefficients> coefficients = spline_coefficients(held, around, steps);
  if (info.method != Method::kPublished) drop_small_components(coefficients, around);
  const auto band = static_cast<std::int16_t>(load_le<std::int32_t>(&header[kBandAt]));
  std::vector<BrickKind> kinds(coefficients.size());
  for (std::size_t b = 0; b < kinds.size(); ++b) kinds[b] = finish(coefficients[b], held.bricks[b], held.grid.size, band);
  store_certificate(header.data(), certify(held, around, coefficients));
  const BrickTree tree = brick_tree(BrickRows(held), kinds);

  const std::size_t nodes_at = align64(kHeaderBytes + 4 * tree.root.size());
  const std::size_t bricks_at = align64(nodes_at + 4 * tree.nodes.size());
  const std::size_t bricks_end = bricks_at + sizeof(Coefficients) * (tree.stored.size() + 2);
  const std::vector<std::uint8_t> table = stiffness_table(held.stiffness, tree.stored);
  const std::size_t bytes = bricks_end + table.size();
  if (bytes > std::numeric_limits<std::uint32_t>::max()) {
    throw InputError("the field needs " + std::to_string(bytes) + " bytes, at most 4 GB fit; choose a larger --voxel or a smaller --band");
  }
  field_file::Image image(bytes);
  std::uint8_t* at = image.data();
  std::copy(header.begin(), header.end(), at);
  store_le(at + kTotalBytesAt, static_cast<std::uint64_t>(bytes));
  store_le(at + kNodeCountAt, static_cast<std::uint32_t>(tree.nodes.size() / kBricksPerNode));
  store_le(at + kBrickCountAt, static_cast<std::uint32_t>(tree.stored.size() + 2));
  store_le(at + kRootOffsetAt, static_cast<std::uint32_t>(kHeaderBytes));
  store_le(at + kNodeOffsetAt, static_cast<std::uint32_t>(nodes_at));
  store_le(at + kBrickOffsetAt, static_cast<std::uint32_t>(bricks_at));
  if (!table.empty()) {
    if (info.interpolation == Interpolation::kSpline) store_le(at + kMinorAt, kMinorWithTable);
    store_le(at + kStiffnessTableAt, static_cast<std::uint32_t>(bricks_end));
  }

  static_assert(std::endian::native == std::endian::little, "tables are copied as they are");
  std::memcpy(at + kHeaderBytes, tree.root.data(), 4 * tree.root.size());
  std::memcpy(at + nodes_at, tree.nodes.data(), 4 * tree.nodes.size());
  Coefficients brick;
  std::uint8_t* brick_at = at + bricks_at;
  const auto append = [&](const Coefficients& values) {
    brick_at = std::copy_n(reinterpret_cast<const std::uint8_t*>(&values), sizeof values, brick_at);
  };
  brick.fill(band);
  append(brick);
  brick.fill(static_cast<std::int16_t>(-band));
  append(brick);
  for (const std::size_t b : tree.stored) append(coefficients[b]);
  assert(brick_at == at + bricks_end);
  std::copy(table.begin(), table.end(), brick_at);
  store_le(at + kChecksumAt, crc32(at + kTotalBytesAt, bytes - kTotalBytesAt));

  const Result<FieldView> view = FieldView::parse(image.bytes());
  if (!view) {  // the one thing that a field can still have wrong
    throw InputError("the surface reaches the border of the grid: the points do not enclose a body, check their normals");
  }
  return {std::move(image), *view};
}

field_file::Image write_image(field::BandField field, FieldInfo info) { return write_field(std::move(field), info).image; }

FieldInfo info_of(const FieldView& view) {
  const std::uint8_t* at = view.image.data();
  const auto real = [at](std::size_t offset) { return std::bit_cast<double>(load_le<std::uint64_t>(at + offset)); };
  FieldInfo info;
  info.stiffness_n_per_mm = static_cast<double>(view.stiffness.raw()) / (1 << Stiffness::kFractionBits);
  info.source_hash = load_le<std::uint64_t>(at + kSourceHashAt);
  info.method = view.method;
  info.interpolation = view.interpolation;
  info.point_count = load_le<std::uint32_t>(at + kPointCountAt);
  info.placement = {real(kScaleAt), {real(kOffsetAt), real(kOffsetAt + 8), real(kOffsetAt + 16)}};
  return info;
}

}  // namespace isotouch::encoding
