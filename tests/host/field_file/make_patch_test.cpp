#include "host/field_file/make_patch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "host/error.h"
#include "host/field_file/image.h"
#include "shared/bytes.h"
#include "shared/crc32.h"
#include "shared/field_patch.h"
#include "tests/support/field_image.h"

namespace isotouch::field_file {
namespace {

using test::FieldImage;
using test::FieldOptions;
using test::trilinear_options;
using Bytes = std::vector<std::uint8_t>;

FieldImage ball(double radius, const FieldOptions& options) {
  return FieldImage(
      {40, 36, 21},
      [=](const test::Point& at) {
        return length(at - test::Point{20, 18, 10}) - radius;
      },
      options);
}

Bytes apply_to(const FieldView& before, const Bytes& bytes) {
  const auto patch = FieldPatch::parse(bytes);
  Image image(patch ? patch->image_bytes() : 0);
  if (!patch || !apply(*patch, before, {image.data(), image.size()})) return {};
  return {image.data(), image.data() + image.size()};
}

TEST(MakePatch, RefusesOtherGrids) {
  const FieldImage before = ball(4, trilinear_options());
  FieldOptions spline = trilinear_options(), soft = trilinear_options();
  spline.interpolation = Interpolation::kSpline;
  soft.stiffness = 0.5;
  EXPECT_THROW(make_patch(before.view(), ball(5, spline).view()), InputError);
  EXPECT_THROW(make_patch(before.view(), ball(5, soft).view()), InputError);
}

TEST(MakePatch, RefusesEqualFields) {
  EXPECT_THROW(make_patch(ball(4, trilinear_options()).view(), ball(4, trilinear_options()).view()), InputError);
}

TEST(MakePatch, OnlyTheImageAfterMustBeCanonical) {
  const FieldImage good = ball(4, trilinear_options());
  const FieldView& view = good.view();
  Image untidy(view.image.size());  // a byte between the tables
  std::copy(view.image.begin(), view.image.end(), untidy.data());
  untidy.data()[load_le<std::uint32_t>(untidy.data() + image_layout::kNodeOffsetAt) - 1] = 1;
  store_le(untidy.data() + 12, crc32(untidy.data() + 16, untidy.size() - 16));
  const auto other = FieldView::parse(untidy.bytes());
  ASSERT_TRUE(other);

  EXPECT_THROW(make_patch(view, *other), InputError);
  EXPECT_EQ(apply_to(*other, make_patch(*other, view)), good.bytes());
}

TEST(MakePatch, OnlyZerosMayStandBetweenTheTables) {
  const FieldImage before = ball(4, trilinear_options()), after = ball(5, trilinear_options());
  const FieldView& view = after.view();
  const auto end_of_root =
      image_layout::kHeaderBytes + 4 * static_cast<std::size_t>(view.root_size[0] * view.root_size[1] * view.root_size[2]);
  const auto nodes = load_le<std::uint32_t>(view.image.data() + image_layout::kNodeOffsetAt);
  ASSERT_LT(end_of_root, nodes) << "nothing stands between the tables";
  for (std::size_t at = end_of_root; at < nodes; ++at) {
    Image changed(view.image.size());
    std::copy(view.image.begin(), view.image.end(), changed.data());
    changed.data()[at] = 1;
    store_le(changed.data() + 12, crc32(changed.data() + 16, changed.size() - 16));
    const auto other = FieldView::parse(changed.bytes());
    if (!other) continue;
    EXPECT_THROW(make_patch(before.view(), *other), InputError) << at;
  }
  EXPECT_EQ(apply_to(before.view(), make_patch(before.view(), view)), after.bytes());
}

}  // namespace
}  // namespace isotouch::field_file
