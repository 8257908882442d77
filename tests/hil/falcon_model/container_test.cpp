#include "hil/falcon_model/container.h"

#include <gtest/gtest.h>

#include "tests/hil/falcon_model/driver.h"

namespace isotouch::falcon_model {
namespace {

TEST(Container, TheSmallestImageIsCompleteAtItsLastByteAndNotBefore) {
  Container container;
  const Bytes image = driver::small_image();
  for (std::size_t i = 0; i < image.size(); ++i) {
    EXPECT_EQ(container.state(), Container::State::kReading) << i;
    container.push(image[i]);
  }
  EXPECT_EQ(container.state(), Container::State::kComplete);
  EXPECT_EQ(container.entry_point(), 0x003F8002U);
  EXPECT_EQ(container.blocks(), 1U);
}

TEST(Container, SeveralBlocksAreFollowed) {
  Container container;
  for (const std::uint8_t byte : driver::image_of({3643, 241, 336, 2})) {
    EXPECT_NE(container.state(), Container::State::kComplete);
    container.push(byte);
  }
  EXPECT_EQ(container.state(), Container::State::kComplete);
  EXPECT_EQ(container.blocks(), 4U);
}

TEST(Container, AWrongKeyOrReservedWordNeverCompletes) {
  for (std::size_t at = 0; at < 18; ++at) {
    Bytes image = driver::small_image();
    image[at] ^= 0x40;
    Container container;
    for (const std::uint8_t byte : image) container.push(byte);
    EXPECT_EQ(container.state(), Container::State::kMalformed) << at;
  }
}

}  // namespace
}  // namespace isotouch::falcon_model
