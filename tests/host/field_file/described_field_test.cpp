#include "host/field_file/described_field.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <vector>

#include "host/encoding/write_image.h"
#include "host/error.h"
#include "host/field_file/packed.h"
#include "shared/packed_field.h"
#include "tests/host/encoding/field_bodies.h"

namespace isotouch::field_file {
namespace {

using Bytes = std::vector<std::uint8_t>;

field::BandField ball() { return test::field_of(test::ball(9), {9, 9, 9}); }

Bytes packed(const Image& image, const Marks& marks = {}) { return pack(*FieldView::parse(image.bytes()), marks); }

Bytes copy_of(const Image& image) { return {image.bytes().begin(), image.bytes().end()}; }

bool is_refused(const Bytes& bytes) {
  try {
    describe_field(bytes, "it", false);
  } catch (const InputError&) {
    return true;
  }
  return false;
}

TEST(DescribedField, APackedFieldIsDescribedAsItsImage) {
  const Image image = encoding::write_image(ball(), {});
  const Bytes bytes = packed(image), plain = copy_of(image);
  const DescribedField head = describe_field(bytes, "it", false);
  EXPECT_FALSE(head.whole) << "nothing asks for it";
  const DescribedField whole = describe_field(bytes, "it", true), same = describe_field(plain, "it", false);
  ASSERT_TRUE(whole.whole);
  ASSERT_TRUE(same.whole);
  for (const DescribedField* field : {&head, &whole, &same}) {
    EXPECT_EQ(field->image_bytes, image.size());
    EXPECT_EQ(field->packed_bytes, bytes.size());
    EXPECT_EQ(field->hash, FieldView::parse(image.bytes())->hash());
    EXPECT_EQ(field->header.size, whole.whole->view.size);
    EXPECT_EQ(field->header.brick_count, whole.whole->view.brick_count);
    EXPECT_EQ(field->header.bricks, nullptr);
    ASSERT_EQ(field->header.image.size(), image_layout::kHeaderBytes);
    EXPECT_EQ(std::memcmp(field->header.image.data(), image.data(), image_layout::kHeaderBytes), 0);
  }
}

TEST(DescribedField, WhatLiesBehindTheHeaderIsUnpacked) {
  field::BandField field = ball();
  const Image image = encoding::write_image(field, {});
  Marks marks;
  const FieldView view = *FieldView::parse(image.bytes());
  for (std::int32_t x = 0; x < view.size[0]; ++x) marks.mark(view, x, view.size[1] / 2, view.size[2] / 2);
  ASSERT_TRUE(marks.any());
  const DescribedField marked = describe_field(packed(image, marks), "it", false);
  ASSERT_TRUE(marked.whole);
  EXPECT_TRUE(std::ranges::equal(marked.whole->invented.bytes(), marks.bytes()));

  for (const field::Brick& brick : field.bricks) field.stiffness.push_back(1.0 + brick.cell.cast<double>().sum());
  const DescribedField varied = describe_field(packed(encoding::write_image(field, {})), "it", false);
  ASSERT_TRUE(varied.whole);
  EXPECT_NE(varied.whole->view.stiffness_parts, nullptr);
}

TEST(DescribedField, NothingIsSaidOfADamagedFile) {
  const Bytes good = packed(encoding::write_image(ball(), {}));
  ASSERT_FALSE(is_refused(good));
  for (std::size_t at = 0; at < good.size(); ++at) {
    if (at == packed_layout::kMinorAt || at == packed_layout::kMinorAt + 1) continue;  // an addition: a newer writer's
    for (const int bit : {static_cast<int>(at % 8), static_cast<int>((at + 5) % 8)}) {
      Bytes bytes = good;
      bytes[at] ^= static_cast<std::uint8_t>(1U << bit);
      EXPECT_TRUE(is_refused(bytes)) << "bit " << bit << " of byte " << at;
    }
  }
  for (std::size_t length = 0; length < good.size(); length += length < 400 ? 1 : 37) {
    EXPECT_TRUE(is_refused(Bytes(good.begin(), good.begin() + static_cast<std::ptrdiff_t>(length)))) << length;
  }
  Bytes longer = good;
  longer.push_back(0);
  EXPECT_TRUE(is_refused(longer));
}

}  // namespace
}  // namespace isotouch::field_file
