/// The device on a virtual machine's USB: a stream socket that QEMU's usb-redir connects to.
///
///   qemu-system-... -device qemu-xhci,id=xhci -chardev socket,id=falcon,path=PATH,reconnect=1 -device usb-redir,chardev=falcon,bus=xhci.0
#pragma once

#include <filesystem>
#include <memory>

#include "hil/falcon_sim/frontend.h"

namespace isotouch::falcon_sim {

/// fails     std::runtime_error: as Listener, or a sentence that this build was made without the library
std::unique_ptr<Frontend> make_usbredir_frontend(const std::filesystem::path& path, PacedDevice& device);

}  // namespace isotouch::falcon_sim
