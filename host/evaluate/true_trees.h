/// What hands ask about a true surface (truth_comparison.h): what is nearest or in the way, and what is inside.
#pragma once

#include "host/field/triangle_tree.h"

namespace isotouch::evaluate {

/// The trees stay alive as long as this.
struct TrueTrees {
  /// A mesh of one sheet: all its faces bound it.
  TrueTrees(const field::TriangleTree& all) : outer(all), closed(all) {}
  TrueTrees(const field::TriangleTree& outer_faces, const field::TriangleTree& all) : outer(outer_faces), closed(all) {}

  const field::TriangleTree& outer;   ///< of the faces that bound the union: what can be touched
  const field::TriangleTree& closed;  ///< of all faces: what they turn round is inside
};

}  // namespace isotouch::evaluate
