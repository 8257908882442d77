#include "firmware/falcon/usb_bus.h"

#include <unistd.h>

#include <algorithm>
#include <array>

#include "shared/printable.h"

namespace isotouch::falcon {

LinkError usb_error(int code) {
  switch (code) {
    case LIBUSB_ERROR_ACCESS: return LinkError::kNotAllowed;
    case LIBUSB_ERROR_BUSY: return LinkError::kBusy;
    case LIBUSB_ERROR_NOT_FOUND: return LinkError::kNotFound;
    case LIBUSB_ERROR_TIMEOUT: return LinkError::kTimedOut;
    case LIBUSB_ERROR_PIPE: return LinkError::kStalled;
    default: return LinkError::kGone;
  }
}

namespace {

std::string text_of(libusb_device_handle* handle, std::uint8_t index) {
  std::array<unsigned char, 128> text{};
  const int size = index == 0 ? 0 : libusb_get_string_descriptor_ascii(handle, index, text.data(), static_cast<int>(text.size()));
  std::string name(text.begin(), text.begin() + std::max(size, 0));
  make_printable(name, '?');
  return name;
}

}  // namespace

FalconIdentity usb_identity(libusb_device_handle* handle, const libusb_device_descriptor& descriptor) {
  return {descriptor.idVendor,
          descriptor.idProduct,
          descriptor.bcdDevice,
          text_of(handle, descriptor.iManufacturer),
          text_of(handle, descriptor.iProduct),
          text_of(handle, descriptor.iSerialNumber)};
}

LinkResult<void> for_each_falcon(libusb_context* context, const FalconVisit& each) {
  libusb_device** devices = nullptr;
  const auto count = libusb_get_device_list(context, &devices);
  if (count < 0) return LinkError::kNoUsb;
  bool found = false;
  for (decltype(+count) i = 0; i < count && !found; ++i) {
    libusb_device_descriptor descriptor{};
    if (libusb_get_device_descriptor(devices[i], &descriptor) != 0) continue;
    found = descriptor.idVendor == kFalconVendor && descriptor.idProduct == kFalconProduct && each(devices[i], descriptor);
  }
  libusb_free_device_list(devices, 1);
  if (count == 0 && access("/dev/bus/usb", F_OK) != 0) return LinkError::kNoUsb;
  return {};
}

}  // namespace isotouch::falcon
