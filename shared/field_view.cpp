#include "shared/field_view.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <optional>

#include "shared/bytes.h"
#include "shared/crc32.h"
#include "shared/hash64.h"

namespace isotouch {

static_assert(std::endian::native == std::endian::little, "the image is used in place and is little-endian");

namespace {

using namespace image_layout;

/// The inverse of SPEC's reciprocal, by the exact test: is `inverse` the integer nearest to 2^44 / edge?
bool is_reciprocal(std::int64_t edge, std::int64_t inverse) {
  const std::int64_t miss = edge * inverse - (std::int64_t{1} << 44);
  return 2 * std::max(miss, -miss) <= edge;
}

bool all_equal(const std::uint32_t* values, std::uint32_t expected) {
  return std::all_of(values, values + kBricksPerNode, [=](std::uint32_t v) { return v == expected; });
}

/// True when the entries refer to each of the nodes or bricks that are stored, those from 2 up to `count`, once and in this order. No image can then
/// refer to so much of itself that what is made of it is far larger.
bool each_once(const std::uint32_t* entries, const std::uint32_t* end, std::uint32_t count) {
  std::uint32_t next = kInside + 1;
  bool in_order = true;
  for (; entries != end; ++entries) {  // without a branch: which entries are stored is hard to predict
    const bool stored = *entries > kInside;
    in_order &= !stored | (*entries == next);
    next += stored ? 1 : 0;
  }
  return in_order && next == count;
}

bool all_equal(const std::int16_t* values, std::int32_t expected) {
  return std::all_of(values, values + kSamplesPerBrick, [=](std::int16_t v) { return v == expected; });
}

/// True when no stored number is beyond the band.
bool is_within_band(const FieldView& view) {
  const std::int32_t band = view.band.raw();
  const std::int16_t* end = view.bricks + std::size_t{view.brick_count} * kSamplesPerBrick;
  return std::none_of(view.bricks, end, [band](std::int16_t number) { return number > band || number < -band; });
}

/// True when the two outermost layers on all sides are far outside, and all samples beyond them in the last nodes: nothing is open towards the border.
bool border_is_outside(const FieldView& view) {
  const auto outermost = [&](std::int32_t index, std::size_t axis) { return index < 2 || index >= view.size[axis] - 2; };
  const auto holds_outermost = [&](std::int32_t first, std::size_t axis) { return first == 0 || outermost(first + 3, axis); };
  const auto is_outside = [&](std::int32_t i, std::int32_t j, std::int32_t k) {
    if (view.brick_number(i, j, k) == kOutside) return true;
    const std::int16_t* coefficient = view.brick(i, j, k);
    for (std::int32_t n = 0; n < static_cast<std::int32_t>(kSamplesPerBrick); ++n) {
      const std::int32_t x = i + (n & 3), y = j + (n >> 2 & 3), z = k + (n >> 4);
      if ((outermost(x, 0) || outermost(y, 1) || outermost(z, 2)) && coefficient[n] != view.band.raw()) return false;
    }
    return true;
  };
  const auto end = [&](std::size_t axis) { return view.root_size[axis] << kNodeShift; };
  for (std::int32_t k = 0; k < end(2); k += 4) {
    for (std::int32_t j = 0; j < end(1); j += 4) {
      const bool whole_row = holds_outermost(k, 2) || holds_outermost(j, 1);
      for (std::int32_t i = 0; i < end(0); i += 4) {
        if ((whole_row || holds_outermost(i, 0)) && !is_outside(i, j, k)) return false;
      }
    }
  }
  return true;
}

/// True when every stored brick has a stiffness, and no constant one.
bool is_stiffness_table(const FieldView& view) {
  const std::uint8_t* parts = view.stiffness_parts;
  return parts[kOutside] == 0 && parts[kInside] == 0 &&
         std::none_of(parts + kInside + 1, parts + view.brick_count, [](std::uint8_t part) { return part == 0; });
}

/// What must hold before the checksum of an image is worth computing; nothing when all of it does.
std::optional<Error> outline_error(std::span<const std::uint8_t> header, std::uint64_t image_bytes) {
  const std::uint8_t* at = header.data();
  if (header.size() < kMagic.size() || !std::equal(kMagic.begin(), kMagic.end(), at)) return Error::kBadMagic;
  if (header.size() < kHeaderBytes) return Error::kTruncated;
  if (load_le<std::uint16_t>(at + kMajorAt) != kMajor) return Error::kBadVersion;
  if (load_le<std::uint32_t>(at + kHeaderBytesAt) != kHeaderBytes) return Error::kBadHeader;
  const auto total = load_le<std::uint64_t>(at + kTotalBytesAt);
  if (total > image_bytes) return Error::kTruncated;
  if (total != image_bytes || total > 0xFFFFFFFFU) return Error::kBadSize;

  return std::nullopt;
}

}  // namespace

Result<FieldView> FieldView::of_header(std::span<const std::uint8_t> header, std::uint64_t image_bytes) {
  if (const auto wrong = outline_error(header, image_bytes)) return *wrong;
  const std::uint8_t* at = header.data();
  FieldView view;
  const auto field = [at](std::size_t offset) { return load_le<std::int32_t>(at + offset); };
  view.origin = {Mm::from_raw(field(kOriginAt)), Mm::from_raw(field(kOriginAt + 4)), Mm::from_raw(field(kOriginAt + 8))};
  view.edge = MmPerVoxel::from_raw(field(kEdgeAt));
  view.inverse_edge = VoxelPerMm::from_raw(field(kInverseEdgeAt));
  view.band = Distance::from_raw(field(kBandAt));
  view.stiffness = Stiffness::from_raw(field(kStiffnessAt));
  view.interpolation = Interpolation{load_le<std::uint32_t>(at + kInterpolationAt)};
  view.method = Method{load_le<std::uint32_t>(at + kMethodAt)};
  if (const auto slope = load_le<std::uint32_t>(at + kMaxSlopeAt); slope > 1U << kSlopeBits) {
    view.inverse_slope = Ratio::from_raw(static_cast<std::int32_t>((std::uint64_t{1} << (Ratio::kFractionBits + kSlopeBits)) / slope));
  }
  view.node_count = load_le<std::uint32_t>(at + kNodeCountAt);
  view.brick_count = load_le<std::uint32_t>(at + kBrickCountAt);

  for (const Mm component : {view.origin.x, view.origin.y, view.origin.z}) {
    if (component < Mm::of(-512) || component > Mm::of(512)) return Error::kBadHeader;
  }
  if (view.edge < MmPerVoxel::of(1.0 / 64) || view.edge > MmPerVoxel::of(16)) return Error::kBadHeader;
  if (!is_reciprocal(view.edge.raw(), view.inverse_edge.raw())) return Error::kBadHeader;
  if (view.interpolation != Interpolation::kSpline && view.interpolation != Interpolation::kTrilinear) return Error::kBadHeader;
  const bool published = view.method == Method::kPublished;
  if (published ? view.interpolation != Interpolation::kTrilinear : view.method != Method::kDefault) return Error::kBadHeader;
  if (view.band < Distance::of(1) || view.band > Distance::of(7.99)) return Error::kBadHeader;
  if (view.stiffness <= Stiffness{} || view.stiffness > Stiffness::of(100)) return Error::kBadHeader;

  std::uint64_t root_cells = 1;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto size = load_le<std::uint32_t>(at + kSizeAt + 4 * axis);
    const auto root_size = load_le<std::uint32_t>(at + kRootSizeAt + 4 * axis);
    if (size < 8 || size > kMaxSize) return Error::kBadHeader;
    if (root_size != (size + 15) >> kNodeShift) return Error::kBadSize;
    view.size[axis] = static_cast<std::int32_t>(size);
    view.root_size[axis] = static_cast<std::int32_t>(root_size);
    root_cells *= root_size;
  }
  if (view.node_count < 2 || view.brick_count < 2) return Error::kBadHeader;
  const std::uint64_t nodes_at = align64(kHeaderBytes + 4 * root_cells);
  const std::uint64_t bricks_at = align64(nodes_at + std::uint64_t{view.node_count} * kBricksPerNode * 4);
  const std::uint64_t bricks_end = bricks_at + std::uint64_t{view.brick_count} * kSamplesPerBrick * 2;
  const auto table_at = load_le<std::uint32_t>(at + kStiffnessTableAt);
  if (load_le<std::uint32_t>(at + kRootOffsetAt) != kHeaderBytes || load_le<std::uint32_t>(at + kNodeOffsetAt) != nodes_at ||
      load_le<std::uint32_t>(at + kBrickOffsetAt) != bricks_at || (table_at != 0 && table_at != bricks_end) ||
      image_bytes != bricks_end + (table_at != 0 ? view.brick_count : 0)) {
    return Error::kBadSize;
  }
  return view;
}

Result<FieldView> FieldView::parse(std::span<const std::uint8_t> image) {
  const std::uint8_t* at = image.data();
  if (reinterpret_cast<std::uintptr_t>(at) % 8 != 0) return Error::kMisaligned;
  const auto header = image.first(std::min(image.size(), kHeaderBytes));
  if (const auto wrong = outline_error(header, image.size())) return *wrong;
  if (crc32(at + kTotalBytesAt, image.size() - kTotalBytesAt) != load_le<std::uint32_t>(at + kChecksumAt)) return Error::kBadChecksum;
  const Result<FieldView> described = of_header(header, image.size());
  if (!described) return described.error();

  FieldView view = *described;
  view.image = image;
  view.root = reinterpret_cast<const std::uint32_t*>(at + kHeaderBytes);
  view.nodes = reinterpret_cast<const std::uint32_t*>(at + load_le<std::uint32_t>(at + kNodeOffsetAt));
  view.bricks = reinterpret_cast<const std::int16_t*>(at + load_le<std::uint32_t>(at + kBrickOffsetAt));
  if (const auto table_at = load_le<std::uint32_t>(at + kStiffnessTableAt); table_at != 0) view.stiffness_parts = at + table_at;

  const std::uint32_t* root_end =
      view.root + std::size_t(view.root_size[0]) * std::size_t(view.root_size[1]) * std::size_t(view.root_size[2]);
  if (!each_once(view.root, root_end, view.node_count)) return Error::kBadIndex;
  const std::uint32_t* nodes_end = view.nodes + std::size_t{view.node_count} * kBricksPerNode;
  if (!all_equal(view.nodes, kOutside) || !all_equal(view.nodes + kBricksPerNode, kInside)) return Error::kBadIndex;
  if (!each_once(view.nodes + 2 * kBricksPerNode, nodes_end, view.brick_count)) return Error::kBadIndex;
  if (!all_equal(view.bricks, view.band.raw()) || !all_equal(view.bricks + kSamplesPerBrick, -view.band.raw())) return Error::kBadIndex;
  if (!is_within_band(view)) return Error::kBadSample;
  if (!border_is_outside(view)) return Error::kBadIndex;
  if (view.stiffness_parts != nullptr && !is_stiffness_table(view)) return Error::kBadIndex;
  return view;
}

std::uint64_t FieldView::hash() const { return hash64(image.data(), image.size()); }

}  // namespace isotouch
