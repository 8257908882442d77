/// The colours that carry a meaning. They are those of Okabe and Ito, which people with any kind of colour vision tell apart; every one of them
/// comes with a shape, a dash or a hatch of its own, so that no picture depends on colour alone.
///
/// source    M. Okabe and K. Ito, Color Universal Design, jfly.uni-koeln.de/color, 2008
#pragma once

#include "host/view/image.h"

namespace isotouch::view {

inline const Colour kBlue = srgb(0x0072B2);
inline const Colour kOrange = srgb(0xE69F00);
inline const Colour kVermilion = srgb(0xD55E00);
inline const Colour kPurple = srgb(0xCC79A7);
inline const Colour kGreen = srgb(0x009E73);

inline const Colour& kProxyColour = kBlue;       ///< a ball, or a disc
inline const Colour& kHipColour = kOrange;       ///< a cube, or a square
inline const Colour& kInventedColour = kPurple;  ///< hatched
inline const Colour& kRimColour = kVermilion;    ///< a line
inline const Colour& kTurnedColour = kBlue;      ///< a bristle on the surface
inline const Colour& kThinColour = kGreen;       ///< hatched the other way
inline const Colour kForceColour = srgb(0x1B2026);
inline const Colour kPlainSurface = srgb(0xD4DEE8);

}  // namespace isotouch::view
