#include "host/field_file/marks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "host/encoding/write_image.h"
#include "host/error.h"
#include "host/field_file/open_field.h"
#include "host/field_file/packed.h"
#include "shared/bytes.h"
#include "shared/crc32.h"
#include "shared/packed_field.h"
#include "tests/host/encoding/field_bodies.h"
#include "tests/support/scratch_folder.h"

namespace isotouch::field_file {
namespace {

using Bytes = std::vector<std::uint8_t>;

OpenField ball() { return open_field(encoding::write_image(test::field_of(test::ball(14), Eigen::Vector3d::Constant(14)), {}), "ball"); }

/// Every stored brick on the side of small x.
Marks half(const FieldView& view) {
  Marks marks;
  for (int k = 0; k < view.size[2]; k += 4) {
    for (int j = 0; j < view.size[1]; j += 4) {
      for (int i = 0; i < view.size[0] / 2; i += 4) marks.mark(view, i, j, k);
    }
  }
  return marks;
}

Bytes written(const OpenField& field, const Marks& marks) { return pack(field.view, marks); }

TEST(Marks, AreOfBricksThatTheImageStores) {
  const OpenField field = ball();
  Marks marks;
  marks.mark(field.view, 0, 0, 0);
  EXPECT_FALSE(marks.any()) << "far outside has no surface";
  marks = half(field.view);
  EXPECT_TRUE(marks.any());
  EXPECT_FALSE(marks.has(0));
  EXPECT_FALSE(marks.has(1));
  EXPECT_TRUE(marks.has(field.view.brick_number(4, field.view.size[1] / 2, field.view.size[2] / 2)));
  EXPECT_FALSE(marks.has(1U << 30)) << "beyond the last";
}

TEST(Marks, ShareIsThatOfTheSurface) {
  const OpenField field = ball();
  EXPECT_EQ(share_of({}, field.view), 0);
  EXPECT_NEAR(share_of(half(field.view), field.view), 0.5, 0.1);
  Marks all;
  for (int k = 0; k < field.view.size[2]; ++k) {
    for (int j = 0; j < field.view.size[1]; ++j) {
      for (int i = 0; i < field.view.size[0]; ++i) all.mark(field.view, i, j, k);
    }
  }
  EXPECT_EQ(share_of(all, field.view), 1);
}

TEST(Marks, ComeBackFromTheFileAndLeaveTheFieldAsItIs) {
  const OpenField field = ball();
  const Marks marks = half(field.view);
  const Bytes with = written(field, marks), without = written(field, {});
  EXPECT_EQ(with.size(), without.size() + (field.view.brick_count + 7) / 8);
  const StoredField read = unpack(with, "it");
  EXPECT_TRUE(std::ranges::equal(read.invented.bytes(), marks.bytes()));
  EXPECT_TRUE(std::ranges::equal(read.image.bytes(), field.image.bytes()));
  EXPECT_EQ(PackedField::parse(with)->image_hash, field.view.hash());
  EXPECT_FALSE(unpack(without, "it").invented.any());

  const ScratchFolder folder;
  const auto file = folder.write("a.itf", std::string(with.begin(), with.end()));
  EXPECT_TRUE(std::ranges::equal(open_field(file).invented.bytes(), marks.bytes()));
}

TEST(Marks, ThatAreDamagedAreRefused) {
  const OpenField field = ball();
  const Bytes good = written(field, half(field.view));
  const std::size_t first = good.size() - (field.view.brick_count + 7) / 8;
  for (std::size_t at = first; at < good.size(); ++at) {
    Bytes bytes = good;
    bytes[at] ^= 0x10;
    EXPECT_THROW(unpack(bytes, "it"), InputError) << "the checksum covers byte " << at;
  }
  Bytes constant = good;
  constant[first] |= 1;
  store_le(&constant[packed_layout::kChecksumAt], crc32(&constant[16], constant.size() - 16));
  try {
    unpack(constant, "it");
    FAIL() << "a mark of a brick without surface";
  } catch (const InputError& e) {
    EXPECT_NE(std::string(e.what()).find("marks of invented surface"), std::string::npos) << e.what();
  }
}

}  // namespace
}  // namespace isotouch::field_file
