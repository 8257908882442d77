#include "firmware/falcon/falcon_list.h"

#include <array>
#include <cstdio>

#include "firmware/falcon/usb_bus.h"

namespace isotouch::falcon {

UsbListing list_falcons() {
  UsbListing listing;
  libusb_context* context = nullptr;
  if (libusb_init(&context) != 0) {
    listing.trouble = LinkError::kNoUsb;
    return listing;
  }
  const LinkResult<void> listed = for_each_falcon(context, [&](libusb_device* device, const libusb_device_descriptor& descriptor) {
    FoundFalcon falcon;
    falcon.bus = libusb_get_bus_number(device);
    falcon.address = libusb_get_device_address(device);
    libusb_device_handle* handle = nullptr;
    if (const int opened = libusb_open(device, &handle); opened != 0) {
      falcon.trouble = usb_error(opened);
    } else {
      const FalconIdentity identity = usb_identity(handle, descriptor);
      falcon.name = identity.name;
      falcon.serial = identity.serial;
      libusb_close(handle);
    }
    listing.falcons.push_back(falcon);
    return false;
  });
  libusb_exit(context);
  if (!listed)
    listing.trouble = listed.error();
  else if (listing.falcons.empty())
    listing.trouble = LinkError::kNotFound;
  return listing;
}

std::string explain(const UsbListing& listing) {
  if (listing.trouble) return std::string("no Falcon to list: ") + describe(*listing.trouble) + "; " + advice(*listing.trouble);
  std::string lines;
  for (const FoundFalcon& falcon : listing.falcons) {
    std::array<char, 40> place{};
    std::snprintf(place.data(), place.size(), "bus %03d device %03d: ", falcon.bus, falcon.address);
    if (!lines.empty()) lines += '\n';
    lines += place.data();
    if (falcon.trouble)
      lines += std::string("a Falcon, but ") + describe(*falcon.trouble) + "; " + advice(*falcon.trouble);
    else
      lines += falcon.name + ", serial " + falcon.serial;
  }
  return lines;
}

}  // namespace isotouch::falcon
