#include "host/server/scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "tests/support/field_image.h"

namespace isotouch::server {
namespace {

field_file::OpenField small_ball() {
  const auto bytes = test::FieldImage({24, 24, 24}, [](const test::Point& p) { return length(p - test::Point{12, 12, 12}) - 5; }).bytes();
  field_file::Image image(bytes.size());
  std::ranges::copy(bytes, image.data());
  return field_file::open_field(std::move(image), "ball");
}

TEST(Scene, OfAnImageWithoutMarksNobodyKnowsWhatWasInvented) {
  EXPECT_TRUE(Scene("ball", small_ball()).summary()["invented_share"].is_null());
  field_file::OpenField marked = small_ball();
  marked.invented.mark(marked.view, 12, 12, 16);
  const auto share = Scene("ball", std::move(marked)).summary()["invented_share"];
  ASSERT_TRUE(share.is_number());
  EXPECT_GT(share.get<double>(), 0);
  EXPECT_LT(share.get<double>(), 0.5);
}

}  // namespace
}  // namespace isotouch::server
