#include "host/field_file/open_field.h"

#include <utility>

#include "host/error.h"

namespace isotouch::field_file {

OpenField open_field(const std::filesystem::path& file) { return open_field(read_field(file), file.string()); }

OpenField open_field(StoredField stored, const std::string& name) {
  OpenField field = open_field(std::move(stored.image), name);
  field.invented = std::move(stored.invented);
  return field;
}

OpenField open_field(field_file::Image image, const std::string& name) {
  const Result<FieldView> view = FieldView::parse({image.data(), image.size()});
  if (!view) throw InputError(name + ": not usable as a field: " + describe(view.error()) + "; build it again");
  return {std::move(image), *view};
}

}  // namespace isotouch::field_file
