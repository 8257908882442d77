/// Image ↔ packed field (shared/SPEC.md, section 4): what the prediction of its samples missed, compressed by zstd.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "host/field_file/image.h"
#include "shared/field_view.h"

namespace isotouch::field_file {

/// The packed form of a checked image.
std::vector<std::uint8_t> pack(const FieldView& view);

/// Unpacks the image and checks its hash. Whether the image is a valid field is for FieldView::parse to say.
///
/// name      stands for the file in the sentence
/// fails     InputError: the bytes are refused by PackedField::parse or `restore`, the frame is not as SPEC.md 4.1 says, the hash is another.
///           Before, not more memory is taken than SPEC.md 4.1 allows for that many bytes
Image unpack(std::span<const std::uint8_t> bytes, const std::string& name);

}  // namespace isotouch::field_file
