/// What a file says of its field, which is unpacked only where the answer lies in it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "host/field_file/open_field.h"
#include "shared/field_view.h"

namespace isotouch::field_file {

struct DescribedField {
  std::size_t image_bytes = 0, packed_bytes = 0;
  std::uint64_t hash = 0;               ///< of the image
  FieldView header;                     ///< of the image's header alone: no tables, no bricks. Borrows the file's bytes or `whole`
  std::optional<OpenField> whole = {};  ///< where it was asked for, where the file holds the image itself, a stiffness table or marks
};

/// bytes     of the file; stay alive and unchanged
/// name      stands for the file in the sentence
/// whole     is the image wanted in any case?
/// fails     InputError naming the file: as `open_field`. Without the image: what its header and the checksum of all bytes do not show, as
///           bricks that a wrong program wrote, is not seen
DescribedField describe_field(const std::vector<std::uint8_t>& bytes, const std::string& name, bool whole);

}  // namespace isotouch::field_file
