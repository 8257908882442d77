#include "host/trace/rendering_difference.h"

#include <Eigen/Core>
#include <algorithm>

#include "host/angle.h"
#include "host/to_double.h"

namespace isotouch::trace {

namespace {

bool gives_full_force(InputKind kind, const Output& out) {
  return may_give_force(kind, out) && (kind == InputKind::kPosition || (out.status & kRamping) == 0);
}

double depth_of(const Output& out) { return (to_double(out.proxy) - to_double(out.hip)).norm(); }

}  // namespace

void RenderingDifference::add(InputKind kind, const Output& recorded, const Output& rendered) {
  ++ticks_;
  const bool one = (recorded.status & kContact) != 0, other = (rendered.status & kContact) != 0;
  contact_differs_ += one != other ? 1U : 0U;
  if (!one && !other) return;
  ++touching_;
  const double depth = std::min(one ? depth_of(recorded) : 0, other ? depth_of(rendered) : 0);
  const Eigen::Vector3d from = to_double(recorded.force), to = to_double(rendered.force);
  for (Values* const values : {&all_, &shallow_}) {
    if (values == &shallow_ && depth > kShallowMm) continue;
    values->proxy_mm.push_back((to_double(rendered.proxy) - to_double(recorded.proxy)).norm());
    if (!gives_full_force(kind, recorded)) continue;
    values->force_n.push_back((to - from).norm());
    if (from.norm() >= kDirectionForce && to.norm() >= kDirectionForce) values->direction_deg.push_back(angle_deg(from, to));
  }
}

RenderingFigures RenderingDifference::figures() const { return {ticks_, touching_, contact_differs_, all_.errors(), shallow_.errors()}; }

}  // namespace isotouch::trace
