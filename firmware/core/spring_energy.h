/// A spring whose stiffness changes along the surface, and which yet gives no energy away.
///
/// The spring between the HIP h and the proxy p holds E = k(p) |h - p|² / 2. A hand that presses where the surface is soft, slides to where it is hard and
/// lets go would be given the difference. Two things prevent that:
///
/// - The proxy leans along the surface to where it is softer, to the p that has the least E: from the closest point by the v in its tangent plane with
///   (I - depth H) v = -½ |h - p|² ∇ ln k, and down by the ½ vᵀ H v that the surface falls there, H its curvature. Then the force is the gradient of an
///   energy, and a hand that slides to a harder place feels that it goes uphill. Each k(p) |h - p|² / 2 is as stiff in every direction as the surface is
///   at p, so the least of them is nowhere stiffer than the hardest place.
/// - The stiffness that is felt grows only as far as the hand has stretched the spring: k(p) |h - p|² is at most what the spring would hold at its last
///   place, k(p') |h - p'|², plus a reserve. It bounds what the leaning leaves over in deep presses, at sharp borders and edges.
///   The reserve of a few microjoule keeps the first ticks of a contact, where the proxy still settles, from making the whole contact soft.
///
/// source    least action of a spring, ∂E/∂p = 0; passivity: Colgate and Schenkel 1997, Passivity of a class of sampled-data systems; DESIGN.md, "Feel"
#pragma once

#include "firmware/core/proxy.h"
#include "firmware/core/stiffness_at.h"
#include "shared/field_view.h"
#include "shared/units.h"
#include "shared/vec3.h"

namespace isotouch::core {

struct SpringState {
  StiffnessSample felt;        ///< part: what was felt last; slope: the table's at that place
  Vec3<Voxel> proxy;           ///< that was felt last, index coordinates
  Vec3<Voxel> lean, step;      ///< in the tangent plane of the closest point, and what was missing to the least energy
  Vec3<Slope> turn;            ///< of the surface along the lean
  std::int64_t reserve = 0;    ///< energy that the stiffness may still grow by, part times square voxels, 50 fraction bits
  Ratio trust = Ratio::of(1);  ///< the share of the step that is taken: it damps what would swing
  bool holds = false;          ///< in contact, on a field whose stiffness varies
};

/// Moves the proxy to where the spring holds least, a step a tick by what was sampled in the last one. Nothing moves on a field of one stiffness.
///
/// surface     the field where the closest point was found
/// contact     proxy and deflection of the surface, within ±8191 voxels; moves by no more than the deflection's length
/// fails       never
/// tick        yes: constant cost, no division
void lean_to_the_softer(const FieldSample& surface, SpringState& state, Contact& contact);

/// The stiffness that the hand feels at the proxy. On a field of the published method it is just the table's.
///
/// contact     the proxy that is felt, with friction
/// largest     what the table's 255 stands for, and what a field without one has everywhere
/// returns     above 0, at most what the table says there
/// fails       never
/// tick        yes: one sample of the stiffness, constant cost, no division
Stiffness felt_stiffness(const Contact& contact, const FieldView& field, Stiffness largest, SpringState& state);

}  // namespace isotouch::core
