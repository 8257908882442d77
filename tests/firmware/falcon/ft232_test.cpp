#include "firmware/falcon/ft232.h"

#include <gtest/gtest.h>

#include <numeric>
#include <vector>

namespace isotouch::falcon::ft232 {
namespace {

TEST(Ft232, EverySixtyFourBytesLoseTheirPair) {
  for (const std::size_t data : {0U, 1U, 61U, 62U, 63U, 100U, 124U, 310U}) {
    std::vector<std::uint8_t> transfer, expected(data);
    std::iota(expected.begin(), expected.end(), std::uint8_t{0x80});
    for (std::size_t at = 0; at < data || at == 0; at += 62) {
      transfer.insert(transfer.end(), {0x01, 0x60});
      transfer.insert(transfer.end(), expected.begin() + static_cast<std::ptrdiff_t>(at),
                      expected.begin() + static_cast<std::ptrdiff_t>(std::min(at + 62, data)));
    }
    LineCounts counts;
    ASSERT_EQ(strip_status(transfer, counts), data);
    transfer.resize(data);
    EXPECT_EQ(transfer, expected);
    EXPECT_EQ(counts.packets, std::max<std::size_t>((data + 61) / 62, 1));
    EXPECT_EQ(counts.empty, data == 0 ? 1U : 0U);
    EXPECT_EQ(counts.overruns + counts.parity + counts.framing + counts.breaks + counts.runts, 0U);
  }
}

TEST(Ft232, LineErrorsAreCountedForEveryPacket) {
  std::vector<std::uint8_t> transfer(64 + 64 + 3);
  transfer[1] = 0x60 | 0x02 | 0x08;
  transfer[65] = 0x02 | 0x04;
  transfer[129] = 0x10 | 0x01;
  LineCounts counts;
  EXPECT_EQ(strip_status(transfer, counts), 62U + 62U + 1U);
  EXPECT_EQ(counts.overruns, 2U);
  EXPECT_EQ(counts.framing, 1U);
  EXPECT_EQ(counts.parity, 1U);
  EXPECT_EQ(counts.breaks, 1U);
}

TEST(Ft232, ASingleByteIsNoPacket) {
  std::vector<std::uint8_t> transfer(65, 0x60);
  LineCounts counts;
  EXPECT_EQ(strip_status(transfer, counts), 62U);
  EXPECT_EQ(counts.runts, 1U);
  EXPECT_EQ(strip_status({}, counts), 0U);
}

TEST(Ft232, DivisorsGiveTheRates) {
  const auto rate = [](const UsbSetup& setup) {
    const int code = setup[2] | setup[3] << 8;
    const double fractions[] = {0, 0.5, 0.25, 0.125};
    return code == 1 ? 2e6 : 3e6 / ((code & 0x3FFF) + fractions[code >> 14]);
  };
  EXPECT_EQ(rate(kBaud9600), 9600.0);
  EXPECT_NEAR(rate(kBaudUpload), 142857, 1);
  EXPECT_EQ(rate(kBaudRun), 1.5e6);
}

}  // namespace
}  // namespace isotouch::falcon::ft232
