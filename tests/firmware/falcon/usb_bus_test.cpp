#include "firmware/falcon/usb_bus.h"

#include <gtest/gtest.h>

namespace isotouch::falcon {
namespace {

TEST(UsbBus, EveryErrorThatAPersonCanDoSomethingAboutHasItsOwn) {
  EXPECT_EQ(usb_error(LIBUSB_ERROR_ACCESS), LinkError::kNotAllowed);
  EXPECT_EQ(usb_error(LIBUSB_ERROR_BUSY), LinkError::kBusy);
  EXPECT_EQ(usb_error(LIBUSB_ERROR_NOT_FOUND), LinkError::kNotFound);
  EXPECT_EQ(usb_error(LIBUSB_ERROR_TIMEOUT), LinkError::kTimedOut);
  EXPECT_EQ(usb_error(LIBUSB_ERROR_PIPE), LinkError::kStalled);
  for (const int other : {LIBUSB_ERROR_IO, LIBUSB_ERROR_NO_DEVICE, LIBUSB_ERROR_NO_MEM, LIBUSB_ERROR_OTHER})
    EXPECT_EQ(usb_error(other), LinkError::kGone) << other;
}

}  // namespace
}  // namespace isotouch::falcon
