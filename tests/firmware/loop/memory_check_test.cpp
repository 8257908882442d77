#include "firmware/loop/memory_check.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "tests/support/field_image.h"

namespace isotouch::loop {
namespace {

std::vector<std::uint8_t> ball(double radius) {
  return test::FieldImage({32, 32, 32}, [radius](const test::Point& p) { return length(p - test::Point{16, 16, 16}) - radius; }).bytes();
}

struct Bench {
  FieldSlots fields{1 << 20};
  std::array<std::uint8_t, 100> model{};
  std::array<std::uint8_t, 7> of_the_guard{};
  MemoryCheck check{fields, {model, of_the_guard}};

  std::span<std::uint8_t> load(const std::vector<std::uint8_t>& image) {
    const std::span<std::uint8_t> room = fields.begin(image.size());
    std::copy(image.begin(), image.end(), room.begin());
    EXPECT_TRUE(fields.verify() && fields.commit());
    fields.field();  // the tick takes it over
    return room;
  }
  Damage round() {
    Damage damage = Damage::kNone;
    for (std::size_t part = 0; part < FieldSlots::kParts; ++part) damage = std::max(damage, check.step());
    return damage;
  }
};

TEST(MemoryCheck, FindsAnyBitOfTheFieldWithinARound) {
  Bench bench;
  EXPECT_EQ(bench.round(), Damage::kNone);
  const std::span<std::uint8_t> image = bench.load(ball(8));
  EXPECT_EQ(bench.round(), Damage::kNone);
  for (std::size_t byte = 0; byte < image.size(); byte += image.size() / 97) {
    image[byte] ^= 16;
    EXPECT_EQ(bench.round(), Damage::kField) << byte;
    image[byte] ^= 16;
    EXPECT_EQ(bench.check.step(), Damage::kField) << "what was damaged once is not believed again";
    bench.fields.clear();
    bench.fields.field();
    EXPECT_EQ(bench.round(), Damage::kNone);
    EXPECT_EQ(bench.load(ball(8)).size(), image.size());
    bench.fields.clear();
    bench.fields.field();
    EXPECT_EQ(bench.load(ball(8)).data(), image.data()) << "the same place again";
  }
}

TEST(MemoryCheck, AnotherFieldIsWellAgain) {
  Bench bench;
  bench.load(ball(8))[300] ^= 1;
  EXPECT_EQ(bench.round(), Damage::kField);
  bench.load(ball(9));
  EXPECT_EQ(bench.round(), Damage::kNone);
}

TEST(MemoryCheck, FindsAnyBitOfWhatWasPreparedAtOnceAndForGood) {
  for (std::size_t byte = 0; byte < 107; ++byte) {
    Bench bench;
    std::uint8_t& flipped = byte < 100 ? bench.model[byte] : bench.of_the_guard[byte - 100];
    EXPECT_EQ(bench.check.step(), Damage::kNone);
    flipped ^= 128;
    EXPECT_EQ(bench.check.step(), Damage::kPrepared);
    flipped ^= 128;
    EXPECT_EQ(bench.check.step(), Damage::kPrepared) << "nobody knows what it did meanwhile";
  }
}

}  // namespace
}  // namespace isotouch::loop
