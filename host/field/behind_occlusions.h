/// Where one part of a scan of one side hides another, the surface behind goes on a little.
#pragma once

#include "host/cloud/oriented_points.h"
#include "host/field/front_view.h"
#include "host/field/scan.h"

namespace isotouch::field {

/// Samples on the tangent planes of those that lie at the edge of a shadow, into the shadow. Without them the surface between the edge of what lies in
/// front and the edge of its shadow runs along the line of sight; on a surface that was seen at a small angle it fills the wedge above what was seen.
///
/// scan      of one side, without strays; outward normals
/// view      of its points
/// spacing   between neighbouring samples, the scan's unit
/// opening   so high shall the wedge be at the edge of the shadow, the same unit
/// returns   positions and normals, without stiffness; they end well before what hides them
cloud::OrientedPoints behind_occlusions(const Scan& scan, const FrontView& view, double spacing, double opening);

}  // namespace isotouch::field
