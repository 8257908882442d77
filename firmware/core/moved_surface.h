/// Where the proxy goes on when the surface has moved by itself.
#pragma once

#include "firmware/core/proxy.h"
#include "shared/field_view.h"

namespace isotouch::core {

/// How far a surface may rise in one patch so that the proxy still rises with it, voxels. A body that reaches further round the proxy has appeared there.
inline constexpr int kMostRise = 3;

/// Keeps the proxy on its side of the surface. It looks where the proxy is, and then outwards along the old normal, a voxel at a time, for the first place
/// that is outside and whose surface faces as the old one did: with another one the proxy would leave a thin wall by its back.
///
/// - the surface sank, or is gone: the proxy is in free space, on its way to the HIP;
/// - it rose by kMostRise at most: the proxy is in front of it;
/// - a body is round the proxy: held inside, no contact until the HIP has left.
///
/// field     the patched one
/// state     of the last tick, in the field before
/// tick      yes: constant cost, kMostRise + 1 samples
void keep_side(const FieldView& field, ProxyState& state);

}  // namespace isotouch::core
