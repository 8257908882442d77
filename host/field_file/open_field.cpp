#include "host/field_file/open_field.h"

#include <utility>

#include "host/error.h"

namespace isotouch::field_file {

OpenField open_field(const std::filesystem::path& file) { return open_field(field_file::read_image(file), file.string()); }

OpenField open_field(field_file::Image image, const std::string& name) {
  const Result<FieldView> view = FieldView::parse({image.data(), image.size()});
  if (!view) throw InputError(name + ": not usable as a field: " + describe(view.error()) + "; build it again");
  return {std::move(image), *view};
}

}  // namespace isotouch::field_file
