/// Parts of a scan that nothing joins to the rest: neighbours cannot tell their side.
#pragma once

#include <cstdint>
#include <vector>

#include "host/field/scan.h"

namespace isotouch::field {

/// Turns closed parts that hang on nothing and are inside out, if their normals agree with each other. A part within another one bounds a hollow, and
/// faces inward; one within a hollow faces outward again.
///
/// heard     the normals are the file's: only a part that is clearly outside all others is turned. What looks closed and faces inward may be the wall of a
///           hole whose edge was not scanned
/// returns   the samples whose normals were turned
std::vector<std::uint32_t> turn_lone_parts(Scan& scan, bool heard);

}  // namespace isotouch::field
