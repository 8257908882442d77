/// Band field → a field's image (shared/SPEC.md, section 2).
#pragma once

#include <cstdint>

#include "host/cloud/oriented_points.h"
#include "host/encoding/small_components.h"
#include "host/field/band_field.h"
#include "host/field_file/image.h"
#include "host/field_file/open_field.h"
#include "shared/field_view.h"

namespace isotouch::encoding {

/// What the image says beside the distances.
struct FieldInfo {
  double stiffness_n_per_mm = 0.8;  ///< the largest, where the field has one for each brick: they are scaled to it
  std::uint64_t source_hash = 0;
  Method method = Method::kDefault;
  Interpolation interpolation = Interpolation::kSpline;  ///< always trilinear with the published method
  std::uint32_t point_count = 0;
  cloud::Placement placement;
};

/// Turns distances into what the interpolation wants, spline coefficients or the distances themselves, rounds them and lays out the image. The same field
/// gives the same bytes on every machine.
///
/// field     bricks sorted by cell, one a cell, each within the grid; a brick that is not listed has the sign of the sample beside it in its
///           row, and that of the border, which is outside, where its row has none before it
/// dropped   where given, is told what was too small for the grid; nothing is with the published method
/// returns   an image and what FieldView::parse says of it. Origin, edge and band are rounded to the formats of SPEC.md 2.3: choose a grid that
///           has them (`field::make_grid`), and every sample stays where it was computed
/// fails     InputError when the field does not fit the format (size, edge, band, origin, stiffness) or when the object reaches the border
field_file::OpenField write_field(field::BandField field, FieldInfo info, SmallComponents* dropped = nullptr);
/// The image alone.
field_file::Image write_image(field::BandField field, FieldInfo info);

/// What `write_field` was told, read back from a checked image; stiffness as rounded.
FieldInfo info_of(const FieldView& view);

}  // namespace isotouch::encoding
