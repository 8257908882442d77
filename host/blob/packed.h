/// Blob ↔ its wire and disk form (shared/SPEC.md, section 4): what the prediction of its samples missed, compressed by zstd.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "host/blob/image.h"
#include "shared/blob.h"

namespace isotouch::blob {

/// The packed form of a checked image.
std::vector<std::uint8_t> pack(const BlobView& view);

/// The image in a packed form: the one that was packed, by its hash. Whether it is a good blob is told by BlobView::parse.
///
/// name      stands for the file in the sentence
/// fails     InputError: the bytes are refused by PackedBlob::parse or `restore`, the frame is not as SPEC.md 4.1 says, the hash is another.
///           Before, not more memory is taken than SPEC.md 4.1 allows for that many bytes
Image unpack(std::span<const std::uint8_t> bytes, const std::string& name);

}  // namespace isotouch::blob
