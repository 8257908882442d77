/// PLY files: ascii and both byte orders, any number type, properties and elements in any order, lists and unknown elements skipped.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include "host/cloud/model.h"
#include "host/cloud/oriented_points.h"
#include "host/cloud/ply_header.h"

namespace isotouch::cloud {

/// Takes place, normal and stiffness (point_columns.h) of element `vertex`, and list `vertex_indices` (or `vertex_index`) of element `face`.
/// Without normals it also takes the list of element `range_grid`: the vertex in each cell of a range image, an empty list where nothing returned.
///
/// name      of the file, for the sentences
/// header    of the same bytes
/// returns   a model; without normals, stiffness or faces where the file has none
/// fails     InputError with the line, or for binary files the element's number: bad grammar, unknown types, counts that the file cannot hold,
///           a body that is too short or too long, coordinates or stiffnesses that are not finite (a normal becomes zero), faces or cells that refer to no
///           vertex
/// source    G. Turk, "The PLY Polygon File Format", 1994; of the range images: B. Curless, Stanford 3D Scanning Repository, whose scanner looks
///           along -z, and PCL's PLYWriter, whose camera is the origin
Model read_ply(const std::string& name, std::span<const std::uint8_t> bytes, const PlyHeader& header);
inline Model read_ply(const std::string& name, std::span<const std::uint8_t> bytes) {
  return read_ply(name, bytes, read_ply_header(name, bytes));
}

/// Does the element hold strips of triangles, as Stanford's scanalyze writes them? They are not read.
bool is_strips(const PlyElement& element);

/// Does the header declare faces or strips of triangles, but no normals?
bool is_bare_ply_mesh(const PlyHeader& header);

/// Writes binary little-endian PLY with double coordinates, so that nothing is lost. The file is replaced as a whole.
///
/// comment   one line, may be empty
/// fails     InputError naming the file
void write_ply(const std::filesystem::path& file, const OrientedPoints& points, const std::string& comment = {});

}  // namespace isotouch::cloud
