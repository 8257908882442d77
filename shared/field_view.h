/// A field: a signed distance as one memory image (SPEC.md, section 2). `FieldView::parse` checks everything once; after it nothing can
/// go wrong: every look-up with sample indices inside `size` lands inside the image.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "shared/envelope.h"
#include "shared/result.h"
#include "shared/units.h"
#include "shared/vec3.h"

namespace isotouch {

/// Byte offsets of the header's fields, in the order of SPEC.md 2.3.
namespace image_layout {
inline constexpr std::array<std::uint8_t, 4> kMagic = {'I', 'T', 'F', 'B'};
inline constexpr std::uint16_t kMajor = 1;
inline constexpr std::uint16_t kMinor = 1;  ///< of an image without a stiffness table
inline constexpr std::uint16_t kMinorWithTable = 2;
inline constexpr std::uint16_t kMinorTrilinear = 3;  ///< with or without a table; the newest
using namespace envelope_layout;
inline constexpr std::size_t kSourceHashAt = 24;
inline constexpr std::size_t kOriginAt = 32;
inline constexpr std::size_t kEdgeAt = 44;
inline constexpr std::size_t kInverseEdgeAt = 48;
inline constexpr std::size_t kBandAt = 52;
inline constexpr std::size_t kSizeAt = 56;
inline constexpr std::size_t kRootSizeAt = 68;
inline constexpr std::size_t kStiffnessAt = 80;
inline constexpr std::size_t kNodeCountAt = 84;
inline constexpr std::size_t kBrickCountAt = 88;
inline constexpr std::size_t kRootOffsetAt = 92;
inline constexpr std::size_t kNodeOffsetAt = 96;
inline constexpr std::size_t kBrickOffsetAt = 100;
inline constexpr std::size_t kMethodAt = 104;
inline constexpr std::size_t kPointCountAt = 108;
inline constexpr std::size_t kScaleAt = 112;
inline constexpr std::size_t kOffsetAt = 120;
inline constexpr std::size_t kMaxSlopeAt = 144;
inline constexpr std::size_t kQuantisationAt = 148;
inline constexpr std::size_t kThinnestWallAt = 152;
inline constexpr std::size_t kAdvisedStiffnessAt = 156;
inline constexpr std::size_t kAdvisedPeriodAt = 160;
inline constexpr std::size_t kAdvisedDampingAt = 164;
inline constexpr std::size_t kAdvisedDelayAt = 168;
inline constexpr std::size_t kStiffnessTableAt = 172;
inline constexpr std::size_t kInterpolationAt = 176;
inline constexpr std::size_t kHeaderBytes = 256;

inline constexpr int kBrickShift = 2;  ///< 4 samples a side
inline constexpr int kNodeShift = 4;   ///< 16 samples a side
inline constexpr std::size_t kSamplesPerBrick = 64;
inline constexpr std::size_t kBricksPerNode = 64;
inline constexpr std::uint32_t kMaxSize = 4096;
inline constexpr std::uint32_t kOutside = 0;  ///< number of the brick, and of the node, that is far outside throughout
inline constexpr std::uint32_t kInside = 1;   ///< the same, far inside
inline constexpr int kSlopeBits = 16;         ///< fraction bits of the largest slope
inline constexpr int kFullStiffness = 255;    ///< in the stiffness table: as much as the header says

template <class T>
constexpr T align64(T bytes) {  // in the caller's width: a hostile size must not wrap where std::size_t has 32 bits
  return (bytes + 63) & ~T{63};
}
}  // namespace image_layout

/// What a field is between its samples, and so what its numbers are (SPEC.md 2.1).
enum class Interpolation : std::uint32_t {
  kSpline = 0,     ///< a quadratic B-spline: the numbers are its coefficients
  kTrilinear = 1,  ///< linear along each axis: the numbers are the distances at the samples
};

/// How a field was built, and so how it is rendered.
enum class Method : std::uint32_t {
  kDefault = 0,
  kPublished = 1,  ///< levels, rendered by the published descent; always trilinear
};

/// A coefficient or distance as the image stores it.
using Distance = Fixed<Unit<0, 0, 0, 1>, 12>;

/// A checked image. Trivially copyable; borrows the bytes.
///
/// tick      every member but `parse` and `hash`
struct FieldView {
  Vec3<Mm> origin;  ///< workspace position of sample (0, 0, 0)
  MmPerVoxel edge;
  VoxelPerMm inverse_edge;
  Distance band;
  Interpolation interpolation = Interpolation::kSpline;
  Method method = Method::kDefault;
  Stiffness stiffness;                      ///< the largest, where there is a table of it
  Ratio inverse_slope = Ratio::of(1);       ///< how much of a distance is surely free way: 1 / the largest slope where that is above 1
  std::array<std::int32_t, 3> size{};       ///< samples along x, y, z
  std::array<std::int32_t, 3> root_size{};  ///< nodes along x, y, z
  std::uint32_t node_count = 0;
  std::uint32_t brick_count = 0;
  const std::uint32_t* root = nullptr;
  const std::uint32_t* nodes = nullptr;
  const std::int16_t* bricks = nullptr;
  const std::uint8_t* stiffness_parts = nullptr;  ///< of each brick, in 255ths of `stiffness`, 0 for bricks 0 and 1; nullptr = one for all
  std::span<const std::uint8_t> image;

  /// Checks a header before there is memory for what it describes. The view has no tables and no bricks yet.
  ///
  /// header       the first bytes of the image
  /// image_bytes  of the whole image
  /// fails        as `parse`, without what it finds behind the header
  /// tick         no
  static Result<FieldView> of_header(std::span<const std::uint8_t> header, std::uint64_t image_bytes);

  /// Checks `image` completely and returns the view on it.
  ///
  /// image     8-byte aligned, stays alive and unchanged as long as the view is used
  /// fails     kMisaligned, kTruncated, kBadMagic, kBadVersion, kBadHeader (a field outside SPEC's range), kBadSize (layout not as SPEC computes it),
  ///           kBadChecksum, kBadIndex (an entry outside its table; a stored node or brick without a place of its own, or out of order; a constant node or
  ///           brick that is not; a border, or what lies beyond it, that is not far outside; a stiffness for a constant brick, or none for another), kBadSample
  ///           (a number beyond the band)
  /// tick      no: it reads the whole image
  static Result<FieldView> parse(std::span<const std::uint8_t> image);

  /// Where `root` has the entry for sample (i, j, k), each index within [0, size), and where that node has its own.
  std::size_t root_entry(std::int32_t i, std::int32_t j, std::int32_t k) const {
    using image_layout::kNodeShift;
    return static_cast<std::size_t>((((k >> kNodeShift) * root_size[1]) + (j >> kNodeShift)) * root_size[0] + (i >> kNodeShift));
  }
  static std::size_t node_entry(std::uint32_t node, std::int32_t i, std::int32_t j, std::int32_t k) {
    using namespace image_layout;
    const auto slot = (((k >> kBrickShift) & 3) << 4) | (((j >> kBrickShift) & 3) << 2) | ((i >> kBrickShift) & 3);
    return node * kBricksPerNode + static_cast<std::size_t>(slot);
  }

  /// The number of the brick that holds sample (i, j, k), each index within [0, size).
  std::uint32_t brick_number(std::int32_t i, std::int32_t j, std::int32_t k) const {
    return nodes[node_entry(root[root_entry(i, j, k)], i, j, k)];
  }

  /// Its 64 coefficients.
  const std::int16_t* brick(std::int32_t i, std::int32_t j, std::int32_t k) const {
    return bricks + std::size_t{brick_number(i, j, k)} * image_layout::kSamplesPerBrick;
  }

  /// The coefficient of one sample, each index within [0, size).
  std::int16_t coefficient(std::int32_t i, std::int32_t j, std::int32_t k) const {
    return brick(i, j, k)[((k & 3) << 4) | ((j & 3) << 2) | (i & 3)];
  }

  /// The hash that names this image (SPEC.md: XXH64 of all its bytes).
  std::uint64_t hash() const;
};

}  // namespace isotouch
