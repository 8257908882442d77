#include "shared/field_patch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <functional>
#include <string>
#include <vector>

#include "shared/bytes.h"
#include "shared/crc32.h"
#include "shared/hash64.h"
#include "tests/support/alloc_guard.h"
#include "tests/support/field_image.h"
#include "tests/support/field_patch.h"
#include "tests/support/random.h"

namespace isotouch {
namespace {

using test::FieldImage;
using test::FieldOptions;
using test::make_patch;
using test::Point;
using test::trilinear_options;
using Bytes = std::vector<std::uint8_t>;

constexpr std::array<std::uint32_t, 3> kSize = {40, 36, 21};

/// Some balls, each of which may be anywhere in the grid or nowhere.
FieldImage random_field(test::Random& random, const FieldOptions& options, int balls) {
  std::vector<std::pair<Point, double>> all;
  for (int n = 0; n < balls; ++n) {
    const double radius = random.uniform(1.0, 5.0);
    const auto within = [&](std::uint32_t size) { return random.uniform(6, size - 7.0); };
    all.push_back({{within(kSize[0]), within(kSize[1]), within(kSize[2])}, radius});
  }
  return FieldImage(
      kSize,
      [&](const Point& at) {
        double nearest = 100;
        for (const auto& [centre, radius] : all) nearest = std::min(nearest, length(at - centre) - radius);
        return nearest;
      },
      options);
}

struct Memory {
  explicit Memory(std::size_t bytes)
      : words((bytes + 7) / 8 + 1, 0xA5A5A5A5A5A5A5A5), span(reinterpret_cast<std::uint8_t*>(words.data()), bytes) {}
  std::vector<std::uint64_t> words;
  std::span<std::uint8_t> span;
};

/// returns   the image after, or why there is none
struct Applied {
  Bytes image;
  bool refused = false;
  Error error{};
};
Applied patched(const Bytes& bytes, const FieldView& before) {
  const auto patch = FieldPatch::parse(bytes);
  if (!patch) return {{}, true, patch.error()};
  if (patch->image_bytes() > (1U << 24)) return {{}, true, Error::kBadSize};
  Memory memory(patch->image_bytes());
  const auto image = apply(*patch, before, memory.span);
  EXPECT_EQ(memory.words.back(), 0xA5A5A5A5A5A5A5A5) << "written beyond the image";
  if (!image) return {{}, true, image.error()};
  return {{image->begin(), image->end()}, false, {}};
}

void seal(Bytes& bytes) { store_le(bytes.data() + 12, crc32(bytes.data() + 16, bytes.size() - 16)); }

TEST(FieldPatch, LeadsFromAnyImageToAnyOtherOnItsGridToTheByte) {
  test::Random random(1);
  int compared = 0, with_cells = 0;
  for (int kind = 0; kind < 3; ++kind) {
    FieldOptions options = kind == 0 ? trilinear_options() : FieldOptions{};
    options.band = 2.0;
    if (kind == 2) options.stiffness_part = [&](const Point&) { return 1 + static_cast<int>(random.bits() % 3); };
    for (int pair = 0; pair < 12; ++pair) {
      const FieldImage before = random_field(random, options, pair % 4), after = random_field(random, options, pair / 4);
      if (before.bytes() == after.bytes()) continue;
      const Bytes bytes = make_patch(before.view(), after.view());
      const Applied applied = patched(bytes, before.view());
      ASSERT_FALSE(applied.refused) << describe(applied.error);
      ASSERT_EQ(applied.image, after.bytes());
      ++compared;
      with_cells += FieldPatch::parse(bytes)->cells.empty() ? 0 : 1;
    }
  }
  EXPECT_GT(compared, 32);
  EXPECT_GT(with_cells, 28);
}

TEST(FieldPatch, HoldsTheCellsThatDifferAndNoOthers) {
  FieldOptions options = trilinear_options();
  const auto with_ball = [&](double radius) {
    return FieldImage(
        kSize,
        [=](const Point& at) {
          return length(at - Point{20, 18, 10}) - radius;
        },
        options);
  };
  const FieldImage before = with_ball(4.0), after = with_ball(4.1);
  const Bytes bytes = make_patch(before.view(), after.view());
  int differing = 0;
  for (std::int32_t k = 0; k < 24; k += 4) {
    for (std::int32_t j = 0; j < 36; j += 4) {
      for (std::int32_t i = 0; i < 40; i += 4) {
        differing += std::memcmp(before.view().brick(i, j, k), after.view().brick(i, j, k), 128) != 0 ? 1 : 0;
      }
    }
  }
  EXPECT_EQ(FieldPatch::parse(bytes)->cells.size(), static_cast<std::size_t>(4 * differing));
  EXPECT_GT(differing, 10);
}

TEST(FieldPatch, AChangedByteIsRefusedOrDoesNotMatter) {
  test::Random random(2);
  const FieldImage before = random_field(random, trilinear_options(), 1), after = random_field(random, trilinear_options(), 1);
  const Bytes good = make_patch(before.view(), after.view());
  int refused = 0;
  for (const bool is_sealed : {false, true}) {
    for (std::size_t at = 0; at < good.size(); at += is_sealed && at > 1000 ? 7 : 1) {
      Bytes bad = good;
      bad[at] = static_cast<std::uint8_t>(bad[at] ^ (1U << random.bits() % 8));
      if (is_sealed) seal(bad);
      const Applied applied = patched(bad, before.view());
      refused += applied.refused ? 1 : 0;
      if (applied.refused) continue;
      ASSERT_EQ(applied.image, after.bytes()) << "byte " << at;
    }
  }
  EXPECT_GT(refused, static_cast<int>(good.size()));
}

TEST(FieldPatch, ACutOneIsRefused) {
  test::Random random(3);
  const FieldImage before = random_field(random, trilinear_options(), 1), after = random_field(random, trilinear_options(), 1);
  const Bytes good = make_patch(before.view(), after.view());
  for (std::size_t size = 0; size < good.size(); size += size < 400 ? 1 : 97) {
    EXPECT_TRUE(patched(Bytes(good.data(), good.data() + size), before.view()).refused) << size;
  }
  Bytes longer = good;
  longer.push_back(0);
  EXPECT_EQ(patched(longer, before.view()).error, Error::kBadSize);
}

TEST(FieldPatch, FitsNoOtherField) {
  test::Random random(4);
  const FieldImage before = random_field(random, trilinear_options(), 2), after = random_field(random, trilinear_options(), 2);
  const Bytes bytes = make_patch(before.view(), after.view());
  EXPECT_EQ(patched(bytes, after.view()).error, Error::kOtherField);
  EXPECT_EQ(patched(bytes, random_field(random, trilinear_options(), 2).view()).error, Error::kOtherField);
  FieldOptions elsewhere = trilinear_options();
  elsewhere.edge_mm = 0.5;
  EXPECT_EQ(patched(bytes, random_field(random, elsewhere, 2).view()).error, Error::kOtherField);
}

/// A patch with one thing wrong, sealed again so that only this can be why it is refused.
TEST(FieldPatch, WhatIsWrongIsNamed) {
  test::Random random(5);
  const FieldImage before = random_field(random, trilinear_options(), 1), after = random_field(random, trilinear_options(), 1);
  const Bytes good = make_patch(before.view(), after.view());
  const auto cells = load_le<std::uint32_t>(&good[40]);
  ASSERT_GT(cells, 2U);
  const std::size_t bricks_at = 320 + 4 * std::size_t{cells};
  const auto word = [](Bytes& b, std::size_t at, std::uint32_t value) { store_le(&b[at], value); };
  const struct {
    const char* what;
    Error error;
    std::function<void(Bytes&)> spoil;
  } cases[] = {
      {"magic", Error::kBadMagic, [](Bytes& b) { b[3] = 'P'; }},
      {"major", Error::kBadVersion, [](Bytes& b) { b[4] = 2; }},
      {"header bytes", Error::kBadHeader, [](Bytes& b) { b[8] = 1; }},
      {"total bytes, more", Error::kTruncated, [](Bytes& b) { b[16]++; }},
      {"total bytes, fewer", Error::kBadSize, [](Bytes& b) { b[16]--; }},
      {"the number of cells", Error::kBadSize, [&](Bytes& b) { word(b, 40, cells + 1); }},
      {"the number of stored cells", Error::kBadSize, [](Bytes& b) { b[44]++; }},
      {"a huge number of cells", Error::kBadSize, [&](Bytes& b) { word(b, 40, 0xFFFFFFFF); }},
      {"a huge number of stored cells", Error::kBadSize, [&](Bytes& b) { word(b, 44, 0xFFFFFFFF); }},
      {"the image's magic", Error::kBadMagic, [](Bytes& b) { b[64] = 0; }},
      {"the published method", Error::kBadHeader, [&](Bytes& b) { word(b, 64 + 104, 1); }},
      {"a cell twice", Error::kBadPatch, [&](Bytes& b) { std::copy_n(&b[320], 4, &b[324]); }},
      {"a cell outside the tree", Error::kBadPatch, [&](Bytes& b) { word(b, bricks_at - 4, 0xFFFFFFFC | (b[bricks_at - 4] & 3U)); }},
      {"a kind that is none", Error::kBadPatch, [&](Bytes& b) { b[320] |= 3; }},
      {"another kind", Error::kBadPatch, [&](Bytes& b) { b[320] ^= 2; }},
      {"a stored cell that is constant", Error::kBadPatch,
       [&](Bytes& b) {
         for (std::size_t n = 0; n < 64; ++n) store_le(&b[bricks_at + 2 * n], std::int16_t{2 * 4096});
       }},
      {"hash before", Error::kOtherField, [](Bytes& b) { b[24]++; }},
      {"hash after as before", Error::kBadPatch, [](Bytes& b) { std::copy_n(&b[24], 8, &b[32]); }},
      {"a reserved byte of the image's header", Error::kOtherField, [](Bytes& b) { b[64 + 255]++; }},
      {"the image's minor version", Error::kOtherField, [](Bytes& b) { b[64 + 6]++; }},
      {"hash after", Error::kBadChecksum, [](Bytes& b) { b[32]++; }},
      {"the edge", Error::kBadHeader, [](Bytes& b) { b[64 + 44]++; }},
      {"the stiffness", Error::kOtherField, [](Bytes& b) { b[64 + 80]++; }},
      {"the scale", Error::kOtherField, [](Bytes& b) { b[64 + 112]++; }},
      {"the interpolation", Error::kOtherField, [](Bytes& b) { b[64 + 176] = 0; }},
      {"a coefficient", Error::kBadChecksum, [&](Bytes& b) { b[bricks_at]++; }},
      {"the certificate", Error::kBadChecksum, [](Bytes& b) { b[64 + 144]++; }},
  };
  for (const auto& c : cases) {
    Bytes bad = good;
    c.spoil(bad);
    seal(bad);
    const Applied applied = patched(bad, before.view());
    EXPECT_TRUE(applied.refused) << c.what;
    EXPECT_EQ(describe(applied.error), std::string(describe(c.error))) << c.what;
  }
}

/// More bricks or nodes than the header counts must not be written beyond the image.
TEST(FieldPatch, CountsThatDoNotFitAreRefused) {
  test::Random random(6);
  const FieldImage before = random_field(random, trilinear_options(), 3), after = random_field(random, trilinear_options(), 3);
  const FieldImage smaller = random_field(random, trilinear_options(), 0);
  Bytes bytes = make_patch(before.view(), after.view());
  std::copy_n(smaller.view().image.begin(), 256, bytes.begin() + 64);
  seal(bytes);
  EXPECT_EQ(patched(bytes, before.view()).error, Error::kBadSize);
  bytes = make_patch(before.view(), smaller.view());
  std::copy_n(after.view().image.begin(), 256, bytes.begin() + 64);
  seal(bytes);
  EXPECT_EQ(patched(bytes, before.view()).error, Error::kBadSize);
}

TEST(FieldPatch, ACellThatDoesNotChangeIsRefused) {
  test::Random random(9);
  const FieldImage before = random_field(random, trilinear_options(), 2);
  const auto flipped = [&](std::size_t at) {  // before with one byte of its header changed, as the image after
    Bytes bytes = before.bytes();
    bytes[at]++;
    seal(bytes);
    return bytes;
  };
  const Bytes after = flipped(image_layout::kSourceHashAt);
  Memory memory(after.size());
  std::copy(after.begin(), after.end(), memory.span.begin());
  Bytes bytes = make_patch(before.view(), *FieldView::parse(memory.span));
  ASSERT_EQ(bytes.size(), patch_layout::kHeaderBytes) << "only the header changes";
  EXPECT_EQ(patched(bytes, before.view()).image, after);

  const std::uint32_t number = before.view().nodes[2 * 64];
  ASSERT_EQ(number, image_layout::kOutside) << "the first node's first cell";
  std::uint32_t entry = 0;
  while (before.view().root[entry] != 2) ++entry;
  bytes.resize(bytes.size() + 4);
  store_le(&bytes[320], entry * 64 << 2 | number);
  store_le(&bytes[40], 1U);
  store_le(&bytes[16], std::uint64_t{bytes.size()});
  seal(bytes);
  EXPECT_EQ(patched(bytes, before.view()).error, Error::kBadPatch);

  // and a stored one
  const FieldView& view = before.view();
  std::size_t slot = 0;
  while (view.nodes[2 * 64 + slot] < 2) ++slot;
  store_le(&bytes[320], static_cast<std::uint32_t>(entry * 64 + slot) << 2 | 2U);
  store_le(&bytes[44], 1U);
  const auto* brick = reinterpret_cast<const std::uint8_t*>(view.bricks + 64 * std::size_t{view.nodes[2 * 64 + slot]});
  bytes.insert(bytes.end(), brick, brick + 128);
  store_le(&bytes[16], std::uint64_t{bytes.size()});
  seal(bytes);
  EXPECT_EQ(patched(bytes, before.view()).error, Error::kBadPatch);
}

TEST(FieldPatch, AppliesWithoutAllocation) {
  test::Random random(7);
  const FieldImage before = random_field(random, trilinear_options(), 2), after = random_field(random, trilinear_options(), 2);
  const Bytes bytes = make_patch(before.view(), after.view());
  Memory memory(after.view().image.size());
  const test::AllocGuard guard;
  const auto patch = FieldPatch::parse(bytes);
  const bool done = patch.has_value() && apply(*patch, before.view(), memory.span).has_value();
  EXPECT_EQ(guard.count(), 0U);
  EXPECT_TRUE(done);
}

}  // namespace
}  // namespace isotouch
