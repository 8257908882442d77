#include "host/encoding/inside_samples.h"

#include <gtest/gtest.h>

#include "host/encoding/write_image.h"
#include "tests/host/encoding/field_bodies.h"

namespace isotouch::encoding {
namespace {

TEST(InsideSamples, CountsEveryNegativeCoefficientOfTheGrid) {
  const field_file::Image image = write_image(test::field_of(test::hollow_ball(40, 17), Eigen::Vector3d::Constant(40)), {});
  const auto view = FieldView::parse(image.bytes());
  ASSERT_TRUE(view.has_value());
  std::size_t expected = 0;
  for (int k = 0; k < view->size[2]; ++k) {
    for (int j = 0; j < view->size[1]; ++j) {
      for (int i = 0; i < view->size[0]; ++i) expected += view->coefficient(i, j, k) < 0 ? 1U : 0U;
    }
  }
  EXPECT_EQ(inside_samples(*view), expected);
  EXPECT_NEAR(static_cast<double>(expected), 4.0 / 3 * M_PI * (40.0 * 40 * 40 - 17.0 * 17 * 17), 500);
}

}  // namespace
}  // namespace isotouch::encoding
