/// Header, tables and bricks → the bytes of an image (shared/SPEC.md, section 2.3).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>

#include "host/encoding/certificate.h"
#include "host/encoding/write_image.h"
#include "host/field/band_field.h"
#include "host/field_file/image.h"
#include "shared/field_view.h"

namespace isotouch::encoding {

using ImageHeader = std::array<std::uint8_t, image_layout::kHeaderBytes>;

/// All that a header says before there are bricks.
///
/// grid      exact, as `field::make_grid` gives it
/// band      half width, voxels
/// fails     InputError when grid, band, stiffness or origin do not fit the format
ImageHeader image_header(const field::Grid& grid, double band, const FieldInfo& info);

/// Puts the certificate in. Its numbers are rounded up: what is promised from above must hold.
void store_certificate(const Certificate& certificate, ImageHeader& header);

/// The tables of an image.
struct ImageTables {
  std::span<const std::uint32_t> root, nodes;  ///< nodes 0 and 1 among them
  std::size_t stored = 0;                      ///< bricks from number 2 on
  std::span<const std::uint8_t> stiffness;     ///< a byte for each brick, 0 and 1 among them; empty = none
};

/// copy      is called once, and writes the stored bricks in the order of their numbers, 128 bytes each
/// fails     InputError when the image would not fit 4 GB
field_file::Image lay_out_image(const ImageHeader& header, const ImageTables& tables, const std::function<void(std::uint8_t*)>& copy);

}  // namespace isotouch::encoding
