#include "shared/patch_chain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <string>
#include <utility>
#include <vector>

#include "shared/bytes.h"
#include "tests/support/alloc_guard.h"
#include "tests/support/field_image.h"
#include "tests/support/field_patch.h"

namespace isotouch {
namespace {

using test::FieldImage;
using Bytes = std::vector<std::uint8_t>;

struct Recorded {
  Recorded() {
    for (int n = 0; n < 5; ++n) {
      fields.emplace_back(
          std::array<std::uint32_t, 3>{24, 24, 24},
          [n](const test::Point& p) {
            return length(p - test::Point{12, 12, 12}) - 4 - 0.3 * n;
          },
          test::FieldOptions{.band = 2.0, .prefilter = false, .interpolation = Interpolation::kTrilinear});
      if (n > 0) patches.push_back(test::make_patch(fields[fields.size() - 2].view(), fields.back().view()));
    }
  }
  Bytes file(const std::vector<std::size_t>& order = {0, 1, 2, 3}) const {
    Bytes bytes;
    for (const std::size_t n : order) bytes.insert(bytes.end(), patches[n].begin(), patches[n].end());
    return bytes;
  }
  std::uint64_t hash(std::size_t n) const { return fields[n].view().hash(); }
  std::deque<FieldImage> fields;
  std::vector<Bytes> patches;
};

const Recorded& recorded() {
  static const Recorded all;
  return all;
}

struct Memory {
  explicit Memory(std::size_t bytes) : one(bytes / 8 + 1), other(bytes / 8 + 1) {}
  std::array<std::span<std::uint8_t>, 2> places() {
    const auto of = [](std::vector<std::uint64_t>& words) {
      return std::span(reinterpret_cast<std::uint8_t*>(words.data()), 8 * words.size());
    };
    return {of(one), of(other)};
  }
  std::vector<std::uint64_t> one, other;
};

TEST(PatchChain, LeadsFromImageToImage) {
  const Bytes file = recorded().file();
  const auto found = check_patches(file, recorded().fields[0].view());
  ASSERT_TRUE(found);
  EXPECT_EQ(found->count, 4U);
  Memory memory(found->largest_image);
  PatchChain chain(recorded().fields[0].view(), file, memory.places());
  EXPECT_EQ(chain.field().hash(), recorded().hash(0));
  const test::AllocGuard guard;
  bool all = true;
  for (std::size_t n = 1; n < 5; ++n) {
    all = all && chain.advance(static_cast<std::uint32_t>(recorded().hash(n))).has_value() && chain.field().hash() == recorded().hash(n);
  }
  EXPECT_EQ(guard.count(), 0U);
  EXPECT_TRUE(all);
  EXPECT_EQ(chain.advance(0).error(), Error::kNoPatches);
  EXPECT_EQ(chain.field().hash(), recorded().hash(4));
}

TEST(PatchChain, ATickThatLeadsToTheFieldItselfNeedsNone) {
  PatchChain chain(recorded().fields[1].view(), {}, {});
  EXPECT_TRUE(chain.advance(static_cast<std::uint32_t>(recorded().hash(1))));
  EXPECT_EQ(chain.field().hash(), recorded().hash(1));
  EXPECT_EQ(chain.advance(static_cast<std::uint32_t>(recorded().hash(2))).error(), Error::kNoPatches);
}

TEST(PatchChain, WithoutPatchesThereAreNone) {
  EXPECT_EQ(check_patches({}, 5)->count, 0U);
  PatchChain chain(recorded().fields[0].view(), {}, {});
  EXPECT_EQ(chain.advance(0).error(), Error::kNoPatches);
}

TEST(PatchChain, RefusesWhatIsMissingCutChangedOrOutOfOrder) {
  const auto error = [](const Bytes& file) {
    const auto found = check_patches(file, recorded().fields[0].view());
    return found ? std::string("none") : std::string(describe(found.error()));
  };
  EXPECT_EQ(error(recorded().file()), "none");
  EXPECT_EQ(error(recorded().file({0, 1})), "none") << "fewer are for the trace to miss";
  EXPECT_EQ(error(recorded().file({1, 2, 3})), describe(Error::kOtherField));
  EXPECT_EQ(error(recorded().file({0, 2, 3})), describe(Error::kOtherField));
  EXPECT_EQ(error(recorded().file({0, 2, 1, 3})), describe(Error::kOtherField));
  EXPECT_EQ(error(recorded().file({0, 0, 1})), describe(Error::kOtherField));
  const Bytes good = recorded().file();
  for (std::size_t size = 1; size < good.size(); size += 61) {
    const bool at_border = size == recorded().patches[0].size();
    EXPECT_EQ(error({good.data(), good.data() + size}) == "none", at_border) << size;
  }
  for (std::size_t at = 0; at < good.size(); at += 37) {
    Bytes bad = good;
    bad[at] ^= 4;
    EXPECT_NE(error(bad), "none") << at;
  }
}

TEST(PatchChain, AnImageIsNoLargerThanItsPatchCanMakeIt) {
  const FieldView first = recorded().fields[0].view();
  // The last patch leads to an image that was not there; its header counts more and more bricks and nodes.
  for (const auto& [count_at, unit] : {std::pair{image_layout::kBrickCountAt, std::uint64_t{128}}, {image_layout::kNodeCountAt, 256}}) {
    for (const std::uint32_t more : {0U, 1U, 1000U, 10'000'000U}) {
      Bytes file = recorded().file();
      Bytes patch(recorded().patches[3].begin(), recorded().patches[3].begin() + patch_layout::kHeaderBytes);
      std::uint8_t* header = patch.data() + patch_layout::kImageHeaderAt;
      const auto add = [&](std::size_t at, std::uint64_t bytes) {
        store_le(header + at, static_cast<std::uint32_t>(load_le<std::uint32_t>(header + at) + bytes));
      };
      add(count_at, more);
      if (count_at == image_layout::kNodeCountAt) add(image_layout::kBrickOffsetAt, unit * more);
      store_le(header + image_layout::kTotalBytesAt, load_le<std::uint64_t>(header + image_layout::kTotalBytesAt) + unit * more);
      store_le(patch.data() + patch_layout::kHashBeforeAt, recorded().hash(4));
      store_le(patch.data() + patch_layout::kHashAfterAt, std::uint64_t{1});
      store_le(patch.data() + patch_layout::kCellsAt, 0U);
      store_le(patch.data() + patch_layout::kStoredAt, 0U);
      seal(patch_layout::kForm, patch);
      file.insert(file.end(), patch.begin(), patch.end());
      const auto found = check_patches(file, first);
      ASSERT_EQ(found.has_value(), more == 0) << more;
      EXPECT_EQ(more == 0 ? Error::kBadSize : found.error(), Error::kBadSize) << more;
    }
  }
}

TEST(PatchChain, ATickNamesWhereItsPatchLeads) {
  const Bytes file = recorded().file();
  Memory memory(1 << 20);
  PatchChain chain(recorded().fields[0].view(), file, memory.places());
  EXPECT_EQ(chain.advance(static_cast<std::uint32_t>(recorded().hash(2))).error(), Error::kOtherField);
  EXPECT_EQ(chain.field().hash(), recorded().hash(0));
  EXPECT_TRUE(chain.advance(static_cast<std::uint32_t>(recorded().hash(1))));
}

TEST(PatchChain, TooLittleMemoryIsRefused) {
  const Bytes file = recorded().file();
  Memory memory(100);
  PatchChain chain(recorded().fields[0].view(), file, memory.places());
  EXPECT_EQ(chain.advance(static_cast<std::uint32_t>(recorded().hash(1))).error(), Error::kBadSize);
}

}  // namespace
}  // namespace isotouch
