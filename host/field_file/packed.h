/// Image ↔ packed field (shared/SPEC.md, section 4): what the prediction of its samples missed, compressed by zstd.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "host/field_file/image.h"
#include "shared/field_view.h"
#include "shared/packed_field.h"

namespace isotouch::field_file {

/// The packed form of a checked image.
///
/// invented  which of its bricks hold invented surface; a controller has no use for it
std::vector<std::uint8_t> pack(const FieldView& view, const Marks& invented = {});

/// What PackedField::parse says of the bytes: all that can be checked without unpacking.
///
/// name      stands for the file in the sentence
/// fails     InputError: the bytes are refused
PackedField checked_packed(std::span<const std::uint8_t> bytes, const std::string& name);

/// Unpacks the image and checks its hash. Whether the image is a valid field is for FieldView::parse to say.
///
/// name      stands for the file in the sentence
/// fails     InputError: the bytes are refused by `checked_packed` or `restore`, the frame is not as SPEC.md 4.1 says, the hash is another.
///           Before, not more memory is taken than SPEC.md 4.1 allows for that many bytes
StoredField unpack(std::span<const std::uint8_t> bytes, const std::string& name);

}  // namespace isotouch::field_file
