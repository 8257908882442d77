#include "host/blob/image.h"

#include <algorithm>

#include "host/blob/packed.h"
#include "host/files/whole_file.h"
#include "shared/packed_blob.h"

namespace isotouch::blob {

Image read_image(const std::filesystem::path& file) {
  const std::vector<std::uint8_t> bytes = read_file(file);
  if (PackedBlob::has_magic(bytes)) return unpack(bytes, file.string());
  Image image(bytes.size());
  std::copy(bytes.begin(), bytes.end(), image.data());
  return image;
}

}  // namespace isotouch::blob
