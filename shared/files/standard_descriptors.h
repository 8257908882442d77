/// Standard input, output and error that a program was started without.
#pragma once

namespace isotouch::files {

/// Opens each of the three that is closed, so that no file of the program gets its number, and with it what is printed. What is opened refuses to be
/// read or written, as a closed one does. Call it first.
void occupy_standard_descriptors();

}  // namespace isotouch::files
