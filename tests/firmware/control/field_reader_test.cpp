#include "firmware/control/field_reader.h"

#include <gtest/gtest.h>

#include "tests/firmware/control/control_rig.h"
#include "tests/firmware/store/packed_field.h"

namespace isotouch::control {
namespace {

/// Two clients, and a field that was copied for them.
class FieldReading : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_FALSE(fields.begin_with(store::packed_ball(1).bytes, "ball"));
    ASSERT_FALSE(fields.copy().refusal);
  }

  loop::LinuxClock clock;
  loop::FieldSlots slots{1 << 20};
  store::FieldIntake fields{slots, nullptr, clock, {}};
  FieldReader reader{fields};
  const ControlClient one, other;
};

TEST_F(FieldReading, WhoDoesNotGetOnGivesWayToAnother) {
  const protocol::ReadImage front{0, 8}, next{8, 8};
  constexpr std::int64_t kLittle = FieldReader::kPatienceNs - 1;
  EXPECT_FALSE(reader.begin(one, front, 0));
  EXPECT_TRUE(reader.begin(other, front, kLittle));
  EXPECT_FALSE(reader.go_on(one, next, kLittle));
  EXPECT_TRUE(reader.begin(other, front, 2 * kLittle));
  EXPECT_FALSE(reader.begin(other, front, 2 * kLittle + 1));
  EXPECT_TRUE(reader.go_on(one, next, 2 * kLittle + 1));
  EXPECT_TRUE(reader.begin(one, front, 2 * kLittle + 1));
  reader.drop(one);
  EXPECT_TRUE(reader.begin(one, front, 2 * kLittle + 1));
  reader.drop(other);
  EXPECT_FALSE(reader.begin(one, front, 2 * kLittle + 1));
}

TEST_F(FieldReading, TheLastPartEndsTheReading) {
  const auto bytes = static_cast<std::uint32_t>(fields.copied().size());
  EXPECT_FALSE(reader.begin(one, {0, 8}, 0));
  EXPECT_EQ(reader.part().bytes.size(), 8U);
  EXPECT_TRUE(reader.begin(other, {0, 8}, 0));
  EXPECT_FALSE(reader.go_on(one, {bytes - 1, 8}, 0));
  EXPECT_EQ(reader.part().bytes.size(), 1U);
  EXPECT_FALSE(reader.begin(other, {0, 8}, 0));
}

TEST_F(FieldReading, APartHasABoundedNumberOfBytes) {
  EXPECT_TRUE(reader.begin(one, {0, 0}, 0));
  EXPECT_TRUE(reader.begin(one, {0, protocol::kMaxChunk + 1}, 0));
  EXPECT_FALSE(reader.begin(one, {0, protocol::kMaxChunk}, 0));
}

}  // namespace
}  // namespace isotouch::control
