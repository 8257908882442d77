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

/// Of samples that are not connected: those that lie on a surface with most of their neighbours, ascending.
///
/// alone     these samples and no others
std::vector<std::uint32_t> on_a_surface(const Scan& alone);

struct Sides {
  std::vector<std::uint32_t> samples;  ///< ascending
  std::size_t sparse = 0;              ///< of these, samples that only others like them connect
};

/// The connected samples, and those of sparse sides: where one side of a wall is much denser than the other, a sample of the other has hardly any of its
/// own side among its nearest, so that it seems to be a stray. Such samples lie on a surface among themselves, and face another way than those beside
/// them: else they are another layer of a surface that is known.
///
/// scan      its normals have a side
Sides connected_sides(const Scan& scan);

}  // namespace isotouch::field
