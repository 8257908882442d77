/// Which reader bytes are for whose name does not tell: standard input, a pipe.
#pragma once

#include <cstdint>
#include <span>

#include "host/cloud/file_kind.h"

namespace isotouch::cloud {

/// STL by its size or its first word; OBJ and text by the first word of the first two lines that are no comments.
///
/// bytes     no PLY file's
FileKind content_kind(std::span<const std::uint8_t> bytes);

}  // namespace isotouch::cloud
