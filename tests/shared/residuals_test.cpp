#include "shared/residuals.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <map>
#include <span>
#include <vector>

#include "shared/bytes.h"
#include "shared/crc32.h"
#include "shared/field_view.h"
#include "shared/hash64.h"
#include "tests/support/alloc_guard.h"
#include "tests/support/field_image.h"
#include "tests/support/random.h"

namespace isotouch {
namespace {

using namespace image_layout;
using Bytes = std::vector<std::uint8_t>;

/// An image made of integers alone, the same on every machine.
struct Tree {
  std::array<std::uint32_t, 3> size{};
  std::vector<std::uint32_t> root;
  std::vector<std::array<std::uint32_t, 64>> nodes;
  std::vector<std::array<std::int16_t, 64>> bricks;
  std::int32_t band = 4 * 4096;
  std::size_t tail = 0;  ///< bytes behind the bricks

  static constexpr std::uint32_t kGap = 64;  ///< bytes between the tables that no layout explains

  std::uint32_t nodes_at() const { return static_cast<std::uint32_t>(kHeaderBytes + align64(4 * root.size())) + kGap; }
  std::uint32_t bricks_at() const { return nodes_at() + static_cast<std::uint32_t>(256 * nodes.size()); }

  std::vector<std::uint64_t> image() const {
    const std::size_t bytes = bricks_at() + 128 * bricks.size() + tail;
    std::vector<std::uint64_t> words(bytes / 8);
    auto* at = reinterpret_cast<std::uint8_t*>(words.data());
    for (std::size_t n = 0; n < bytes; ++n) at[n] = static_cast<std::uint8_t>(n * 7);
    std::memcpy(at, "ITFB", 4);
    store_le<std::uint16_t>(at + kMajorAt, 1);
    store_le<std::int32_t>(at + kBandAt, band);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      store_le<std::uint32_t>(at + kSizeAt + 4 * axis, size[axis]);
      store_le<std::uint32_t>(at + kRootSizeAt + 4 * axis, (size[axis] + 15) / 16);
    }
    store_le(at + kNodeCountAt, static_cast<std::uint32_t>(nodes.size()));
    store_le(at + kBrickCountAt, static_cast<std::uint32_t>(bricks.size()));
    store_le(at + kRootOffsetAt, static_cast<std::uint32_t>(kHeaderBytes));
    store_le(at + kNodeOffsetAt, nodes_at());
    store_le(at + kBrickOffsetAt, bricks_at());
    std::memcpy(at + kHeaderBytes, root.data(), 4 * root.size());
    std::memcpy(at + nodes_at(), nodes.data(), 256 * nodes.size());
    std::memcpy(at + bricks_at(), bricks.data(), 128 * bricks.size());
    return words;
  }
};

/// A slope in a general direction with some noise, clamped; the tree either counts up, or is anything that its numbers allow.
Tree random_tree(std::uint64_t seed, bool counts_up) {
  test::Random random(seed);
  const auto below = [&](std::uint64_t limit) { return static_cast<std::uint32_t>(random.bits() % limit); };
  Tree tree;
  for (std::uint32_t& size : tree.size) size = 8 + below(40);
  const auto nodes_along = [&](std::size_t axis) { return (tree.size[axis] + 15) / 16; };
  const std::uint32_t cells = nodes_along(0) * nodes_along(1) * nodes_along(2), bricks = 2 + 20 * cells;
  tree.nodes = {{}, {}};
  tree.nodes[1].fill(1);
  std::uint32_t next = 2;
  for (std::uint32_t cell = 0; cell < cells; ++cell) {
    std::array<std::uint32_t, 64> node{};
    for (std::uint32_t& entry : node) {
      const bool counted = below(3) == 0 && next < bricks;
      entry = counted ? next++ : counts_up || below(2) == 0 ? below(2) : below(bricks);
    }
    tree.root.push_back(counts_up || below(3) != 0 ? static_cast<std::uint32_t>(tree.nodes.size()) : below(2 + cells));
    tree.nodes.push_back(node);
  }
  for (std::uint32_t brick = 0; brick < bricks; ++brick) {
    std::array<std::int16_t, 64> samples{};
    const int slope = static_cast<int>(below(4096)), start = static_cast<int>(below(40000)) - 20000, noise = brick % 7 == 0 ? 65536 : 200;
    for (int n = 0; n < 64; ++n) {
      const int value =
          start + slope * (n & 3) - 1500 * ((n >> 2) & 3) + 900 * (n >> 4) + static_cast<int>(below(static_cast<std::uint64_t>(noise)));
      samples[static_cast<std::size_t>(n)] = static_cast<std::int16_t>(noise > 200 ? value : std::clamp(value, -tree.band, tree.band));
    }
    if (brick < 2) samples.fill(static_cast<std::int16_t>(brick == 0 ? tree.band : -tree.band));
    tree.bricks.push_back(samples);
  }
  tree.tail = 8 * below(5);
  return tree;
}

std::span<const std::uint8_t> bytes_of(const std::vector<std::uint64_t>& words) {
  return {reinterpret_cast<const std::uint8_t*>(words.data()), 8 * words.size()};
}

/// SPEC.md 4.2 and 4.3 word by word, on a grid in doubles and maps, without any of the code under test.
class Twin {
 public:
  explicit Twin(const Tree& tree) : tree_(tree) {
    const auto words = tree.image();
    const auto bytes = bytes_of(words);
    residuals_.assign(bytes.begin() + kHeaderBytes, bytes.end());
    exchange(kHeaderBytes, tree.root.size());
    exchange(tree.nodes_at(), 64 * tree.nodes.size());
    number_cells();
    std::array<Bytes, 4> low, high;
    for (std::uint32_t brick = 0; brick < tree.bricks.size(); ++brick) {
      for (int n = 0; n < 64; ++n) {
        const auto [rule, prediction] = predicted(brick, n & 3, (n >> 2) & 3, n >> 4);
        const int difference = sample(brick, n) - prediction;
        const int wrapped = ((difference + 32768) % 65536 + 65536) % 65536 - 32768;
        const int code = wrapped >= 0 ? 2 * wrapped : -2 * wrapped - 1;
        low[rule].push_back(static_cast<std::uint8_t>(code % 256));
        high[rule].push_back(static_cast<std::uint8_t>(code / 256));
      }
    }
    auto out = residuals_.begin() + static_cast<std::ptrdiff_t>(tree.bricks_at() - kHeaderBytes);
    for (const auto* planes : {&low, &high}) {
      for (const Bytes& stream : *planes) out = std::copy(stream.begin(), stream.end(), out);
    }
    for (std::size_t rule = 0; rule < 4; ++rule) sizes_[rule] = static_cast<std::uint32_t>(low[rule].size());
  }

  const Bytes& residuals() const { return residuals_; }
  const StreamSizes& sizes() const { return sizes_; }

 private:
  using Cell = std::array<int, 3>;

  void exchange(std::size_t image_at, std::size_t entries) {
    std::uint32_t counter = 2;
    for (std::size_t n = 0; n < entries; ++n) {
      std::uint8_t* at = &residuals_[image_at - kHeaderBytes + 4 * n];
      const auto entry = load_le<std::uint32_t>(at);
      if (entry == counter) {
        store_le<std::uint32_t>(at, 2), ++counter;
      } else if (entry == 2) {
        store_le<std::uint32_t>(at, counter);
      }
    }
  }

  int nodes_along(std::size_t axis) const { return static_cast<int>(tree_.size[axis] + 15) / 16; }

  std::uint32_t number(const Cell& c) const {
    const int node = (c[2] / 4 * nodes_along(1) + c[1] / 4) * nodes_along(0) + c[0] / 4;
    return tree_.nodes[tree_.root[static_cast<std::size_t>(node)]][static_cast<std::size_t>(c[2] % 4 * 16 + c[1] % 4 * 4 + c[0] % 4)];
  }

  void number_cells() {
    std::uint32_t next_node = 2, next = 2;
    for (int cell = 0; cell < static_cast<int>(tree_.root.size()); ++cell) {
      if (tree_.root[static_cast<std::size_t>(cell)] != next_node) continue;
      ++next_node;
      for (int slot = 0; slot < 64; ++slot) {
        const Cell c = {4 * (cell % nodes_along(0)) + slot % 4, 4 * (cell / nodes_along(0) % nodes_along(1)) + slot / 4 % 4,
                        4 * (cell / nodes_along(0) / nodes_along(1)) + slot / 16};
        if (number(c) == next) cells_[next++] = c;
      }
    }
  }

  int sample(std::uint32_t brick, int n) const { return tree_.bricks[brick][static_cast<std::size_t>(n)]; }

  /// The sample at (x, y, z) of the brick, each index from -2 to 3.
  int before(std::uint32_t brick, int x, int y, int z) const {
    if (x >= 0 && y >= 0 && z >= 0) return sample(brick, x + 4 * y + 16 * z);
    if (brick < 2) return brick == 0 ? tree_.band : -tree_.band;
    std::uint32_t other = 0;
    if (const auto cell = cells_.find(brick); cell != cells_.end()) {
      const Cell c = {cell->second[0] - (x < 0), cell->second[1] - (y < 0), cell->second[2] - (z < 0)};
      if (std::min({c[0], c[1], c[2]}) >= 0 && number(c) < brick) other = number(c);
    }
    return sample(other, (x + 4) % 4 + 4 * ((y + 4) % 4) + 16 * ((z + 4) % 4));
  }

  std::pair<std::size_t, int> predicted(std::uint32_t brick, int x, int y, int z) const {
    const auto s = [&](int dx, int dy, int dz) { return before(brick, x - dx, y - dy, z - dz); };
    const auto known = [&](std::initializer_list<int> samples) {
      return std::all_of(samples.begin(), samples.end(), [&](int v) { return std::abs(v) < tree_.band; });
    };
    const auto clamped = [&](int v) { return std::clamp(v, -tree_.band, tree_.band); };
    const auto mean = [](const std::vector<int>& values) {
      int sum = 0;
      for (const int value : values) sum += value;
      return sum / static_cast<int>(values.size());
    };
    const int corner = s(1, 0, 0) + s(0, 1, 0) + s(0, 0, 1) - s(1, 1, 0) - s(1, 0, 1) - s(0, 1, 1) + s(1, 1, 1);
    if (known({s(1, 0, 0), s(0, 1, 0), s(0, 0, 1), s(1, 1, 0), s(1, 0, 1), s(0, 1, 1), s(1, 1, 1)})) return {0, clamped(corner)};
    std::vector<int> planes, lines;
    if (known({s(1, 0, 0), s(0, 1, 0), s(1, 1, 0)})) planes.push_back(s(1, 0, 0) + s(0, 1, 0) - s(1, 1, 0));
    if (known({s(1, 0, 0), s(0, 0, 1), s(1, 0, 1)})) planes.push_back(s(1, 0, 0) + s(0, 0, 1) - s(1, 0, 1));
    if (known({s(0, 1, 0), s(0, 0, 1), s(0, 1, 1)})) planes.push_back(s(0, 1, 0) + s(0, 0, 1) - s(0, 1, 1));
    if (!planes.empty()) return {1, clamped(mean(planes))};
    if (known({s(1, 0, 0), s(2, 0, 0)})) lines.push_back(2 * s(1, 0, 0) - s(2, 0, 0));
    if (known({s(0, 1, 0), s(0, 2, 0)})) lines.push_back(2 * s(0, 1, 0) - s(0, 2, 0));
    if (known({s(0, 0, 1), s(0, 0, 2)})) lines.push_back(2 * s(0, 0, 1) - s(0, 0, 2));
    if (!lines.empty()) return {2, clamped(mean(lines))};
    return {3, clamped(corner)};
  }

  const Tree& tree_;
  std::map<std::uint32_t, Cell> cells_;
  Bytes residuals_;
  StreamSizes sizes_{};
};

/// The image again, from a buffer that has only its header.
std::vector<std::uint64_t> restored(const Bytes& residuals, const StreamSizes& sizes, std::span<const std::uint8_t> header) {
  std::vector<std::uint64_t> words((kHeaderBytes + residuals.size()) / 8);
  auto* at = reinterpret_cast<std::uint8_t*>(words.data());
  std::copy_n(header.begin(), kHeaderBytes, at);
  const auto result = restore(residuals, sizes, {at, 8 * words.size()});
  EXPECT_TRUE(result) << describe(result.error());
  return words;
}

/// `predict` with room to work in.
StreamSizes predicted(std::span<const std::uint8_t> image, Bytes& residuals) {
  std::vector<std::uint32_t> codes(64 * load_le<std::uint32_t>(image.data() + kBrickCountAt));
  return predict(image, codes, residuals);
}

TEST(Residuals, TheyAreThoseOfTheTwinAndTheImageComesBack) {
  StreamSizes used{};
  for (std::uint64_t seed = 1; seed <= 24; ++seed) {
    const Tree tree = random_tree(seed, seed % 2 == 0);
    const auto image = tree.image();
    const Twin twin(tree);
    Bytes residuals(8 * image.size() - kHeaderBytes);
    const StreamSizes sizes = predicted(bytes_of(image), residuals);
    ASSERT_EQ(sizes, twin.sizes()) << seed;
    ASSERT_EQ(residuals, twin.residuals()) << seed;
    ASSERT_EQ(restored(residuals, sizes, bytes_of(image)), image) << seed;
    for (std::size_t rule = 0; rule < 4; ++rule) used[rule] += sizes[rule];
  }
  for (const std::uint32_t samples : used) EXPECT_GT(samples, 1000U) << "each rule was used";
}

TEST(Residuals, TheyAreTheSameOnEveryProcessor) {
  const auto image = random_tree(7, true).image();
  Bytes residuals(8 * image.size() - kHeaderBytes);
  predicted(bytes_of(image), residuals);
  EXPECT_EQ(hash64(residuals.data(), residuals.size()), 0x97b9457304542facULL);
}

TEST(Residuals, ABallComesBackAndIsMostlyForeseen) {
  const test::FieldImage ball({48, 48, 48}, [](const test::Point& p) { return test::length(p - test::Point{23.3, 24.1, 23.8}) - 14; });
  const std::span<const std::uint8_t> image = ball.view().image;
  Bytes residuals(image.size() - kHeaderBytes);
  const StreamSizes sizes = predicted(image, residuals);
  const auto words = restored(residuals, sizes, image);
  EXPECT_TRUE(std::equal(image.begin(), image.end(), bytes_of(words).begin()));
  // Of the samples with all neighbours known, the high byte of the residual is zero: less than 128 of 4096 a voxel were not foreseen.
  const std::size_t high = residuals.size() - 64 * ball.view().brick_count;
  const auto first = residuals.begin() + static_cast<std::ptrdiff_t>(high);
  EXPECT_GT(std::count(first, first + static_cast<std::ptrdiff_t>(sizes[0]), 0), 0.9 * sizes[0]);
  EXPECT_GT(sizes[0], 10000U);
}

TEST(Residuals, NeitherWayAllocates) {
  const auto image = random_tree(3, true).image();
  Bytes residuals(8 * image.size() - kHeaderBytes);
  std::vector<std::uint64_t> words = image;
  std::vector<std::uint32_t> codes(64 * load_le<std::uint32_t>(bytes_of(image).data() + kBrickCountAt));
  const test::AllocGuard guard;
  const StreamSizes sizes = predict(bytes_of(image), codes, residuals);
  const auto result = restore(residuals, sizes, {reinterpret_cast<std::uint8_t*>(words.data()), 8 * words.size()});
  EXPECT_EQ(guard.count(), 0U);
  EXPECT_TRUE(result);
}

/// Whatever stands in residuals and sizes: an error, or an image; never a step outside of either (the sanitizers watch).
TEST(Residuals, AnythingMayBeRestored) {
  test::Random random(5);
  int accepted = 0, refused = 0;
  const auto image = random_tree(4, true).image();
  Bytes good(8 * image.size() - kHeaderBytes);
  const StreamSizes sizes = predicted(bytes_of(image), good);
  for (int n = 0; n < 400; ++n) {
    Bytes residuals = good;
    StreamSizes other = sizes;
    std::vector<std::uint64_t> words = image;
    auto* at = reinterpret_cast<std::uint8_t*>(words.data());
    const std::size_t changes = n % 3 == 0 ? residuals.size() : 1 + random.bits() % 4;
    for (std::size_t c = 0; c < changes; ++c)
      residuals[static_cast<std::size_t>(random.bits() % residuals.size())] = static_cast<std::uint8_t>(random.bits());
    if (n % 5 == 0) other[random.bits() % 4] += static_cast<std::uint32_t>(random.bits() % 3) - 1;
    if (n % 7 == 0) at[kBandAt + random.bits() % (kMethodAt - kBandAt)] ^= static_cast<std::uint8_t>(1U << (random.bits() % 8));
    restore(residuals, other, {at, 8 * words.size()}) ? ++accepted : ++refused;
  }
  EXPECT_GT(accepted, 5);
  EXPECT_GT(refused, 100);
}

}  // namespace
}  // namespace isotouch
