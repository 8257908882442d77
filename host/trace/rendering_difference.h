/// How two renderers differ on the same hand: forces and proxies of one beside those of the other.
#pragma once

#include <cstddef>
#include <vector>

#include "host/quantiles.h"
#include "shared/tick_io.h"

namespace isotouch::trace {

/// N: a smaller force has no direction that a hand feels.
inline constexpr double kDirectionForce = 0.1;

/// mm: a hand that is at most this deep by one of the two. Deeper inside an object two proxies may rest far apart, and both be right.
inline constexpr double kShallowMm = 1;

/// In ticks in which one of the two touches.
struct RenderingErrors {
  Quantiles force_n;        ///< length of the difference
  Quantiles direction_deg;  ///< between the forces, where both are kDirectionForce or more
  Quantiles proxy_mm;       ///< between the proxies
};

struct RenderingFigures {
  std::size_t ticks = 0;
  std::size_t touching = 0;         ///< in which one of the two touches, or both
  std::size_t contact_differs = 0;  ///< in which only one of the two touches
  RenderingErrors all;
  RenderingErrors shallow;  ///< up to kShallowMm
};

/// Collects tick by tick. In a device's recording forces count only where the device gives its full force: in the state active, after the ramp.
class RenderingDifference {
 public:
  void add(InputKind kind, const Output& recorded, const Output& rendered);
  RenderingFigures figures() const;

 private:
  struct Values {
    std::vector<double> force_n, direction_deg, proxy_mm;
    RenderingErrors errors() const { return {quantiles(force_n), quantiles(direction_deg), quantiles(proxy_mm)}; }
  };
  std::size_t ticks_ = 0, touching_ = 0, contact_differs_ = 0;
  Values all_, shallow_;
};

}  // namespace isotouch::trace
