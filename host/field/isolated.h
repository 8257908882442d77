/// Samples far from all others, which no surface can be known from.
#pragma once

#include "host/cloud/oriented_points.h"
#include "host/field/scan.h"

namespace isotouch::field {

/// The samples that at least three others have among their nearest, in their order; those left out have no voice either. A stray point in the air
/// has neighbours, but it is nobody's neighbour; in a sparse part of a scan, or beside a dense one, samples have each other.
///
/// source    in-degree of the neighbour graph: Hautamäki, Kärkkäinen, Fränti, Outlier detection using k-nearest neighbour graph, 2004
cloud::OrientedPoints without_isolated(const Scan& scan);

}  // namespace isotouch::field
