/// What both users of libusb in this folder need: the Falcons on the bus, and libusb's errors in our words.
#pragma once

#include <libusb.h>

#include <functional>

#include "firmware/falcon/falcon_link.h"

namespace isotouch::falcon {

/// What went wrong; `code` is a negative libusb_error. One that has no word of its own counts as kGone: opening anew is the cure for all of them.
LinkError usb_error(int code);

/// Reads the strings of an opened device; empty where they cannot be read.
FalconIdentity usb_identity(libusb_device_handle* handle, const libusb_device_descriptor& descriptor);

/// Returns true to end the search.
using FalconVisit = std::function<bool(libusb_device*, const libusb_device_descriptor&)>;

/// Calls `each` with every Falcon on the bus, in the bus's order.
///
/// fails     kNoUsb
LinkResult<void> for_each_falcon(libusb_context* context, const FalconVisit& each);

}  // namespace isotouch::falcon
