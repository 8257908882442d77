#include "shared/residuals.h"

#include <algorithm>
#include <cassert>

#include "shared/bytes.h"
#include "shared/field_view.h"
#include "shared/predicted_samples.h"

namespace isotouch {

using image_layout::kHeaderBytes;

namespace {

/// The two byte planes of the four streams, as cursors into the residuals.
template <class Byte>
struct Streams {
  std::array<Byte*, kRules> low{}, high{}, end{};

  Streams(Byte* at, const StreamSizes& sizes) {
    for (std::size_t rule = 0; rule < kRules; ++rule) at = end[rule] = (low[rule] = at) + sizes[rule];
    for (std::size_t rule = 0; rule < kRules; ++rule) at = (high[rule] = at) + sizes[rule];
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

constexpr int kRuleBits = 2;
static_assert(kRules == 1U << kRuleBits);

constexpr std::uint32_t zigzag(std::int32_t difference) {
  const auto wrapped = static_cast<std::int16_t>(difference);
  return static_cast<std::uint16_t>((wrapped * 2) ^ (wrapped >> 15));
}

constexpr std::int32_t unzigzag(std::uint32_t code) { return static_cast<std::int32_t>(code >> 1) ^ -static_cast<std::int32_t>(code & 1); }

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
  StreamSizes sizes{};
  std::uint32_t* code = codes.data();
  PredictedSamples(parts, image.data(), bricks).for_each([&](Prediction p, std::int16_t sample) {
    ++sizes[p.rule];
    *code++ = zigzag(sample - p.value) << kRuleBits | static_cast<std::uint32_t>(p.rule);
  });
  Streams<std::uint8_t> streams(out(parts.bricks_at), sizes);
  for (const std::uint32_t coded : codes) {
    const std::size_t rule = coded & (kRules - 1);
    *streams.low[rule]++ = static_cast<std::uint8_t>(coded >> kRuleBits & 255U);
    *streams.high[rule]++ = static_cast<std::uint8_t>(coded >> (kRuleBits + 8));
  }
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
  PredictedSamples(parts, image.data(), reinterpret_cast<std::int16_t*>(image.data() + parts.bricks_at))
      .for_each([&](Prediction p, std::int16_t& sample) {
        if (streams.low[p.rule] == streams.end[p.rule]) {
          complete = false;
          sample = 0;
          return;
        }
        const std::uint32_t code = *streams.low[p.rule]++ | static_cast<std::uint32_t>(*streams.high[p.rule]++) << 8;
        sample = static_cast<std::int16_t>(p.value + unzigzag(code));
      });
  if (!complete) return Error::kBadSize;
  return std::span<const std::uint8_t>(image);
}

}  // namespace isotouch
