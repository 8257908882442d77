/// Polygons → triangles.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "host/cloud/model.h"

namespace isotouch::cloud {

/// Appends a polygon to the model's faces as a fan: its first corner with every two that follow each other. `cut_polygons` looks at it as soon as all
/// positions are known.
///
/// corners   of fewer than three nothing is appended
/// line      of the file, from 1; 0 in a binary file
/// number    among the file's faces, from 1
void add_polygon(Model& model, std::span<const std::uint32_t> corners, std::size_t line, std::size_t number);

/// A fan covers its polygon where the polygon is convex, and often elsewhere. Every other fan is replaced by as many triangles that do: ears are cut
/// off, which are corners whose triangle holds no other corner. Each edge of the polygon keeps its direction. A polygon without area keeps its fan.
///
/// name      of the file, for the sentence
/// fails     InputError with the polygon's place: it runs out of ears, as some that cross themselves or run along themselves do, or it has so many
///           corners that this would take too long. One that crosses itself and has ears enough, or whose fan looks to one side, is accepted: what its
///           triangles wind round is inside
/// source    G. H. Meisters, Polygons have ears, American Mathematical Monthly 82, 1975
void cut_polygons(Model& model, const std::string& name);

}  // namespace isotouch::cloud
