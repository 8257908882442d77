/// Patches of normals that point the wrong way, turned round.
#pragma once

#include <cstddef>

#include "host/field/scan.h"

namespace isotouch::field {

/// Neighbours that surely agree hang together. Such a part is turned where it lies beside a larger one and clearly contradicts it nearly everywhere. The
/// two sides of a thin wall contradict each other, too, but lie behind each other, and surfaces across a gap lie before each other; beside a turned
/// patch neither is the rule.
///
/// scan      most normals outward
/// returns   how many were turned
std::size_t turn_patches(Scan& scan);

}  // namespace isotouch::field
