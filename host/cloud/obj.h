/// Wavefront OBJ: positions, normals and faces. Everything else in it is skipped. A backslash at its end joins a line with the next.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "host/cloud/model.h"

namespace isotouch::cloud {

/// Takes `v` (its first three numbers) and `f` (larger polygons as fans, see polygon.h), indices from 1 or backwards from -1.
///
/// returns   all vertices in their order; no normals
/// fails     InputError with the line: no number, not finite, an index of a vertex that is not there, a face of fewer than three corners
Model read_obj_faces(const std::string& name, std::span<const std::uint8_t> bytes);

/// Takes the oriented points: normals `vn` belong to the corners of faces, so there is one point for each pair `v//vn` that a face names,
/// in order of first use. Without any face the n-th normal belongs to the n-th vertex. A vertex with several normals gives several points at
/// one place, which the check of the cloud then merges like all others.
///
/// returns   points with normals, no faces; without points or normals where the file has none, or no corner of its faces names a normal
/// fails     as above; also corners without a normal beside others with one, and vertices and normals of different number where there are no faces
Model read_obj_points(const std::string& name, std::span<const std::uint8_t> bytes);

/// Are there faces, of which none names a normal?
bool is_bare_obj_mesh(const std::string& name, std::span<const std::uint8_t> bytes);

}  // namespace isotouch::cloud
