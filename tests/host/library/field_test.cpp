#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "host/library/isotouch.h"
#include "shared/bytes.h"
#include "shared/crc32.h"
#include "shared/field_view.h"
#include "tests/host/library/golden.h"
#include "tests/support/field_image.h"
#include "tests/support/scratch_folder.h"

namespace isotouch {
namespace {

using test::Field;

std::vector<char> bytes_of(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(LibraryField, SaysWhatItIs) {
  const isotouch_field_facts facts = Field().facts();
  EXPECT_NE(facts.hash, 0U);
  EXPECT_GT(facts.stiffness_n_mm, 0);
  EXPECT_GT(facts.scale, 0);
  for (int axis = 0; axis < 3; ++axis)
    EXPECT_NEAR(facts.high_mm[axis] - facts.low_mm[axis], facts.voxel_mm * (facts.samples[axis] - 1), 1e-9) << axis;
  EXPECT_EQ(facts.varies_in_stiffness, 0U);
  EXPECT_EQ(Field("field_1_2.itf").facts().varies_in_stiffness, 1U);
}

/// The facts of a field whose header states this placement.
isotouch_field_facts facts_with(double scale, double offset) {
  const test::FieldImage image({16, 16, 16},
                               [](const test::Point& p) {
                                 return test::length(p - test::Point{8, 8, 8}) - 3.0;
                               },
                               {.edge_mm = 0.5, .band = 2.0, .stiffness = 0.5, .largest_slope = 1.25});
  std::vector<std::uint8_t> bytes = image.bytes();
  namespace at = image_layout;
  store_le(bytes.data() + at::kScaleAt, std::bit_cast<std::uint64_t>(scale));
  store_le(bytes.data() + at::kOffsetAt + 8, std::bit_cast<std::uint64_t>(offset));
  store_le(bytes.data() + at::kChecksumAt, crc32(bytes.data() + at::kTotalBytesAt, bytes.size() - at::kTotalBytesAt));
  isotouch_field field = 0;
  isotouch_field_facts facts{};
  EXPECT_DONE(isotouch_field_read(bytes.data(), bytes.size(), &field));
  EXPECT_DONE(isotouch_field_describe(field, &facts, sizeof facts));
  EXPECT_DONE(isotouch_free(field));
  return facts;
}

TEST(LibraryField, APlacementThatCannotBeIsNone) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN(), kInfinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(facts_with(2, 3).scale, 2);
  EXPECT_EQ(facts_with(2, 3).offset_mm[1], 3);
  for (const auto& [scale, offset] : {std::pair(kNan, 3.0), {kInfinity, 3.0}, {0, 3}, {-1, 3}, {2, kNan}, {2, kInfinity}, {1e-300, 3}}) {
    const isotouch_field_facts facts = facts_with(scale, offset);
    EXPECT_EQ(facts.scale, 0) << scale << ' ' << offset;
    EXPECT_EQ(facts.offset_mm[1], 0) << scale << ' ' << offset;
  }
}

TEST(LibraryField, FromMemoryAndFromAFileAreOne) {
  const Field file;
  const std::vector<char> bytes = bytes_of(test::golden("field_1_1.itf"));
  isotouch_field memory = 0;
  ASSERT_DONE(isotouch_field_read(bytes.data(), bytes.size(), &memory));
  isotouch_field_facts facts{};
  EXPECT_DONE(isotouch_field_describe(memory, &facts, sizeof facts));
  EXPECT_EQ(facts.hash, file.facts().hash);
  EXPECT_DONE(isotouch_free(memory));
}

TEST(LibraryField, ASavedFieldIsTheSameField) {
  const ScratchFolder folder;
  const Field field("field_1_2.itf");
  const std::string path = (folder.path() / "saved.itf").string();
  ASSERT_DONE(isotouch_field_save(field.handle, path.c_str()));
  isotouch_field saved = 0;
  ASSERT_DONE(isotouch_field_load(path.c_str(), &saved));
  isotouch_field_facts facts{};
  EXPECT_DONE(isotouch_field_describe(saved, &facts, sizeof facts));
  EXPECT_EQ(facts.hash, field.facts().hash);
  EXPECT_DONE(isotouch_free(saved));
}

TEST(LibraryField, EveryCutAndEveryChangedByteIsRefused) {
  const std::vector<char> whole = bytes_of(test::golden("field_1_1.itf"));
  ASSERT_GT(whole.size(), 1000U);
  int tried = 0;
  for (std::size_t at = 0; at < whole.size(); at += whole.size() / 97) {
    isotouch_field field = 77;
    EXPECT_EQ(isotouch_field_read(whole.data(), at, &field), ISOTOUCH_BAD_DATA) << at;
    std::vector<char> changed = whole;
    changed[at] = static_cast<char>(changed[at] ^ 0x10);
    EXPECT_EQ(isotouch_field_read(changed.data(), changed.size(), &field), ISOTOUCH_BAD_DATA) << at;
    EXPECT_EQ(field, 77U);
    ++tried;
  }
  EXPECT_GT(tried, 90);
}

TEST(LibraryField, WhatIsNotThereIsNamed) {
  isotouch_field field = 0;
  EXPECT_REFUSED(isotouch_field_load("/nowhere/field.itf", &field), ISOTOUCH_BAD_DATA, "/nowhere/field.itf");
  EXPECT_REFUSED(isotouch_field_load("", &field), ISOTOUCH_BAD_ARGUMENT, "path is empty");
  EXPECT_REFUSED(isotouch_field_load("-", &field), ISOTOUCH_BAD_DATA, "./-");
  EXPECT_REFUSED(isotouch_field_load(nullptr, &field), ISOTOUCH_BAD_ARGUMENT, "path is a null pointer");
  EXPECT_REFUSED(isotouch_field_load(test::golden("field_1_1.itf").c_str(), nullptr), ISOTOUCH_BAD_ARGUMENT, "field is a null pointer");
  EXPECT_REFUSED(isotouch_field_read(nullptr, 10, &field), ISOTOUCH_BAD_ARGUMENT, "bytes is a null pointer");
  const Field there;
  EXPECT_REFUSED(isotouch_field_save(there.handle, "/nowhere/field.itf"), ISOTOUCH_BAD_DATA, "/nowhere/field.itf");
  isotouch_field_facts facts{};
  EXPECT_REFUSED(isotouch_field_describe(there.handle, &facts, sizeof facts - 8), ISOTOUCH_BAD_ARGUMENT, "isotouch_field_facts");
  EXPECT_REFUSED(isotouch_field_describe(there.handle, nullptr, sizeof facts), ISOTOUCH_BAD_ARGUMENT, "facts");
}

TEST(LibraryField, SamplesFallOnTheWayOutAndGradientsPointOut) {
  const Field field;
  const isotouch_field_facts facts = field.facts();
  std::vector<double> points;
  for (int i = 0; i <= 200; ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      const double middle = (facts.low_mm[axis] + facts.high_mm[axis]) / 2;
      points.push_back(axis == 1 ? middle + (facts.high_mm[1] - middle) * i / 200 : middle);
    }
  }
  const std::size_t count = points.size() / 3;
  std::vector<double> distance(count), gradient(3 * count), stiffness(count);
  std::vector<std::uint8_t> in_band(count);
  ASSERT_DONE(
      isotouch_field_sample(field.handle, count, points.data(), distance.data(), gradient.data(), stiffness.data(), in_band.data()));
  EXPECT_LT(distance.front(), 0);
  EXPECT_GT(distance.back(), 0);
  int known = 0;
  for (std::size_t i = 0; i < count; ++i) {
    EXPECT_LE(std::abs(distance[i]), facts.band_mm + 1e-9);
    if (in_band[i] == 0 || std::abs(distance[i]) > facts.voxel_mm) continue;  // deep inside other sides are as near
    ++known;
    EXPECT_GT(gradient[3 * i + 1], 0.3) << i;
    EXPECT_NEAR(stiffness[i], facts.stiffness_n_mm, 1e-9);
  }
  EXPECT_GT(known, 2);
  std::vector<double> alone(count);
  ASSERT_DONE(isotouch_field_sample(field.handle, count, points.data(), alone.data(), nullptr, nullptr, nullptr));
  EXPECT_EQ(alone, distance);
  EXPECT_DONE(isotouch_field_sample(field.handle, 0, nullptr, nullptr, nullptr, nullptr, nullptr));
}

TEST(LibraryField, PlacesThatAreNoneAreErrorsAndNothingIsWritten) {
  const Field field;
  for (const double wrong : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    const double points[6] = {0, 0, 0, 0, wrong, 0};
    double distance[2] = {7, 7};
    EXPECT_REFUSED(isotouch_field_sample(field.handle, 2, points, distance, nullptr, nullptr, nullptr), ISOTOUCH_BAD_ARGUMENT, "number 4");
    EXPECT_EQ(distance[0], 7);
  }
  const double far[3] = {1e300, -1e300, 0};
  double distance = 0;
  EXPECT_DONE(isotouch_field_sample(field.handle, 1, far, &distance, nullptr, nullptr, nullptr));
  EXPECT_GT(distance, 0);
  EXPECT_REFUSED(isotouch_field_sample(field.handle, 1, nullptr, &distance, nullptr, nullptr, nullptr), ISOTOUCH_BAD_ARGUMENT, "points_mm");
  EXPECT_REFUSED(isotouch_field_sample(field.handle, SIZE_MAX, far, &distance, nullptr, nullptr, nullptr), ISOTOUCH_BAD_ARGUMENT,
                 "fit no memory");
}

}  // namespace
}  // namespace isotouch
