#include "host/field_file/image.h"

#include <algorithm>
#include <utility>

#include "host/field_file/packed.h"
#include "host/files/whole_file.h"
#include "shared/packed_field.h"

namespace isotouch::field_file {

StoredField read_field(const std::filesystem::path& file) { return read_field(read_file(file), file.string()); }

StoredField read_field(const std::vector<std::uint8_t>& bytes, const std::string& name) {
  if (PackedField::has_magic(bytes)) return unpack(bytes, name);
  Image image(bytes.size());
  std::copy(bytes.begin(), bytes.end(), image.data());
  return {std::move(image)};
}

}  // namespace isotouch::field_file
