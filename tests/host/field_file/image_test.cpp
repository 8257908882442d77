#include "host/field_file/image.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "host/encoding/write_image.h"
#include "host/error.h"
#include "host/field_file/packed.h"
#include "host/files/whole_file.h"
#include "shared/field_view.h"
#include "tests/host/encoding/field_bodies.h"

namespace isotouch::field_file {
namespace {

TEST(Image, EitherFormIsReadFromAFile) {
  const Image image = encoding::write_image(test::field_of(test::ball(9), {9, 9, 9}), {});
  const std::vector<std::uint8_t> packed = pack(*FieldView::parse(image.bytes()));
  const auto file = std::filesystem::path(::testing::TempDir()) / "image_test.itf";
  const auto comes_back = [&] { return std::ranges::equal(read_field(file).image.bytes(), image.bytes()); };
  write_file(file, image.data(), image.size());
  EXPECT_TRUE(comes_back());
  write_file(file, packed.data(), packed.size());
  EXPECT_TRUE(comes_back());
  write_file(file, packed.data(), packed.size() - 1);
  EXPECT_THROW(read_field(file), InputError);
  std::filesystem::remove(file);
  EXPECT_THROW(read_field(file), InputError);
}

}  // namespace
}  // namespace isotouch::field_file
