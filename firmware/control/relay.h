/// `isotouchd relay`: what comes in at standard input goes to the control socket, and back. Run over ssh, it is the way in from another machine:
/// ssh says who it is, the socket's permissions and the program's list say whether they may.
#pragma once

#include <string>

#include "shared/files/refusal.h"

namespace isotouch::control {

/// Copies until the controller has closed its side; the end of the input is passed on.
///
/// input, output   file numbers, blocking
/// returns         there is no controller at `socket_path`, or the connection broke
Refusal relay(const std::string& socket_path, int input, int output);

}  // namespace isotouch::control
