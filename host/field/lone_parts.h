/// Parts of a scan that nothing joins to the rest: neighbours cannot tell their side.
#pragma once

#include <cstddef>

#include "host/field/scan.h"

namespace isotouch::field {

/// Turns closed parts that hang on nothing and are inside out, if their normals agree with each other. A part within another one bounds a hollow, and
/// faces inward; one within a hollow faces outward again.
///
/// heard     the normals are the file's: a part within another one stays as it is
/// returns   how many normals were turned
std::size_t turn_lone_parts(Scan& scan, bool heard);

}  // namespace isotouch::field
