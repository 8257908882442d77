/// Samples far from all others, from which no surface can be known.
#pragma once

#include <cstdint>
#include <vector>

#include "host/field/scan.h"

namespace isotouch::field {

/// The samples that at least three others have among their nearest, ascending; the others have no voice either. A stray point in the air
/// has neighbours, but it is nobody's neighbour; in a sparse part of a scan, or beside a dense one, samples have each other.
///
/// source    in-degree of the neighbour graph: Hautamäki, Kärkkäinen, Fränti, Outlier detection using k-nearest neighbour graph, 2004
std::vector<std::uint32_t> connected(const Scan& scan);

}  // namespace isotouch::field
