/// `isotouchd relay`: what comes in at standard input goes to the control socket, and back. Run over ssh, it is the way in from another machine:
/// ssh says who it is, the socket's permissions and the program's list say whether they may.
#pragma once

#include <string>

#include "firmware/control/control_socket.h"
#include "shared/files/refusal.h"

namespace isotouch::control {

/// Copies until the controller has closed its side; the end of the input is passed on.
///
/// input, output   file numbers, blocking
/// patience_ms     as of connect_to_socket
/// returns         there is no controller at `socket_path`, it lets nobody in, or the connection broke
Refusal relay(const std::string& socket_path, int input, int output, int patience_ms = kLetInMs);

}  // namespace isotouch::control
