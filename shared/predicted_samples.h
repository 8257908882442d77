/// The samples of an image in the order of SPEC.md 4.3, each with its prediction from those before it.
///
/// tick      no
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>

#include "shared/field_view.h"
#include "shared/image_parts.h"

namespace isotouch {

static_assert(std::endian::native == std::endian::little, "tables and bricks are used in place and are little-endian");

/// Which rule predicted a sample; each has a stream of its own.
enum Rule : std::size_t { kCorner, kPlanes, kLines, kNothing, kRules };

struct Prediction {
  Rule rule;
  std::int32_t value;
};

/// The mean of what can be told.
struct Mean {
  std::int32_t sum = 0;
  std::int32_t count = 0;

  void add_if(bool known, std::int32_t value) {
    sum += known ? value : 0;
    count += known ? 1 : 0;
  }
  std::int32_t value() const { return count == 1 ? sum : count == 2 ? sum / 2 : sum / 3; }
};

/// Four numbers at once. Of int, which a comparison gives, and not std::int32_t, which may be another type of the same size.
using Four = int __attribute__((vector_size(16)));
static_assert(sizeof(Four) == 4 * sizeof(std::int32_t));

/// What the rows before a row of four samples tell of it; the first of these samples it does not know.
struct RowAhead {
  Four corner;  ///< the corner's formula without the sample before on x
  Four known;   ///< are all others that it takes known?
  Four blank;   ///< are neither of the samples before on y and z known?
};

/// A brick behind the two layers before it on each axis: 6 samples a side, x fastest.
class Window {
 public:
  static constexpr int kY = 6, kZ = 36;
  static constexpr std::size_t index(int x, int y, int z) { return static_cast<std::size_t>(x + kY * y + kZ * z); }

  std::int16_t* at(int x, int y, int z) { return &samples_[index(x, y, z)]; }
  const std::int16_t* at(int x, int y, int z) const { return &samples_[index(x, y, z)]; }
  void fill(std::int32_t value) { samples_.fill(static_cast<std::int16_t>(value)); }

  /// Copies the layers before the brick out of the seven bricks before it.
  ///
  /// before    [z][y][x], 0 the cell before and 1 the cell itself on that axis; the last one, the brick itself, is not read
  void gather(const std::array<const std::int16_t*, 8>& before) {
    for (int z = 0; z < 6; ++z) {
      for (int y = 0; y < 6; ++y) {
        const std::size_t pair = (z >= 2 ? 4U : 0U) | (y >= 2 ? 2U : 0U);
        const int row = (((z + 2) & 3) << 4) | (((y + 2) & 3) << 2);
        std::memcpy(at(0, y, z), before[pair] + row + 2, 2 * sizeof(std::int16_t));
        if (pair != 6) std::memcpy(at(2, y, z), before[pair | 1U] + row, 4 * sizeof(std::int16_t));
      }
    }
  }

  /// Puts the brick's own samples in.
  void put(const std::int16_t* brick) {
    for (int z = 2; z < 6; ++z) {
      for (int y = 2; y < 6; ++y, brick += 4) std::memcpy(at(2, y, z), brick, 4 * sizeof *brick);
    }
  }

  /// Four samples of a row.
  static Four load(const std::int16_t* at) {
    std::int16_t __attribute__((vector_size(8))) row;
    std::memcpy(&row, at, sizeof row);
    return __builtin_convertvector(row, Four);
  }

  static Four known(Four row, std::int32_t band) { return (row < band) & (row > -band); }

  /// at        the first sample of a row of the brick; the rows before it are there
  static RowAhead row_ahead(const std::int16_t* at, std::int32_t band) {
    const Four y = load(at - kY), z = load(at - kZ), xy = load(at - 1 - kY), xz = load(at - 1 - kZ), yz = load(at - kY - kZ),
               xyz = load(at - 1 - kY - kZ);
    const Four has_y = known(y, band), has_z = known(z, band);
    return {y + z - xy - xz - yz + xyz, has_y & has_z & known(xy, band) & known(xz, band) & known(yz, band) & known(xyz, band),
            ~(has_y | has_z)};
  }

  /// What SPEC.md 4.3 expects at `at`, a sample of the brick; those before it are there.
  static Prediction predict(const std::int16_t* at, std::int32_t band) {
    const auto s = [at](int x, int y, int z) -> std::int32_t { return at[-(x + kY * y + kZ * z)]; };
    const auto known = [band](std::int32_t sample) { return std::abs(sample) < band; };
    const std::int32_t x = s(1, 0, 0), y = s(0, 1, 0), z = s(0, 0, 1), xy = s(1, 1, 0), xz = s(1, 0, 1), yz = s(0, 1, 1), xyz = s(1, 1, 1);
    const bool has_x = known(x), has_y = known(y), has_z = known(z), has_xy = known(xy), has_xz = known(xz), has_yz = known(yz);
    const std::int32_t corner = std::clamp(x + y + z - xy - xz - yz + xyz, -band, band);
    if (has_x & has_y & has_z & has_xy & has_xz & has_yz & known(xyz)) return {kCorner, corner};
    if (!(has_x | has_y | has_z)) return {kNothing, corner};  // what every other rule needs, and a quarter of all samples has not

    Mean planes;
    planes.add_if(has_x & has_y & has_xy, x + y - xy);
    planes.add_if(has_x & has_z & has_xz, x + z - xz);
    planes.add_if(has_y & has_z & has_yz, y + z - yz);
    if (planes.count > 0) return {kPlanes, std::clamp(planes.value(), -band, band)};

    Mean lines;
    const std::int32_t xx = s(2, 0, 0), yy = s(0, 2, 0), zz = s(0, 0, 2);
    lines.add_if(has_x & known(xx), 2 * x - xx);
    lines.add_if(has_y & known(yy), 2 * y - yy);
    lines.add_if(has_z & known(zz), 2 * z - zz);
    if (lines.count > 0) return {kLines, std::clamp(lines.value(), -band, band)};
    return {kNothing, corner};
  }

 private:
  std::array<std::int16_t, 6 * 6 * 6> samples_{};
};

/// Visits the bricks in SPEC's order. `Sample` is const where the image is read, and written by `visit` where it is restored.
template <class Sample>
class PredictedSamples {
 public:
  PredictedSamples(const ImageParts& parts, const std::uint8_t* image, Sample* bricks)
      : parts_(parts),
        root_(reinterpret_cast<const std::uint32_t*>(image + parts.root_at)),
        nodes_(reinterpret_cast<const std::uint32_t*>(image + parts.nodes_at)),
        bricks_(bricks) {}

  /// visit     (Window&, Sample*): the window of a brick, whose own samples `visit` has to put in, and these samples
  template <class Visit>
  void for_each_brick(Visit&& visit) {
    window_.fill(parts_.band);
    visit(window_, brick(next_++));
    window_.fill(-parts_.band);
    visit(window_, brick(next_++));
    const auto [nx, ny, nz] = signed_root_size();
    std::uint32_t next_node = 2;
    const std::uint32_t* cell = root_;
    for (int z = 0; z < nz; ++z) {
      for (int y = 0; y < ny; ++y) {
        for (int x = 0; x < nx; ++x, ++cell) {
          if (*cell == next_node) visit_node(next_node++, 4 * x, 4 * y, 4 * z, visit);
        }
      }
    }
    window_.fill(parts_.band);
    while (next_ < parts_.brick_count) visit(window_, brick(next_++));
  }

 private:
  std::array<int, 3> signed_root_size() const {
    return {static_cast<int>(parts_.root_size[0]), static_cast<int>(parts_.root_size[1]), static_cast<int>(parts_.root_size[2])};
  }

  template <class Visit>
  void visit_node(std::uint32_t node, int x, int y, int z, Visit&& visit) {
    for (int slot = 0; slot < 64; ++slot) {
      if (nodes_[std::size_t{node} * image_layout::kBricksPerNode + static_cast<std::size_t>(slot)] != next_ || next_ >= parts_.brick_count)
        continue;
      window_.gather(bricks_before(x + (slot & 3), y + ((slot >> 2) & 3), z + (slot >> 4)));
      visit(window_, brick(next_++));
    }
  }

  Sample* brick(std::uint32_t number) const { return bricks_ + std::size_t{number} * image_layout::kSamplesPerBrick; }

  std::array<const std::int16_t*, 8> bricks_before(int x, int y, int z) const {
    std::array<const std::int16_t*, 8> before{};
    for (int n = 0; n < 7; ++n)
      before[static_cast<std::size_t>(n)] = brick(earlier(x - 1 + (n & 1), y - 1 + ((n >> 1) & 1), z - 1 + (n >> 2)));
    before[7] = before[0];  // never read
    return before;
  }

  /// The number of the brick in a cell; brick 0 when it is outside the grid or not visited yet.
  std::uint32_t earlier(int x, int y, int z) const {
    if ((x | y | z) < 0) return image_layout::kOutside;
    const auto [nx, ny, nz] = signed_root_size();
    const std::uint32_t node = root_[((z >> 2) * ny + (y >> 2)) * nx + (x >> 2)];
    const std::uint32_t number =
        nodes_[std::size_t{node} * image_layout::kBricksPerNode + static_cast<std::size_t>(((z & 3) << 4) | ((y & 3) << 2) | (x & 3))];
    return number < next_ ? number : image_layout::kOutside;
  }

  ImageParts parts_;
  const std::uint32_t* root_;
  const std::uint32_t* nodes_;
  Sample* bricks_;
  std::uint32_t next_ = 0;  ///< number of the brick to visit
  Window window_;
};

}  // namespace isotouch
