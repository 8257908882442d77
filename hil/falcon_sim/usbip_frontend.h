/// The device on a Linux kernel's own USB, without hardware: its virtual host controller (vhci_hcd) takes one end of a pair of sockets, and the
/// frontend answers at the other end. libusb, usbfs and the controller above them are the ones that a real device would have.
///
/// source    the kernel's Documentation/usb/usbip_protocol: CMD_SUBMIT, RET_SUBMIT, CMD_UNLINK, RET_UNLINK, 48 bytes each, big-endian
#pragma once

#include <filesystem>
#include <functional>
#include <memory>

#include "hil/falcon_sim/frontend.h"
#include "hil/falcon_sim/listener.h"

namespace isotouch::falcon_sim {

/// Hands the kernel's end of the pair over, each time the device is plugged in; false while the kernel still has the one before.
using AttachPort = std::function<bool(Descriptor kernels_end)>;

/// Attaches to the first port of a host controller, by its folder in sysfs: /sys/devices/platform/vhci_hcd.0. Needs root.
///
/// fails     when called, std::runtime_error: the module is not loaded, or there is no permission
AttachPort vhci_port(std::filesystem::path controller);

/// fails     std::runtime_error as `attach`
std::unique_ptr<Frontend> make_usbip_frontend(AttachPort attach, PacedDevice& device);

}  // namespace isotouch::falcon_sim
