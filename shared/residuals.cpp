#include "shared/residuals.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cstdlib>
#include <cstring>

#include "shared/bytes.h"
#include "shared/field_view.h"
#include "shared/predicted_samples.h"

namespace isotouch {

using image_layout::kHeaderBytes;

namespace {

constexpr int kRuleBits = 2;
static_assert(kRules == 1U << kRuleBits);

using FourBytes = std::uint8_t __attribute__((vector_size(4)));

bool any(Four mask) {
  const auto halves = std::bit_cast<std::array<std::uint64_t, 2>>(mask);
  return (halves[0] | halves[1]) != 0;
}

/// The two byte planes of the four streams, as cursors into the residuals.
template <class Byte>
struct Streams {
  std::array<Byte*, kRules> low{}, high{}, end{};

  Streams(Byte* at, const StreamSizes& sizes) {
    for (std::size_t rule = 0; rule < kRules; ++rule) at = end[rule] = (low[rule] = at) + sizes[rule];
    for (std::size_t rule = 0; rule < kRules; ++rule) at = (high[rule] = at) + sizes[rule];
  }

  /// Appends four codes, all at once where they have one rule.
  void put(const std::uint32_t* codes) {
    Four four;
    std::memcpy(&four, codes, sizeof four);
    const Four rules = four & static_cast<int>(kRules - 1);
    if (!any(rules != rules[0])) {
      put(four >> kRuleBits & 255, low[static_cast<std::size_t>(rules[0])]);
      put(four >> (kRuleBits + 8), high[static_cast<std::size_t>(rules[0])]);
      return;
    }
    for (int n = 0; n < 4; ++n) {
      const auto rule = static_cast<std::size_t>(rules[n]);
      *low[rule]++ = static_cast<std::uint8_t>(four[n] >> kRuleBits & 255);
      *high[rule]++ = static_cast<std::uint8_t>(four[n] >> (kRuleBits + 8));
    }
  }

 private:
  static void put(Four numbers, Byte*& to) {
    const auto bytes = __builtin_convertvector(numbers, FourBytes);
    std::memcpy(to, &bytes, sizeof bytes);
    to += sizeof bytes;
  }
};

/// Exchanges the number `next`, which grows where it is met, with 2.
class Counter {
 public:
  std::uint32_t code(std::uint32_t entry) {
    if (entry == next_) return ++next_, 2;
    return entry == 2 ? next_ : entry;
  }
  std::uint32_t entry(std::uint32_t code) {
    if (code == 2) return next_++;
    return code == next_ ? 2 : code;
  }

 private:
  std::uint32_t next_ = 2;
};

/// Both work in place, entry by entry.
void predict_table(std::uint8_t* table, std::uint64_t entries) {
  Counter counter;
  for (const std::uint8_t* end = table + 4 * entries; table != end; table += 4) {
    store_le(table, counter.code(load_le<std::uint32_t>(table)));
  }
}

/// False when an entry is not below `limit`.
bool restore_table(std::uint8_t* table, std::uint64_t entries, std::uint32_t limit) {
  Counter counter;
  bool inside = true;
  for (const std::uint8_t* end = table + 4 * entries; table != end; table += 4) {
    const std::uint32_t entry = counter.entry(load_le<std::uint32_t>(table));
    inside &= entry < limit;
    store_le(table, entry);
  }
  return inside;
}

constexpr std::uint32_t zigzag(std::int32_t difference) {
  const auto wrapped = static_cast<std::int16_t>(difference);
  return static_cast<std::uint16_t>((wrapped * 2) ^ (wrapped >> 15));
}

constexpr std::int32_t unzigzag(std::uint32_t code) { return static_cast<std::int32_t>(code >> 1) ^ -static_cast<std::int32_t>(code & 1); }

/// What can be told of four samples; as `Mean`, but of two at most.
struct FourMeans {
  Four sum{}, count{};

  void add_if(Four known, Four value) {
    sum += known & value;
    count -= known;
  }
  Four value() const { return count == 2 ? (sum - (sum < 0)) >> 1 : sum; }
};

/// Codes rows of four samples. Most rows have one rule. A row in which a sample is the mean of three is coded sample by sample; there are few.
class RowCoder {
 public:
  explicit RowCoder(std::int32_t band) : band_(band) {}

  /// at        the row in its window, which holds its samples
  void code(const std::int16_t* at, std::uint32_t* code) {
    const auto s = [at](int x, int y, int z) { return Window::load(at - (x + Window::kY * y + Window::kZ * z)); };
    const auto known = [this](Four row) { return Window::known(row, band_); };
    const Four x = s(1, 0, 0), y = s(0, 1, 0), z = s(0, 0, 1), xy = s(1, 1, 0), xz = s(1, 0, 1), yz = s(0, 1, 1), xyz = s(1, 1, 1);
    const Four xx = s(2, 0, 0), yy = s(0, 2, 0), zz = s(0, 0, 2);
    const Four has_x = known(x), has_y = known(y), has_z = known(z);
    const Four corner = x + y + z - xy - xz - yz + xyz;
    const Four is_corner = has_x & has_y & has_z & known(xy) & known(xz) & known(yz) & known(xyz);
    const bool all_corners = !any(~is_corner);
    if (all_corners || !any(has_x | has_y | has_z)) {
      const Rule rule = all_corners ? kCorner : kNothing;
      sizes_[rule] += 4;
      return code_row(at, corner, four(rule), code);
    }

    FourMeans planes, lines;
    planes.add_if(has_x & has_y & known(xy), x + y - xy);
    planes.add_if(has_x & has_z & known(xz), x + z - xz);
    planes.add_if(has_y & has_z & known(yz), y + z - yz);
    lines.add_if(has_x & known(xx), 2 * x - xx);
    lines.add_if(has_y & known(yy), 2 * y - yy);
    lines.add_if(has_z & known(zz), 2 * z - zz);
    const Four by_planes = (planes.count > 0) & ~is_corner, by_lines = (planes.count == 0) & (lines.count > 0);
    if (any((by_planes & (planes.count == 3)) | (by_lines & (lines.count == 3)))) return code_singly(at, code);
    mixed_ += 4;
    corners_ -= is_corner, planes_ -= by_planes, lines_ -= by_lines;
    code_row(at,
             by_planes  ? planes.value()
             : by_lines ? lines.value()
                        : corner,
             is_corner   ? four(kCorner)
             : by_planes ? four(kPlanes)
             : by_lines  ? four(kLines)
                         : four(kNothing),
             code);
  }

  StreamSizes sizes() const {
    StreamSizes all = sizes_;
    const auto sum = [](Four counts) { return static_cast<std::uint32_t>(counts[0] + counts[1] + counts[2] + counts[3]); };
    const std::uint32_t corners = sum(corners_), planes = sum(planes_), lines = sum(lines_);
    all[kCorner] += corners, all[kPlanes] += planes, all[kLines] += lines, all[kNothing] += mixed_ - corners - planes - lines;
    return all;
  }

 private:
  static Four four(std::size_t number) { return Four{} + static_cast<int>(number); }

  /// value     what the rules expect, before it is clamped
  void code_row(const std::int16_t* at, Four value, Four rule, std::uint32_t* code) const {
    value = value > band_ ? Four{} + band_ : value;
    value = value < -band_ ? Four{} - band_ : value;
    const Four wrapped = ((Window::load(at) - value) << 16) >> 16;
    const Four folded = ((wrapped * 2) ^ (wrapped >> 15)) & 0xFFFF;
    const Four codes = folded << kRuleBits | rule;
    std::memcpy(code, &codes, sizeof codes);
  }
  void code_singly(const std::int16_t* at, std::uint32_t* code) {
    for (int n = 0; n < 4; ++n) {
      const Prediction p = Window::predict(at + n, band_);
      ++sizes_[p.rule];
      code[n] = zigzag(at[n] - p.value) << kRuleBits | static_cast<std::uint32_t>(p.rule);
    }
  }

  std::int32_t band_;
  Four corners_{}, planes_{}, lines_{};  ///< samples that each rule predicted in rows of several rules, in each place of a row
  std::uint32_t mixed_ = 0;              ///< samples in these rows
  StreamSizes sizes_{};                  ///< of all others
};

}  // namespace

StreamSizes predict(std::span<const std::uint8_t> image, std::span<std::uint32_t> codes, std::span<std::uint8_t> residuals) {
  assert(residuals.size() + kHeaderBytes == image.size());
  const Result<ImageParts> checked = ImageParts::of(image.first(kHeaderBytes), image.size());
  assert(checked);
  const ImageParts& parts = *checked;
  assert(codes.size() == parts.samples());
  std::copy(image.begin() + kHeaderBytes, image.end(), residuals.begin());
  const auto out = [&](std::uint32_t at) { return &residuals[at - kHeaderBytes]; };
  predict_table(out(parts.root_at), parts.root_entries());
  predict_table(out(parts.nodes_at), parts.node_entries());

  const auto* bricks = reinterpret_cast<const std::int16_t*>(image.data() + parts.bricks_at);
  RowCoder coder(parts.band);
  std::uint32_t* code = codes.data();
  PredictedSamples(parts, image.data(), bricks).for_each_brick([&](Window& window, const std::int16_t* samples) {
    window.put(samples);
    for (int z = 2; z < 6; ++z) {
      for (int y = 2; y < 6; ++y, code += 4) coder.code(window.at(2, y, z), code);
    }
  });
  const StreamSizes sizes = coder.sizes();
  Streams<std::uint8_t> streams(out(parts.bricks_at), sizes);
  for (std::size_t row = 0; row < codes.size(); row += 4) streams.put(&codes[row]);
  return sizes;
}

Result<std::span<const std::uint8_t>> restore(std::span<const std::uint8_t> residuals, const StreamSizes& sizes,
                                              std::span<std::uint8_t> image) {
  if (reinterpret_cast<std::uintptr_t>(image.data()) % 8 != 0) return Error::kMisaligned;
  if (image.size() < kHeaderBytes || residuals.size() + kHeaderBytes != image.size()) return Error::kBadSize;
  const Result<ImageParts> checked = ImageParts::of(image.first(kHeaderBytes), image.size());
  if (!checked) return checked.error();
  const ImageParts& parts = *checked;
  if (std::uint64_t{sizes[0]} + sizes[1] + sizes[2] + sizes[3] != parts.samples()) return Error::kBadSize;

  std::copy(residuals.begin(), residuals.end(), image.begin() + kHeaderBytes);
  if (!restore_table(&image[parts.root_at], parts.root_entries(), parts.node_count)) return Error::kBadIndex;
  if (!restore_table(&image[parts.nodes_at], parts.node_entries(), parts.brick_count)) return Error::kBadIndex;

  Streams<const std::uint8_t> streams(&residuals[parts.bricks_at - kHeaderBytes], sizes);
  bool complete = true;
  const auto next_sample = [&](const std::int16_t* at, const RowAhead& ahead, int n) -> std::int16_t {
    const bool has_before = std::abs(at[-1]) < parts.band;
    const bool corner = has_before && ahead.known[n] != 0;
    const Prediction p =
        corner || (!has_before && ahead.blank[n] != 0)
            ? Prediction{corner ? kCorner : kNothing, std::clamp<std::int32_t>(ahead.corner[n] + at[-1], -parts.band, parts.band)}
            : Window::predict(at, parts.band);
    if (streams.low[p.rule] == streams.end[p.rule]) return complete = false, std::int16_t{0};
    const std::uint32_t code = *streams.low[p.rule]++ | static_cast<std::uint32_t>(*streams.high[p.rule]++) << 8;
    return static_cast<std::int16_t>(p.value + unzigzag(code));
  };
  PredictedSamples(parts, image.data(), reinterpret_cast<std::int16_t*>(image.data() + parts.bricks_at))
      .for_each_brick([&](Window& window, std::int16_t* sample) {
        for (int z = 2; z < 6; ++z) {
          for (int y = 2; y < 6; ++y) {
            std::int16_t* at = window.at(2, y, z);
            const RowAhead ahead = Window::row_ahead(at, parts.band);
            for (int n = 0; n < 4; ++n) at[n] = *sample++ = next_sample(at + n, ahead, n);
          }
        }
      });
  if (!complete) return Error::kBadSize;
  return std::span<const std::uint8_t>(image);
}

}  // namespace isotouch
