/// The volume between two closed surfaces: what is inside one and outside the other.
#pragma once

#include <cstddef>

#include "host/field/triangle_tree.h"

namespace isotouch::evaluate {

struct WrongSide {
  double volume = 0;    ///< mm³ inside exactly one of the two
  double too_much = 0;  ///< of it, what is inside `surface` only
  double truth = 0;     ///< mm³ inside `truth`
  std::size_t lines = 0;
};

/// Along lines parallel to x that run through everything, every place where either surface is crossed is computed and the stretches on which the
/// two disagree are summed. So the whole space counts, a flipped interior as much as a thin skin, and cost grows with the lines' crossings.
///
/// exact      along each line, also where surfaces are grazed: an edge belongs to one of its two faces; a point is inside where the faces before
///            it turn round it once or more, so parts that run through each other count once
/// bounded    across: the lines are a Fibonacci lattice, as even along y and along z as their number allows, so nothing gains from surfaces that
///            lie along the grid. What is thinner than a line's share in both y and z may fall between them
///
/// surface, truth   closed, mm
/// area_a_line      mm², each line's share of the cross-section
WrongSide wrong_side(const field::TriangleTree& surface, const field::TriangleTree& truth, double area_a_line);

}  // namespace isotouch::evaluate
