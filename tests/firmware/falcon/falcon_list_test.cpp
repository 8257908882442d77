#include "firmware/falcon/falcon_list.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <libusb.h>

#include "tests/firmware/falcon/fake_libusb.h"

namespace isotouch::falcon {
namespace {

using test::fake_bus;
using testing::HasSubstr;

TEST(FalconList, HasALineForEveryFalcon) {
  test::FakeClock clock;
  test::FakeFalcon first(clock), second(clock), keyboard(clock);
  fake_bus() = {};
  fake_bus().devices = {{&first}, {&keyboard}, {&second}};
  fake_bus().devices[1].product = 0x6001;
  fake_bus().devices[2].open_error = LIBUSB_ERROR_ACCESS;
  const UsbListing listing = list_falcons();
  ASSERT_EQ(listing.falcons.size(), 2U);
  EXPECT_EQ(explain(listing),
            "bus 001 device 002: FALCON HAPTIC, serial FAKE0001\n"
            "bus 001 device 004: a Falcon, but this user may not open it; install 60-isotouch-falcon.rules into /etc/udev/rules.d and plug "
            "it in again");
  EXPECT_EQ(fake_bus().contexts + fake_bus().handles + fake_bus().lists, 0);
}

TEST(FalconList, IsASentenceWhenThereIsNone) {
  fake_bus() = {};
  fake_bus().init_error = LIBUSB_ERROR_OTHER;
  EXPECT_EQ(list_falcons().trouble, LinkError::kNoUsb);
  EXPECT_THAT(explain(list_falcons()), HasSubstr("no Falcon to list: this machine offers no USB to programs; "));
  test::FakeClock clock;
  test::FakeFalcon keyboard(clock);
  fake_bus() = {};
  fake_bus().devices = {{&keyboard}};
  fake_bus().devices[0].product = 0x6001;
  EXPECT_EQ(list_falcons().trouble, LinkError::kNotFound);
  EXPECT_EQ(explain(list_falcons()), "no Falcon to list: no such device is there; plug in its USB cable, or start the simulated one");
}

}  // namespace
}  // namespace isotouch::falcon
