#include "host/field_file/image.h"

#include <algorithm>
#include <utility>

#include "host/field_file/packed.h"
#include "host/files/whole_file.h"
#include "shared/packed_field.h"

namespace isotouch::field_file {

StoredField read_field(const std::filesystem::path& file) {
  const std::vector<std::uint8_t> bytes = read_file(file);
  if (PackedField::has_magic(bytes)) return unpack(bytes, file.string());
  Image image(bytes.size());
  std::copy(bytes.begin(), bytes.end(), image.data());
  return {std::move(image)};
}

}  // namespace isotouch::field_file
