/// The world of a machine without an operating system, as far as a debugger or QEMU lends it: a console and an end.
///
/// source    "Semihosting for AArch32 and AArch64": SYS_WRITE0, SYS_EXIT_EXTENDED
#pragma once

#include <cstdint>

namespace isotouch::semihosting {

/// text      ends with a zero
void write(const char* text);

/// Ends the machine; the code becomes QEMU's.
[[noreturn]] void end(int code);

}  // namespace isotouch::semihosting
